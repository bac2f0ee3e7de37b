/**
 * The coordinates of a PLY file in double precision: vtkPLYReader rounds them to single precision.
 */
#ifndef PlyCoordinates_h
#define PlyCoordinates_h

#include <string>

class vtkPolyData;

/**
 * Puts the coordinates as the file has them in place of the surface's rounded ones, if the file
 * has them in double precision. The file has passed CheckPly, and `surface` was read from it.
 */
void RestorePlyCoordinates(const std::string& path, vtkPolyData* surface);

#endif
