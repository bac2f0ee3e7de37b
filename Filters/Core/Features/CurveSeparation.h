/**
 * @file CurveSeparation.h
 * @brief Places on curves that lie close to each other, so that each curve keeps its own cells.
 *
 * The dual ends on a curve only where the cells that reach it are those of the curve's own sites,
 * each in the stretch that is nearest to it along the curve. Between two curves closer to each
 * other than their sites are spaced this needs sites opposite each other.
 */
#ifndef remesh_CurveSeparation_h
#define remesh_CurveSeparation_h

#include "Features/FeatureSites.h"
#include "Support/RunControl.h"

namespace remesh
{
/** What curves may take to be kept apart. */
struct CurveRoom
{
  Offset maxPoints; ///< vertices on features
  double spacing;   ///< of the sites, in R^d; sections shorter than a fiftieth are left
};

/**
 * Adds places, with their sites, to the curves until no site of theirs is nearer, in R^d, to a
 * place of a curve than the curve's own site there, or until there is no more room for
 * vertices; none at all where these would not get half of the sites away.
 *
 * A curve is divided at the foot of a site that is too near; where the curves of both meet in a
 * corner, at the site's distance from the corner. At a corner where the metrics of several sides
 * contradict each other, sites of one curve can stay too near to another.
 *
 * @param curves of each curve, whether it is looked after: those that got places since the others
 *        were kept apart, as far as that was possible, and all that get some on the way.
 * @param sites on the features; those of the added places join them.
 * @param control asked for cancellation; then some sites may still be too near.
 * @return the number of places added.
 * Cost: some rounds, one where nothing is too near, each O(V + F), and a neighbour search for each
 * edge of the curves.
 */
Index separateCurves(const FeaturedSurface& featured, std::vector<char> curves,
  const CurveRoom& room, const RunControl& control, FeatureSites& sites);
}

#endif
