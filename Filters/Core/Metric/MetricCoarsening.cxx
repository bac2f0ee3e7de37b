#include "Metric/MetricCoarsening.h"

#include "Mesh/EdgeTable.h"
#include "Metric/FacetStar.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
constexpr double goodEnough = 0.3;         // quality of triangles, 1 for equal sides
constexpr double minShare = 0.01;          // of the points, that a pass is to remove
constexpr Index pointsBetweenLooks = 1024; // at whether the run is cancelled

class Coarsening
{
public:
  Coarsening(const ShapedFacets& surface, double longest)
    : m_longest(longest)
    , m_states(static_cast<std::size_t>(surface.points), State::Open)
  {
    const std::size_t count = surface.facetPoints.size();
    m_facets.points.assign(surface.facetPoints.begin(), surface.facetPoints.end());
    m_facets.lengths.resize(count);
    m_facets.across.assign(count, { noIndex, noIndex, noIndex });
    m_facets.cornerOfPoint.assign(static_cast<std::size_t>(surface.points), noIndex);
    for (std::size_t f = 0; f < m_facets.lengths.size(); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        m_facets.lengths[f][k] = std::sqrt(surface.shapes[f].edge2(k));
      }
    }
  }

  bool run(const RunControl& control)
  {
    const EdgeTable edges = buildEdgeTable(m_facets.points, control);
    if (control.cancelled())
    {
      return false;
    }
    this->join(edges);
    const auto count = static_cast<Index>(m_states.size());
    std::size_t last = 0;
    do
    {
      last = m_removed.size();
      for (Index point = 0; point < count; ++point)
      {
        if (point % pointsBetweenLooks == 0 && control.cancelled())
        {
          return false;
        }
        if (m_states[point] == State::Open)
        {
          m_states[point] = State::Tried;
          this->tryPoint(point);
        }
      }
      std::replace(m_states.begin(), m_states.end(), State::Waiting, State::Open);
    } while (static_cast<double>(m_removed.size() - last) > minShare * count);
    return true;
  }

  void take(CoarseSurface& coarse)
  {
    std::vector<Index> numbers(m_states.size(), noIndex);
    for (std::size_t p = 0; p < m_states.size(); ++p)
    {
      if (m_states[p] != State::Removed)
      {
        numbers[p] = static_cast<Index>(coarse.points.size());
        coarse.points.push_back(static_cast<Index>(p));
      }
    }
    for (std::size_t f = 0; f < m_facets.points.size(); ++f)
    {
      const Triple& points = m_facets.points[f];
      if (points[0] != noIndex)
      {
        coarse.facetPoints.push_back(
          { numbers[points[0]], numbers[points[1]], numbers[points[2]] });
        coarse.shapes.push_back(shapeOf(m_facets.lengths[f]));
      }
    }
    coarse.removed.swap(m_removed);
  }

