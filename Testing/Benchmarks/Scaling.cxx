#include "Scaling.h"

#include "Runs.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <thread>

namespace remesh::benchmark
{
namespace
{
Measurement evaluated(
  const Surface& surface, const EmbeddedSurface& embedded, Offset points, const Settings& settings)
{
  return { surface.name, embedded.numberOfFacets(), points, embedded.dimension, settings.threads,
    evaluation(embedded, points, settings) };
}

double processor(const Measurement& measurement)
{
  return value(measurement.figures, "processor");
}

/** Least squares of the relative deviations from a m + b n. */
Figures fitSizes(const std::vector<Measurement>& measurements)
{
  const auto rows = static_cast<Eigen::Index>(measurements.size());
  Eigen::MatrixX2d model(rows, 2);
  for (Eigen::Index k = 0; k < rows; ++k)
  {
    const Measurement& one = measurements[static_cast<std::size_t>(k)];
    model(k, 0) = static_cast<double>(one.triangles) / processor(one);
    model(k, 1) = static_cast<double>(one.points) / processor(one);
  }
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(rows);
  const Eigen::Vector2d fit = model.colPivHouseholderQr().solve(ones);
  return { { "per_triangle", 1e6 * fit[0], "us" }, { "per_point", 1e6 * fit[1], "us" },
    { "deviation", 100.0 * (model * fit - ones).cwiseAbs().maxCoeff(), "%" } };
}

/** The slope of the regression line of log seconds over log triangles. */
double exponentOf(const std::vector<Measurement>& measurements)
{
  const auto rows = static_cast<Eigen::Index>(measurements.size());
  Eigen::ArrayXd size(rows);
  Eigen::ArrayXd cost(rows);
  for (Eigen::Index k = 0; k < rows; ++k)
  {
    const Measurement& one = measurements[static_cast<std::size_t>(k)];
    size[k] = std::log(static_cast<double>(one.triangles));
    cost[k] = std::log(processor(one));
  }
  size -= size.mean();
  return (size * (cost - cost.mean())).sum() / size.square().sum();
}
}

void scaleSize(Workshop& workshop, CaseResult& result)
{
  for (const double triangles : { scanTriangles, 4.0 * scanTriangles, 16.0 * scanTriangles })
  {
    const Surface surface = bumpyTorus(static_cast<double>(workshop.shrunk(triangles)));
    const EmbeddedSurface embedded = gaussMapped(surface.data);
    for (const double points : { 1e4, 3e4, 1e5, 3e5 })
    {
      result.measurements.push_back(
        evaluated(surface, embedded, workshop.shrunk(points), workshop.settings()));
    }
  }
  result.figures = fitSizes(result.measurements);
}

void scaleRatio(Workshop& workshop, CaseResult& result)
{
  for (const double triangles : { 2e4, 6e4, 2e5, 6e5, 2e6 })
  {
    const Surface surface = bumpyTorus(static_cast<double>(workshop.shrunk(triangles)));
    result.measurements.push_back(evaluated(
      surface, gaussMapped(surface.data), workshop.shrunk(0.1 * triangles), workshop.settings()));
  }
  result.figures = { { "exponent", exponentOf(result.measurements), "1" } };
}

void scaleDimension(Workshop& workshop, CaseResult& result)
{
  const Surface surface = bumpyTorus(static_cast<double>(workshop.shrunk(2e4)));
  for (const int dimension : { 3, 6, 8, 10, 17, 100, 1000 })
  {
    result.measurements.push_back(evaluated(
      surface, embeddedIn(surface.data, dimension), workshop.shrunk(2e3), workshop.settings()));
  }
}

void scaleThreads(Workshop& workshop, CaseResult& result)
{
  const Surface& surface = workshop.fine();
  const EmbeddedSurface embedded = gaussMapped(surface.data);
  const int most = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  for (const double points : { 3e4, 1e5 })
  {
    double alone = 0.0;
    Settings settings = workshop.settings();
    for (settings.threads = 1; settings.threads <= most; settings.threads *= 2)
    {
      Measurement one = evaluated(surface, embedded, workshop.shrunk(points), settings);
      const Figures whole = filterRun(surface.data, one.points, settings);
      const double wall = value(whole, "wall");
      one.figures.push_back({ "filter_processor", value(whole, "processor"), "s" });
      one.figures.push_back({ "filter_wall", wall, "s" });
      alone = settings.threads == 1 ? wall : alone;
      result.figures.push_back(
        { "speedup_" + std::to_string(one.points) + "_" + std::to_string(settings.threads),
          alone / wall, "1" });
      result.measurements.push_back(std::move(one));
    }
  }
}
}
