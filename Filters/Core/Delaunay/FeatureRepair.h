/**
 * @file FeatureRepair.h
 * @brief Where other cells reach a feature curve, it gets places between its own.
 */
#ifndef remesh_FeatureRepair_h
#define remesh_FeatureRepair_h

#include "Delaunay/Collar.h"

namespace remesh
{
/**
 * A site whose cell reaches a curve between two of the curve's sites shows that the curve is too
 * coarse there: the curve gets a place at the point nearest to it, or, if the site is on another
 * curve that meets it in a corner, as far from that (CurveLevel.h). A free site is to go for it, so
 * that the number of vertices stays; one on a feature is not. Each section is divided once at
 * most, where it can be by the cell nearest to its middle.
 *
 * Then the curves are kept apart again (see separateCurves), those with new places from each other
 * and from the rest, or all where they are not yet; no free site goes for these places.
 *
 * @param intrusions as the seams have them, or coarse sections.
 * @param areApart the curves were before, as far as that is possible.
 * @param mostPoints vertices on features, to keep curves apart.
 * @param featureSites are brought up to date; `sites` are to follow (replaceFixed).
 * @param joining the free sites that are to go.
 * @return the number of new places on the curves.
 */
Index refineCurves(const FeaturedSurface& featured, const std::vector<Intrusion>& intrusions,
  const Sites& sites, bool areApart, Offset mostPoints, const RunControl& control,
  FeatureSites& featureSites, std::vector<Index>& joining);

/**
 * Where inverted triangles show that a curve is too coarse: it passes a corner of theirs
 * (PassedPoints.h), or one joins a section of it with a cell, of another site on a feature, that
 * reaches it.
 *
 * @return such cells; for a corner that is passed, its own, with its foot in R^3 and no distance.
 * Of no use when cancelled.
 */
std::vector<Intrusion> coarseSections(const std::vector<Triple>& inverted,
  const Components& components, const Seams& seams, const FeaturedSurface& featured,
  const FeatureSites& featureSites, const RunControl& control = RunControl());

/** Puts these in the place of the fixed sites. */
void replaceFixed(const FeatureSites& featureSites, Sites& sites);
}

#endif
