#include "Placement/Quadric.h"

#include "Mesh/FacetGeometry.h"
#include "Support/Parallel.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
/** Flatter directions are noise: the share of the largest eigenvalue below which one is cut off. */
constexpr double leastEigenvalue = 1e-2;

Point3 minimiser(const PlacementProblem& problem, Index vertex)
{
  const Components& components = problem.components;
  const Point3& center = components.centroids[vertex];
  Eigen::Matrix3d quadric = Eigen::Matrix3d::Zero();
  Point3 slope = Point3::Zero();
  double radius2 = 0.0;
  for (Offset p = components.pieceBegin[vertex]; p < components.pieceBegin[vertex + 1]; ++p)
  {
    const Offset piece = components.pieces[p];
    const Index facet = problem.diagram.facets[piece];
    const double area =
      problem.diagram.integrals[piece].fraction() * facetArea(problem.mesh, facet);
    if (!(area > 0.0))
    {
      continue;
    }
    const Point3& a = problem.facetPoint(facet, 0);
    const Point3& b = problem.facetPoint(facet, 1);
    const Point3& c = problem.facetPoint(facet, 2);
    const Point3 normal = facetNormal(a, b, c);
    quadric += area * normal * normal.transpose();
    slope += (area * normal.dot(a - center)) * normal;
    const double* w = problem.diagram.integrals[piece].weights;
    const Point3 middle = (w[0] * a + w[1] * b + w[2] * c) / (w[0] + w[1] + w[2]);
    radius2 = std::max(radius2, (middle - center).squaredNorm());
  }
  const double size = quadric.trace();
  if (!(size > 0.0) || !std::isfinite(size))
  {
    return center;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(quadric / size);
  const Point3 values = solver.eigenvalues();
  Point3 shift = Point3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    if (values[k] > leastEigenvalue * values[2])
    {
      const Point3 axis = solver.eigenvectors().col(k);
      shift += axis.dot(slope) / (size * values[k]) * axis;
    }
  }
  const double length = shift.norm();
  const double radius = std::sqrt(radius2);
  return length <= radius ? Point3(center + shift) : Point3(center + radius / length * shift);
}
}

Status placeByQuadrics(
  const PlacementProblem& problem, const RunControl& control, std::vector<Point3>& positions)
{
  const bool done = forEachRange(Blocks::cut(problem.numberOfVertices(), 256, 4096), control,
    [&](Offset begin, Offset end)
    {
      for (Offset v = begin; v < end; ++v)
      {
        if (!problem.isFixed(static_cast<std::size_t>(v)))
        {
          positions[v] = minimiser(problem, static_cast<Index>(v));
        }
      }
    });
  return done ? Status::success() : Status::cancelled();
}
}
