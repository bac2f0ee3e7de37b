#include "Optimization/Sampling.h"

#include "Support/Random.h"

#include <algorithm>

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
  return static_cast<Index>(found - m_running.begin());
}

void FacetSampler::interpolate(Index facet, const double b[3], double* point) const
{
  const Triple& corners = m_surface.facetCorners[facet];
  for (int k = 0; k < m_surface.dimension; ++k)
  {
    point[k] = b[0] * m_surface.corner(corners[0])[k] + b[1] * m_surface.corner(corners[1])[k] +
      b[2] * m_surface.corner(corners[2])[k];
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

Status sampleSurface(const EmbeddedSurface& surface, Offset numberOfSites, SamplingMethod method,
  std::uint64_t seed, Sites& sites)
{
  if (numberOfSites < 1 || numberOfSites > maximumIndex)
  {
    return Status::invalid("The number of points must be 1 to " + std::to_string(maximumIndex) +
      ", not " + std::to_string(numberOfSites) + ".");
  }
  std::vector<double> weights(surface.constants.size());
  std::transform(surface.constants.begin(), surface.constants.end(), weights.begin(),
    [](const FacetConstants& facet) { return facet.mass; });
  const FacetSampler sampler(surface, weights);
  sites.dimension = surface.dimension;
  sites.coordinates.resize(
    static_cast<std::size_t>(numberOfSites) * static_cast<std::size_t>(surface.dimension));

  const auto n = static_cast<std::size_t>(numberOfSites);
  std::vector<double> along(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    along[i] = uniform01(seed, i, Along);
    if (method == SamplingMethod::Stratified)
    {
      along[i] = (static_cast<double>(i) + along[i]) / static_cast<double>(n);
    }
  }
  if (method == SamplingMethod::Stratified)
  {
    for (std::size_t i = 0; i < n; ++i)
    {
      sampler.drawOnCurve(along[i], sites.site(static_cast<Index>(i)));
    }
    return Status::success();
  }
  std::sort(along.begin(), along.end());
  for (std::size_t i = 0; i < n; ++i)
  {
    sampler.draw(along[i], uniform01(seed, i, WithinU), uniform01(seed, i, WithinV),
      sites.site(static_cast<Index>(i)));
  }
  return Status::success();
}
}
