#include "Optimization/QuasiNewton.h"

#include "Optimization/BlockedVectors.h"
#include "Optimization/EmptyCells.h"
#include "Optimization/FixedSites.h"
#include "Support/Bfloat16.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <deque>

namespace remesh
{
namespace
{
constexpr double sufficientDecrease = 1e-4; // Armijo's constant
constexpr int mostTrials = 12;
constexpr double longestStep = 2.0; // times the root mean square radius of the cell

/** One pair of the history. */
struct Correction
{
  static_assert(2 * sizeof(Bfloat16) == historyBytes);

  std::vector<Bfloat16> step;
  std::vector<Bfloat16> change; ///< of the gradient
  double product = 0.0;         ///< step . change > 0
};

/** The limited-memory approximation of the inverse Hessian. */
class InverseHessian
{
public:
  InverseHessian(int length, const BlockedVectors& vectors)
    : m_length(static_cast<std::size_t>(std::max(length, 0)))
    , m_vectors(vectors)
  {
  }

  void clear() { m_history.clear(); }

  /** Takes in a step t p and the gradient's change from -2 before to -2 after. */
  void update(const std::vector<double>& direction, double length,
    const std::vector<double>& momentBefore, const std::vector<double>& momentAfter)
  {
    if (m_length == 0)
    {
      return;
    }
    const auto stepAt = [&](std::size_t k)
    { return Bfloat16(static_cast<float>(length * direction[k])); };
    const auto changeAt = [&](std::size_t k)
    { return Bfloat16(static_cast<float>(2.0 * (momentBefore[k] - momentAfter[k]))); };
    const double product = m_vectors.sum([&](std::size_t k)
      { return static_cast<double>(stepAt(k)) * static_cast<double>(changeAt(k)); });
    if (!(product > 0.0))
    {
      return; // and the oldest pair stays
    }
    Correction pair;
    if (m_history.size() == m_length)
    {
      pair = std::move(m_history.front()); // for its memory
      m_history.pop_front();
    }
    pair.product = product;
    pair.step.resize(direction.size());
    pair.change.resize(direction.size());
    m_vectors.forEach(
      [&](std::size_t k)
      {
        pair.step[k] = stepAt(k);
        pair.change[k] = changeAt(k);
      });
    m_history.push_back(std::move(pair));
  }

  /** Direction -H g with g = -2 moment and the initial H = gamma diag(1 / (2 m_i)). */
  void descend(const CellSums& sums, int dimension, std::vector<double>& direction) const
  {
    direction.resize(sums.moment.size());
    m_vectors.forEach([&](std::size_t k) { direction[k] = 2.0 * sums.moment[k]; });
    std::vector<double> factors(m_history.size());
    for (std::size_t h = m_history.size(); h-- > 0;)
    {
      const Correction& pair = m_history[h];
      factors[h] =
        m_vectors.sum([&](std::size_t k) { return pair.step[k] * direction[k]; }) / pair.product;
      m_vectors.forEach([&](std::size_t k) { direction[k] -= factors[h] * pair.change[k]; });
    }
    const auto d = static_cast<std::size_t>(dimension);
    const double gamma = this->curvatureScale(sums, d);
    m_vectors.forEach(
      [&](std::size_t k)
      {
        const double mass = sums.mass[k / d];
        direction[k] = mass > 0.0 ? gamma * direction[k] / (2.0 * mass) : 0.0;
      });
    for (std::size_t h = 0; h < m_history.size(); ++h)
    {
      const Correction& pair = m_history[h];
      const double factor = factors[h] -
        m_vectors.sum([&](std::size_t k) { return pair.change[k] * direction[k]; }) / pair.product;
      m_vectors.forEach([&](std::size_t k) { direction[k] += factor * pair.step[k]; });
    }
  }

private:
  /**
   * The factor that makes the initial Hessian fit the last step's curvature, at least Lloyd's:
   * diag(2 m_i) bounds the Hessian from above.
   */
  double curvatureScale(const CellSums& sums, std::size_t dimension) const
  {
    if (m_history.empty())
    {
      return 1.0;
    }
    const Correction& last = m_history.back();
    const double scaled = m_vectors.sum(
      [&](std::size_t k)
      {
        const double change = last.change[k];
        const double mass = sums.mass[k / dimension];
        return mass > 0.0 ? change * change / (2.0 * mass) : 0.0;
      });
    return scaled > 0.0 ? std::max(1.0, last.product / scaled) : 1.0;
  }

