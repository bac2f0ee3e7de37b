#include "Metric/SolutionMetric.h"

#include "Mesh/Extent.h"
#include "Metric/QuadraticFit.h"
#include "Metric/TensorAlgebra.h"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <limits>

namespace remesh
{
namespace
{
/** Points of a mesh of equilateral triangles with sides of length 1, for an area of 1. */
const double pointsPerArea = 2.0 / std::sqrt(3.0);

Tensor2 within(const Symmetric3<double>& tensor, const FittedSide& side)
{
  const Point3 x = multiply(tensor, side.x);
  const Point3 y = multiply(tensor, side.y);
  return { x.dot(side.x), x.dot(side.y), y.dot(side.y) };
}

double exponentOf(ErrorNorm norm)
{
  switch (norm)
  {
    case ErrorNorm::L1:
      return -1.0 / 4.0;
    case ErrorNorm::L2:
      return -1.0 / 6.0;
    case ErrorNorm::L4:
      return -1.0 / 10.0;
    default:
      return 0.0;
  }
}

/** The metric as a function of the scale of what the functions ask for. */
class ScaledMetric
{
public:
  ScaledMetric(
    const SurfaceMesh& mesh, const SolutionMetricInput& input, const SolutionMetricOptions& options)
    : m_mesh(mesh)
    , m_input(input)
    , m_options(options)
  {
    const double diagonal = boundingBoxDiagonal(mesh);
    const double largest = options.maximumSize > 0.0 ? options.maximumSize : diagonal;
    m_least = 1.0 / (largest * largest);
    m_most = options.minimumSize > 0.0 ? 1.0 / (options.minimumSize * options.minimumSize)
                                       : std::numeric_limits<double>::infinity();
  }

  Status prepare(RunControl& control)
  {
    control.enterPhase("Second derivatives", 0.0, 0.8);
    Status status = m_sides.build(m_mesh, control.silent());
    if (status.ok())
    {
      status = fitQuadratics(m_sides, m_input.values, control, m_fits);
    }
    control.enterPhase("Metric", 0.8, 1.0);
    const std::size_t functions = m_input.components.size() + m_input.hessians.size();
    m_wanted.resize(functions);
    int column = 0;
    for (std::size_t k = 0; k < functions && status.ok(); ++k)
    {
      status = this->findWanted(k, column, control.silent());
      column += k < m_input.components.size() ? m_input.components[k] : 0;
    }
    return status;
  }

  /** Whether a function asks for any points. */
  bool isConstant() const { return m_isConstant; }

  /** Points of a mesh with edges of length 1. @return false when cancelled. */
  bool countPoints(double scale, const RunControl& control, double& points) const
  {
    double area = 0.0;
    const bool done = sumInBlocks(
      this->blocks(), control.silent(),
      [&](std::size_t side) {
        return this->areaOf(side) * std::sqrt(std::max(this->at(side, scale).determinant(), 0.0));
      },
      area);
    points = pointsPerArea * area;
    return done;
  }

  bool fill(double scale, const RunControl& control, std::vector<Symmetric3<double>>& tensors) const
  {
    tensors.resize(m_mesh.points.size());
    return forEachItem(m_mesh.numberOfPoints(), control.silent(),
      [&](Offset point)
      {
        Eigen::Matrix3d whole = Eigen::Matrix3d::Zero();
        for (Offset side = m_sides.begins()[point]; side < m_sides.begins()[point + 1]; ++side)
        {
          const Eigen::Matrix3d own = this->inSpace(static_cast<std::size_t>(side), scale);
          whole = side == m_sides.begins()[point] ? own : intersect(whole, own);
        }
        tensors[point] = symmetricOf(whole);
      });
  }

private:
  Blocks blocks() const
  {
    return Blocks::cut(static_cast<Offset>(m_fits.sides.size()), 64, 1 << 14);
  }
  double areaOf(std::size_t side) const { return m_sides.sides()[side].area; }

