#include "Metric/IsometrySteps.h"

#include "Support/Parallel.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
constexpr std::size_t look = 10; // steps over which the decrease counts

/** J J' of a facet. */
struct Gram
{
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
};

/** Q - J of a facet, from J: two rows of d numbers, one after the other. Returns |Q - J|². */
template <int fixed>
double replaceByRest(int dimension, double* rows)
{
  constexpr double flat = 1e-12; // of the larger stretch: below, the smaller has no direction
  const int d = fixed > 0 ? fixed : dimension;
  double* x = rows;
  double* y = rows + d;
  Gram gram;
  for (int k = 0; k < d; ++k)
  {
    gram.xx += x[k] * x[k];
    gram.xy += x[k] * y[k];
    gram.yy += y[k] * y[k];
  }
  const double trace = gram.xx + gram.yy;
  if (!(trace > 0.0))
  {
    std::fill_n(rows, 2 * d, 0.0);
    x[0] = y[1] = 1.0;
    return 2.0;
  }
  const double root =
    std::sqrt(std::max(gram.xx * gram.yy - gram.xy * gram.xy, flat * flat * trace * trace));
  const double sum = std::sqrt(trace + 2.0 * root); // of both stretches
  // (C + root I)^-1 sum J
  const double a = gram.xx + root;
  const double c = gram.yy + root;
  const double scale = sum / (a * c - gram.xy * gram.xy);
  const double xx = scale * c - 1.0;
  const double xy = -scale * gram.xy;
  const double yy = scale * a - 1.0;
  double squared = 0.0;
  for (int k = 0; k < d; ++k)
  {
    const double first = xx * x[k] + xy * y[k];
    const double second = xy * x[k] + yy * y[k];
    x[k] = first;
    y[k] = second;
    squared += first * first + second * second;
  }
  return squared;
}

class Steps
{
public:
  Steps(const MetricLaplacian& laplacian, const StepOptions& options, const RunControl& control)
    : m_laplacian(laplacian)
    , m_options(options)
    , m_control(control)
  {
  }

  bool run(Rows& places, std::vector<double>& energies)
  {
    double energy = 0.0;
    if (!this->findRests(places, energy))
    {
      return false;
    }
    energies.assign(1, energy);
    Rows slope;
    Rows way;
    for (int k = 0; k < m_options.iterations && !this->hasEnded(energies); ++k)
    {
      m_control.report(static_cast<double>(k) / m_options.iterations);
      if (!m_laplacian.divergence(m_rests, m_control.silent(), slope) || !this->solve(slope, way))
      {
        return false;
      }
      places += way;
      if (!this->findRests(places, energy))
      {
        return false;
      }
      energies.push_back(energy);
    }
    return true;
  }

private:
  bool solve(Rows& slope, Rows& way) const
  {
    return m_options.matrix
      ? m_options.matrix->approach(slope, m_options.innerIterations, m_control.silent(), way)
      : m_laplacian.solve(slope, m_control.silent(), way);
  }

  bool findRests(const Rows& places, double& energy)
  {
    return places.cols() == 6 ? this->findRestsIn<6>(places, energy)
                              : this->findRestsIn<0>(places, energy);
  }

  /** Q - J on each facet, and the energy per area. */
  template <int fixed>
  bool findRestsIn(const Rows& places, double& energy)
  {
    const auto d = static_cast<int>(places.cols());
    m_rests.resize(2 * Offset(m_laplacian.numberOfFacets()), d);
    const Blocks blocks = Blocks::cut(m_laplacian.numberOfFacets(), 64, 1 << 14);
    const auto findRest = [&](std::size_t f)
    {
      const auto facet = static_cast<Index>(f);
      double* rows = m_rests.data() + 2 * Offset(facet) * d;
      m_laplacian.gradient<fixed>(places, facet, rows);
      return m_laplacian.area(facet) * replaceByRest<fixed>(d, rows);
    };
    const bool done = sumInBlocks(blocks, m_control.silent(), findRest, energy);
    energy /= m_laplacian.totalArea();
    return done;
  }

  bool hasEnded(const std::vector<double>& energies) const
  {
    constexpr double exact = 1e-12; // nothing but rounding
    const std::size_t count = energies.size();
    return energies.back() < exact ||
      (count > look &&
        energies[count - 1 - look] - energies.back() < m_options.energyDecrease * energies.back());
  }

  const MetricLaplacian& m_laplacian;
  const StepOptions& m_options;
  RunControl m_control;
  Rows m_rests; ///< 2F x d
};
}

bool stepToIsometry(const MetricLaplacian& laplacian, const StepOptions& options,
  const RunControl& control, Rows& places, std::vector<double>& energies)
{
  return Steps(laplacian, options, control).run(places, energies);
}

std::array<double, 2> stretchesOf(const FacetRows& gradient)
{
  const double xx = gradient.row(0).squaredNorm();
  const double xy = gradient.row(0).dot(gradient.row(1));
  const double yy = gradient.row(1).squaredNorm();
  const double large = 0.5 * (xx + yy) + std::hypot(0.5 * (xx - yy), xy);
  const double small = large > 0.0 ? std::max(0.0, xx * yy - xy * xy) / large : 0.0;
  return { std::sqrt(small), std::sqrt(large) };
}
}
