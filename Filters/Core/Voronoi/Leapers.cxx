#include "Voronoi/Leapers.h"

#include "Embedding/Distance.h"
#include "Support/FloatBounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace remesh
{
namespace
{
constexpr std::size_t most = 32;
constexpr std::size_t sitesForOne = 256;
constexpr double infinity = std::numeric_limits<double>::infinity();

/** The coordinates of some sites as SiteDistances wants them; far away where a group has none. */
std::vector<double> packGroups(const Sites& sites, const std::vector<Index>& some)
{
  const auto d = static_cast<std::size_t>(sites.dimension);
  const std::size_t groups = (some.size() + lanes - 1) / lanes;
  std::vector<double> coordinates(groups * lanes * d, infinity);
  for (std::size_t k = 0; k < some.size(); ++k)
  {
    for (std::size_t m = 0; m < d; ++m)
    {
      coordinates[(k / lanes * d + m) * lanes + k % lanes] = sites.site(some[k])[m];
    }
  }
  return coordinates;
}
}

double Leapers::find(const Sites& sites, const std::vector<double>& displacements)
{
  m_sites.resize(displacements.size());
  std::iota(m_sites.begin(), m_sites.end(), 0);
  const auto last = m_sites.begin() +
    static_cast<std::ptrdiff_t>(std::min(most, displacements.size() / sitesForOne));
  std::nth_element(m_sites.begin(), last, m_sites.end(),
    [&](Index a, Index b)
    { return displacements[a] != displacements[b] ? displacements[a] > displacements[b] : a < b; });
  const double usual = displacements[*last];
  m_sites.erase(last, m_sites.end());
  m_coordinates = packGroups(sites, m_sites);
  return usual;
}

float Leapers::nearestTo(const Sites& sites, Index site) const
{
  double squared[most];
  const auto groups = static_cast<int>((m_sites.size() + lanes - 1) / lanes);
  m_evaluate({ m_coordinates.data(), groups, sites.dimension, sites.site(site), squared });
  const auto own = std::find(m_sites.begin(), m_sites.end(), site);
  if (own != m_sites.end())
  {
    squared[own - m_sites.begin()] = infinity;
  }
  double nearest = infinity;
  for (int group = 0; group < groups; ++group)
  {
    nearest = std::min(nearest, minOfLanes(squared + group * lanes));
  }
  return roundedDown(std::sqrt(nearest) / aboveRounding);
}
}
