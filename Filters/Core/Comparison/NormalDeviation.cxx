#include "Comparison/NormalDeviation.h"

#include "Mesh/FacetGeometry.h"
#include "Support/Parallel.h"

#include <cmath>

namespace remesh
{
namespace
{
/** Degrees between unit vectors, exact for small angles, too. */
double angleBetween(const Point3& a, const Point3& b)
{
  constexpr double degreesPerRadian = 57.29577951308232088;
  return degreesPerRadian * 2.0 * std::atan2((a - b).norm(), (a + b).norm());
}
}

Status measureNormalDeviations(const Triangles& mesh, const TriangleTree& surface, double size,
  const RunControl& control, std::vector<double>& degrees)
{
  constexpr double sameShare = 1e-9;
  const double sameDistance = 1e-12 * size;
  degrees.assign(static_cast<std::size_t>(mesh.count()), std::numeric_limits<double>::quiet_NaN());
  const auto deviationOf = [&](Offset t, Index& hint)
  {
    const auto [a, b, c] = mesh.corners(t);
    const Point3 normal = facetNormal(a, b, c);
    const Point3 centroid = (a + b + c) / 3.0;
    const TriangleTree::Place closest = surface.closest(centroid, hint);
    hint = closest.slot;
    const double radius = std::sqrt(closest.at.squared) * (1.0 + sameShare) + sameDistance;
    double least = 180.0;
    surface.visitWithin(centroid, radius * radius,
      [&](const TriangleTree::Place& place)
      {
        const auto& [p, q, r] = surface.cornersOf(place.slot);
        least = std::min(least, angleBetween(normal, facetNormal(p, q, r)));
      });
    return least;
  };
  const bool done = forEachRange(Blocks::cut(mesh.count(), 1024, 4096), control,
    [&](Offset begin, Offset end)
    {
      Index hint = noIndex;
      for (Offset t = begin; t < end; ++t)
      {
        const auto [a, b, c] = mesh.corners(t);
        if (hasArea(a, b, c))
        {
          degrees[t] = deviationOf(t, hint);
        }
      }
    });
  return done ? Status::success() : Status::cancelled();
}
}
