#include "Features/CurveStations.h"

#include "Embedding/Distance.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
std::vector<double> measureCurve(const FeaturedSurface& featured, Index curve)
{
  const auto& [mesh, surface, features] = featured;
  const FeatureCurve& course = features.curves[curve];
  std::vector<double> lengths{ 0.0 };
  for (const Index edge : course.edges)
  {
    double length = 0.0;
    for (Offset i = features.edges.edgeFacetsBegin[edge];
         i < features.edges.edgeFacetsBegin[edge + 1]; ++i)
    {
      const Index facet = features.edges.edgeFacets[i];
      const int k = features.edges.sideOf(facet, edge);
      const Triple& corners = mesh.facetCorners[facet];
      const double squared = squaredDistance<Eigen::Dynamic>(
        surface.corner(corners[k]), surface.corner(corners[(k + 1) % 3]), surface.dimension);
      length = std::max(length, surface.lengthScale(facet) * std::sqrt(squared));
    }
    lengths.push_back(lengths.back() + length);
  }
  return lengths;
}

Station stationAt(const std::vector<double>& lengths, double length)
{
  const auto after = std::upper_bound(lengths.begin(), lengths.end(), length);
  const auto last = static_cast<Index>(lengths.size()) - 2;
  const Index segment = std::clamp(static_cast<Index>(after - lengths.begin()) - 1, Index(0), last);
  const double extent = lengths[segment + 1] - lengths[segment];
  const double t = extent > 0.0 ? std::clamp((length - lengths[segment]) / extent, 0.0, 1.0) : 0.0;
  return stationIn(segment, t, last + 1);
}

double lengthAt(const std::vector<double>& lengths, const Station& station)
{
  return lengths[station.segment] +
    station.t * (lengths[station.segment + 1] - lengths[station.segment]);
}

bool insertStation(const std::vector<double>& lengths, const Station& station, double minSection,
  double minGap, std::vector<Station>& places)
{
  const auto after = std::upper_bound(places.begin(), places.end(), station);
  if (after == places.begin() || after == places.end())
  {
    return false;
  }
  const double begin = lengthAt(lengths, *(after - 1));
  const double end = lengthAt(lengths, *after);
  const double gap = minGap * (end - begin);
  const double length = lengthAt(lengths, station);
  if (end - begin < minSection || length < begin + gap || length > end - gap)
  {
    return false;
  }
  places.insert(after, station);
  return true;
}

Station stationAtRadius(
  const SurfaceMesh& mesh, const FeatureCurve& curve, bool fromFront, double radius)
{
  const auto count = static_cast<Index>(curve.edges.size());
  const Point3& end = mesh.points[fromFront ? curve.points.front() : curve.points.back()];
  for (Index k = 0; k < count; ++k)
  {
    const Index segment = fromFront ? k : count - 1 - k;
    const Index from = fromFront ? segment : segment + 1;
    const Point3 a = mesh.points[curve.points[from]] - end;
    const Point3 b = mesh.points[curve.points[fromFront ? segment + 1 : segment]] - end;
    if (b.norm() < radius)
    {
      continue;
    }
    // |a + u (b - a)| = radius, the root in [0, 1].
    const Point3 along = b - a;
    const double p = a.dot(along) / along.squaredNorm();
    const double q = (a.squaredNorm() - radius * radius) / along.squaredNorm();
    const double u = std::clamp(-p + std::sqrt(std::max(0.0, p * p - q)), 0.0, 1.0);
    return stationIn(segment, fromFront ? u : 1.0 - u, count);
  }
  return fromFront ? Station{ count - 1, 1.0 } : Station{ 0, 0.0 };
}
}
