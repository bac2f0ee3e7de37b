#include "Metric/StraightEdges.h"

#include "Support/Grouping.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace remesh
{
namespace
{
constexpr int directions = 5; // of a half turn: an ellipse has two harmonics
constexpr int maxFits = 3;
constexpr double unchanged = 0.03;  // relative, of squares of lengths: an ellipse that stays
constexpr int maxFacets = 400;      // that half an edge crosses
constexpr double maxSkewness = 0.9; // of an ellipse in the one before: it stays one
constexpr double stretch = 0.25;    // of a unit, over which the metric is taken as linear

using Vector2 = Eigen::Vector2d;

/** A facet in its plane, with the logarithms of the metric at its corners. */
struct FlatFacet
{
  Vector2 corners[3];
  Tensor2 logarithms[3];

  Vector2 side(int k) const { return this->corners[(k + 1) % 3] - this->corners[k]; }

  /** Length in the metric of a short step to both sides of a place. */
  double speed(const Vector2& place, const Vector2& step) const
  {
    const Vector2 u = this->corners[1] - this->corners[0];
    const Vector2 v = this->corners[2] - this->corners[0];
    const Vector2 p = place - this->corners[0];
    const double area = u[0] * v[1];
    const double second = p[1] * u[0] / area;
    const double first = (p[0] * v[1] - p[1] * v[0]) / area;
    const Tensor2 log = this->logarithms[0] * (1.0 - first - second) + this->logarithms[1] * first +
      this->logarithms[2] * second;
    return std::sqrt(exponential(log).squared(step[0], step[1]));
  }
};

/** Half an edge, on its way over the facets. */
struct Walker
{
  Index facet = noIndex;
  int entry = -1; ///< the side it came in by; -1 - k: it began at corner k
  Vector2 place = Vector2::Zero();
  Vector2 way = Vector2::Zero(); ///< of length 1
  double length = 0.0;           ///< in the metric, so far
  double distance = 0.0;         ///< in R^3, so far
  double speed = 1.0;            ///< the last one
};

double turnOf(const Vector2& from, const Vector2& to)
{
  return from[0] * to[1] - from[1] * to[0];
}

/** A facet around a point, laid into the point's tangent plane. */
struct Sector
{
  Index facet;
  int corner;
  Vector2 first; ///< to its next corners
  Vector2 second;
  double firstLength; ///< in R^3
  double secondLength;
};

class StraightWalk
{
public:
  StraightWalk(const SurfaceMesh& mesh, const EdgeTable& edges, const MetricField& metric,
    const RunControl& control)
    : m_mesh(mesh)
    , m_edges(edges)
    , m_metric(metric)
    , m_facets(mesh.facetPoints.size())
  {
    const auto flatten = [&](Offset facet)
    {
      const auto f = static_cast<std::size_t>(facet);
      const TangentFrame frame = TangentFrame::of(mesh, f);
      const std::array<Tensor2, 3> tensors = tensorsOf(mesh, metric, f);
      const Point3& first = mesh.points[mesh.facetPoints[f][0]];
      for (int k = 0; k < 3; ++k)
      {
        const Point3 way = mesh.points[mesh.facetPoints[f][k]] - first;
        m_facets[f].corners[k] = { way.dot(frame.x), k == 1 ? 0.0 : way.dot(frame.y) };
        m_facets[f].logarithms[k] = logarithm(tensors[k]);
      }
    };
    const auto pointOf = [&](Offset corner) { return mesh.facetPoints[corner / 3][corner % 3]; };
    m_complete = forEachItem(static_cast<Offset>(m_facets.size()), control, flatten) &&
      groupByKey(3 * static_cast<Offset>(m_facets.size()), mesh.numberOfPoints(), control, pointOf,
        m_corners);
  }

  bool complete() const { return m_complete; }

  /** The facets around a point. */
  void findSectors(Index point, const TangentFrame& frame, std::vector<Sector>& sectors) const
  {
    sectors.clear();
    for (Offset i = m_corners.begins[point]; i < m_corners.begins[point + 1]; ++i)
    {
      const auto facet = static_cast<Index>(m_corners.items[i] / 3);
      const int k = static_cast<int>(m_corners.items[i] % 3);
      const Triple& points = m_mesh.facetPoints[facet];
      const Point3 first = m_mesh.points[points[(k + 1) % 3]] - m_mesh.points[point];
      const Point3 second = m_mesh.points[points[(k + 2) % 3]] - m_mesh.points[point];
      sectors.push_back({ facet, k, { first.dot(frame.x), first.dot(frame.y) },
        { second.dot(frame.x), second.dot(frame.y) }, first.norm(), second.norm() });
    }
  }

  /**
   * How far an edge from a point goes for a length in the metric.
   *
   * @param along a unit vector in the point's tangent plane.
   * @param tensor there.
   */
  double distanceFor(double length, const std::vector<Sector>& sectors, const Vector2& along,
    const Tensor2& tensor) const
  {
    Walker walker;
    if (!this->start(sectors, along, walker))
    {
      return length / std::sqrt(tensor.squared(along[0], along[1]));
    }
    for (int k = 0; k < maxFacets; ++k)
    {
      const int exit = this->cross(length, walker);
      if (walker.length >= length || !this->enterNext(exit, walker))
      {
        break;
      }
    }
    return walker.distance + std::max(0.0, length - walker.length) / walker.speed;
  }

private:
  /** The facet around the point that the direction leads into; false where none does. */
  bool start(const std::vector<Sector>& sectors, const Vector2& along, Walker& walker) const
  {
    constexpr double slack = -1e-9;
    double best = slack;
    for (const Sector& sector : sectors)
    {
      const double turn = turnOf(sector.first, sector.second);
      const double a = turnOf(along, sector.second) / turn;
      const double b = turnOf(sector.first, along) / turn;
      const double least = std::min(a * sector.firstLength, b * sector.secondLength);
      if (turn != 0.0 && least > best)
      {
        best = least;
        const int k = sector.corner;
        const FlatFacet& flat = m_facets[sector.facet];
        walker.facet = sector.facet;
        walker.entry = -1 - k;
        walker.place = flat.corners[k];
        walker.way = a * flat.side(k) - b * flat.side((k + 2) % 3);
      }
    }
    walker.way.normalize();
    return best > slack;
  }

  /** Goes through the facet, or to where the length is reached; the side it leaves by. */
  int cross(double length, Walker& walker) const
  {
    const FlatFacet& flat = m_facets[walker.facet];
    int exit = 0;
    double reach = std::numeric_limits<double>::max();
    for (int k = 0; k < 3; ++k)
    {
      const bool isBehind = walker.entry >= 0
        ? k == walker.entry
        : k == -1 - walker.entry || (k + 1) % 3 == -1 - walker.entry;
      const Vector2 side = flat.side(k);
      const Vector2 to = flat.corners[k] - walker.place;
      const double across = walker.way[0] * side[1] - walker.way[1] * side[0];
      const double there = (to[0] * side[1] - to[1] * side[0]) / across;
      if (!isBehind && across > 0.0 && there < reach)
      {
        reach = there;
        exit = k;
      }
    }
    if (!(reach < std::numeric_limits<double>::max()))
    {
      reach = 0.0;
    }
    this->advance(std::max(reach, 0.0), length, walker);
    return exit;
  }

  void advance(double reach, double length, Walker& walker) const
  {
    constexpr int maxSteps = 32;
    const FlatFacet& flat = m_facets[walker.facet];
    double step = reach;
    int steps = 1;
    walker.speed = flat.speed(walker.place + 0.5 * step * walker.way, walker.way);
    if (reach * walker.speed > 2.0 * stretch * length)
    {
      const double wanted = reach * walker.speed / (2.0 * stretch * length);
      steps = static_cast<int>(std::min<double>(wanted, maxSteps - 1)) + 1;
      step = reach / steps;
      walker.speed = flat.speed(walker.place + 0.5 * step * walker.way, walker.way);
    }
    for (int k = 0; k < steps; ++k)
    {
      if (k > 0)
      {
        walker.speed = flat.speed(walker.place + 0.5 * step * walker.way, walker.way);
      }
      const double share =
        std::min(1.0, (length - walker.length) / std::max(walker.speed * step, 1e-300));
      walker.distance += share * step;
      walker.place += step * walker.way;
      if (share < 1.0)
      {
        walker.length = length;
        break;
      }
      walker.length += walker.speed * step;
    }
  }

  /** Unfolds the facet beyond a side; false at borders, and where several are. */
  bool enterNext(int exit, Walker& walker) const
  {
    const Index edge = m_edges.facetEdges[walker.facet][exit];
    if (m_edges.valence(edge) != 2)
    {
      return false;
    }
    const Index begin = m_edges.edgeFacetsBegin[edge];
    const Index next = m_edges.edgeFacets[begin] == walker.facet ? m_edges.edgeFacets[begin + 1]
                                                                 : m_edges.edgeFacets[begin];
    const FlatFacet& from = m_facets[walker.facet];
    const FlatFacet& to = m_facets[next];
    const int entry = m_edges.sideOf(next, edge);
    const bool isTurned = m_mesh.facetPoints[next][entry] == m_mesh.facetPoints[walker.facet][exit];
    const Vector2 side = from.side(exit);
    const double length2 = side.squaredNorm();
    const Vector2 off = walker.place - from.corners[exit];
    const double share = std::clamp(off.dot(side) / length2, 0.0, 1.0);
    const double along = walker.way.dot(side) / std::sqrt(length2);
    const double across = std::sqrt(std::max(0.0, 1.0 - along * along));
    const Vector2 other = to.side(entry).normalized();
    const Vector2 inward(-other[1], other[0]);
    walker.place = to.corners[entry] + (isTurned ? share : 1.0 - share) * to.side(entry);
    walker.way = (isTurned ? along : -along) * other + across * inward;
    walker.facet = next;
    walker.entry = entry;
    return true;
  }

  const SurfaceMesh& m_mesh;
  const EdgeTable& m_edges;
  const MetricField& m_metric;
  std::vector<FlatFacet> m_facets;
  Groups m_corners; ///< of each point: 3 facet + k
  bool m_complete = false;
};

/** An ellipse in another one: of a mean and its second harmonics. */
struct FittedEllipse
{
  double mean = 0.0;
  double cosine = 0.0;
  double sine = 0.0;

  bool isCircle() const
  {
    return std::abs(this->mean - 1.0) < unchanged &&
      this->cosine * this->cosine + this->sine * this->sine < unchanged * unchanged;
  }
  Tensor2 tensor() const
  {
    const double skewness = std::hypot(this->cosine, this->sine);
    const double shrink =
      skewness > maxSkewness * this->mean ? maxSkewness * this->mean / skewness : 1.0;
    return { this->mean + shrink * this->cosine, shrink * this->sine,
      this->mean - shrink * this->cosine };
  }
};

/** A point, of which the ellipse is sought. */
struct Place
{
  const StraightWalk& walk;
  const std::vector<Sector>& sectors;
  Tensor2 tensor; ///< of the metric as given
  double unit;
};

/** The ellipse at a point, in that of the last round, of which `root` is the root. */
FittedEllipse fitEllipse(const Place& at, const Tensor2& root)
{
  const Tensor2 back = inverse(root);
  const double half = 0.5 * at.unit;
  FittedEllipse fit;
  for (int k = 0; k < directions; ++k)
  {
    const double angle = pi * k / directions;
    const double u = std::cos(angle);
    const double v = std::sin(angle);
    const Vector2 way(back.xx * u + back.xy * v, back.xy * u + back.yy * v);
    const double length = way.norm();
    const Vector2 along = way / length;
    const double reach = at.walk.distanceFor(half, at.sectors, along, at.tensor) +
      at.walk.distanceFor(half, at.sectors, -along, at.tensor);
    const double squared = (at.unit * length / reach) * (at.unit * length / reach);
    fit.mean += squared / directions;
    fit.cosine += 2.0 / directions * squared * std::cos(2.0 * angle);
    fit.sine += 2.0 / directions * squared * std::sin(2.0 * angle);
  }
  return fit;
}

Tensor2 limitedAt(const Place& at)
{
  Tensor2 tensor = at.tensor;
  for (int round = 0; round < maxFits; ++round)
  {
    const Tensor2 root = squareRoot(tensor);
    const FittedEllipse fit = fitEllipse(at, root);
    tensor = sandwich(root, fit.tensor());
    if (fit.isCircle())
    {
      break;
    }
  }
  return tensor;
}
}

bool limitToStraightEdges(const SurfaceMesh& mesh, const EdgeTable& edges,
  const MetricField& metric, double unit, const RunControl& control, MetricField& limited)
{
  const StraightWalk walk(mesh, edges, metric, control);
  if (!walk.complete())
  {
    return false;
  }
  limited.normals = metric.normals;
  limited.tensors.resize(metric.tensors.size());
  return forEachRange(Blocks::cut(mesh.numberOfPoints(), 256, 1 << 12), control,
    [&](Offset begin, Offset end)
    {
      std::vector<Sector> sectors;
      for (Offset point = begin; point < end; ++point)
      {
        const TangentFrame frame = TangentFrame::across(metric.normals[point]);
        walk.findSectors(static_cast<Index>(point), frame, sectors);
        const Tensor2 tensor =
          limitedAt({ walk, sectors, frame.within(metric.tensors[point]), unit });
        limited.tensors[point] = frame.tensorOf(tensor, 0.5 * (tensor.xx + tensor.yy));
      }
    });
}
}
