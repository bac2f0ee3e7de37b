/**
 * .mesh and .meshb files of Medit, mmg and others, in double precision, and the .sol and .solb
 * files beside them.
 *
 * Triangles and quadrilaterals are read, with their references as the cell array Reference; all
 * else, such as edges, required parts and tetrahedra, is left out.
 */
#ifndef MeshReader_h
#define MeshReader_h

#include <vtkSmartPointer.h>

#include <string>

class vtkPolyData;

/** `extension`: ".mesh" or ".meshb". Throws Failure for a file that is not complete. */
vtkSmartPointer<vtkPolyData> ReadMesh(const std::string& bytes, const std::string& extension);

/**
 * Adds what a .sol or .solb file has for the points: the first as the array Metric, further ones as
 * Solution1, Solution2 and so on. Tensors get VTK's order, XX YY ZZ XY YZ XZ or XX YY XY. Throws
 * Failure for a file that is not complete, or not for so many points.
 */
void AddSolutions(const std::string& bytes, const std::string& extension, vtkPolyData* surface);

#endif
