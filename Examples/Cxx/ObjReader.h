/**
 * Wavefront OBJ in double precision.
 *
 * Own code: vtkOBJReader has single precision and skips faces that have not the same kinds of
 * numbers as the first; assimp has single precision, and a backslash at the end of a comment costs
 * it the next face; tinyobjloader refuses comments behind numbers, joined lines and "1/1/", takes
 * what is no number for 0 and drops faces of two corners.
 */
#ifndef ObjReader_h
#define ObjReader_h

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkPolyData;

/**
 * Points as the file has them; polygons; point arrays TCoords and Normals where all corners have
 * some. Of several objects (o), groups (g) or materials (usemtl), the cell arrays ObjectIds,
 * GroupIds and MaterialIds tell which each polygon belongs to, counted in the order in which they
 * come, and the field data ObjectNames, GroupNames and MaterialNames what they are called.
 *
 * Throws Failure for a face that cannot be read, for numbers that are not finite and for free-form
 * surfaces. Adds to `warnings` what was left out.
 */
vtkSmartPointer<vtkPolyData> ReadObj(const std::string& text, std::vector<std::string>& warnings);

#endif
