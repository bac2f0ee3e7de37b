/**
 * @file TestFacetSites.h
 * @brief Sites as a facet sees them, of all kinds that make exact decisions hard, and what the
 *        decisions about any of them must satisfy.
 *
 * A `Source` has `int below(int bound)` and `double fraction()`, in [0, 1) with all its bits.
 */
#ifndef remesh_TestFacetSites_h
#define remesh_TestFacetSites_h

#include "Embedding/Distance.h"
#include "TestExact.h"

#include <array>

namespace remesh::test
{
/** A facet in R^d and places of sites that tie, or nearly so; H values are rounded as elsewhere. */
template <class Source>
class FacetScene
{
public:
  using Point = std::vector<double>;

  explicit FacetScene(Source& source)
    : m_source(source)
    , m_dimension(source.below(3) == 0 ? 6 : 3)
    , m_size(std::ldexp(1.0, -source.below(40)))
  {
    // A facet next to the origin, or far from it against its size; now and then a sliver.
    const Point place = this->randomPoint(source.below(2) == 0 ? m_size : 1.0);
    const bool flat = source.below(3) == 0; // all in one plane of coordinates
    const bool sliver = source.below(6) == 0;
    for (Point& corner : m_corners)
    {
      corner = this->sum(place, this->randomPoint(m_size), 1.0);
      if (flat)
      {
        corner[2] = place[2];
      }
    }
    if (sliver)
    {
      m_corners[2] = this->sum(this->between(m_corners[0], m_corners[1], source.fraction()),
        this->randomPoint(m_size), 0x1p-30);
    }
    m_middle = this->between(m_corners[0],
      this->between(m_corners[1], m_corners[2], source.fraction()), source.fraction());
    m_reach = m_size * std::ldexp(1.0, source.below(8) - 4);
    m_normal = this->randomPoint(m_reach);
    m_kind = source.below(6);
  }

  FacetSite see(Index id, const Point& place) const
  {
    FacetSite seen{ id, {} };
    for (int k = 0; k < 3; ++k)
    {
      seen.h[k] = squaredDistance<Eigen::Dynamic>(place.data(), m_corners[k].data(), m_dimension);
    }
    return seen;
  }

  Point place()
  {
    switch (m_kind)
    {
      case 0: // on a circle about the middle, in the facet's plane
        return this->onCircle();
      case 1: // the same, pushed off the plane to either side
        return this->sum(this->onCircle(), m_normal, m_source.below(2) ? 1.0 : -1.0);
      case 2: // on a line: bisectors do not meet
        return this->sum(m_middle, m_normal, m_source.below(9) - 4.0);
      case 3: // on corners and on edges
      {
        const int k = m_source.below(3);
        const double along = m_source.below(2) ? 0.0 : m_source.below(5) / 4.0;
        return this->between(m_corners[k], m_corners[(k + 1) % 3], along);
      }
      case 4: // a grid
        return this->sum(
          this->sum(m_corners[0], this->sum(m_corners[1], m_corners[0], -1.0), m_source.below(4)),
          this->sum(m_corners[2], m_corners[0], -1.0), m_source.below(4));
      default:
        return this->sum(m_middle, this->randomPoint(m_reach), 1.0);
    }
  }

private:
  Point randomPoint(double size)
  {
    Point point;
    for (int k = 0; k < m_dimension; ++k)
    {
      point.push_back(size * (2.0 * m_source.fraction() - 1.0));
    }
    return point;
  }

  Point sum(const Point& a, const Point& b, double factor) const
  {
    Point result = a;
    for (int k = 0; k < m_dimension; ++k)
    {
      result[k] += factor * b[k];
    }
    return result;
  }

  Point between(const Point& a, const Point& b, double t) const
  {
    Point result = a;
    for (int k = 0; k < m_dimension; ++k)
    {
      result[k] = (1.0 - t) * a[k] + t * b[k];
    }
    return result;
  }

  /** Orthonormal directions in the facet's plane, but for rounding; any, if it is a sliver. */
  Point onCircle()
  {
    const auto dot = [this](const Point& a, const Point& b)
    {
      double value = 0.0;
      for (int k = 0; k < m_dimension; ++k)
      {
        value += a[k] * b[k];
      }
      return value;
    };
    const Point zero(static_cast<std::size_t>(m_dimension), 0.0);
    const auto unit = [&](const Point& a)
    { return this->sum(zero, a, 1.0 / std::max(1e-290, std::sqrt(dot(a, a)))); };
    const Point u = unit(this->sum(m_corners[1], m_corners[0], -1.0));
    const Point edge = this->sum(m_corners[2], m_corners[0], -1.0);
    const Point v = unit(this->sum(edge, u, -dot(u, edge)));
    const double angle = m_source.below(2) ? 6.2831853071795862 * m_source.fraction()
                                           : 0.78539816339744828 * m_source.below(8);
    return this->sum(
      this->sum(m_middle, u, m_reach * std::cos(angle)), v, m_reach * std::sin(angle));
  }

