#include "Comparison/DistanceSums.h"

#include "Mesh/FacetGeometry.h"
#include "Support/Random.h"

#include <cmath>

namespace remesh
{
namespace
{
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

/** Samples triangles; each search begins at the triangles that the one before found. */
class Sampler
{
public:
  Sampler(const SampledTriangles& from, const TriangleTree& to)
    : m_from(from)
    , m_to(to)
  {
    std::fill_n(m_packet.slots, lanes, noIndex);
  }

  void sample(Offset triangle)
  {
    const std::array<Point3, 3> p = m_from.triangles.corners(triangle);
    if (!hasArea(p[0], p[1], p[2]))
    {
      return;
    }
    const double area = facetArea(p[0], p[1], p[2]);
    const double wanted = area * m_from.samplesPerArea;
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
      if (m_from.isFirst[3 * triangle + k])
      {
        this->add(p[k], 0.0); // for the largest distance alone
      }
    }
  }

  /** Of all triangles so far. */
  const DistanceSums& sums()
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
      { return uniform01(static_cast<std::uint64_t>(m_from.first + triangle), 2 * k + which, 0); };
      const double root = std::sqrt(random(0));
      const double v = random(1) * root;
      this->add(p[0] + (root - v) * (p[1] - p[0]) + v * (p[2] - p[0]), area / count);
    }
  }

  const SampledTriangles& m_from;
  const TriangleTree& m_to;
  TriangleTree::Packet m_packet; ///< points that are waiting
  double m_weights[lanes] = {};
  int m_count = 0;
  DistanceSums m_sums;
};

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
}

void DistanceSums::add(double weight, double squaredDistance)
{
  this->area += weight;
  this->distance += weight * std::sqrt(squaredDistance);
  this->squared += weight * squaredDistance;
  this->largestSquared = std::max(this->largestSquared, squaredDistance);
}

DistanceSums& DistanceSums::operator+=(const DistanceSums& part)
{
  this->area += part.area;
  this->distance += part.distance;
  this->squared += part.squared;
  this->largestSquared = std::max(this->largestSquared, part.largestSquared);
  return *this;
}

Blocks sampledBlocks(Offset triangles)
{
  return Blocks::cut(triangles, 1024, 4096);
}

SampledTriangles sampledTriangles(const Triangles& surface, Offset numberOfSamples)
{
  const double area = areaOf(surface);
  return { surface, firstCorners(surface), area, static_cast<double>(numberOfSamples) / area, 0 };
}

Status sumDistances(const SampledTriangles& from, const TriangleTree& to, const Blocks& blocks,
  const RunControl& control, std::vector<DistanceSums>& sums)
{
  sums.resize(static_cast<std::size_t>(blocks.count()));
  const bool done = forEachBlock(blocks.count(), control,
    [&](Offset block)
    {
      Sampler sampler(from, to);
      for (Offset t = blocks.begin(block); t < blocks.end(block); ++t)
      {
        sampler.sample(t);
      }
      sums[block] = sampler.sums();
    });
  return done ? Status::success() : Status::cancelled();
}
}