  std::size_t m_length;
  const BlockedVectors& m_vectors;
  std::deque<Correction> m_history; ///< oldest first
};

/**
 * Shortens the steps that leave their cell's surroundings, of which the energy at hand tells
 * nothing: a cell that has become small since the history was written makes its site leap.
 */
void stayNear(const CellSums& sums, int dimension, std::vector<double>& direction)
{
  const auto d = static_cast<std::size_t>(dimension);
  for (std::size_t i = 0; i < sums.mass.size(); ++i)
  {
    Eigen::Map<Eigen::VectorXd> step(direction.data() + i * d, dimension);
    const double most =
      sums.mass[i] > 0.0 ? longestStep * std::sqrt(sums.energy[i] / sums.mass[i]) : 0.0;
    if (const double length = step.norm(); length > most)
    {
      step *= most / length;
    }
  }
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

/** Backtracks from the unit step until the energy has fallen enough. */
Status search(RestrictedVoronoi& voronoi, const Sites& sites, const CellSums& sums,
  const std::vector<double>& direction, const BlockedVectors& vectors, const RunControl& control,
  Trial& trial)
{
  const double slope = slopeAlong(sums, direction, vectors);
  trial.sites.dimension = sites.dimension;
  trial.sites.fixed = sites.fixed;
  trial.sites.coordinates.resize(sites.coordinates.size());
  trial.length = 1.0;
  trial.accepted = false;
  for (int k = 0; k < mostTrials; ++k)
  {
    vectors.forEach([&](std::size_t c)
      { trial.sites.coordinates[c] = sites.coordinates[c] + trial.length * direction[c]; });
    if (!vectors.complete())
    {
      return Status::cancelled();
    }
    if (Status status =
          voronoi.integrate(trial.sites, k == 0 ? control : control.silent(), trial.sums);
        !status.ok())
    {
      return status;
    }
    holdFixedSites(trial.sites, trial.sums);
    const double rise = trial.sums.totalEnergy - sums.totalEnergy;
    if (rise <= sufficientDecrease * trial.length * slope)
    {
      trial.accepted = true;
      break;
    }
    trial.length = shorterLength(trial.length, slope, rise);
  }
  return Status::success();
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

Status minimizeQuasiNewton(RestrictedVoronoi& voronoi, const EmbeddedSurface& surface,
  const QuasiNewtonOptions& options, std::uint64_t seed, const RunControl& control, Sites& sites,
  CellSums& sums, Convergence& convergence, Index& emptyCells)
{
  const BlockedVectors vectors(sites.coordinates.size(), control);
  InverseHessian hessian(historyWithin(surface, sites.count(), options.historyLength), vectors);
  const double gradientBound = options.gradientTolerance * convergence.rows.front().gradientNorm;
  std::vector<double> direction;
  Trial trial;
  for (int step = 0; step < options.iterations && sums.gradientNorm > gradientBound; ++step)
  {
    hessian.descend(sums, sites.dimension, direction);
    stayNear(sums, sites.dimension, direction);
    if (!(slopeAlong(sums, direction, vectors) < 0.0))
    {
      hessian.clear(); // the history misleads: Lloyd's direction always descends
      hessian.descend(sums, sites.dimension, direction);
    }
    if (Status status = search(
          voronoi, sites, sums, direction, vectors, control.step(step, options.iterations), trial);
        !status.ok())
    {
      return status;
    }
    if (!trial.accepted)
    {
      break; // rounding is all that is left to gain
    }
    hessian.update(direction, trial.length, sums.moment, trial.sums.moment);
    if (countEmptyFree(trial.sites, trial.sums) > 0)
    {
      hessian.clear();
      if (Status status = integrateAndFill(
            voronoi, surface, seed, control.silent(), trial.sites, trial.sums, emptyCells);
          !status.ok())
      {
        return status;
      }
    }
    const double decrease = sums.totalEnergy - trial.sums.totalEnergy;
    std::swap(sites, trial.sites);
    std::swap(sums, trial.sums);
    convergence.add(sums.totalEnergy, sums.gradientNorm, trial.length);
    if (decrease <= options.energyTolerance * sums.totalEnergy)
    {
      break;
    }
  }
  return Status::success();
}
}
