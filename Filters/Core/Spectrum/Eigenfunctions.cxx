#include "Spectrum/Eigenfunctions.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <vector>

namespace remesh
{
namespace
{
constexpr Index maxDense = 500; // points; 0.3 s
constexpr Index minBasis = 120; // vectors for one band
constexpr Index maxBasis = 400; // 3.2 kB for each point; a third of them converge

Status findDense(const SurfaceLaplacian& laplacian, Index count, Eigenpairs& pairs)
{
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
    Eigen::MatrixXd(laplacian.stiffness), Eigen::MatrixXd(laplacian.mass));
  if (solver.info() != Eigen::Success || !solver.eigenvalues().allFinite())
  {
    return Status::invalid("The Laplacian has no finite eigenvalues: the surface has triangles "
                           "whose angles are nothing but rounding. Remesh it first.");
  }
  const Eigen::VectorXd values = solver.eigenvalues().segment(laplacian.numberOfConstants, count);
  pairs.values.assign(values.data(), values.data() + count);
  pairs.functions = solver.eigenvectors().middleCols(laplacian.numberOfConstants, count);
  return Status::success();
}

/** Bands of eigenpairs, one after the other. */
class Bands
{
public:
  Bands(const SurfaceLaplacian& laplacian, Index count, const RunControl& control)
    : m_laplacian(laplacian)
    , m_control(control)
    , m_shifted(laplacian)
    , m_counter(m_shifted)
    , m_wanted(count)
    , m_functions(laplacian.size, count)
  {
  }

  Status run(Eigenpairs& pairs)
  {
    Status status = Status::success();
    while (status.ok() && this->count() < m_wanted)
    {
      m_control.report(static_cast<double>(this->count()) / m_wanted);
      status = this->addNext();
    }
    pairs.values.assign(m_values.begin(), m_values.begin() + (status.ok() ? m_wanted : 0));
    pairs.functions = std::move(m_functions);
    return status;
  }

private:
  Index count() const { return static_cast<Index>(m_values.size()); }
  /** Vectors for what is left. */
  Index basis() const
  {
    return m_effort * std::clamp(3 * (m_wanted - this->count() + 8), minBasis, maxBasis);
  }

  /** A band whose lower half should reach the last one; nearer and nearer until it does. */
  Status addNext()
  {
    constexpr int tries = 8;
    double ahead = m_reach;
    const Index before = this->count();
    for (int k = 0; k < tries; ++k, ahead *= 0.75)
    {
      // Below all eigenvalues at first, but no farther than the distance of two (H. Weyl, 1911).
      Status status = this->addBand(before > 0 ? m_end + ahead : -4.0 * pi / m_laplacian.area);
      m_effort = this->count() > before ? 1 : m_effort + k % 2; // many that are nearly equal
      if (!status.ok() || this->count() > before)
      {
        return status;
      }
    }
    return Status::invalid("The eigenfunctions do not converge: the surface has triangles whose "
                           "angles are nothing but rounding. Remesh it first.");
  }

  /** Adds the pairs around a shift, beyond the last band's end, if it reaches that. */
  Status addBand(double shift)
  {
    if (Status status = m_shifted.factor(shift, m_control.silent()); !status.ok())
    {
      return status;
    }
    FoundBand band;
    const Eigen::MatrixXd none(m_laplacian.size, 0);
    if (!findAround(m_shifted, none, this->basis(), m_control.silent(), band))
    {
      return Status::cancelled();
    }
    const double end = this->endOf(band);
    if (band.low > m_end || !(end > m_end))
    {
      return Status::success();
    }
    Index wanted = 0;
    Status status = this->countBelow(end, wanted);
    if (status.ok())
    {
      status = this->complete(end, wanted, band);
    }
    if (status.ok() && this->inside(band, end) == wanted)
    {
      this->take(band, end);
    }
    return status;
  }

  /** How many eigenvalues there are from the last band's end to a value. */
  Status countBelow(double value, Index& wanted)
  {
    Status status = m_counter.factor(value, m_control.silent());
    wanted = m_counter.eigenvaluesBelow() - m_laplacian.numberOfConstants - this->count();
    return status;
  }

  Index inside(const FoundBand& band, double end) const
  {
    return static_cast<Index>(std::count_if(band.pairs.values.begin(), band.pairs.values.end(),
      [&](double value) { return value > m_end && value < end; }));
  }

