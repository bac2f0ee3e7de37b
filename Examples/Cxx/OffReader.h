/**
 * OFF as text, in double precision; normals, colours and texture coordinates are left out.
 *
 * Own code: VTK has no reader, and that of assimp has single precision and drops faces of more
 * than nine corners.
 */
#ifndef OffReader_h
#define OffReader_h

#include <vtkSmartPointer.h>

#include <string>

class vtkPolyData;

/** Throws Failure for a file that is not complete. */
vtkSmartPointer<vtkPolyData> ReadOff(const std::string& text);

#endif
