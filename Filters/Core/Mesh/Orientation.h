/**
 * @file Orientation.h
 * @brief One sense of rotation for each shell of a surface, where there is one.
 */
#ifndef remesh_Orientation_h
#define remesh_Orientation_h

#include "Mesh/EdgeTable.h"

#include <vector>

namespace remesh
{
struct Orientation
{
  std::vector<unsigned char> flipped; ///< F, 1: the facet must be turned round
  Offset numberOfFlipped = 0;
  bool orientable = true; ///< no shell is one-sided
};

/**
 * Whether all facets agree across the edges of exactly two already: then nothing is to be turned.
 *
 * @param control asked for cancellation; false when cancelled.
 * Cost: O(F), in parallel.
 */
bool isOriented(const std::vector<Triple>& facetPoints, const EdgeTable& edges,
  const RunControl& control = RunControl());

/**
 * Makes the facets of each shell agree across their common edges. A shell is what one reaches
 * through edges of exactly two facets; edges of more facets separate shells.
 *
 * Of the two orientations a shell takes that of the larger share of its area (a tie within
 * rounding: that of its first facet), so a consistent input stays as it is, inside out or not. A
 * one-sided shell (Moebius strip) is left as it was.
 *
 * @param facetAreas F, in any unit, above or equal to 0.
 * Cost: O(F). Deterministic.
 */
Orientation findOrientation(const std::vector<Triple>& facetPoints, const EdgeTable& edges,
  const std::vector<double>& facetAreas);
}

#endif