  /** The k-th function's metric, for one point of a mesh. */
  Status findWanted(std::size_t k, int column, const RunControl& control)
  {
    std::vector<Tensor2>& wanted = m_wanted[k];
    wanted.resize(m_fits.sides.size());
    double area = 0.0;
    const bool done = sumInBlocks(
      this->blocks(), control,
      [&](std::size_t side)
      {
        wanted[side] = this->optimal(this->hessian(side, k, column));
        return this->areaOf(side) * std::sqrt(std::max(wanted[side].determinant(), 0.0));
      },
      area);
    if (!done)
    {
      return Status::cancelled();
    }
    m_isConstant = m_isConstant && !(area > 0.0);
    const double factor = area > 0.0 ? 1.0 / (pointsPerArea * area) : 0.0;
    for (Tensor2& tensor : wanted)
    {
      tensor = tensor * factor;
    }
    return Status::success();
  }

  /** |H| of a function; of a vector the root of the sum of squares. */
  Tensor2 hessian(std::size_t side, std::size_t k, int column) const
  {
    const std::size_t fitted = m_input.components.size();
    if (k >= fitted)
    {
      const Index point = m_sides.sides()[side].point;
      return absolute(within(m_input.hessians[k - fitted][point], m_fits.sides[side]));
    }
    const int count = m_input.components[k];
    if (count == 1)
    {
      return absolute(m_fits.hessian(side, static_cast<std::size_t>(column)));
    }
    Tensor2 squares{ 0.0, 0.0, 0.0 };
    for (int c = column; c < column + count; ++c)
    {
      const Tensor2& h = m_fits.hessian(side, static_cast<std::size_t>(c));
      squares = squares +
        Tensor2{ h.xx * h.xx + h.xy * h.xy, h.xy * (h.xx + h.yy), h.xy * h.xy + h.yy * h.yy };
    }
    return withEigenvalues(squares, [](double value) { return std::sqrt(std::max(value, 0.0)); });
  }

  Tensor2 optimal(const Tensor2& hessian) const
  {
    const Tensor2 rounded = this->withRatio(hessian);
    const double determinant = rounded.determinant();
    return determinant > 0.0 ? rounded * std::pow(determinant, exponentOf(m_options.norm))
                             : Tensor2{ 0.0, 0.0, 0.0 };
  }

  Tensor2 withRatio(const Tensor2& tensor) const
  {
    Spectrum2 spectrum = spectrumOf(tensor);
    spectrum.second =
      std::max(spectrum.second, spectrum.first / (m_options.maximumRatio * m_options.maximumRatio));
    return spectrum.tensor();
  }

  Tensor2 withinSizes(const Tensor2& tensor) const
  {
    return withEigenvalues(
      tensor, [&](double value) { return std::min(std::max(value, m_least), m_most); });
  }

  Tensor2 at(std::size_t side, double scale) const
  {
    const Index point = m_sides.sides()[side].point;
    Tensor2 all{ m_least, 0.0, m_least };
    for (const auto& wanted : m_wanted)
    {
      all = intersection(all, this->withinSizes(wanted[side] * scale));
    }
    if (m_options.chordTolerance > 0.0)
    {
      const double factor = 1.0 / (8.0 * m_options.chordTolerance);
      all = intersection(all, this->withinSizes(absolute(m_fits.sides[side].bend) * factor));
    }
    for (const auto& metric : m_input.metrics)
    {
      all = intersection(all, this->withinSizes(within(metric[point], m_fits.sides[side])));
    }
    if (!m_input.sizes.empty())
    {
      const double value = 1.0 / (m_input.sizes[point] * m_input.sizes[point]);
      all = intersection(all, this->withinSizes({ value, 0.0, value }));
    }
    return this->withRatio(this->withinSizes(all));
  }

  Eigen::Matrix3d inSpace(std::size_t side, double scale) const
  {
    const Tensor2 flat = this->at(side, scale);
    const FittedSide& frame = m_fits.sides[side];
    return flat.xx * frame.x * frame.x.transpose() + flat.yy * frame.y * frame.y.transpose() +
      flat.xy * (frame.x * frame.y.transpose() + frame.y * frame.x.transpose()) +
      spectrumOf(flat).second * frame.normal * frame.normal.transpose();
  }

