/**
 * @file PieceFlips.h
 * @brief Flips edges between the pieces of a facet, so that they are well shaped in some measure.
 *
 * Splits at middles of edges keep the shapes that facets have in R^3, about. Where a measure wants
 * thin pieces across the direction of their facet, many more of them would be needed than the
 * measure asks for.
 *
 * 1. An edge between two pieces of one facet that make a convex quadrilateral is flipped where that
 *    lowers the sum of both energies. With (a^2 + b^2 + c^2) / area this makes a Delaunay
 *    triangulation where the measure is the same everywhere (O. Musin, "Properties of the Delaunay
 *    triangulation", 1997).
 * 2. The edges around are looked at again.
 *
 * The sum falls at each flip, so this ends. Edges of the facets stay, and with them all features;
 * pieces tile their facet as before, and whether a quadrilateral is convex is decided exactly.
 */
#ifndef remesh_PieceFlips_h
#define remesh_PieceFlips_h

#include "Refinement/RefinedSurface.h"
#include "Support/RunControl.h"

#include <functional>
#include <limits>

namespace remesh
{
/** By what shapes of pieces are judged. */
struct PieceShapes
{
  /** Of a piece: above 0, the better the smaller. Called from several threads. */
  std::function<double(const FacetOrigin& piece)> energy;
  /** Edges between two pieces that both have no more energy than that are left alone. */
  double enough = 0.0;
  /** A facet with more energy than that is a needle: see RefinementLimits. */
  double needle = std::numeric_limits<double>::infinity();
};

/** Pieces of facets; those of each are one after the other. */
struct Pieces
{
  std::vector<Triple>& points;
  std::vector<FacetOrigin>& origins;
  std::vector<std::array<FeatureKind, 3>>& kinds; ///< of their sides, or empty
};

/**
 * @return false when cancelled: then pieces are of no use. Parallel, deterministic. O(F log F), and
 * the energies of about ten pieces each.
 */
[[nodiscard]] bool flipPieces(const PieceShapes& shapes, const RunControl& control, Pieces pieces);
}

#endif
