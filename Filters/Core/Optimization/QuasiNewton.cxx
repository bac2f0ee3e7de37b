#include "Optimization/QuasiNewton.h"

#include "Optimization/EmptyCells.h"
#include "Optimization/FixedSites.h"
#include "Optimization/HistoryPass.h"
#include "Support/BlockedVectors.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <deque>

namespace remesh
{
namespace
{
constexpr double sufficientDecrease = 1e-4; // Armijo's constant
constexpr int maxTrials = 12;
constexpr double longestStep = 2.0; // times the root mean square radius of the cell

/** One pair of the history. */
struct Correction
{
  static_assert(sizeof(HalvedNumbers::value_type) == historyBytes); // a word holds two numbers

  HalvedNumbers step;
  HalvedNumbers change; ///< of the gradient
  double product = 0.0; ///< step . change > 0
};

/** The limited-memory approximation of the inverse Hessian. */
class InverseHessian
{
public:
  InverseHessian(int length, const BlockedVectors& vectors, const RunControl& control)
    : m_length(static_cast<std::size_t>(std::max(length, 0)))
    , m_vectors(vectors)
    , m_groups(static_cast<Offset>((vectors.size() + groupOfNumbers - 1) / groupOfNumbers),
        groupOfNumbers, control)
  {
  }

  void clear() { m_history.clear(); }

  /** False once a run was cancelled: then the history is not to be used. */
  bool complete() const { return m_groups.complete(); }

  /** Takes in a step and the gradient's change from -2 moment before to after. */
  void update(
    const Sites& sites, const CellSums& sums, const Sites& newSites, const CellSums& newSums)
  {
    if (m_length == 0)
    {
      return;
    }
    Correction pair{ HalvedNumbers(m_groups.size() / 2), HalvedNumbers(m_groups.size() / 2), 0.0 };
    pair.product = m_groups.sumOfBlocks(
      [&](std::size_t begin, std::size_t end)
      {
        return m_passes.pair({ sites.coordinates.data() + begin,
          newSites.coordinates.data() + begin, sums.moment.data() + begin,
          newSums.moment.data() + begin, std::min(end, m_vectors.size()) - begin,
          pair.step.data() + begin / 2, pair.change.data() + begin / 2 });
      });
    if (!(pair.product > 0.0))
    {
      return; // and the oldest pair stays
    }
    if (m_history.size() == m_length)
    {
      m_history.pop_front();
    }
    m_history.push_back(std::move(pair));
  }

  /** Direction -H g with g = -2 moment and the initial H = gamma diag(1 / (2 m_i)). */
  void descend(const CellSums& sums, std::vector<double>& direction) const
  {
    direction.resize(m_vectors.size());
    if (m_history.empty())
    {
      this->divideByMass(sums, sums.moment, 2.0, direction); // Lloyd's step
      return;
    }
    std::vector<float> work(m_groups.size());
    m_vectors.forEach([&](std::size_t k) { work[k] = static_cast<float>(2.0 * sums.moment[k]); });
    const std::size_t length = m_history.size();
    const auto step = [&](std::size_t h)
    { return h < length ? m_history[h].step.data() : nullptr; };
    const auto change = [&](std::size_t h)
    { return h < length ? m_history[h].change.data() : nullptr; };
    std::vector<double> factors(length);
    double product = this->pass(work, 0.0, nullptr, step(length - 1));
    for (std::size_t h = length; h-- > 0;)
    {
      factors[h] = product / m_history[h].product;
      product = this->pass(work, -factors[h], change(h), step(h - 1)); // none before the oldest
    }
    this->divideByMass(sums, work, this->curvatureScale(sums), work);
    product = this->pass(work, 0.0, nullptr, change(0));
    for (std::size_t h = 0; h < length; ++h)
    {
      const double factor = factors[h] - product / m_history[h].product;
      product = this->pass(work, factor, step(h), change(h + 1));
    }
    m_vectors.forEach([&](std::size_t k) { direction[k] = work[k]; });
  }

private:
  /** A pass of the recursion over all of the vector. */
  double pass(std::vector<float>& vector, double factor, const std::uint32_t* added,
    const std::uint32_t* next) const
  {
    return m_groups.sumOfBlocks(
      [&](std::size_t begin, std::size_t end)
      {
        return m_passes.recur(
          { vector.data() + begin, (end - begin) / groupOfNumbers, static_cast<float>(factor),
            added ? added + begin / 2 : nullptr, next ? next + begin / 2 : nullptr });
      });
  }