  Source& m_source;
  int m_dimension;
  double m_size;
  int m_kind = 0;
  std::array<Point, 3> m_corners;
  Point m_middle;
  Point m_normal;
  double m_reach = 0.0;
};

/** H values from a scene, from small integers, or of all magnitudes. */
template <class Source>
std::vector<FacetSite> anyFacetSites(Source& source, int count)
{
  std::vector<FacetSite> sites;
  const int kind = source.below(8);
  const double scale = std::ldexp(1.0, source.below(120) - 100);
  const double largest = 2.0 + source.below(5);
  const double digits = std::ldexp(1.0, source.below(54));
  FacetScene<Source> scene(source);
  for (Index id = 0; id < count; ++id)
  {
    FacetSite site{ id, {} };
    for (double& h : site.h)
    {
      h = kind == 0 ? scale * std::floor(largest * source.fraction())
        : kind == 1 ? scale * (std::floor(largest * source.fraction()) + 1.0 / 3.0)
        : kind == 2 ? scale * (1.0 + std::floor(digits * source.fraction()) / digits)
                    : std::ldexp(source.fraction(), -source.below(256));
    }
    sites.push_back(kind < 4 ? site : scene.see(id, scene.place()));
  }
  return sites;
}

/** Ties and near ties: copies, plane combinations of others, and the last bits changed. */
template <class Source>
void disturb(std::vector<FacetSite>& sites, Source& source)
{
  const int count = static_cast<int>(sites.size());
  const auto any = [&]() -> FacetSite& { return sites[source.below(count)]; };
  for (int times = source.below(3); times > 0; --times)
  {
    FacetSite& site = any();
    const FacetSite a = any(), b = any(), c = any();
    const double along = source.below(5) - 2.0;
    const double shift = source.below(2) ? 0.0 : site.h[source.below(3)];
    const int kind = source.below(4);
    for (int k = 0; k < 3; ++k)
    {
      const double combined = a.h[k] + along * (b.h[k] - a.h[k]) + (c.h[k] - b.h[k]);
      site.h[k] = kind == 0 ? a.h[k] : kind == 1 ? std::abs(combined) : site.h[k];
      // The same all over: the cells of two sites meet nowhere.
      site.h[k] = kind == 2 ? a.h[k] + shift : site.h[k];
      if (source.below(3) == 0)
      {
        site.h[k] = std::abs(std::nextafter(site.h[k], source.below(2) ? 1e300 : -1e300));
      }
      site.h[k] = site.h[k] < 0x1p-300 ? 0.0 : site.h[k]; // where exactness ends
    }
  }
}

/** Gives the sites ids in any order, with gaps. */
template <class Source>
void shuffleIds(std::vector<FacetSite>& sites, Source& source)
{
  for (int s = static_cast<int>(sites.size()); s > 1; --s)
  {
    std::swap(sites[s - 1].id, sites[source.below(s)].id);
  }
  for (FacetSite& site : sites)
  {
    site.id = 5 * site.id + 2;
  }
}

struct DecisionCount
{
  long wrong = 0;
  long corners = 0;
  long edges = 0;
  long inside = 0;
};

/** At each corner: as in exact arithmetic, and one of the two wins. */
inline void checkCornerDecisions(
  const std::vector<FacetSite>& s, const ExactSites& exact, int q, int i, DecisionCount& count)
{
  for (int k = 0; k < 3; ++k)
  {
    const bool beats = beatsAtCorner(s[q], s[i], k);
    const int expected = exact.atCorner(q, i, k);
    count.wrong += expected == 0 || beats != (expected < 0);
    count.wrong += beats == beatsAtCorner(s[i], s[q], k);
    ++count.corners;
  }
}

/** Where i and j change places on an edge: q beats both or none, as in exact arithmetic. */
inline void checkEdgeDecisions(const std::vector<FacetSite>& s, const ExactSites& exact, int q,
  int i, int j, DecisionCount& count)
{
  for (int k = 0; k < 3; ++k)
  {
    const bool leaving = exact.atCorner(i, j, k) < 0;
    if (leaving == (exact.atCorner(i, j, (k + 1) % 3) < 0))
    {
      continue;
    }
    const bool beats = beatsOnEdge(s[q], s[i], s[j], k, leaving);
    const int expected = exact.onEdge(q, i, j, k);
    count.wrong += expected == 0 || beats != (expected < 0);
    count.wrong += beats != beatsOnEdge(s[q], s[j], s[i], k, !leaving);
    ++count.edges;
  }
}

/** Where three meet: q beats all or none of them, as in exact arithmetic. */
inline void checkInsideDecisions(const std::vector<FacetSite>& s, const ExactSites& exact, int q,
  int i, int j, int m, DecisionCount& count)
{
  const int sense = exact.orientation(i, j, m);
  if (sense == 0)
  {
    return;
  }
  if (sense < 0)
  {
    std::swap(j, m);
  }
  const bool beats = beatsInside(s[q], s[i], s[j], s[m]);
  const int expected = exact.inside(q, i, j, m);
  count.wrong += expected == 0 || beats != (expected < 0);
  count.wrong += beats != beatsInside(s[q], s[j], s[m], s[i]);
  count.wrong += beats != beatsInside(s[q], s[m], s[i], s[j]);
  ++count.inside;
}

/** All decisions about four sites. */
inline void checkDecisions(const std::vector<FacetSite>& sites, DecisionCount& count)
{
  const ExactSites exact(sites);
  for (int q = 0; q < 4; ++q)
  {
    const int i = (q + 1) % 4;
    const int j = (q + 2) % 4;
    const int m = (q + 3) % 4;
    checkCornerDecisions(sites, exact, q, i, count);
    checkEdgeDecisions(sites, exact, q, i, j, count);
    checkInsideDecisions(sites, exact, q, i, j, m, count);
  }
}
}

#endif
