/**
 * STL, binary and text, the latter in double precision.
 *
 * Own code: vtkSTLReader has single precision, takes whatever is in a file as triangles, and from
 * VTK 9.6 on refuses text that starts with blanks or capitals.
 */
#ifndef StlReader_h
#define StlReader_h

#include <vtkSmartPointer.h>

#include <string>

class vtkPolyData;

/**
 * Three points for each triangle. Of several solids in a text file, the cell array SolidIds tells
 * which each triangle belongs to. Throws Failure for a file that is not complete.
 */
vtkSmartPointer<vtkPolyData> ReadStl(const std::string& bytes);

#endif