private:
  enum class State : char
  {
    Open,
    Waiting, ///< for the next pass: something around it was removed
    Tried,
    Fixed,
    Removed
  };
  using Lengths = std::array<double, 3>;

  static TargetShape shapeOf(const Lengths& lengths)
  {
    TargetShape shape;
    shape.a = lengths[0];
    shape.b = (lengths[0] * lengths[0] + lengths[2] * lengths[2] - lengths[1] * lengths[1]) /
      (2.0 * lengths[0]);
    shape.c = std::sqrt(std::max(lengths[2] * lengths[2] - shape.b * shape.b, 0.0));
    return shape;
  }

  /** Finds what is across sides; fixes points where that is not one facet that fits. */
  void join(const EdgeTable& edges)
  {
    std::vector<int> facets(m_states.size(), 0);
    for (Index f = 0; f < static_cast<Index>(m_facets.points.size()); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        const Index edge = edges.facetEdges[f][k];
        const Index begin = edges.edgeFacetsBegin[edge];
        ++facets[m_facets.points[f][k]];
        m_facets.cornerOfPoint[m_facets.points[f][k]] = cornerOf(f, k);
        if (edges.valence(edge) == 2)
        {
          const Index other =
            edges.edgeFacets[begin] == f ? edges.edgeFacets[begin + 1] : edges.edgeFacets[begin];
          const int side = edges.sideOf(other, edge);
          if (m_facets.points[other][side] != m_facets.points[f][k])
          {
            m_facets.across[f][k] = cornerOf(other, side);
            continue;
          }
        }
        else if (edges.valence(edge) == 1)
        {
          continue;
        }
        m_states[m_facets.points[f][k]] = m_states[m_facets.points[f][next(k)]] = State::Fixed;
      }
    }
    for (std::size_t p = 0; p < m_states.size(); ++p)
    {
      Star star;
      if (m_states[p] == State::Open &&
        (m_facets.cornerOfPoint[p] == noIndex ||
          (walkAround(m_facets, static_cast<Index>(p), star) && star.facets != facets[p])))
      {
        m_states[p] = State::Fixed;
      }
    }
  }

  bool mayGo(const Star& star) const
  {
    for (int i = 0; i < star.ends; ++i)
    {
      if (m_states[star.points[i]] == State::Fixed)
      {
        return false;
      }
    }
    if (star.isBorder || star.facets < 3)
    {
      return star.isBorder && star.facets > 1;
    }
    const Index sides[3] = { outside(m_facets, star, 0), outside(m_facets, star, 1),
      outside(m_facets, star, 2) };
    const auto isSame = [](Index a, Index b)
    { return a != noIndex && b != noIndex && a / 3 == b / 3; };
    return star.facets > 3 ||
      !(isSame(sides[0], sides[1]) || isSame(sides[1], sides[2]) || isSame(sides[2], sides[0]));
  }

  void tryPoint(Index point)
  {
    Star star;
    if (!walkAround(m_facets, point, star) || !this->mayGo(star) || !layOut(m_facets, star))
    {
      return;
    }
    double qualities[Star::maxFacets + 1];
    for (int end = 0; end < star.ends; ++end)
    {
      const bool isEnd = !star.isBorder || end == 0 || end == star.ends - 1;
      qualities[end] = isEnd ? qualityFrom(star, end, m_longest) : -1.0;
    }
    const double least = std::max(std::min(star.worst, goodEnough), 1e-6);
    for (;;)
    {
      const int best =
        static_cast<int>(std::max_element(qualities, qualities + star.ends) - qualities);
      if (!(qualities[best] >= least))
      {
        return;
      }
      if (!isTaken(m_facets, star, best))
      {
        this->remove(point, star, best);
        return;
      }
      qualities[best] = -1.0;
    }
  }

  void join(Index side, Index other)
  {
    m_facets.across[side / 3][side % 3] = other;
    if (other != noIndex)
    {
      m_facets.across[other / 3][other % 3] = side;
    }
  }

  /** Removes a point: the facets at one end go, the others get that end instead of the point. */
  void remove(Index point, const Star& star, int end)
  {
    m_removed.push_back(this->placeOf(point, star, end));
    const auto sideAfter = [](Index corner) { return corner - corner % 3 + next(corner % 3); };
    const auto sideBefore = [=](Index corner) { return sideAfter(sideAfter(corner)); };
    // Facet i is between the ends i and i + 1.
    const int dead[2] = { end, star.from(end, star.ends - 1) };
    const bool hasDead[2] = { !star.isBorder || end == 0, !star.isBorder || end != 0 };
    const Index first = star.corners[star.isBorder && end != 0 ? 0 : star.from(end, 1)];
    const Index last = star.corners[star.isBorder ? (end == 0 ? star.facets - 1 : star.facets - 2)
                                                  : star.from(end, star.ends - 2)];
    const Index beyond[2] = { hasDead[0] ? outside(m_facets, star, dead[0]) : noIndex,
      hasDead[1] ? outside(m_facets, star, dead[1]) : noIndex };
    for (int k = 1; k + 1 < star.ends; ++k)
    {
      const int b = star.from(end, k);
      const int c = star.from(end, k + 1);
      this->fill(star.corners[b], star, { end, b, c });
    }
    for (int k = 0; k < 2; ++k)
    {
      if (hasDead[k])
      {
        m_facets.points[star.corners[dead[k]] / 3] = { noIndex, noIndex, noIndex };
        this->join(k == 0 ? first : sideBefore(last), beyond[k]);
      }
    }
    m_facets.cornerOfPoint[star.points[end]] = first;
    m_states[point] = State::Removed;
    // At the ends of facets that are gone.
    m_facets.cornerOfPoint[m_facets.points[first / 3][next(static_cast<int>(first % 3))]] =
      sideAfter(first);
    m_facets.cornerOfPoint[m_facets.points[last / 3][sideBefore(last) % 3]] = sideBefore(last);
    for (int i = 0; i < star.ends; ++i)
    {
      m_states[star.points[i]] = State::Waiting;
    }
  }

  /** A facet of the star becomes the triangle of three ends, the first of them its new corner. */
  void fill(Index corner, const Star& star, const std::array<int, 3>& ends)
  {
    const Index facet = corner / 3;
    int k = static_cast<int>(corner % 3);
    m_facets.points[facet][k] = star.points[ends[0]];
    for (int j = 0; j < 3; ++j, k = next(k))
    {
      m_facets.lengths[facet][k] = (star.places[ends[next(j)]] - star.places[ends[j]]).norm();
    }
  }

  RemovedPoint placeOf(Index point, const Star& star, int end) const
  {
    if (star.isBorder)
    {
      const Vector2 way = star.places[star.ends - 1] - star.places[0];
      const double share = std::clamp(-star.places[0].dot(way) / way.squaredNorm(), 0.0, 1.0);
      return { point, { star.points[0], star.points[star.ends - 1], star.points[0] },
        { static_cast<float>(1.0 - share), static_cast<float>(share), 0.0F } };
    }
    RemovedPoint removed{ point, {}, {} };
    double best = -1e300;
    for (int k = 1; k + 1 < star.ends; ++k)
    {
      const int ends[3] = { end, star.from(end, k), star.from(end, k + 1) };
      double parts[3];
      for (int j = 0; j < 3; ++j)
      {
        parts[j] = cross(star.places[ends[next(j)]], star.places[ends[next(next(j))]]);
      }
      const double sum = parts[0] + parts[1] + parts[2];
      const double least = std::min({ parts[0], parts[1], parts[2] }) / sum;
      if (least > best)
      {
        best = least;
        double total = 0.0;
        for (int j = 0; j < 3; ++j)
        {
          removed.others[j] = star.points[ends[j]];
          parts[j] = std::max(parts[j], 0.0);
          total += parts[j];
        }
        for (int j = 0; j < 3; ++j)
        {
          removed.weights[j] = static_cast<float>(parts[j] / total);
        }
      }
    }
    return removed;
  }

  double m_longest; ///< side that may be made
  JoinedFacets m_facets;
  std::vector<State> m_states;
  std::vector<RemovedPoint> m_removed;
};
}

Rows CoarseSurface::prolonged(const Rows& values) const
{
  const auto d = values.cols();
  Rows all(static_cast<Offset>(this->points.size() + this->removed.size()), d);
  for (std::size_t p = 0; p < this->points.size(); ++p)
  {
    all.row(this->points[p]) = values.row(static_cast<Offset>(p));
  }
  for (auto point = this->removed.rbegin(); point != this->removed.rend(); ++point)
  {
    all.row(point->point) = point->weights[0] * all.row(point->others[0]) +
      point->weights[1] * all.row(point->others[1]) + point->weights[2] * all.row(point->others[2]);
  }
  return all;
}

bool coarsen(
  const ShapedFacets& surface, double longest, const RunControl& control, CoarseSurface& coarse)
{
  coarse = CoarseSurface{};
  Coarsening coarsening(surface, longest);
  if (!coarsening.run(control))
  {
    return false;
  }
  coarsening.take(coarse);
  return true;
}
}
