/**
 * Looks through a PLY file before VTK does: vtkPLYReader 9.1 writes out of bounds when a file ends
 * early, and prints to the terminal.
 */
#ifndef PlyCheck_h
#define PlyCheck_h

#include <string>

/**
 * Throws Failure, saying what is wrong, unless the header is well formed, there are vertices with
 * x, y and z, and the body has as many elements as the header says. Cost: one pass over the lists.
 */
void CheckPly(const std::string& path);

#endif
