#include "Comparison/SurfaceDistance.h"

#include "Comparison/MaximumBound.h"
#include "Mesh/FacetGeometry.h"
#include "Support/Parallel.h"
#include "Support/Random.h"

#include <cmath>

namespace remesh
{
namespace
{
constexpr Offset wantedBlocks = 1024;
constexpr Offset longestBlock = 4096;

/** Integrals over a part of the surface. */
struct Sums
{
  double area = 0.0;
  double distance = 0.0;
  double squared = 0.0;
  double largestSquared = 0.0;

  void add(double weight, double squaredDistance)
  {
    this->area += weight;
    this->distance += weight * std::sqrt(squaredDistance);
    this->squared += weight * squaredDistance;
    this->largestSquared = std::max(this->largestSquared, squaredDistance);
  }
};

/** A point of a triangle, by barycentric coordinates, and the share of the area it stands for. */
struct QuadraturePoint
{
  double u;
  double v;
  double weight;
};

/**
 * Exact up to degree 4: the squared distance of a triangle that a smooth surface crosses [D. A.
 * Dunavant, "High degree efficient symmetrical Gaussian quadrature rules for the triangle", 1985].
 */
constexpr std::array<QuadraturePoint, 6> quadrature = { {
  { 0.445948490915965, 0.445948490915965, 0.223381589678011 },
  { 0.445948490915965, 0.108103018168070, 0.223381589678011 },
  { 0.108103018168070, 0.445948490915965, 0.223381589678011 },
  { 0.091576213509771, 0.091576213509771, 0.109951743655322 },
  { 0.091576213509771, 0.816847572980459, 0.109951743655322 },
  { 0.816847572980459, 0.091576213509771, 0.109951743655322 },
} };

/** Visits the k^2 congruent parts of a triangle by one corner and two edges. */
template <class Visit>
void visitParts(const std::array<Point3, 3>& p, Offset k, const Visit& visit)
{
  const Point3 u = (p[1] - p[0]) / static_cast<double>(k);
  const Point3 v = (p[2] - p[0]) / static_cast<double>(k);
  for (Offset i = 0; i < k; ++i)
  {
    for (Offset j = 0; i + j < k; ++j)
    {
      const Point3 corner = p[0] + static_cast<double>(i) * u + static_cast<double>(j) * v;
      visit(corner, u, v);
      if (i + j + 1 < k)
      {
        visit(Point3(corner + u + v), Point3(-u), Point3(-v));
      }
    }
  }
}

/** For each corner of each triangle with area, whether its point has come for the first time. */
std::vector<char> firstCorners(const Triangles& surface)
{
  std::vector<char> seen(surface.points.size(), 0);
  std::vector<char> isFirst(3 * surface.triangles.size(), 0);
  for (Offset t = 0; t < surface.count(); ++t)
  {
    const auto [a, b, c] = surface.corners(t);
    for (int k = 0; k < 3 && hasArea(a, b, c); ++k)
    {
      char& point = seen[surface.triangles[t][k]];
      isFirst[3 * t + k] = point == 0;
      point = 1;
    }
  }
  return isFirst;
}

/** Samples triangles; each search begins at the triangles that the one before found. */
class Sampler
{
public:
  Sampler(const Triangles& from, const TriangleTree& to, double samplesPerArea,
    const std::vector<char>& isFirst)
    : m_from(from)
    , m_to(to)
    , m_samplesPerArea(samplesPerArea)
    , m_isFirst(isFirst)
  {
    std::fill_n(m_packet.slots, lanes, noIndex);
  }

  void sample(Offset triangle)
  {
    const std::array<Point3, 3> p = m_from.corners(triangle);
    if (!hasArea(p[0], p[1], p[2]))
    {
      return;
    }
    const double area = facetArea(p[0], p[1], p[2]);
    const double wanted = area * m_samplesPerArea;
    if (wanted < static_cast<double>(quadrature.size()))
    {
      this->sampleAtRandom(triangle, p, area, static_cast<int>(std::ceil(wanted)));
    }
    else
    {
      const auto k = static_cast<Offset>(std::ceil(std::sqrt(wanted / quadrature.size())));
      const double part = area / static_cast<double>(k * k);
      visitParts(p, k,
        [&](const Point3& corner, const Point3& u, const Point3& v)
        {
          for (const QuadraturePoint& at : quadrature)
          {
            this->add(corner + at.u * u + at.v * v, part * at.weight);
          }
        });
    }
    for (int k = 0; k < 3; ++k)
    {
      if (m_isFirst[3 * triangle + k])
      {
        this->add(p[k], 0.0); // for the largest distance alone
      }
    }
  }

