/**
 * @file PointArrays.h
 * @brief Points and their arrays as the core reads them.
 */
#ifndef remesh_PointArrays_h
#define remesh_PointArrays_h

#include "Preparation/GivenSites.h"

#include <optional>
#include <vector>

class vtkDataArray;
class vtkPointSet;
class vtkPolyData;

namespace remesh
{
/** An array to be read in place, which must outlive what is returned; none of nullptr. */
std::optional<PointArray> lentArray(vtkDataArray* array);

/**
 * The point arrays whose values are interpolated to a mesh (CarriedArrays.h), but the active
 * normals, which the mesh has anew. None for surfaces of several blocks: these keep their own
 * values where they meet.
 */
std::vector<PointArray> carriedPointArrays(vtkPolyData* input);

/** The points, with their array `Embedding`, likewise; none of nullptr. */
std::optional<GivenSites> givenSites(vtkPointSet* input);
}

#endif
