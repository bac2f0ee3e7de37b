#include "Placement/NormalCones.h"

#include "Mesh/FacetGeometry.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace remesh
{
namespace
{
/** Of the sine of a narrow cone's angle, at most, and far above it. */
constexpr double coneRounding = 1e-6;

/**
 * The least cosine of a vector to the axis that makes it less than 90 degrees with all in the cone:
 * the sine of the cone's half angle, as the two angles must not sum to more than 90 degrees.
 */
double cosineOfCone(const std::vector<Point3>& normals, const Point3& axis)
{
  double widest = 1.0;
  for (const Point3& normal : normals)
  {
    if (normal.isZero(0.0))
    {
      return std::numeric_limits<double>::infinity();
    }
    widest = std::min(widest, normal.dot(axis));
  }
  return widest > 0.0 ? std::sqrt(1.0 - widest * widest) + coneRounding
                      : std::numeric_limits<double>::infinity();
}
}

NormalCones::NormalCones(const PlacementProblem& problem, const RunControl& control)
  : m_cones(static_cast<std::size_t>(problem.numberOfVertices()),
      Cone{ Point3::Zero(), std::numeric_limits<double>::infinity() })
{
  const Components& components = problem.components;
  // What is left undone by a cancelled run is a cone that nothing is along.
  static_cast<void>(
    forEachRange(Blocks::cut(problem.numberOfVertices(), 64, 4096), control.silent(),
      [&](Offset begin, Offset end)
      {
        std::vector<Point3> normals;
        for (Offset v = begin; v < end; ++v)
        {
          normals.clear();
          Point3 sum = Point3::Zero();
          for (Offset p = components.pieceBegin[v]; p < components.pieceBegin[v + 1]; ++p)
          {
            const Index facet = problem.diagram.facets[components.pieces[p]];
            normals.push_back(facetNormal(problem.facetPoint(facet, 0),
              problem.facetPoint(facet, 1), problem.facetPoint(facet, 2)));
            sum += normals.back();
          }
          const double length = sum.norm();
          if (length > 0.0)
          {
            const Point3 axis = sum / length;
            m_cones[v] = { axis, cosineOfCone(normals, axis) };
          }
        }
      }));
}
}
