/**
 * Looks through a PLY file before VTK does: vtkPLYReader 9.1 crashes when a file ends early or a
 * face refers to a point that does not exist, and prints to the terminal.
 */
#ifndef PlyCheck_h
#define PlyCheck_h

#include <string>

/**
 * Throws Failure, saying what is wrong, unless the header is well formed and the body has all
 * that the header announces, with valid point ids. Cost: one pass over the file.
 */
void CheckPly(const std::string& path);

#endif
