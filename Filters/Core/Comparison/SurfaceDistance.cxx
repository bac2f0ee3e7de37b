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
constexpr int samplesPerPart = 3;

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

/** Of a triangle by one corner and two edges; of equal weight. */
std::array<Point3, samplesPerPart> quadraturePoints(
  const Point3& corner, const Point3& u, const Point3& v)
{
  return { corner + (u + v) / 6.0, corner + (4.0 * u + v) / 6.0, corner + (u + 4.0 * v) / 6.0 };
}

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

/** Samples triangles; each search begins at the triangle that the one before found. */
struct Sampler
{
  const Triangles& from;
  const TriangleTree& to;
  double samplesPerArea;
  Sums sums;
  Index hint = noIndex;

  double squaredDistance(const Point3& point)
  {
    const TriangleTree::Place place = this->to.closest(point, this->hint);
    this->hint = place.slot;
    return place.at.squared;
  }

  void sample(Offset triangle)
  {
    const std::array<Point3, 3> p = this->from.corners(triangle);
    if (!hasArea(p[0], p[1], p[2]))
    {
      return;
    }
    const double area = facetArea(p[0], p[1], p[2]);
    const double wanted = area * this->samplesPerArea;
    if (wanted < 1.0)
    {
      const std::array<Point3, samplesPerPart> places =
        quadraturePoints(p[0], p[1] - p[0], p[2] - p[0]);
      const std::uint64_t which = mixBits(static_cast<std::uint64_t>(triangle)) % samplesPerPart;
      this->sums.add(area, this->squaredDistance(places[which]));
    }
    else
    {
      const auto k = static_cast<Offset>(std::ceil(std::sqrt(wanted / samplesPerPart)));
      const double weight = area / (static_cast<double>(k * k) * samplesPerPart);
      visitParts(p, k,
        [&](const Point3& corner, const Point3& u, const Point3& v)
        {
          for (const Point3& place : quadraturePoints(corner, u, v))
          {
            this->sums.add(weight, this->squaredDistance(place));
          }
        });
    }
    for (const Point3& corner : p)
    {
      this->sums.largestSquared =
        std::max(this->sums.largestSquared, this->squaredDistance(corner));
    }
  }
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
  const Blocks blocks = Blocks::cut(from.count(), wantedBlocks, longestBlock);
  std::vector<Sums> sums(static_cast<std::size_t>(blocks.count()));
  if (!forEachBlock(blocks.count(), control,
        [&](Offset block)
        {
          Sampler sampler{ from, to, static_cast<double>(numberOfSamples) / area, {} };
          for (Offset t = blocks.begin(block); t < blocks.end(block); ++t)
          {
            sampler.sample(t);
          }
          sums[block] = sampler.sums;
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
