/**
 * @file Sampling.h
 * @brief The first sites: points drawn evenly from the surface in R^d.
 */
#ifndef remesh_Sampling_h
#define remesh_Sampling_h

#include "Embedding/EmbeddedSurface.h"
#include "Support/RunControl.h"
#include "Support/Status.h"

#include <cstdint>

namespace remesh
{
enum class SamplingMethod
{
  Random,    ///< [Levy12] Algorithm 4
  Stratified ///< one site in each of n strata of equal area along a space-filling curve
};

/** How sites are drawn. */
struct SiteDrawing
{
  SamplingMethod method;
  std::uint64_t seed;
};

/** InvalidInput for n < 1 or more sites than an Index holds. */
Status checkNumberOfSites(Offset numberOfSites);

/**
 * Draws n sites, each uniformly distributed over the surface's area in R^d; with a density, over
 * the measure that the sites of a centroidal Voronoi tessellation are spread evenly over.
 *
 * Random: facets by sorted random numbers against the running area (with the first facet's area
 * counted from the start), a point of the facet by Turk's method (Graphics Gems, 1990).
 * Stratified: the i-th number is drawn from [i, i + 1) / n, and its place within the facet's share
 * is mapped to the facet along a Sierpinski curve, which keeps area.
 *
 * Sites come out in the order of the facets. Deterministic in (seed, n, surface). O(F + n log n),
 * in parallel but for the running area.
 *
 * @return InvalidInput for n < 1 or more sites than an Index holds.
 */
Status sampleSurface(const EmbeddedSurface& surface, Offset numberOfSites,
  const SiteDrawing& drawing, Sites& sites, const RunControl& control = RunControl());

/** Draws points with a probability proportional to a weight per facet, uniform within a facet. */
class FacetSampler
{
public:
  /** @param weights F values >= 0, not all 0. */
  FacetSampler(const EmbeddedSurface& surface, const std::vector<double>& weights);

  /** @param facets those to draw from, in the order along which numbers are mapped to them. */
  FacetSampler(
    const EmbeddedSurface& surface, const std::vector<double>& weights, std::vector<Index> facets);

  /** The point (d) for three numbers of [0, 1): where among the facets, and where within one. */
  void draw(double along, double u, double v, double* point) const;

  /** The point for one number, along the facets and along the Sierpinski curve within one. */
  void drawOnCurve(double along, double* point) const;

private:
  /** Facet that holds a fraction of the total weight; `inside` is where, in [0, 1). */
  Index find(double along, double& inside) const;
  void interpolate(Index facet, const double b[3], double* point) const;

  const EmbeddedSurface& m_surface;
  std::vector<double> m_running; ///< running sums of the weights
  std::vector<Index> m_facets;   ///< what the sums stand for; empty: all facets
};

/** Draws from some facets as sampleSurface does from all, by their measure. O(facets). */
FacetSampler siteSampler(const EmbeddedSurface& surface, const std::vector<Index>& facets);

/**
 * Draws so many further sites; their dimension is that of the surface.
 * The random numbers are those of the sites' ids. O(n log n).
 */
Status drawSites(const FacetSampler& sampler, Offset count, const SiteDrawing& drawing,
  Sites& sites, const RunControl& control);
}

#endif
