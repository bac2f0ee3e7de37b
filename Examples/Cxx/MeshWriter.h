/**
 * .mesh and .meshb files, and the .sol and .solb files beside them, in double precision: text, or
 * binary files of version 2, of version 3 where they are larger than 2 GB, in this machine's order
 * of bytes.
 */
#ifndef MeshWriter_h
#define MeshWriter_h

#include <string>

class vtkDataArray;
class vtkPolyData;

enum class MeshFormat
{
  Text,
  Binary,
  LargeBinary // places of 8 bytes, which mmg does not read
};

/** For the extension, and so many points and triangles, or tensors. */
MeshFormat MeshFormatFor(const std::string& extension, long long rows);

/** Triangles with the whole numbers of the cell array Reference, or 0. */
std::string MeshBytes(vtkPolyData* surface, MeshFormat format);

/**
 * A metric at the vertices: a size for one component, else a tensor, 11 12 22 13 23 33.
 *
 * @param metric of 1, 3, 6 or 9 components, as vtkAnisotropicRemesher takes them. 3 are a tensor of
 *   the plane: across it, where a surface of the plane has no edge, 33 is the square root of its
 *   determinant, so that the tensor has an inverse, and a scaled one is scaled as a whole.
 * @param order of 3 and 6 components: "vtk", "rows" or "sol".
 */
std::string SolutionBytes(vtkDataArray* metric, const std::string& order, MeshFormat format);

/** The name for the metric beside a mesh, "x.solb" for "x.meshb.gz"; "": it has none. */
std::string SolutionNameFor(const std::string& path);

#endif
