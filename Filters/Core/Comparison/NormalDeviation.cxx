#include "Comparison/NormalDeviation.h"

#include "Mesh/FacetGeometry.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
  const TriangleTree::Tolerance asClose{ 1e-9, 1e-12 * size };
  degrees.assign(static_cast<std::size_t>(mesh.count()), std::numeric_limits<double>::quiet_NaN());
  const auto deviationOf = [&](Offset t, std::vector<TriangleTree::Place>& closest)
  {
    const auto [a, b, c] = mesh.corners(t);
    const Point3 normal = facetNormal(a, b, c);
    const Point3 middle = (a + b + c) / 3.0;
    const double near = closest.empty()
      ? std::numeric_limits<double>::infinity()
      : surface.closestOn(closest.front().slot, middle).at.squared;
    surface.findClosest(middle, asClose, near, closest);
    double least = 180.0;
    for (const TriangleTree::Place& place : closest)
    {
      const auto& [p, q, r] = surface.cornersOf(place.slot);
      least = std::min(least, angleBetween(normal, facetNormal(p, q, r)));
    }
    return least;
  };
  const bool done = forEachRange(Blocks::cut(mesh.count(), 1024, 4096), control,
    [&](Offset begin, Offset end)
    {
      std::vector<TriangleTree::Place> closest; // to the last triangle
      for (Offset t = begin; t < end; ++t)
      {
        const auto [a, b, c] = mesh.corners(t);
        if (hasArea(a, b, c))
        {
          degrees[t] = deviationOf(t, closest);
        }
      }
    });
  return done ? Status::success() : Status::cancelled();
}
}