  /** As intersection() of TensorAlgebra.h. */
  static Eigen::Matrix3d intersect(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b)
  {
    const Eigen::LLT<Eigen::Matrix3d> factor(a);
    const Eigen::Matrix3d lower = factor.matrixL();
    const Eigen::Matrix3d half = factor.matrixL().solve(b);
    const Eigen::Matrix3d relative = factor.matrixL().solve(half.transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
      0.5 * (relative + relative.transpose()));
    const Eigen::Matrix3d basis = lower * solver.eigenvectors();
    return basis * solver.eigenvalues().cwiseMax(1.0).asDiagonal() * basis.transpose();
  }

  const SurfaceMesh& m_mesh;
  const SolutionMetricInput& m_input;
  const SolutionMetricOptions& m_options;
  double m_least; ///< eigenvalue of the largest size
  double m_most;  ///< of the smallest
  SurfaceSides m_sides;
  QuadraticFits m_fits;
  std::vector<std::vector<Tensor2>> m_wanted; ///< of each function, for each side
  bool m_isConstant = true;
};

/** A scale, and the points that the metric asks for there. */
struct Trial
{
  double scale = 0.0;
  double points = 0.0;
};

/**
 * Two scales, a factor of 4 apart, between which the metric asks for the number of points, or the
 * second of which changes nothing any more. @return false when cancelled.
 */
bool bracketScale(
  const ScaledMetric& metric, double wanted, const RunControl& control, Trial& low, Trial& high)
{
  constexpr double saturated = 1e-9; // a growth for 4 times the scale
  constexpr int maxSteps = 500;      // all that doubles have
  high.scale = wanted;
  if (!metric.countPoints(high.scale, control, high.points))
  {
    return false;
  }
  const double factor = high.points < wanted ? 4.0 : 0.25;
  for (int k = 0; k < maxSteps; ++k)
  {
    low = high;
    high.scale *= factor;
    if (!metric.countPoints(high.scale, control, high.points))
    {
      return false;
    }
    const bool isBetween = (high.points < wanted) != (low.points < wanted);
    const bool isSaturated = factor > 1.0 && high.points - low.points < saturated * wanted;
    if (isBetween || isSaturated)
    {
      break;
    }
  }
  if (factor < 1.0)
  {
    std::swap(low, high);
  }
  return true;
}

/** The scale at which the metric asks for the number of points. @return false when cancelled. */
bool findScale(const ScaledMetric& metric, double wanted, const RunControl& control, double& scale)
{
  constexpr double near = 1e-6;
  constexpr int maxSteps = 60;
  Trial low;
  Trial high;
  if (!bracketScale(metric, wanted, control, low, high))
  {
    return false;
  }
  scale = high.scale;
  // Regula falsi of logarithms, and every third time bisection.
  for (int k = 0; k < maxSteps && low.points < wanted && high.points > wanted; ++k)
  {
    const double share =
      k % 3 == 2 ? 0.5 : std::log(wanted / low.points) / std::log(high.points / low.points);
    Trial middle;
    middle.scale = low.scale * std::pow(high.scale / low.scale, share);
    if (!metric.countPoints(middle.scale, control, middle.points))
    {
      return false;
    }
    scale = middle.scale;
    if (std::abs(middle.points - wanted) < near * wanted)
    {
      break;
    }
    (middle.points < wanted ? low : high) = middle;
  }
  return true;
}
}

Status makeSolutionMetric(const SurfaceMesh& mesh, const SolutionMetricInput& input,
  const SolutionMetricOptions& options, RunControl control, SolutionMetric& metric)
{
  ScaledMetric scaled(mesh, input, options);
  if (Status status = scaled.prepare(control); !status.ok())
  {
    return status;
  }
  metric.isConstant = scaled.isConstant();
  double scale = 0.0;
  bool done = scaled.countPoints(0.0, control, metric.minPoints);
  if (!metric.isConstant && metric.minPoints < options.numberOfPoints)
  {
    done = done && findScale(scaled, options.numberOfPoints, control, scale);
  }
  done = done && scaled.countPoints(scale, control, metric.points) &&
    scaled.fill(scale, control, metric.tensors);
  return done ? Status::success() : Status::cancelled();
}
}
