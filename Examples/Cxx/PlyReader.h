/**
 * PLY, text and binary, in the precision of the file.
 *
 * Own code: vtkPLYReader has single precision and no triangle strips, crashes when a file ends
 * early or a face refers to a point that does not exist, and prints to the terminal.
 */
#ifndef PlyReader_h
#define PlyReader_h

#include <vtkSmartPointer.h>

#include <string>

class vtkPolyData;

/**
 * Polygons of the element "face", then the triangles of the element "tristrips". Arrays as
 * vtkPLYReader has them: of points and faces RGB or RGBA (red, green, blue, alpha), of points
 * Normals (nx, ny, nz) and TCoords (of points or corners), both active. Other numbers that each
 * point or face has are arrays of their own names.
 *
 * Throws Failure, saying what is wrong, unless the header is well formed and the body has all that
 * it announces, with valid point ids.
 */
vtkSmartPointer<vtkPolyData> ReadPly(const std::string& bytes);

#endif
