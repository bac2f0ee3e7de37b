#include "Placement/CellForms.h"

#include "Mesh/FacetGeometry.h"
#include "Support/Parallel.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
/** The metric of R^d on a facet, and along its normal the geometric mean of the stretches. */
Symmetric3<double> facetMetric(const PlacementProblem& problem, Index facet, const Point3& normal)
{
  constexpr double flat = 1e-20; // squared sine of the angle below which edges tell nothing
  const Point3 u = problem.facetPoint(facet, 1) - problem.facetPoint(facet, 0);
  const Point3 v = problem.facetPoint(facet, 2) - problem.facetPoint(facet, 0);
  const double uu = u.squaredNorm();
  const double uv = u.dot(v);
  const double vv = v.squaredNorm();
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > flat * uu * vv))
  {
    return Symmetric3<double>::Zero();
  }
  const Point3 first = (vv * u - uv * v) / determinant; // their products with u and v are 0 and 1
  const Point3 second = (uu * v - uv * u) / determinant;
  const auto& [embeddedU, opposite, embeddedV] = problem.surface.constants[facet].edge2;
  const double mixed = 0.5 * (embeddedU + embeddedV - opposite);
  const double stretch2 = (embeddedU * embeddedV - mixed * mixed) / determinant; // of areas
  return embeddedU * symmetricProduct(first, first) + embeddedV * symmetricProduct(second, second) +
    2.0 * mixed * symmetricProduct(first, second) +
    std::sqrt(std::max(stretch2, 0.0)) * symmetricProduct(normal, normal);
}

void measureCell(
  const PlacementProblem& problem, Index vertex, CellQuadrics& planes, CellForms& forms)
{
  const Components& components = problem.components;
  const Point3& center = components.centroids[vertex];
  Symmetric3<double>& metric = forms.metrics[vertex];
  double all = 0.0;
  double radius2 = 0.0;
  for (Offset p = components.pieceBegin[vertex]; p < components.pieceBegin[vertex + 1]; ++p)
  {
    const Offset piece = components.pieces[p];
    const Index facet = problem.diagram.facets[piece];
    const PieceWeights& part = problem.diagram.weights[piece];
    const double area = part.fraction() * facetArea(problem.mesh, facet);
    if (!(area > 0.0))
    {
      continue;
    }
    const Point3& a = problem.facetPoint(facet, 0);
    const Point3& b = problem.facetPoint(facet, 1);
    const Point3& c = problem.facetPoint(facet, 2);
    const Point3 normal = facetNormal(a, b, c);
    all += area;
    planes.quadrics[vertex] += area * symmetricProduct(normal, normal);
    planes.slopes[vertex] += (area * normal.dot(a - center)) * normal;
    forms.normals[vertex] += area * normal;
    const double scale = problem.surface.lengthScale(facet);
    metric += area * scale * scale * facetMetric(problem, facet, normal);
    const double* w = part.weights;
    const Point3 middle = (w[0] * a + w[1] * b + w[2] * c) / (w[0] + w[1] + w[2]);
    radius2 = std::max(radius2, (middle - center).squaredNorm());
  }
  planes.radii[vertex] = std::sqrt(radius2);
  metric /= all > 0.0 ? all : 1.0;
}

/** Of a quadric: the share of its trace beside the largest eigenvalue. */
double variationOf(const Symmetric3<double>& quadric)
{
  const double trace = quadric[0] + quadric[3] + quadric[5];
  if (!(trace > 0.0) || !std::isfinite(trace))
  {
    return 0.0;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(matrixOf(quadric) / trace, Eigen::EigenvaluesOnly);
  return std::max(0.0, 1.0 - solver.eigenvalues()[2]);
}
}

bool measureCells(const PlacementProblem& problem, const RunControl& control, CellQuadrics& planes,
  CellForms& forms)
{
  const auto count = static_cast<std::size_t>(problem.numberOfVertices());
  planes.quadrics.assign(count, Symmetric3<double>::Zero());
  planes.slopes.assign(count, Point3::Zero());
  planes.radii.assign(count, 0.0);
  forms.normals.assign(count, Point3::Zero());
  forms.metrics.assign(count, Symmetric3<double>::Zero());
  const Blocks blocks = Blocks::cut(problem.numberOfVertices(), 256, 4096);
  double varying = 0.0;
  double all = 0.0;
  const auto measure = [&](std::size_t v)
  {
    measureCell(problem, static_cast<Index>(v), planes, forms);
    return problem.isFixed(v) ? 0.0 : problem.components.area[v] * variationOf(planes.quadrics[v]);
  };
  const auto areaOf = [&](std::size_t v)
  { return problem.isFixed(v) ? 0.0 : problem.components.area[v]; };
  if (!sumInBlocks(blocks, control, measure, varying) ||
    !sumInBlocks(blocks, control.silent(), areaOf, all))
  {
    return false;
  }
  forms.variation = all > 0.0 ? varying / all : 0.0;
  return true;
}
}
