/**
 * @file FeatureRepair.h
 * @brief Where free sites reach a feature curve, they join it.
 */
#ifndef remesh_FeatureRepair_h
#define remesh_FeatureRepair_h

#include "Delaunay/Collar.h"

namespace remesh
{
/**
 * A free site whose cell reaches a curve between two of the curve's sites shows that the curve is
 * too coarse there: the curve gets a place at the point nearest to it, and the free site is to go,
 * so that the number of vertices stays. At most one of them divides a section.
 *
 * Then the curves are kept apart again (see separateCurves); no free site goes for these places.
 *
 * @param mostPoints vertices on features, to keep curves apart.
 * @param stations, featureSites are brought up to date; `sites` are to follow (replaceFixed).
 * @param joining the free sites that are to go.
 * @return the number of new places on the curves.
 */
Index refineCurves(const SurfaceMesh& mesh, const EmbeddedSurface& surface,
  const Features& features, const Seams& seams, const Sites& sites, Offset mostPoints,
  const RunControl& control, Stations& stations, FeatureSites& featureSites,
  std::vector<Index>& joining);

/** Puts these in the place of the fixed sites. */
void replaceFixed(const FeatureSites& featureSites, Sites& sites);
}

#endif
