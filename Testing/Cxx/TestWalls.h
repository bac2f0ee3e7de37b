/**
 * @file TestWalls.h
 * @brief Surfaces of parts with straight walls: walls around profiles, rings between them.
 */
#ifndef TestWalls_h
#define TestWalls_h

#include "TestHelpers.h"

#include <cmath>
#include <functional>

namespace remesh::test
{
/** A wall around a profile, from height 0 to `height`, in so many layers. */
inline void addWall(
  const std::vector<Point3>& profile, double height, int layers, bool outward, TriangleSoup& soup)
{
  const auto first = static_cast<Offset>(soup.points.size());
  const auto n = static_cast<Offset>(profile.size());
  for (int layer = 0; layer <= layers; ++layer)
  {
    for (const Point3& p : profile)
    {
      soup.points.emplace_back(p[0], p[1], height * (static_cast<double>(layer) / layers));
    }
  }
  for (int layer = 0; layer < layers; ++layer)
  {
    for (Offset k = 0; k < n; ++k)
    {
      const Offset a = first + layer * n + k;
      const Offset b = first + layer * n + (k + 1) % n;
      soup.triangles.push_back(
        outward ? std::array<Offset, 3>{ a, b, b + n } : std::array<Offset, 3>{ a, b + n, b });
      soup.triangles.push_back(outward ? std::array<Offset, 3>{ a, b + n, a + n }
                                       : std::array<Offset, 3>{ a, a + n, b + n });
    }
  }
}

/** The flat ring between two profiles of the same number of points. */
inline void addRing(const std::vector<Point3>& inner, const std::vector<Point3>& outer, double z,
  bool up, TriangleSoup& soup)
{
  const auto first = static_cast<Offset>(soup.points.size());
  const auto n = static_cast<Offset>(inner.size());
  for (const auto* profile : { &inner, &outer })
  {
    for (const Point3& p : *profile)
    {
      soup.points.emplace_back(p[0], p[1], z);
    }
  }
  for (Offset k = 0; k < n; ++k)
  {
    const Offset a = first + k;
    const Offset b = first + (k + 1) % n;
    soup.triangles.push_back(
      up ? std::array<Offset, 3>{ a, a + n, b + n } : std::array<Offset, 3>{ a, b + n, a + n });
    soup.triangles.push_back(
      up ? std::array<Offset, 3>{ a, b + n, b } : std::array<Offset, 3>{ a, b, b + n });
  }
}

/** Points around the axis at a radius for each. */
inline std::vector<Point3> profileOf(int points, const std::function<double(int)>& radius)
{
  std::vector<Point3> profile;
  for (int k = 0; k < points; ++k)
  {
    const double angle = 2.0 * pi * k / points;
    profile.emplace_back(radius(k) * std::cos(angle), radius(k) * std::sin(angle), 0.0);
  }
  return profile;
}
}

#endif
