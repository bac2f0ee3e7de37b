/**
 * @file NearbySites.h
 * @brief The sites near each of many sites, found by one search for each few that lie together.
 *
 * A search of the trees for each site would spend most of its time on the way to the same leaves.
 */
#ifndef remesh_NearbySites_h
#define remesh_NearbySites_h

#include "Voronoi/NeighborSearch.h"
#include "Voronoi/SiteDistances.h"

#include <algorithm>

namespace remesh
{
/** One thread's work on one range of sites after the other. */
class NearbySites
{
public:
  /** The sites are those of the search. */
  NearbySites(const NeighborSearch& search, const Sites& sites)
    : m_search(search)
    , m_sites(sites)
    , m_lower(static_cast<std::size_t>(sites.dimension))
    , m_upper(m_lower)
    , m_middle(m_lower)
  {
  }

  /**
   * Calls `visit(site, radius)` for the sites [begin, end), those that lie together one after the
   * other; it may ask for the sites within the radius. O(log of their number) for each, and a
   * search for each few.
   *
   * @param radius of a site, not negative; asked more than once, before those that lie together are
   *        visited. It may depend on earlier visits.
   */
  template <class Radius, class Visit>
  void forEach(const Index* begin, const Index* end, const Radius& radius, const Visit& visit)
  {
    m_order.assign(begin, end);
    this->forEachOf(m_order.data(), m_order.data() + m_order.size(), radius, visit);
  }

  /** The sites nearer than its `radius` to the site that is visited, in an order that is fixed. */
  void within(Index site, double radius, std::vector<Neighbor>& found);

private:
  static constexpr std::ptrdiff_t maxTogether = 16;
  static constexpr double farthestTogether = 1.2; ///< from their middle, in radii
  static constexpr std::size_t maxCandidates = 512;

  template <class Radius, class Visit>
  void forEachOf(Index* begin, Index* end, const Radius& radius, const Visit& visit)
  {
    if (begin == end)
    {
      return;
    }
    const int axis = this->measure(begin, end);
    double reach = 0.0;
    if (end - begin <= maxTogether && this->lieTogether(begin, end, radius(*begin), reach))
    {
      double radii[maxTogether] = {};
      std::transform(begin, end, radii, radius);
      if (this->gather(end - begin, reach, *std::max_element(radii, radii + (end - begin))))
      {
        for (const Index* site = begin; site != end; ++site)
        {
          visit(*site, radii[site - begin]);
        }
        return;
      }
    }
    Index* middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end,
      [&](Index a, Index b)
      {
        const double x = m_sites.site(a)[axis];
        const double y = m_sites.site(b)[axis];
        return x != y ? x < y : a < b;
      });
    this->forEachOf(begin, middle, radius, visit);
    this->forEachOf(middle, end, radius, visit);
  }

  int measure(const Index* begin, const Index* end);
  bool lieTogether(const Index* begin, const Index* end, double radius, double& reach);
  bool gather(std::ptrdiff_t together, double reach, double radius);

  const NeighborSearch& m_search;
  const Sites& m_sites;
  SiteDistanceEvaluation m_evaluate = siteDistanceEvaluation(widestInstructionSet());
  std::vector<Index> m_order;
  std::vector<double> m_lower;  ///< d, of the box around the sites in hand
  std::vector<double> m_upper;  ///< d
  std::vector<double> m_middle; ///< d
  std::vector<Neighbor> m_candidates;
  std::vector<double> m_coordinates; ///< of the candidates, see SiteDistances
  std::vector<double> m_squared;
  std::vector<Neighbor> m_near; ///< scratch
};
}

#endif
