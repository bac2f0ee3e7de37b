/**
 * @file SeamCharts.h
 * @brief Where the values of a point array jump: seams, as texture coordinates have them.
 *
 * The caller's points become one where they coincide. Each value that an array has there is a
 * *chart* of the point. A seam is an edge whose ends are on one chart in one facet, and on another
 * in the other.
 */
#ifndef remesh_SeamCharts_h
#define remesh_SeamCharts_h

#include "Preparation/SurfacePreparation.h"

namespace remesh
{
struct SeamCharts
{
  /** F x 3, the chart of each corner, 0, 1, ... at each point. Empty: no value jumps. */
  std::vector<Triple> ofCorners;
  /** Points with several charts. */
  Offset points = 0;
};

/**
 * Values that differ by no more than `tolerance` of the range, in all components, are on one chart.
 * O(F x components); nothing where no points coincide.
 *
 * @param array one tuple for each of the caller's points.
 */
SeamCharts findSeamCharts(
  const SurfaceMesh& mesh, const PointArray& array, double tolerance, const RunControl& control);

/**
 * The charts of `request.seams`, for features; none where points at the mean spacing along all
 * seams would be more than a third of those asked for: most of the mesh would be seam.
 */
std::vector<Triple> findKeptSeams(
  const SurfaceMesh& mesh, const PreparationRequest& request, const RunControl& control);

/** A warning for carried arrays that jump where no seam is kept: they are interpolated across. */
void tellJumps(
  const PreparationRequest& request, const RunControl& control, PreparedSurface& prepared);
}

#endif
