#include "Placement/StepLimit.h"

#include "Mesh/FacetGeometry.h"
#include "Placement/TriangleShape.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
constexpr double leastCosine = 0.5;
constexpr double largestStretch = 6.0;
constexpr int lastLevel = 4; // the way is 2^-level, and 0 at the last one

double cosineTo(const Point3& normal, const Corners& p)
{
  return normal.dot(facetNormal(p[0], p[1], p[2]));
}

/** Whether a triangle at `after` is worse than allowed. */
bool isSpoilt(const Triple& triangle, const ShapeReference& reference, const Point3& surfaceNormal,
  const std::vector<Point3>& before, const std::vector<Point3>& after)
{
  const Corners now = cornersOf(triangle, after);
  const Corners then = cornersOf(triangle, before);
  if (now == then)
  {
    return false;
  }
  const double length = surfaceNormal.norm();
  if (length > 0.0)
  {
    const Point3 normal = surfaceNormal / length;
    const double cosine = cosineTo(normal, now);
    if (!(cosine >= leastCosine || cosine >= cosineTo(normal, then)))
    {
      return true;
    }
  }
  const Corners shape = cornersOf(triangle, reference.positions);
  const double stretch = stretchRatio(shape, now);
  return !(stretch <= largestStretch || stretch <= stretchRatio(shape, then));
}
}

bool limitSteps(const PlacementProblem& problem, const VertexStars& stars,
  const ShapeReference& reference, const std::vector<Point3>& before, const RunControl& control,
  std::vector<Point3>& goals)
{
  const RunControl silent = control.silent();
  const std::vector<Point3> wanted = goals;
  const auto numberOfTriangles = static_cast<Offset>(problem.triangles.size());
  const Blocks triangles = Blocks::cut(numberOfTriangles, 64, 4096);
  const Blocks vertices = Blocks::cut(problem.numberOfVertices(), 64, 4096);
  std::vector<char> spoilt(problem.triangles.size(), 0);
  std::vector<char> levels(goals.size(), 0);
  std::vector<char> changed(goals.size(), 1); // since the triangles were judged
  for (;;)
  {
    const bool judged = forEachRange(triangles, silent,
      [&](Offset begin, Offset end)
      {
        for (Offset t = begin; t < end; ++t)
        {
          const Triple& triangle = problem.triangles[t];
          spoilt[t] = std::any_of(triangle.begin(), triangle.end(),
                        [&](Index v) { return changed[v] != 0; }) &&
            isSpoilt(triangle, reference,
              reference.normals.empty() ? Point3(Point3::Zero()) : reference.normals[t], before,
              goals);
        }
      });
    if (!judged)
    {
      return false;
    }
    if (std::none_of(spoilt.begin(), spoilt.end(), [](char is) { return is != 0; }))
    {
      return true;
    }
    const bool moved = forEachRange(vertices, silent,
      [&](Offset begin, Offset end)
      {
        for (auto v = static_cast<Index>(begin); v < end; ++v)
        {
          const bool falls = std::any_of(stars.triangles.begin() + stars.begin(v),
            stars.triangles.begin() + stars.end(v), [&](Index t) { return spoilt[t] != 0; });
          changed[v] = falls && levels[v] < lastLevel;
          if (changed[v])
          {
            ++levels[v];
            const double way = levels[v] < lastLevel ? std::ldexp(1.0, -levels[v]) : 0.0;
            goals[v] = way > 0.0 ? Point3(before[v] + way * (wanted[v] - before[v])) : before[v];
          }
        }
      });
    if (!moved)
    {
      return false;
    }
  }
}
}
