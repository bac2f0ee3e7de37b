#include "Placement/Quadric.h"

#include "Support/Parallel.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace remesh
{
namespace
{
/** Flatter directions are noise: the share of the largest eigenvalue below which one is cut off. */
constexpr double minEigenvalue = 1e-2;

Point3 minimiser(const Point3& center, const CellQuadrics& planes, std::size_t vertex)
{
  const Symmetric3<double>& quadric = planes.quadrics[vertex];
  const double size = quadric[0] + quadric[3] + quadric[5];
  if (!(size > 0.0) || !std::isfinite(size))
  {
    return center;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(matrixOf(quadric) / size);
  const Point3 values = solver.eigenvalues();
  Point3 shift = Point3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    if (values[k] > minEigenvalue * values[2])
    {
      const Point3 axis = solver.eigenvectors().col(k);
      shift += axis.dot(planes.slopes[vertex]) / (size * values[k]) * axis;
    }
  }
  const double length = shift.norm();
  const double radius = planes.radii[vertex];
  return length <= radius ? Point3(center + shift) : Point3(center + radius / length * shift);
}
}

bool placeByQuadrics(const PlacementProblem& problem, const CellQuadrics& planes,
  const RunControl& control, std::vector<Point3>& positions)
{
  return forEachRange(Blocks::cut(problem.numberOfVertices(), 256, 4096), control,
    [&](Offset begin, Offset end)
    {
      for (auto v = static_cast<std::size_t>(begin); v < static_cast<std::size_t>(end); ++v)
      {
        if (!problem.isFixed(v))
        {
          positions[v] = minimiser(problem.components.centroids[v], planes, v);
        }
      }
    });
}
}
