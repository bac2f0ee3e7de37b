/**
 * @file FeatureRepair.h
 * @brief Gives feature curves new places where cells that are not theirs reach them.
 */
#ifndef remesh_FeatureRepair_h
#define remesh_FeatureRepair_h

#include "Delaunay/Collar.h"

namespace remesh
{
/** What refinedCurves did. */
struct RefinedCurves
{
  Index places = 0;           ///< new ones on the curves
  std::vector<char> curves;   ///< whether each curve has got any
  std::vector<Index> joining; ///< free sites that are to go
};

/**
 * If a cell reaches a curve between two of the curve's sites, the curve is too coarse there:
 *
 * 1. The curve gets a place at its point nearest to the cell's site. If that site is on another
 *    curve, which meets this one in a corner, the place is as far from the corner as the site is
 *    (CurveLevel.h).
 * 2. If the site is free, it is to go, so that the number of vertices stays. A site on a feature
 *    stays.
 * 3. Each section of a curve is divided once at most. If several cells reach it, that one counts
 *    which is nearest to its middle and can divide it.
 *
 * Curves with new places may no longer be apart from others: see separateCurves.
 *
 * @param intrusions those of the seams, or what coarseSections returns.
 * @param featureSites are brought up to date. All sites must follow: see replaceFixed.
 */
RefinedCurves refinedCurves(const FeaturedSurface& featured,
  const std::vector<Intrusion>& intrusions, FeatureSites& featureSites);

/**
 * Finds where inverted triangles show that a curve is too coarse. There are two signs of it: a
 * chord of the curve passes a corner of such a triangle (PassedPoints.h); or the triangle joins a
 * section of the curve with the cell of another site on a feature, which reaches the section.
 *
 * @return for the first sign, the cell of the corner, with its foot in R^3 and no distance; for the
 *         second, the cell that reaches the section. Of no use when cancelled.
 */
std::vector<Intrusion> coarseSections(const std::vector<Triple>& inverted, const Seams& seams,
  const FeaturedSurface& featured, const FeatureSites& featureSites,
  const RunControl& control = RunControl());

/** Replaces the fixed sites by those of `featureSites`. */
void replaceFixed(const FeatureSites& featureSites, Sites& sites);
}

#endif
