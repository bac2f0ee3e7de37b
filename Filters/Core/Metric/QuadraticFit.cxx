#include "Metric/QuadraticFit.h"

#include "Mesh/FacetGeometry.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <cmath>

namespace remesh
{
namespace
{
constexpr std::size_t wanted = 16; // points: more than one ring, with the layer that ends it two
/**
 * Weights: of the point itself, and of the others at the distance d, where the mean square is 2:
 * 1 / (1 + d^2). The fit is nearly through the point. Measured on a front of tanh that meshes of
 * 250 points are adapted to five times, error times points: all alike 0.55; the point alone 0.39;
 * both 0.35; second derivatives by their formula 0.36.
 */
constexpr double ownWeight = 10.0;
constexpr int terms = 6; // 1, x, y, x^2 / 2, x y, y^2 / 2

/** Coordinates in the plane of a side, and heights above it. */
struct Layout
{
  Eigen::Matrix<double, Eigen::Dynamic, 2> places;
  Eigen::VectorXd heights;
};

Point3 normalOfSide(const SurfaceMesh& mesh, const SurfaceSides::Scratch& near)
{
  Point3 sum = Point3::Zero();
  for (std::size_t i = 0; i < near.ownFacets; ++i)
  {
    const auto& [a, b, c] = mesh.facetPoints[near.facets[i]];
    const Point3 vector = doubleAreaVector(mesh.points[a], mesh.points[b], mesh.points[c]);
    sum += sum.dot(vector) < 0.0 ? Point3(-vector) : vector;
  }
  return sum.stableNormalized();
}

void setFrame(const Point3& normal, FittedSide& side)
{
  side.normal = normal;
  side.x = normal.unitOrthogonal();
  side.y = normal.cross(side.x);
}

Layout layOut(const SurfaceMesh& mesh, const SurfaceSides::Scratch& near, const FittedSide& side)
{
  constexpr double most = 2.0; // what is steeper lies beside the surface's sheet
  Layout layout;
  layout.places.resize(static_cast<Offset>(near.points.size()), 2);
  layout.heights.resize(layout.places.rows());
  const Point3& origin = mesh.points[near.points[0]];
  for (std::size_t i = 0; i < near.points.size(); ++i)
  {
    const Point3 way = mesh.points[near.points[i]] - origin;
    const Eigen::RowVector2d flat(way.dot(side.x), way.dot(side.y));
    const double length = flat.norm();
    const double factor = length > 0.0 ? std::min(way.norm() / length, most) : 1.0;
    layout.places.row(static_cast<Offset>(i)) = factor * flat;
    layout.heights[static_cast<Offset>(i)] = way.dot(side.normal);
  }
  return layout;
}

/** Least-squares fits in coordinates of covariance 1. */
class Fit
{
public:
  explicit Fit(const Layout& layout)
  {
    constexpr double thin = 1e-20; // of the squared extent: keeps the covariance regular
    const auto count = static_cast<double>(layout.places.rows());
    Eigen::Matrix2d covariance = layout.places.transpose() * layout.places / count;
    covariance.diagonal().array() += thin * covariance.trace();
    const Eigen::LLT<Eigen::Matrix2d> factor(covariance);
    m_inverse = factor.matrixL().solve(Eigen::Matrix2d::Identity());
    const Eigen::Matrix<double, Eigen::Dynamic, 2> w = layout.places * m_inverse.transpose();
    Eigen::Matrix<double, Eigen::Dynamic, terms> rows(w.rows(), terms);
    rows.col(0).setOnes();
    rows.middleCols<2>(1) = w;
    rows.col(3) = 0.5 * w.col(0).cwiseAbs2();
    rows.col(4) = w.col(0).cwiseProduct(w.col(1));
    rows.col(5) = 0.5 * w.col(1).cwiseAbs2();
    m_weights = (1.0 + w.rowwise().squaredNorm().array()).inverse();
    m_weights[0] = ownWeight;
    m_solver.setThreshold(1e-10);
    m_solver.compute(m_weights.asDiagonal() * rows);
  }

  /** `terms` x functions. */
  Eigen::MatrixXd solve(const Eigen::MatrixXd& values) const
  {
    return m_solver.solve(m_weights.asDiagonal() * values);
  }

  Eigen::Vector2d gradient(const Eigen::VectorXd& solution) const
  {
    return m_inverse.transpose() * solution.segment<2>(1);
  }

  Tensor2 hessian(const Eigen::VectorXd& solution) const
  {
    Eigen::Matrix2d own;
    own << solution[3], solution[4], solution[4], solution[5];
    const Eigen::Matrix2d h = m_inverse.transpose() * own * m_inverse;
    return { h(0, 0), 0.5 * (h(0, 1) + h(1, 0)), h(1, 1) };
  }

private:
  Eigen::VectorXd m_weights;
  Eigen::Matrix2d m_inverse; ///< from the plane's coordinates
  Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix<double, Eigen::Dynamic, terms>> m_solver;
};

void fitSide(const SurfaceSides& sides, std::size_t number, const Rows& values,
  SurfaceSides::Scratch& scratch, QuadraticFits& fits)
{
  const SurfaceMesh& mesh = sides.mesh();
  FittedSide& side = fits.sides[number];
  sides.gather(sides.sides()[number], wanted, scratch);
  setFrame(normalOfSide(mesh, scratch), side);
  Layout layout = layOut(mesh, scratch, side);
  const Fit first(layout);
  const Eigen::Vector2d slope = first.gradient(first.solve(layout.heights));
  setFrame((side.normal - slope[0] * side.x - slope[1] * side.y).normalized(), side);
  layout = layOut(mesh, scratch, side);
  const Fit fit(layout);
  side.bend = fit.hessian(fit.solve(layout.heights));
  if (fits.functions == 0)
  {
    return;
  }
  Eigen::MatrixXd near(layout.places.rows(), values.cols());
  for (Eigen::Index i = 0; i < near.rows(); ++i)
  {
    // Differences, so that the solver's threshold is one of what varies.
    near.row(i) = values.row(scratch.points[i]) - values.row(scratch.points[0]);
  }
  const Eigen::MatrixXd solution = fit.solve(near);
  for (std::size_t k = 0; k < fits.functions; ++k)
  {
    fits.hessians[number * fits.functions + k] = fit.hessian(solution.col(static_cast<Offset>(k)));
  }
}
}

Status fitQuadratics(
  const SurfaceSides& sides, const Rows& values, const RunControl& control, QuadraticFits& fits)
{
  fits.functions = static_cast<std::size_t>(values.cols());
  fits.sides.resize(sides.sides().size());
  fits.hessians.resize(fits.sides.size() * fits.functions);
  const Blocks blocks = Blocks::cut(static_cast<Offset>(fits.sides.size()), 64, 1 << 12);
  ScratchPool<SurfaceSides::Scratch> pool([&]() { return sides.makeScratch(); });
  const bool done = forEachRange(blocks, control,
    [&](Offset begin, Offset end)
    {
      const auto scratch = pool.borrow();
      for (Offset side = begin; side < end; ++side)
      {
        fitSide(sides, static_cast<std::size_t>(side), values, *scratch, fits);
      }
    });
  return done ? Status::success() : Status::cancelled();
}
}
