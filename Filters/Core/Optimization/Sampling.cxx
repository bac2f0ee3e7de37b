#include "Optimization/Sampling.h"

#include "Embedding/CornerReader.h"
#include "Support/Grouping.h"
#include "Support/Random.h"

#include <algorithm>
#include <utility>

namespace remesh
{
namespace
{
enum Stream : std::uint64_t
{
  Along = 1,
  WithinU = 2,
  WithinV = 3
};

/** Barycentric coordinates of the point at `t` of a curve that fills a triangle evenly. */
void sierpinskiPoint(double t, double b[3])
{
  // The triangle is halved again and again: (start, end, apex) becomes (start, apex, middle) or
  // (apex, end, middle).
  double corners[3][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }; // start, end, apex
  for (int level = 0; level < 48; ++level)
  {
    double middle[3];
    for (int k = 0; k < 3; ++k)
    {
      middle[k] = 0.5 * (corners[0][k] + corners[1][k]);
    }
    t *= 2.0;
    const int replaced = t < 1.0 ? 1 : 0; // end or start gives way to the apex
    t -= t < 1.0 ? 0.0 : 1.0;
    for (int k = 0; k < 3; ++k)
    {
      corners[replaced][k] = corners[2][k];
      corners[2][k] = middle[k];
    }
  }
  std::copy_n(corners[2], 3, b);
}
}

FacetSampler::FacetSampler(const EmbeddedSurface& surface, const std::vector<double>& weights)
  : m_surface(surface)
  , m_running(weights.size())
{
  double sum = 0.0;
  for (std::size_t f = 0; f < weights.size(); ++f)
  {
    sum += weights[f];
    m_running[f] = sum;
  }
}

FacetSampler::FacetSampler(
  const EmbeddedSurface& surface, const std::vector<double>& weights, std::vector<Index> facets)
  : FacetSampler(surface, weights)
{
  m_facets = std::move(facets);
}

Index FacetSampler::find(double along, double& inside) const
{
  const double target = along * m_running.back();
  auto found = std::upper_bound(m_running.begin(), m_running.end(), target);
  if (found == m_running.end())
  {
    // Rounding put the target at the very end: the last facet that has weight.
    found = std::lower_bound(m_running.begin(), m_running.end(), m_running.back());
  }
  const double before = found == m_running.begin() ? 0.0 : *(found - 1);
  inside = std::clamp((target - before) / (*found - before), 0.0, 0x1.fffffffffffffp-1);
  const auto place = found - m_running.begin();
  return m_facets.empty() ? static_cast<Index>(place) : m_facets[place];
}

void FacetSampler::interpolate(Index facet, const double b[3], double* point) const
{
  CornerReader<Eigen::Dynamic> reader(m_surface);
  const auto corners = reader.facet(facet);
  for (int k = 0; k < m_surface.dimension; ++k)
  {
    point[k] = b[0] * corners[0][k] + b[1] * corners[1][k] + b[2] * corners[2][k];
  }
}

void FacetSampler::draw(double along, double u, double v, double* point) const
{
  double inside = 0.0;
  const Index facet = this->find(along, inside);
  if (u + v > 1.0)
  {
    u = 1.0 - u;
    v = 1.0 - v;
  }
  const double b[3] = { 1.0 - u - v, u, v };
  this->interpolate(facet, b, point);
}

void FacetSampler::drawOnCurve(double along, double* point) const
{
  double inside = 0.0;
  const Index facet = this->find(along, inside);
  double b[3];
  sierpinskiPoint(inside, b);
  this->interpolate(facet, b, point);
}

Status drawSites(const FacetSampler& sampler, Offset count, const SiteDrawing& drawing,
  Sites& sites, const RunControl& control)
{
  const Index first = sites.count();
  const std::uint64_t seed = drawing.seed;
  sites.coordinates.resize(sites.coordinates.size() +
    static_cast<std::size_t>(count) * static_cast<std::size_t>(sites.dimension));
  if (drawing.method == SamplingMethod::Stratified)
  {
    return forEachItem(count, control,
             [&](Offset i)
             {
               const double along = (static_cast<double>(i) + uniform01(seed, first + i, Along)) /
                 static_cast<double>(count);
               sampler.drawOnCurve(along, sites.site(static_cast<Index>(first + i)));
             })
      ? Status::success()
      : Status::cancelled();
  }
  std::vector<double> along(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < along.size(); ++i)
  {
    along[i] = uniform01(seed, first + i, Along);
  }
  std::sort(along.begin(), along.end());
  return forEachItem(count, control,
           [&](Offset i)
           {
             sampler.draw(along[i], uniform01(seed, first + i, WithinU),
               uniform01(seed, first + i, WithinV), sites.site(static_cast<Index>(first + i)));
           })
    ? Status::success()
    : Status::cancelled();
}

Status checkNumberOfSites(Offset numberOfSites)
{
  return numberOfSites < 1 || numberOfSites > maximumIndex
    ? Status::invalid("The number of points must be 1 to " + std::to_string(maximumIndex) +
        ", not " + std::to_string(numberOfSites) + ".")
    : Status::success();
}

Status sampleSurface(const EmbeddedSurface& surface, Offset numberOfSites,
  const SiteDrawing& drawing, Sites& sites, const RunControl& control)
{
  if (Status status = checkNumberOfSites(numberOfSites); !status.ok())
  {
    return status;
  }
  std::vector<double> weights(surface.constants.size());
  for (Index facet = 0; facet < surface.numberOfFacets(); ++facet)
  {
    weights[facet] = surface.siteMeasureOf(facet);
  }
  sites = Sites{};
  sites.dimension = surface.dimension;
  return drawSites(FacetSampler(surface, weights), numberOfSites, drawing, sites, control);
}

FacetSampler siteSampler(const EmbeddedSurface& surface, const std::vector<Index>& facets)
{
  std::vector<double> weights(facets.size());
  std::transform(facets.begin(), facets.end(), weights.begin(),
    [&](Index facet) { return surface.siteMeasureOf(facet); });
  return FacetSampler(surface, weights, facets);
}
}