  /** The product of `factor` diag(1 / (2 m_i)) and the vector `from`. */
  template <class From, class To>
  void divideByMass(const CellSums& sums, const From& from, double factor, To& to) const
  {
    m_vectors.forEachInRows(
      [&](std::size_t i, std::size_t k)
      {
        const double mass = sums.mass[i];
        const double value = mass > 0.0 ? factor * from[k] / (2.0 * mass) : 0.0;
        to[k] = static_cast<typename To::value_type>(value);
      });
  }

  /**
   * The factor that makes the initial Hessian fit the last step's curvature, at least Lloyd's:
   * diag(2 m_i) bounds the Hessian from above.
   */
  double curvatureScale(const CellSums& sums) const
  {
    if (m_history.empty())
    {
      return 1.0;
    }
    const Correction& last = m_history.back();
    const std::size_t d = m_vectors.size() / sums.mass.size();
    const double scaled = m_vectors.sumOfBlocks(
      [&](std::size_t begin, std::size_t end)
      {
        double sum = 0.0;
        for (std::size_t i = begin / d; i < end / d; ++i)
        {
          double squared = 0.0;
          for (std::size_t k = i * d; k < (i + 1) * d; ++k)
          {
            const double change = numberOf(last.change, k);
            squared += change * change;
          }
          sum += sums.mass[i] > 0.0 ? squared / (2.0 * sums.mass[i]) : 0.0;
        }
        return sum;
      });
    return scaled > 0.0 ? std::max(1.0, last.product / scaled) : 1.0;
  }

