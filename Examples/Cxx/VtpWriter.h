/**
 * Writes VTK's XML, inline. In this mode VTK 9.1's writer crashes when its own file does not take
 * everything, on a full disk say; the mode in which it does not, appended, is one that ParaView
 * 5.11 cannot read with the newest libexpat of Debian 12.
 */
#ifndef VtpWriter_h
#define VtpWriter_h

#include <string>

class ProgressBar;
class vtkPolyData;

/** Binary and compressed. Throws Failure, saying why, if the file is not complete. */
void WriteVtp(vtkPolyData* surface, const std::string& path, ProgressBar* progress);

#endif
