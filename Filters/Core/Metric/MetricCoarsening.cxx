#include "Metric/MetricCoarsening.h"

#include "Mesh/EdgeTable.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
constexpr int mostFacets = 16;     // around a point that is removed
constexpr double goodEnough = 0.3; // quality of triangles, 1 for equal sides
constexpr double mostBend = 1.0;   // radians, by which angles may differ from a full turn
constexpr double mostBorderBend = 0.3;
constexpr double leastShare = 0.01; // of the points, that a pass is to remove
constexpr double pi = 3.14159265358979323846;
constexpr Index pointsBetweenLooks = 1024; // at whether the run is cancelled

using Vector2 = Eigen::Vector2d;

double cross(const Vector2& a, const Vector2& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

int next(int k)
{
  return k == 2 ? 0 : k + 1;
}

/** Corner k of facet f, and side k, from it to the next one. */
Index cornerOf(Index facet, int k)
{
  return 3 * facet + k;
}

/** Facets around a point, counter-clockwise, in a plane with the point at its origin. */
struct Star
{
  bool isBorder = false;
  int facets = 0;
  Index corners[mostFacets];      ///< of the facets at the point
  int ends = 0;                   ///< points around
  Index points[mostFacets + 1];   ///< around
  Vector2 places[mostFacets + 1]; ///< of these
  double worst = 1.0;             ///< quality of its facets

  /** The k-th point from one of the ends, around. */
  int from(int end, int k) const { return (end + k) % this->ends; }
};

double qualityOf(const Vector2& a, const Vector2& b, const Vector2& c)
{
  const double sum = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return 2.0 * std::sqrt(3.0) * cross(b - a, c - a) / sum;
}

class Coarsening
{
public:
  Coarsening(const ShapedFacets& surface, double longest)
    : m_longest2(longest * longest)
    , m_points(surface.facetPoints.begin(), surface.facetPoints.end())
    , m_lengths(surface.facetPoints.size())
    , m_across(surface.facetPoints.size(), Triple{ noIndex, noIndex, noIndex })
    , m_cornerOfPoint(static_cast<std::size_t>(surface.points), noIndex)
    , m_states(static_cast<std::size_t>(surface.points), State::Open)
  {
    for (std::size_t f = 0; f < m_lengths.size(); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        m_lengths[f][k] = std::sqrt(surface.shapes[f].edge2(k));
      }
    }
  }

  bool run(const RunControl& control)
  {
    const EdgeTable edges = buildEdgeTable(m_points, control);
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
    } while (static_cast<double>(m_removed.size() - last) > leastShare * count);
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
    for (std::size_t f = 0; f < m_points.size(); ++f)
    {
      const Triple& points = m_points[f];
      if (points[0] != noIndex)
      {
        coarse.facetPoints.push_back(
          { numbers[points[0]], numbers[points[1]], numbers[points[2]] });
        coarse.shapes.push_back(shapeOf(m_lengths[f]));
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
    for (Index f = 0; f < static_cast<Index>(m_points.size()); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        const Index edge = edges.facetEdges[f][k];
        const Index begin = edges.edgeFacetsBegin[edge];
        ++facets[m_points[f][k]];
        m_cornerOfPoint[m_points[f][k]] = cornerOf(f, k);
        if (edges.valence(edge) == 2)
        {
          const Index other =
            edges.edgeFacets[begin] == f ? edges.edgeFacets[begin + 1] : edges.edgeFacets[begin];
          const int side = edges.sideOf(other, edge);
          if (m_points[other][side] != m_points[f][k])
          {
            m_across[f][k] = cornerOf(other, side);
            continue;
          }
        }
        else if (edges.valence(edge) == 1)
        {
          continue;
        }
        m_states[m_points[f][k]] = m_states[m_points[f][next(k)]] = State::Fixed;
      }
    }
    for (std::size_t p = 0; p < m_states.size(); ++p)
    {
      Star star;
      if (m_states[p] == State::Open &&
        (m_cornerOfPoint[p] == noIndex ||
          (this->walk(static_cast<Index>(p), star) && star.facets != facets[p])))
      {
        m_states[p] = State::Fixed;
      }
    }
  }

  /** The facets around a point and their points; false where they are too many. */
  bool walk(Index point, Star& star) const
  {
    const Index begin = m_cornerOfPoint[point];
    Index corner = begin;
    for (Index side = m_across[corner / 3][corner % 3]; side != noIndex;
         side = m_across[corner / 3][corner % 3])
    {
      corner = cornerOf(side / 3, next(static_cast<int>(side % 3))); // clockwise
      if (corner == begin)
      {
        break;
      }
    }
    const Index first = corner;
    star.facets = 0;
    for (;;)
    {
      if (star.facets == mostFacets)
      {
        return false;
      }
      const Index facet = corner / 3;
      const int k = static_cast<int>(corner % 3);
      star.points[star.facets] = m_points[facet][next(k)];
      star.corners[star.facets++] = corner;
      const Index side = m_across[facet][next(next(k))];
      star.isBorder = side == noIndex;
      if (star.isBorder)
      {
        star.points[star.facets] = m_points[facet][next(next(k))];
        star.ends = star.facets + 1;
        return true;
      }
      corner = side; // the point is where that side begins
      if (corner == first)
      {
        star.ends = star.facets;
        return true;
      }
    }
  }

  /** Lays the facets out. False where they do not fit into a plane. */
  bool layOut(Star& star) const
  {
    double spokes[mostFacets + 1] = {};
    double angles[mostFacets];
    double sum = 0.0;
    star.worst = 1.0;
    for (int i = 0; i < star.facets; ++i)
    {
      const Lengths& lengths = m_lengths[star.corners[i] / 3];
      const int k = static_cast<int>(star.corners[i] % 3);
      const double a = lengths[k];
      const double b = lengths[next(next(k))];
      const double c = lengths[next(k)];
      const double cosine = (a * a + b * b - c * c) / (2.0 * a * b);
      const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
      angles[i] = std::atan2(sine, cosine);
      sum += angles[i];
      star.worst =
        std::min(star.worst, 2.0 * std::sqrt(3.0) * a * b * sine / (a * a + b * b + c * c));
      const int end = star.from(i, 1);
      spokes[i] += (star.isBorder && i == 0 ? 1.0 : 0.5) * a;
      spokes[end] += (star.isBorder && i == star.facets - 1 ? 1.0 : 0.5) * b;
    }
    const double bend = sum - (star.isBorder ? pi : 2.0 * pi);
    if (!(std::abs(bend) < (star.isBorder ? mostBorderBend : mostBend)))
    {
      return false;
    }
    const double scale = star.isBorder ? 1.0 : 2.0 * pi / sum;
    double angle = 0.0;
    for (int i = 0; i < star.ends; ++i)
    {
      star.places[i] = { spokes[i] * std::cos(angle), spokes[i] * std::sin(angle) };
      angle += i < star.facets ? scale * angles[i] : 0.0;
    }
    return true;
  }

  /** The worst quality of the triangles from one end to all others; below 0 where it cannot be. */
  double qualityFrom(const Star& star, int end) const
  {
    double worst = 1.0;
    for (int k = 1; k + 1 < star.ends; ++k)
    {
      const Vector2& a = star.places[end];
      const Vector2& b = star.places[star.from(end, k)];
      const Vector2& c = star.places[star.from(end, k + 1)];
      if (k > 1 && (b - a).squaredNorm() > m_longest2)
      {
        return -1.0;
      }
      worst = std::min(worst, qualityOf(a, b, c));
    }
    // A border gets a new side, from one end to the other.
    return star.isBorder && (star.places[0] - star.places[star.ends - 1]).squaredNorm() > m_longest2
      ? -1.0
      : worst;
  }

  /** Whether triangles from that end would join points that are joined already. */
  bool isTaken(const Star& star, int end) const
  {
    Star other;
    if (!this->walk(star.points[end], other))
    {
      return true;
    }
    // Those next to it around the star are joined to it.
    const int first = star.isBorder && end != 0 ? 1 : 2;
    const int last = star.isBorder && end == 0 ? star.ends : star.ends - 1;
    for (int k = first; k < last; ++k)
    {
      const Index point = star.points[star.from(end, k)];
      if (std::find(other.points, other.points + other.ends, point) != other.points + other.ends)
      {
        return true;
      }
    }
    return false;
  }

  /** What is across the side of a facet of a star that is not at its point. */
  Index outside(const Star& star, int facet) const
  {
    const Index corner = star.corners[facet];
    return m_across[corner / 3][next(static_cast<int>(corner % 3))];
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
    const Index sides[3] = { this->outside(star, 0), this->outside(star, 1),
      this->outside(star, 2) };
    const auto isSame = [](Index a, Index b)
    { return a != noIndex && b != noIndex && a / 3 == b / 3; };
    return star.facets > 3 ||
      !(isSame(sides[0], sides[1]) || isSame(sides[1], sides[2]) || isSame(sides[2], sides[0]));
  }

  void tryPoint(Index point)
  {
    Star star;
    if (!this->walk(point, star) || !this->mayGo(star) || !this->layOut(star))
    {
      return;
    }
    double qualities[mostFacets + 1];
    for (int end = 0; end < star.ends; ++end)
    {
      const bool isEnd = !star.isBorder || end == 0 || end == star.ends - 1;
      qualities[end] = isEnd ? this->qualityFrom(star, end) : -1.0;
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
      if (!this->isTaken(star, best))
      {
        this->remove(point, star, best);
        return;
      }
      qualities[best] = -1.0;
    }
  }

  void join(Index side, Index other)
  {
    m_across[side / 3][side % 3] = other;
    if (other != noIndex)
    {
      m_across[other / 3][other % 3] = side;
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
    const Index beyond[2] = { hasDead[0] ? this->outside(star, dead[0]) : noIndex,
      hasDead[1] ? this->outside(star, dead[1]) : noIndex };
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
        m_points[star.corners[dead[k]] / 3] = { noIndex, noIndex, noIndex };
        this->join(k == 0 ? first : sideBefore(last), beyond[k]);
      }
    }
    m_cornerOfPoint[star.points[end]] = first;
    m_states[point] = State::Removed;
    // At the ends of facets that are gone.
    m_cornerOfPoint[m_points[first / 3][next(static_cast<int>(first % 3))]] = sideAfter(first);
    m_cornerOfPoint[m_points[last / 3][sideBefore(last) % 3]] = sideBefore(last);
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
    m_points[facet][k] = star.points[ends[0]];
    for (int j = 0; j < 3; ++j, k = next(k))
    {
      m_lengths[facet][k] = (star.places[ends[next(j)]] - star.places[ends[j]]).norm();
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

  double m_longest2;
  std::vector<Triple> m_points; ///< of facets; noIndex: the facet is gone
  std::vector<Lengths> m_lengths;
  std::vector<Triple> m_across; ///< of each side, the one that it is joined to
  std::vector<Index> m_cornerOfPoint;
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
