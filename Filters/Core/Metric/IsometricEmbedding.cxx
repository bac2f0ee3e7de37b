#include "Metric/IsometricEmbedding.h"

#include "Metric/IsometrySteps.h"
#include "Metric/LaplacianMatrix.h"
#include "Metric/MetricCoarsening.h"
#include "Metric/SpectralStart.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
// In units:
constexpr double longestSide = 0.8;      // of the coarse surface
constexpr double coarseSmoothing = 1.0;  // root of the time for which crumples are smoothed
constexpr double fineSmoothing = 0.2;    // the same, for the coarse surface's own sides
constexpr double minUnits2 = 3000.0;     // that the coarse surface has, of its own ones
constexpr double smoothedUnits2 = 500.0; // the same for the unit of the smoothing
// Steps:
constexpr int coarseSteps = 60;
constexpr int mendingSteps = 60;
constexpr int fineSteps = 8;
constexpr int innerSteps = 6;
/** Of the points: where more are left, the given surface is coarse itself. */
constexpr double coarseShare = 0.7;

/** The unit, or what makes so many units of the area. */
double unitFor(double unit, double area, double count)
{
  return std::min(unit, std::sqrt(area / count));
}

Status cancelledUnless(bool done)
{
  return done ? Status::success() : Status::cancelled();
}

/** From the spectral start, with a factor. */
Status embedWithFactor(const ShapedFacets& surface, const IsometryOptions& options,
  RunControl control, IsometricEmbedding& embedding)
{
  MetricLaplacian laplacian(surface, control.silent());
  if (control.cancelled())
  {
    return Status::cancelled();
  }
  if (Status status = laplacian.factor(control.silent()); !status.ok())
  {
    return status;
  }
  control.enterPhase("Metric embedding", 0.3, 0.4);
  if (!makeSpectralStart(laplacian, options.dimension, options.seed, control, embedding.places))
  {
    return Status::cancelled();
  }
  const bool isSmoothed = options.unit > 0.0;
  control.enterPhase("Metric embedding", 0.4, 0.6);
  StepOptions steps;
  steps.iterations = isSmoothed ? std::min(coarseSteps, options.iterations) : options.iterations;
  steps.energyDecrease = options.energyDecrease;
  if (!stepToIsometry(laplacian, steps, control, embedding.places, embedding.energies))
  {
    return Status::cancelled();
  }
  if (!isSmoothed)
  {
    return Status::success();
  }
  control.enterPhase("Metric embedding", 0.6, 0.7);
  const double width =
    coarseSmoothing * unitFor(options.unit, laplacian.totalArea(), smoothedUnits2);
  steps.iterations = mendingSteps;
  LaplacianMatrix matrix(laplacian, control.silent());
  return cancelledUnless(!control.cancelled() &&
    matrix.smooth(width * width, control.silent(), embedding.places) &&
    stepToIsometry(laplacian, steps, control, embedding.places, embedding.energies));
}

/** From places on a coarse surface, where what is left are short waves. */
Status embedFinely(const MetricLaplacian& laplacian, const IsometryOptions& options,
  RunControl control, IsometricEmbedding& embedding)
{
  control.enterPhase("Metric embedding", 0.7, 1.0);
  LaplacianMatrix matrix(laplacian, control.silent());
  const double width = fineSmoothing * options.unit;
  StepOptions steps;
  steps.iterations = fineSteps;
  steps.matrix = &matrix;
  steps.innerIterations = innerSteps;
  return cancelledUnless(!control.cancelled() &&
    matrix.smooth(width * width, control.silent(), embedding.places) &&
    stepToIsometry(laplacian, steps, control, embedding.places, embedding.energies));
}

Status embedPlaces(const MetricLaplacian& laplacian, const IsometryOptions& options,
  const RunControl& control, IsometricEmbedding& embedding)
{
  const ShapedFacets& surface = laplacian.surface();
  const double unit = unitFor(options.unit, laplacian.totalArea(), minUnits2);
  CoarseSurface coarse;
  if (unit > 0.0 && !coarsen(surface, longestSide * unit, control.silent(), coarse))
  {
    return Status::cancelled();
  }
  const auto count = static_cast<Index>(coarse.points.size());
  if (!(unit > 0.0) || count > coarseShare * surface.points)
  {
    return embedWithFactor(surface, options, control, embedding);
  }
  Status status =
    embedWithFactor({ count, coarse.facetPoints, coarse.shapes }, options, control, embedding);
  if (status.ok())
  {
    embedding.places = coarse.prolonged(embedding.places);
    IsometryOptions fine = options;
    fine.unit = unit;
    status = embedFinely(laplacian, fine, control, embedding);
  }
  return status;
}
}

Status embedIsometrically(const ShapedFacets& surface, const IsometryOptions& options,
  RunControl control, IsometricEmbedding& embedding)
{
  embedding = IsometricEmbedding{};
  control.enterPhase("Metric embedding", 0.0, 0.3);
  const MetricLaplacian laplacian(surface, control.silent());
  if (control.cancelled())
  {
    return Status::cancelled();
  }
  if (Status status = embedPlaces(laplacian, options, control, embedding); !status.ok())
  {
    return status;
  }
  embedding.stretches.resize(surface.shapes.size());
  const auto findStretch = [&](Offset f)
  {
    const auto [least, most] =
      stretchesOf(laplacian.gradient(embedding.places, static_cast<Index>(f)));
    embedding.stretches[f] = { static_cast<float>(least), static_cast<float>(most) };
  };
  return cancelledUnless(
    forEachItem(static_cast<Offset>(surface.shapes.size()), control.silent(), findStretch));
}
}
