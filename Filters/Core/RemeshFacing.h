/**
 * @file RemeshFacing.h
 * @brief Tells which triangles of a dual face the wrong way.
 */
#ifndef remesh_RemeshFacing_h
#define remesh_RemeshFacing_h

#include "Placement/FlipRepair.h"
#include "RemeshTask.h"

#include <vector>

namespace remesh
{
/** Triangles of the cells' centroids. */
struct FlippedTriangles
{
  std::vector<Index> found; ///< ascending
  std::vector<Index> left;  ///< that the steps do not turn back: the dual's where no edges turn
};

/**
 * The triangles that face their own cells' facets the wrong way, or have no height. Those without a
 * height are not left: turned edges mend them.
 */
FlippedTriangles flippedTriangles(
  const Task& task, FlipSteps steps, const RunControl& control, const RemeshResult& result);

/**
 * The triangles that face their own facets, or those of a part of the surface that is closer
 * (StrayTriangles.h), the wrong way and are not turned back by moving vertices.
 *
 * @param flipped those that face their own cells' facets the wrong way.
 */
std::vector<Index> wrongTriangles(const Task& task, const std::vector<Index>& flipped,
  const RunControl& control, const RemeshResult& result);
}

#endif
