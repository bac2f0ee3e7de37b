/**
 * @file PatchSampling.h
 * @brief The first places of the free sites, so many for each patch as it will need.
 */
#ifndef remesh_PatchSampling_h
#define remesh_PatchSampling_h

#include "Features/FeatureSites.h"
#include "Optimization/Sampling.h"

namespace remesh
{
constexpr double cellArea = 0.86602540378443864676; ///< of a hexagon, over the spacing squared

/** The patches' sizes, in lengths as a density scales them. */
struct PatchSizes
{
  std::vector<double> area;
  std::vector<double> border; ///< length of the features around it, both sides of a slit

  /**
   * Free sites that a patch takes at some spacing, before rounding: as many as fill its area, less
   * the rows of half cells that the sites on its borders have.
   */
  double demand(std::size_t patch, double spacing) const;
  /** Of all patches. */
  double totalDemand(double spacing) const;
};

/** O(F). */
PatchSizes measurePatches(const FeaturedSurface& featured);

/**
 * Shares the free sites out to the patches. Sites do not leave their patch, so this must be right
 * from the start: each patch gets as many as fill its area at one common spacing, less the rows of
 * half cells that the sites on its borders have. Patches without border get at least four. Of
 * patches around the same vertices, as the two sides of a coin, all but the first get at least one,
 * or their triangles would be the same.
 *
 * @param wanted free sites in all; where closed patches need more, there are more.
 */
std::vector<Offset> shareOutSites(
  const FeaturedSurface& featured, const FeatureSites& featureSites, Offset wanted);

/**
 * Appends free sites to the fixed ones, drawn in each patch as sampleSurface does for the whole
 * surface. O(F + n log n).
 */
Status samplePatches(const FeaturedSurface& featured, const std::vector<Offset>& counts,
  const SiteDrawing& drawing, Sites& sites, const RunControl& control);
}

#endif
