#include "Voronoi/NearbySites.h"

#include "Embedding/Distance.h"

#include <cmath>

namespace remesh
{
/** The box around some sites, and its longest side. */
int NearbySites::measure(const Index* begin, const Index* end)
{
  const double* first = m_sites.site(*begin);
  std::copy_n(first, m_lower.size(), m_lower.begin());
  std::copy_n(first, m_upper.size(), m_upper.begin());
  for (const Index* site = begin + 1; site != end; ++site)
  {
    const double* x = m_sites.site(*site);
    for (std::size_t k = 0; k < m_lower.size(); ++k)
    {
      m_lower[k] = std::min(m_lower[k], x[k]);
      m_upper[k] = std::max(m_upper[k], x[k]);
    }
  }
  int longest = 0;
  for (std::size_t k = 1; k < m_lower.size(); ++k)
  {
    longest =
      m_upper[k] - m_lower[k] > m_upper[longest] - m_lower[longest] ? static_cast<int>(k) : longest;
  }
  return longest;
}

/** Whether one search serves all, and how far they are from the middle of their box. */
bool NearbySites::lieTogether(const Index* begin, const Index* end, double radius, double& reach)
{
  std::transform(m_lower.begin(), m_lower.end(), m_upper.begin(), m_middle.begin(),
    [](double lower, double upper) { return 0.5 * (lower + upper); });
  double farthest = 0.0;
  for (const Index* site = begin; site != end; ++site)
  {
    farthest = std::max(farthest,
      squaredDistance<Eigen::Dynamic>(m_sites.site(*site), m_middle.data(), m_sites.dimension));
  }
  reach = std::sqrt(farthest);
  return end - begin == 1 || reach <= farthestTogether * radius;
}

/** Looks up what can be near any of the sites in hand; false if that is too much for many. */
bool NearbySites::gather(std::ptrdiff_t together, double reach, double radius)
{
  m_search.within(m_middle.data(), aboveRounding * (reach + radius), m_candidates);
  if (together > 1 && m_candidates.size() > maxCandidates)
  {
    return false;
  }
  const auto d = static_cast<std::size_t>(m_sites.dimension);
  const std::size_t groups = (m_candidates.size() + lanes - 1) / lanes;
  m_coordinates.assign(groups * lanes * d, 0.0);
  m_squared.resize(groups * lanes);
  for (std::size_t c = 0; c < m_candidates.size(); ++c)
  {
    const double* x = m_sites.site(m_candidates[c].site);
    double* to = m_coordinates.data() + c / lanes * lanes * d + c % lanes;
    for (std::size_t k = 0; k < d; ++k)
    {
      to[k * lanes] = x[k];
    }
  }
  return true;
}

void NearbySites::within(Index site, double radius, std::vector<Neighbor>& found)
{
  m_evaluate({ m_coordinates.data(), static_cast<int>(m_squared.size() / lanes), m_sites.dimension,
    m_sites.site(site), m_squared.data() });
  const double most = radius * radius;
  if (m_near.size() < m_candidates.size())
  {
    m_near.resize(m_candidates.size());
  }
  std::ptrdiff_t count = 0;
  for (std::size_t c = 0; c < m_candidates.size(); ++c)
  {
    m_near[count] = { m_candidates[c].site, m_squared[c] };
    count += m_squared[c] < most ? 1 : 0; // no branch to foresee
  }
  found.assign(m_near.begin(), m_near.begin() + count);
  for (Neighbor& neighbor : found)
  {
    neighbor.distance = std::sqrt(neighbor.distance);
  }
}
}