  std::size_t m_length;
  const BlockedVectors& m_vectors;
  BlockedVectors m_groups; ///< of the history
  HistoryPasses m_passes = historyPasses(widestInstructionSet());
  std::deque<Correction> m_history; ///< oldest first
};

/**
 * Shortens the steps that leave their cell's surroundings, of which the energy at hand tells
 * nothing: a cell that has become small since the history was written makes its site leap.
 */
void stayNear(const CellSums& sums, const BlockedVectors& vectors, std::vector<double>& direction)
{
  const std::size_t d = direction.size() / sums.mass.size();
  vectors.forEachRow(
    [&](std::size_t i)
    {
      Eigen::Map<Eigen::VectorXd> step(direction.data() + i * d, static_cast<Eigen::Index>(d));
      const double most =
        sums.mass[i] > 0.0 ? longestStep * std::sqrt(sums.energy[i] / sums.mass[i]) : 0.0;
      if (const double length = step.norm(); length > most)
      {
        step *= most / length;
      }
    });
}

/** Where the line search is, and what it found there. */
struct Trial
{
  Sites sites;
  CellSums sums;
  double length = 1.0;
  bool accepted = false;
};

/** The minimum of the parabola through the energy, its slope and the trial's energy. */
double shorterLength(double length, double slope, double rise)
{
  const double best = -0.5 * slope * length * length / (rise - slope * length);
  return std::clamp(best, 0.1 * length, 0.5 * length);
}

/** g . p, with g = -2 moment. */
double slopeAlong(
  const CellSums& sums, const std::vector<double>& direction, const BlockedVectors& vectors)
{
  return vectors.sum([&](std::size_t k) { return -2.0 * sums.moment[k] * direction[k]; });
}

/**
 * The Hessian's direction; Lloyd's, which always descends, where the history misleads. Found again
 * from the same sums, it is the same. Returns the slope of the energy along it.
 */
double findDescent(const CellSums& sums, const BlockedVectors& vectors, InverseHessian& hessian,
  std::vector<double>& direction)
{
  hessian.descend(sums, direction);
  stayNear(sums, vectors, direction);
  double slope = slopeAlong(sums, direction, vectors);
  if (!(slope < 0.0))
  {
    hessian.clear();
    hessian.descend(sums, direction); // within the cells: near enough
    slope = slopeAlong(sums, direction, vectors);
  }
  return slope;
}

/**
 * Backtracks from the unit step until the energy has fallen enough. The direction becomes the sites
 * where it is, and is found again for each further trial: these are rare, and n x d are many.
 */
Status search(const Relaxation& relaxation, const BlockedVectors& vectors, InverseHessian& hessian,
  const RunControl& control, Trial& trial)
{
  const Sites& sites = relaxation.sites;
  trial.sites.dimension = sites.dimension;
  trial.sites.fixed = sites.fixed;
  trial.length = 1.0;
  trial.accepted = false;
  std::vector<double>& places = trial.sites.coordinates;
  for (int k = 0; k < maxTrials; ++k)
  {
    const double slope = findDescent(relaxation.sums, vectors, hessian, places);
    vectors.forEach(
      [&](std::size_t c) { places[c] = sites.coordinates[c] + trial.length * places[c]; });
    if (!vectors.complete())
    {
      return Status::cancelled();
    }
    if (Status status = relaxation.voronoi.integrate(
          trial.sites, k == 0 ? control : control.silent(), trial.sums);
        !status.ok())
    {
      return status;
    }
    holdFixedSites(trial.sites, trial.sums);
    const double rise = trial.sums.totalEnergy - relaxation.sums.totalEnergy;
    if (rise <= sufficientDecrease * trial.length * slope)
    {
      trial.accepted = true;
      break;
    }
    trial.length = shorterLength(trial.length, slope, rise);
  }
  return Status::success();
}

/** Where sites of the trial have lost their cells, moves these, and forgets the history. */
Status fill(
  const Relaxation& relaxation, const RunControl& control, InverseHessian& hessian, Trial& trial)
{
  if (countEmptyFree(trial.sites, trial.sums) == 0)
  {
    return Status::success();
  }
  hessian.clear();
  return integrateAndFill({ relaxation.voronoi, relaxation.surface, relaxation.seed, trial.sites,
                            trial.sums, relaxation.convergence, relaxation.emptyCells },
    control.silent());
}

/** Takes the trial over; tells by how much the energy has fallen. */
double accept(const Relaxation& relaxation, Trial& trial)
{
  const CellSums& sums = relaxation.sums;
  const double decrease = sums.totalEnergy - trial.sums.totalEnergy;
  std::swap(relaxation.sites, trial.sites);
  std::swap(relaxation.sums, trial.sums);
  relaxation.convergence.add(sums.totalEnergy, sums.gradientNorm, trial.length);
  return decrease;
}
}

int historyWithin(const EmbeddedSurface& surface, Offset numberOfSites, int wanted)
{
  constexpr double largePair = 0x1p24; // bytes
  constexpr double share = 1.0 / 12.0;
  const double d = surface.dimension;
  const double pair = historyBytes * static_cast<double>(numberOfSites) * d;
  if (surface.dimension < manyDimensions || pair <= largePair)
  {
    return wanted;
  }
  const double embedding = sizeof(double) * d * static_cast<double>(surface.numberOfCorners());
  return std::min(wanted, std::max(3, static_cast<int>(share * embedding / pair)));
}

Status minimizeQuasiNewton(
  const Relaxation& relaxation, const QuasiNewtonOptions& options, const RunControl& control)
{
  auto& [voronoi, surface, seed, sites, sums, convergence, emptyCells] = relaxation;
  const BlockedVectors vectors(sites.count(), sites.dimension, control);
  InverseHessian hessian(
    historyWithin(surface, sites.count(), options.historyLength), vectors, control);
  const double gradientBound = options.gradientTolerance * convergence.rows.front().gradientNorm;
  Trial trial;
  for (int step = 0; step < options.iterations && sums.gradientNorm > gradientBound; ++step)
  {
    if (Status status =
          search(relaxation, vectors, hessian, control.step(step, options.iterations), trial);
        !status.ok())
    {
      return status;
    }
    if (!trial.accepted)
    {
      break; // rounding is all that is left to gain
    }
    hessian.update(sites, sums, trial.sites, trial.sums);
    if (!hessian.complete())
    {
      return Status::cancelled();
    }
    if (Status status = fill(relaxation, control, hessian, trial); !status.ok())
    {
      return status;
    }
    const double decrease = accept(relaxation, trial);
    if (decrease <= options.energyTolerance * sums.totalEnergy)
    {
      break;
    }
  }
  return Status::success();
}
}
