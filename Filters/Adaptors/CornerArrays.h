/**
 * @file CornerArrays.h
 * @brief Point arrays of the caller's data, brought to the corners of the surface and back.
 */
#ifndef remesh_CornerArrays_h
#define remesh_CornerArrays_h

#include "Embedding/Embedding.h"
#include "Mesh/SurfaceMesh.h"
#include "Support/Status.h"

class vtkDataArray;

namespace remesh
{
/**
 * The array's value at each corner: the mean over the distinct input points merged into it.
 *
 * @return InvalidInput, with the array's name, for a wrong number of tuples or a value at a used
 *         point that is not finite.
 */
Status readCornerArray(const SurfaceMesh& mesh, vtkDataArray* array, Offset numberOfInputPoints,
  CornerCoordinates& values);

/** All tuples of a point array of three components, as they are. */
Status readNormals(vtkDataArray* array, Offset numberOfInputPoints, std::vector<Point3>& normals);
}

#endif
