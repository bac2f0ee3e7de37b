#include "Metric/IsometricEmbedding.h"

#include "Metric/SpectralStart.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
constexpr std::size_t look = 10; // steps over which the decrease counts

/** J J' of a facet and what follows from it. */
struct Gram
{
  double xx, xy, yy;

  explicit Gram(const FacetRows& rows)
    : xx(rows.row(0).squaredNorm())
    , xy(rows.row(0).dot(rows.row(1)))
    , yy(rows.row(1).squaredNorm())
  {
  }
  /** The least and the largest stretch. */
  std::array<double, 2> stretches() const
  {
    const double mean = 0.5 * (xx + yy);
    const double large = mean + std::hypot(0.5 * (xx - yy), xy);
    const double small = large > 0.0 ? std::max(0.0, xx * yy - xy * xy) / large : 0.0;
    return { std::sqrt(small), std::sqrt(large) };
  }
};

/** The nearest matrix with orthonormal rows; of a flat one, some matrix near it. */
FacetRows nearestIsometry(const FacetRows& rows)
{
  constexpr double flat = 1e-12; // of the larger stretch: below, the smaller has no direction
  const Gram gram(rows);
  const double trace = gram.xx + gram.yy;
  if (!(trace > 0.0))
  {
    FacetRows any = FacetRows::Zero(2, rows.cols());
    any(0, 0) = any(1, 1) = 1.0;
    return any;
  }
  const double root =
    std::sqrt(std::max(gram.xx * gram.yy - gram.xy * gram.xy, flat * flat * trace * trace));
  const double sum = std::sqrt(trace + 2.0 * root); // of both stretches
  // (C + root I)^-1 sum J
  const double a = gram.xx + root;
  const double c = gram.yy + root;
  const double scale = sum / (a * c - gram.xy * gram.xy);
  FacetRows nearest(2, rows.cols());
  nearest.row(0) = scale * (c * rows.row(0) - gram.xy * rows.row(1));
  nearest.row(1) = scale * (a * rows.row(1) - gram.xy * rows.row(0));
  return nearest;
}

/** Local and global steps. */
class Steps
{
public:
  Steps(const MetricLaplacian& laplacian, const RunControl& control)
    : m_laplacian(laplacian)
    , m_control(control)
  {
  }

  /** Runs from `places`; false when cancelled. */
  bool run(const IsometryOptions& options, Rows& places, std::vector<double>& energies)
  {
    double energy = 0.0;
    if (!this->findRests(places, energy))
    {
      return false;
    }
    energies.assign(1, energy);
    for (int k = 0; k < options.iterations && !this->hasEnded(options, energies); ++k)
    {
      m_control.report(static_cast<double>(k) / options.iterations);
      Rows slope;
      Rows way;
      if (!m_laplacian.divergence(m_rests, m_control.silent(), slope) ||
        !m_laplacian.solve(slope, m_control.silent(), way))
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
  /** Q - J on each facet, and the energy per area. */
  bool findRests(const Rows& places, double& energy)
  {
    m_rests.resize(2 * Offset(m_laplacian.numberOfFacets()), places.cols());
    const Blocks blocks = Blocks::cut(m_laplacian.numberOfFacets(), 64, 1 << 14);
    const auto findRest = [&](std::size_t f)
    {
      const auto facet = static_cast<Index>(f);
      const FacetRows rows = m_laplacian.gradient(places, facet);
      const FacetRows rest = nearestIsometry(rows) - rows;
      m_rests.middleRows(2 * Offset(facet), 2) = rest;
      return m_laplacian.area(facet) * rest.squaredNorm();
    };
    const bool done = sumInBlocks(blocks, m_control.silent(), findRest, energy);
    energy /= m_laplacian.totalArea();
    return done;
  }

  static bool hasEnded(const IsometryOptions& options, const std::vector<double>& energies)
  {
    constexpr double exact = 1e-12; // nothing but rounding
    const std::size_t count = energies.size();
    return energies.back() < exact ||
      (count > look &&
        energies[count - 1 - look] - energies.back() < options.energyDecrease * energies.back());
  }

  const MetricLaplacian& m_laplacian;
  RunControl m_control;
  Rows m_rests; ///< 2F x d
};
}

Status embedIsometrically(const SurfaceMesh& mesh, const std::vector<TargetShape>& shapes,
  const IsometryOptions& options, RunControl control, IsometricEmbedding& embedding)
{
  embedding = IsometricEmbedding{};
  control.enterPhase("Metric embedding", 0.0, 0.3);
  MetricLaplacian laplacian(mesh, shapes, control.silent());
  if (control.cancelled())
  {
    return Status::cancelled();
  }
  if (Status status = laplacian.factor(control.silent()); !status.ok())
  {
    return status;
  }
  control.enterPhase("Metric embedding", 0.3, 0.5);
  if (!makeSpectralStart(laplacian, options.dimension, options.seed, control, embedding.places))
  {
    return Status::cancelled();
  }
  control.enterPhase("Metric embedding", 0.5, 1.0);
  Steps steps(laplacian, control);
  if (!steps.run(options, embedding.places, embedding.energies))
  {
    return Status::cancelled();
  }
  embedding.stretches.resize(shapes.size());
  const auto findStretch = [&](Offset f)
  {
    const auto [least, most] =
      Gram(laplacian.gradient(embedding.places, static_cast<Index>(f))).stretches();
    embedding.stretches[f] = { static_cast<float>(least), static_cast<float>(most) };
  };
  return forEachItem(static_cast<Offset>(shapes.size()), control.silent(), findStretch)
    ? Status::success()
    : Status::cancelled();
}
}