  /** Of all triangles so far. */
  const Sums& sums()
  {
    this->search();
    return m_sums;
  }

private:
  void add(const Point3& point, double weight)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      m_packet.points.point[axis][m_count] = point[axis];
    }
    m_weights[m_count++] = weight;
    if (m_count == lanes)
    {
      this->search();
    }
  }

  /** For the points that are waiting. */
  void search()
  {
    if (m_count == 0)
    {
      return;
    }
    for (double(&column)[lanes] : m_packet.points.point)
    {
      std::fill(column + m_count, column + lanes, column[0]);
    }
    m_to.findClosest(m_packet);
    for (int k = 0; k < m_count; ++k)
    {
      m_sums.add(m_weights[k], m_packet.points.squared[k]);
    }
    m_count = 0;
  }

  /** Places of equal weight: too few for a rule that is exact. */
  void sampleAtRandom(Offset triangle, const std::array<Point3, 3>& p, double area, int count)
  {
    for (int k = 0; k < count; ++k)
    {
      const auto random = [&](int which)
      { return uniform01(static_cast<std::uint64_t>(triangle), 2 * k + which, 0); };
      const double root = std::sqrt(random(0));
      const double v = random(1) * root;
      this->add(p[0] + (root - v) * (p[1] - p[0]) + v * (p[2] - p[0]), area / count);
    }
  }

  const Triangles& m_from;
  const TriangleTree& m_to;
  double m_samplesPerArea;
  const std::vector<char>& m_isFirst; ///< T x 3, see firstCorners
  TriangleTree::Packet m_packet;      ///< points that are waiting
  double m_weights[lanes] = {};
  int m_count = 0;
  Sums m_sums;
};

double areaOf(const Triangles& surface)
{
  double area = 0.0;
  for (Offset t = 0; t < surface.count(); ++t)
  {
    const auto [a, b, c] = surface.corners(t);
    area += hasArea(a, b, c) ? facetArea(a, b, c) : 0.0;
  }
  return area;
}

Status sampleSurface(const Triangles& from, const TriangleTree& to, Offset numberOfSamples,
  const RunControl& control, Sums& whole)
{
  const double area = areaOf(from);
  if (!(area > 0.0) || !std::isfinite(area))
  {
    return Status::invalid("The surface has no triangle with a finite area above 0.");
  }
  const std::vector<char> isFirst = firstCorners(from);
  const Blocks blocks = Blocks::cut(from.count(), wantedBlocks, longestBlock);
  std::vector<Sums> sums(static_cast<std::size_t>(blocks.count()));
  if (!forEachBlock(blocks.count(), control,
        [&](Offset block)
        {
          Sampler sampler(from, to, static_cast<double>(numberOfSamples) / area, isFirst);
          for (Offset t = blocks.begin(block); t < blocks.end(block); ++t)
          {
            sampler.sample(t);
          }
          sums[block] = sampler.sums();
        }))
  {
    return Status::cancelled();
  }
  for (const Sums& part : sums)
  {
    whole.area += part.area;
    whole.distance += part.distance;
    whole.squared += part.squared;
    whole.largestSquared = std::max(whole.largestSquared, part.largestSquared);
  }
  return Status::success();
}
}

double TwoSidedDistance::rms() const
{
  return std::sqrt(
    0.5 * (this->forward.rms * this->forward.rms + this->backward.rms * this->backward.rms));
}

Status measureOneSidedDistance(const Triangles& from, const TriangleTree& to,
  const DistanceOptions& options, const RunControl& control, OneSidedDistance& distance)
{
  distance = {};
  const bool bounded = options.boundTolerance >= 0.0;
  Sums sums;
  Status status =
    sampleSurface(from, to, options.numberOfSamples, control.step(0, bounded ? 2 : 1), sums);
  if (!status.ok())
  {
    return status;
  }
  distance.area = sums.area;
  distance.mean = sums.distance / sums.area;
  distance.rms = std::sqrt(sums.squared / sums.area);
  distance.maximum = std::sqrt(sums.largestSquared);
  distance.maximumBound = std::numeric_limits<double>::infinity();
  if (bounded)
  {
    status = boundMaximum(from, to, options, control.step(1, 2), distance);
  }
  return status;
}

Status measureTwoSidedDistance(const Triangles& first, const Triangles& second,
  const DistanceOptions& options, const RunControl& control, TwoSidedDistance& distance)
{
  distance = {};
  const TriangleTree firstTree(first, control);
  const TriangleTree secondTree(second, control);
  if (control.cancelled())
  {
    return Status::cancelled();
  }
  if (firstTree.empty() || secondTree.empty())
  {
    return Status::invalid("A surface has no triangle with an area above 0.");
  }
  Status status =
    measureOneSidedDistance(first, secondTree, options, control.step(0, 2), distance.forward);
  if (status.ok())
  {
    status =
      measureOneSidedDistance(second, firstTree, options, control.step(1, 2), distance.backward);
  }
  return status;
}
}