  /** Finds what is missing, as of many equal eigenvalues: without what was found, again. */
  Status complete(double end, Index wanted, FoundBand& band)
  {
    Index before = -1;
    while (this->inside(band, end) < wanted && this->inside(band, end) > before)
    {
      before = this->inside(band, end);
      FoundBand more;
      if (!findAround(m_shifted, band.pairs.functions, this->basis(), m_control.silent(), more))
      {
        return Status::cancelled();
      }
      const auto known = static_cast<Eigen::Index>(band.pairs.values.size());
      const auto added = static_cast<Eigen::Index>(more.pairs.values.size());
      band.pairs.values.insert(
        band.pairs.values.end(), more.pairs.values.begin(), more.pairs.values.end());
      band.pairs.functions.conservativeResize(Eigen::NoChange, known + added);
      band.pairs.functions.rightCols(added) = more.pairs.functions;
    }
    return Status::success();
  }

  /**
   * Where no eigenvalue is near: in the last gap that is at least as wide as the mean one, of those
   * between the pairs beyond the last band, and from the last pair to what has not converged.
   */
  double endOf(const FoundBand& band) const
  {
    std::vector<double> values(
      std::upper_bound(band.pairs.values.begin(), band.pairs.values.end(), m_end),
      band.pairs.values.end());
    if (values.empty())
    {
      return m_end;
    }
    // What has not converged may be nearer than it seems.
    constexpr double sure = 0.5;
    const double last = values.back();
    values.push_back(std::isfinite(band.high) ? last + sure * (band.high - last) : 2.0 * last);
    const double mean = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
    std::size_t k = values.size() - 1;
    while (k > 1 && values[k] - values[k - 1] < mean)
    {
      --k;
    }
    return 0.5 * (values[k] + values[k - 1]);
  }

  void take(const FoundBand& band, double end)
  {
    const std::vector<double>& values = band.pairs.values;
    std::vector<Eigen::Index> order;
    for (std::size_t k = 0; k < values.size(); ++k)
    {
      if (values[k] > m_end && values[k] < end)
      {
        order.push_back(static_cast<Eigen::Index>(k));
      }
    }
    std::stable_sort(order.begin(), order.end(),
      [&](Eigen::Index a, Eigen::Index b) { return values[a] < values[b]; });
    for (const Eigen::Index k : order)
    {
      if (this->count() < m_wanted)
      {
        m_functions.col(this->count()) = band.pairs.functions.col(k);
      }
      m_values.push_back(values[k]);
    }
    // A band reaches as far to both sides as the last one did. What converges on one side alone, as
    // at first, comes from both sides later.
    constexpr double oneSided = 0.55;
    constexpr double overlap = 0.93;
    const bool isFirst = m_end == 0.0;
    m_reach = (isFirst ? oneSided : overlap) *
      std::min(band.high - m_shifted.shift(), end - m_shifted.shift());
    m_end = end;
  }

  const SurfaceLaplacian& m_laplacian;
  RunControl m_control;
  ShiftedLaplacian m_shifted;
  ShiftedLaplacian m_counter; ///< at the end of a band
  Index m_wanted;
  double m_reach = 0.0;         ///< from a band's end to the next one's shift
  Index m_effort = 1;           ///< the basis is as many times as large
  double m_end = 0.0;           ///< all eigenvalues below it are there, and none is next to it
  std::vector<double> m_values; ///< may become more than are wanted
  Eigen::MatrixXd m_functions;  ///< n x wanted, of which so many are there
};

/** The largest entry of each function, the first of equal ones, becomes positive. */
void turn(Eigenpairs& pairs)
{
  for (Eigen::Index k = 0; k < pairs.functions.cols(); ++k)
  {
    auto function = pairs.functions.col(k);
    constexpr double equal = 1e-6; // of the largest: what rounding and symmetry may exchange
    const double largest = (1.0 - equal) * function.cwiseAbs().maxCoeff();
    Eigen::Index row = 0;
    while (std::abs(function[row]) < largest)
    {
      ++row;
    }
    function *= function[row] < 0.0 ? -1.0 : 1.0;
  }
}
}

Status findEigenfunctions(
  const SurfaceLaplacian& laplacian, Index count, const RunControl& control, Eigenpairs& pairs)
{
  Status status = laplacian.size <= maxDense ? findDense(laplacian, count, pairs)
                                             : Bands(laplacian, count, control).run(pairs);
  if (status.ok())
  {
    turn(pairs);
  }
  return status;
}
}
