/**
 * @file TriangleQuality.h
 * @brief Shapes of triangles, by the definitions of VTK's mesh quality (Verdict).
 */
#ifndef remesh_TriangleQuality_h
#define remesh_TriangleQuality_h

#include "Mesh/FacetGeometry.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace remesh
{
/** What ratios are cut off at, as in Verdict. */
constexpr double largestRatio = 1e30;

/** Of one triangle. One without area has a minimum angle of 0 and a radius ratio at its largest. */
struct TriangleQuality
{
  double minimumAngle = 0.0;         ///< degrees, 0 to 60
  double radiusRatio = largestRatio; ///< circumradius over twice the inradius, 1 to `largestRatio`
  double edgeRatio = largestRatio;   ///< longest over shortest edge, 1 to `largestRatio`

  /** 1 over the radius ratio: 1 for an equilateral triangle, 0 for one without area. */
  double quality() const
  {
    return this->radiusRatio < largestRatio ? 1.0 / this->radiusRatio : 0.0;
  }
};

inline TriangleQuality triangleQuality(const std::array<Point3, 3>& p)
{
  constexpr double degreesPerRadian = 57.29577951308232088;
  std::array<double, 3> edges = { (p[1] - p[0]).stableNorm(), (p[2] - p[1]).stableNorm(),
    (p[0] - p[2]).stableNorm() };
  std::sort(edges.begin(), edges.end());
  const auto [shortest, middle, longest] = edges;
  TriangleQuality quality;
  if (!(longest > 0.0))
  {
    return quality;
  }
  if (shortest * largestRatio > longest)
  {
    quality.edgeRatio = longest / shortest;
  }
  if (!hasArea(p[0], p[1], p[2]))
  {
    return quality;
  }
  // Twice the area over the square of the longest edge: nothing over- or underflows.
  const ShortEdges sides = shortEdges(p[0], p[1], p[2]);
  const double doubleArea = (sides.first / longest).cross(sides.second / longest).norm();
  const double a = shortest / longest;
  const double b = middle / longest;
  quality.minimumAngle =
    degreesPerRadian * std::atan2(doubleArea, 0.5 * (1.0 + (b - a) * (b + a))); // between b and 1
  quality.radiusRatio =
    std::clamp(a * b * (a + b + 1.0) / (4.0 * doubleArea * doubleArea), 1.0, largestRatio);
  return quality;
}
}

#endif
