/**
 * @file Facing.h
 * @brief Tells which triangles of a dual will face the wrong way, before its vertices are placed.
 */
#ifndef remesh_Facing_h
#define remesh_Facing_h

#include "Repair/MeshRepair.h"
#include "Run/Task.h"

#include <vector>

namespace remesh
{
/** Numbers of triangles of the dual, ascending. */
struct WrongTriangles
{
  std::vector<Index> inverted; ///< face against the facets of their own cells, or have no height
  std::vector<Index> strays;   ///< face against another part of the surface, that is closer
};

/**
 * Puts the vertices at the centroids of their cells, and repairs a copy of that mesh by these steps
 * (MeshRepair.h). Returns the triangles that still face the wrong way then.
 *
 * With more strays than `maxStrays` (StrayTriangles.h), the surface goes through itself: no strays
 * are returned then. With more than a quarter of the triangles inverted, the surface has no sides
 * to tell: the repair is left out, and all of them are returned.
 *
 * @param steps what the repair may do.
 * @return empty where cancelled.
 */
WrongTriangles findWrongTriangles(
  const Task& task, MeshSteps steps, const RunControl& control, const RemeshResult& result);
}

#endif
