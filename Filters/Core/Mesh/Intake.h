/**
 * @file Intake.h
 * @brief From a triangle soup to a clean, oriented, spatially ordered SurfaceMesh.
 */
#ifndef remesh_Intake_h
#define remesh_Intake_h

#include "Mesh/BorderGaps.h"
#include "Mesh/SurfaceMesh.h"
#include "Support/RunControl.h"
#include "Support/Status.h"

namespace remesh
{
/** Three half-edges per facet are numbered with an Index. */
constexpr std::int64_t maximumInputTriangles = maximumIndex / 3;

/** Bounds within which the fourth powers of lengths, areas squared, stay normal doubles. */
constexpr double largestCoordinate = 1e50;
constexpr double smallestExtent = 1e-50;

struct IntakeOptions
{
  /**
   * Points closer than this are one point, and so are chains of them; same length unit as the
   * points. The lowest of the caller's points gives the position. 0: equal coordinates only
   * (-0 equals +0), and the ends of sides that are nothing but rounding.
   */
  double mergeDistance = 0.0;
};

struct IntakeReport
{
  Offset droppedDegenerate = 0; ///< triangles with two equal points or no area
  Offset addedBySplits = 0;     ///< facets, beside others that were dropped (CapSplit.h)
  Offset droppedDuplicate = 0;  ///< triangles on the same three points as an earlier one
  Offset droppedFlaps = 0;    ///< the earlier ones themselves, where they are a flap (Duplicates.h)
  Offset mergedPoints = 0;    ///< used input points that became another one's
  Offset flippedFacets = 0;   ///< turned round to make the orientation consistent
  Index components = 0;       ///< connected through shared points
  Index nonManifoldEdges = 0; ///< edges of more than two facets
  Index boundaryEdges = 0;    ///< edges of one facet
  BorderGaps gaps;            ///< slits along the border
  bool orientable = true;     ///< every component has a consistent orientation

  Offset dropped() const
  {
    return this->droppedDegenerate + this->droppedDuplicate + this->droppedFlaps;
  }
};

/**
 * Merges coincident points, drops degenerate and duplicate triangles and unused points, makes the
 * orientation consistent, and orders facets and points along a Hilbert curve.
 *
 * - Coincident: by `mergeDistance`, or the ends of a side that is nothing but rounding
 *   (`roundingOfPoints`), as between the first and the last points of a closed grid.
 * - Degenerate: two corners are one point, or their area is nothing but rounding error
 *   (`hasArea`). Slivers of any width stay, with sides that are more than rounding. Where three
 *   corners are on a line between other triangles, the one across the longest side is split at the
 *   middle corner (CapSplit.h).
 * - Orientation: see `findOrientation`. A consistent input keeps its own, inside out or not.
 * - A facet keeps its first corner; turning it round exchanges the other two.
 * - Facets follow the Hilbert curve of their centroids (ties: input order), points the order in
 *   which the facets meet them. `facetCorners` equals `facetPoints`.
 *
 * @return InvalidInput for ids out of range, more than `maximumInputTriangles`, used points that
 *         are not finite or beyond `largestCoordinate`, a surface below `smallestExtent`, or a
 *         merge distance that is negative or not finite; EmptyInput when no triangle is left.
 *         Then `mesh` is empty. Points that no triangle uses are not looked at.
 * Cost: O(T) with the default merge distance. Deterministic.
 */
Status buildSurfaceMesh(const TriangleSoup& soup, const IntakeOptions& options,
  const RunControl& control, SurfaceMesh& mesh, IntakeReport& report);
}

#endif
