/**
 * @file EdgeSplit.h
 * @brief Splits edges of a surface at their middles, and the facets at them, so that all fits.
 */
#ifndef remesh_EdgeSplit_h
#define remesh_EdgeSplit_h

#include "Refinement/PieceFlips.h"
#include "Support/RunControl.h"

namespace remesh
{
/** Which edges are to be split. */
struct EdgesToSplit
{
  std::vector<double> lengths; ///< E, above 0: by what the shape of facets is judged
  std::vector<char> marked;    ///< E
  /** F, or empty: facets in which the longest side need not be marked where another one is. */
  std::vector<char> open;

  bool isOpen(Index facet) const { return !this->open.empty() && this->open[facet] != 0; }
  /** Whether an edge is longer than another one; there are no equal ones. */
  bool isLonger(Index edge, Index other) const
  {
    return this->lengths[edge] != this->lengths[other] ? this->lengths[edge] > this->lengths[other]
                                                       : edge < other;
  }
};

/** Which of the facet's sides is the longest. */
int longestSide(const Triple& facetEdges, const EdgesToSplit& wanted);

/**
 * Marks the longest side of each facet that has a marked one, and so on from there, but in open
 * ones: facets stay about as well shaped as they were, and their sizes change gradually (M.-C.
 * Rivara, "Mesh refinement processes based on the generalized bisection of simplices", 1984). O(E).
 */
void closeMarks(const EdgeTable& edges, EdgesToSplit& wanted);

/**
 * Splits all marked edges; the marks must be closed. A facet with one becomes two, with two three,
 * with three four of its shape; the first cut is at the middle of the longest side that is split.
 * All others stay, and so does the order of facets; points are numbered as the facets meet them.
 *
 * @param edges of the surface's points; where there are features, theirs.
 * @param shapes if given, edges between the pieces of a facet are flipped by these.
 * @param control asked for cancellation: then the surface is of no use.
 * Cost: O(F). Deterministic.
 */
void splitEdges(const EdgeTable& edges, const EdgesToSplit& wanted, const PieceShapes* shapes,
  const RunControl& control, RefinedSurface& surface);
}

#endif
