/**
 * @file Facing.h
 * @brief Tells which triangles of a dual face the wrong way.
 */
#ifndef remesh_Facing_h
#define remesh_Facing_h

#include "Repair/MeshRepair.h"
#include "Run/Task.h"

#include <vector>

namespace remesh
{
/** Triangles of the dual, with vertices at the centroids of their cells; ascending. */
struct WrongTriangles
{
  std::vector<Index> inverted; ///< against their own cells' facets
  std::vector<Index> strays;   ///< against those of a part of the surface that is closer
};

/**
 * The triangles that face the wrong way, or have no height, and that these steps do not turn back.
 * With more strays than `mostStrays` the surface goes through itself, and none are told.
 */
WrongTriangles findWrongTriangles(
  const Task& task, MeshSteps steps, const RunControl& control, const RemeshResult& result);
}

#endif
