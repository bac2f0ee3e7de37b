/**
 * @file StrayTriangles.h
 * @brief Triangles that face along their own cells' facets, but against those of another part of
 *        the surface that is closer.
 *
 * Where two sheets, or the sides of a thin one, are closer to each other than a chord is to its
 * arc, a triangle of one is next to the other.
 */
#ifndef remesh_StrayTriangles_h
#define remesh_StrayTriangles_h

#include "Placement/PlacementProblem.h"
#include "Placement/WholeSurface.h"
#include "Support/RunControl.h"
#include "Support/Status.h"

#include <algorithm>
#include <vector>

namespace remesh
{
/** With more strays, of so many triangles, points are too few: nothing is done about them. */
inline Offset maxStrays(Offset triangles)
{
  return std::min(triangles / 20, 50 + triangles / 100);
}

/**
 * Marks the triangles that face against one of the surface's facets that are closest to them: all
 * strays are among them, and all that face against their own cells' facets. Parallel, O(T log F).
 *
 * @param suspects T, 1: such a one.
 */
Status findSuspects(const PlacementProblem& problem, const WholeSurface& whole,
  const Triangles& mesh, const RunControl& control, std::vector<char>& suspects);
}

#endif
