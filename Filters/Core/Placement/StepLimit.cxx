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
constexpr double minCosine = 0.5;
constexpr double largestStretch = 6.0;
constexpr int lastLevel = 4; // the way is 2^-level, and 0 at the last one

double cosineTo(const Point3& normal, const Corners& p)
{
  return normal.dot(facetNormal(p[0], p[1], p[2]));
}

/** Whether a triangle at `after` is worse than allowed. */
bool isSpoilt(const Triple& triangle, const ShapeReference& reference, const Point3& surfaceNormal,
  const std::vector<Point3>& after)
{
  const Corners now = cornersOf(triangle, after);
  const Corners then = cornersOf(triangle, reference.before);
  if (now == then)
  {
    return false;
  }
  const double length = surfaceNormal.norm();
  if (length > 0.0)
  {
    const Point3 normal = surfaceNormal / length;
    const double cosine = cosineTo(normal, now);
    if (!(cosine >= minCosine || cosine >= cosineTo(normal, then)))
    {
      return true;
    }
  }
  const Corners shape = cornersOf(triangle, reference.positions);
  const double stretch = stretchRatio(shape, now);
  return !(stretch <= largestStretch || stretch <= stretchRatio(shape, then));
}

/** Vertices on their way to the goals, and the triangles that they spoil. */
class StepLimiter
{
public:
  StepLimiter(
    const PlacementProblem& problem, const ShapeReference& reference, std::vector<Point3>& goals)
    : m_problem(problem)
    , m_reference(reference)
    , m_wanted(goals)
    , m_places(goals)
    , m_spoilt(problem.triangles.size(), 0)
    , m_levels(goals.size(), 0)
    , m_changed(goals.size(), 1)
  {
  }

  /** Judges the triangles whose vertices have changed. */
  bool judge(const RunControl& control)
  {
    const std::vector<Point3>& normals = m_reference.normals;
    return forEachItem(Blocks::cut(static_cast<Offset>(m_spoilt.size()), 64, 4096), control,
      [&](Offset t)
      {
        const Triple& triangle = m_problem.triangles[t];
        m_spoilt[t] = std::any_of(triangle.begin(), triangle.end(),
                        [&](Index v) { return m_changed[v] != 0; }) &&
          isSpoilt(
            triangle, m_reference, normals.empty() ? Point3(Point3::Zero()) : normals[t], m_places);
      });
  }

  bool spoilsAny() const
  {
    return std::any_of(m_spoilt.begin(), m_spoilt.end(), [](char is) { return is != 0; });
  }

  /** Takes the vertices of spoilt triangles back by a level. */
  bool fallBack(const VertexStars& stars, const RunControl& control)
  {
    const std::vector<Point3>& before = m_reference.before;
    return forEachItem(Blocks::cut(m_problem.numberOfVertices(), 64, 4096), control,
      [&](Offset item)
      {
        const auto v = static_cast<Index>(item);
        const bool falls = std::any_of(stars.triangles.begin() + stars.begin(v),
          stars.triangles.begin() + stars.end(v), [&](Index t) { return m_spoilt[t] != 0; });
        m_changed[v] = falls && m_levels[v] < lastLevel;
        if (m_changed[v])
        {
          ++m_levels[v];
          const double way = m_levels[v] < lastLevel ? std::ldexp(1.0, -m_levels[v]) : 0.0;
          m_places[v] = way > 0.0 ? Point3(before[v] + way * (m_wanted[v] - before[v])) : before[v];
        }
      });
  }

private:
  const PlacementProblem& m_problem;
  const ShapeReference& m_reference;
  std::vector<Point3> m_wanted;
  std::vector<Point3>& m_places;
  std::vector<char> m_spoilt;  ///< T
  std::vector<char> m_levels;  ///< K
  std::vector<char> m_changed; ///< K, since the triangles were judged
};
}

bool limitSteps(const PlacementProblem& problem, const VertexStars& stars,
  const ShapeReference& reference, const RunControl& control, std::vector<Point3>& goals)
{
  const RunControl silent = control.silent();
  StepLimiter limiter(problem, reference, goals);
  for (;;)
  {
    if (!limiter.judge(silent))
    {
      return false;
    }
    if (!limiter.spoilsAny())
    {
      return true;
    }
    if (!limiter.fallBack(stars, silent))
    {
      return false;
    }
  }
}
}
