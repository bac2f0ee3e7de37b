/**
 * @file CurveAlignment.h
 * @brief Places of curves beside each other, such as the rims of a thin plate, opposite each other.
 *
 * Two curves closer to each other than their places are spaced need places opposite each other
 * (CurveSeparation.h). Each divided for itself, both would get those of the other besides its own.
 */
#ifndef remesh_CurveAlignment_h
#define remesh_CurveAlignment_h

#include "Features/CurveSampling.h"
#include "Features/FeatureSites.h"

namespace remesh
{
/**
 * Of two curves, the later one gives way: where sites of the earlier one, or corners, are nearer to
 * it, in R^d, than half of the distance between its own places, it is divided anew, with places
 * opposite them: at their feet, or as far as they are from a corner that both curves share
 * (CurveLevel.h). Feet that are closer to each other than to their sites are passed over, and curves
 * that would take a quarter more places stay as they are.
 *
 * @param sites of the sampler's stations; brought up to date with them.
 * @param control asked for cancellation from round to round.
 * Cost: some rounds, the later ones where there are curves beside curves, each O(V + F), and a
 * neighbour search for each edge of the curves.
 */
void alignCurves(const FeaturedSurface& featured, const RunControl& control, CurveSampler& sampler,
  FeatureSites& sites);
}

#endif
