/**
 * @file BorderGaps.h
 * @brief Slits along the border, as of surfaces whose triangles nearly meet.
 */
#ifndef remesh_BorderGaps_h
#define remesh_BorderGaps_h

#include "Mesh/EdgeTable.h"

namespace remesh
{
struct BorderGaps
{
  Offset points = 0;  ///< on the border, that nearly coincide with another one there; 0: no slits
  double width = 0.0; ///< of the bounding-box diagonal: merging over it closes the slits
};

/**
 * Finds slits by merging the points on the border over widths from 3e-3 to 1e-12 of the diagonal,
 * two for each power of ten.
 *
 * 1. A width is small if ten times as much makes at most one in ten of the border's sides vanish. If
 *    a small one merges as many points as the next larger one, these points are much closer to each
 *    other than to any others. The smallest such width is the result.
 * 2. Else, as in a soup of slivers, the width over which most of the border's sides become pairs, if
 *    these are three quarters of all, and at most one in a hundred vanishes.
 *
 * @param points P finite points of R^3; `facets` F x 3 and their `edges`.
 * @param control asked for cancellation; the result of a cancelled run is of no use.
 * Cost: O(F); O(b log b) with b points on the border, some times over where they nearly coincide.
 */
BorderGaps findBorderGaps(const std::vector<Point3>& points, const std::vector<Triple>& facets,
  const EdgeTable& edges, const RunControl& control = RunControl());
}

#endif
