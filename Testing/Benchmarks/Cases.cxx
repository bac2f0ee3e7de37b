#include "Cases.h"

#include "RankRun.h"
#include "Runs.h"
#include "Scaling.h"

#include <algorithm>
#include <cmath>

namespace remesh::benchmark
{
namespace
{
Measurement described(const Surface& surface, Offset points, const Settings& settings)
{
  return { surface.name, surface.data->GetNumberOfPolys(), points, 6, settings.threads, {} };
}

const Surface& chosen(Workshop& workshop, bool finest)
{
  return finest ? workshop.finest() : workshop.fine();
}

Case evaluationCase(const char* name, bool finest, double points)
{
  return { std::string("evaluation-") + name, "one evaluation, averaged over an optimisation",
    [=](Workshop& workshop, CaseResult& result)
    {
      const Surface& surface = chosen(workshop, finest);
      Measurement one = described(surface, workshop.shrunk(points), workshop.settings());
      one.figures = evaluation(gaussMapped(surface.data), one.points, workshop.settings());
      result.measurements.push_back(one);
    } };
}

Case programCase(const std::string& name, const char* description, bool finest, double points,
  const std::vector<std::string>& options)
{
  return { name, description,
    [=](Workshop& workshop, CaseResult& result)
    {
      const Surface& surface = chosen(workshop, finest);
      Measurement one = described(surface, workshop.shrunk(points), workshop.settings());
      one.figures = programRun(surface, one.points, options, workshop.settings());
      result.measurements.push_back(one);
    } };
}

Case runCase(const char* name, bool finest, double points)
{
  return programCase(
    std::string("run-") + name, "the command line, from file to file", finest, points, {});
}

Case plainCase(const char* name, bool finest, double points)
{
  return programCase(std::string("plain-") + name,
    "the command line without features, fit and distances", finest, points,
    { "--no-features", "--placement", "centroid", "--no-distance" });
}

void measureEnergy(Workshop& workshop, CaseResult& result)
{
  const Surface& surface = workshop.fine();
  Measurement one = described(surface, workshop.shrunk(1e4), workshop.settings());
  one.figures = energyLeft(gaussMapped(surface.data), one.points, workshop.settings());
  result.measurements.push_back(one);
}

void measureExactness(Workshop& workshop, CaseResult& result)
{
  const Surface& surface = workshop.fine();
  Measurement one = described(surface, workshop.shrunk(1e4), workshop.settings());
  one.figures = costOfExactness(gaussMapped(surface.data), one.points, workshop.settings());
  result.measurements.push_back(one);
}

void measureShell(Workshop& workshop, CaseResult& result)
{
  const Surface surface = thinShell(static_cast<double>(workshop.shrunk(4e4)));
  Measurement one = described(surface, workshop.shrunk(100), workshop.settings());
  one.figures = filterRun(surface.data, one.points, workshop.settings());
  result.measurements.push_back(one);
}

void measureWideRun(Workshop& workshop, CaseResult& result)
{
  const WideRun wide = { static_cast<int>(workshop.shrunk(1e5)),
    static_cast<int>(workshop.shrunk(1e3)), 5000 };
  const Surface surface = bumpyTorus(wide.triangles);
  Measurement one = described(surface, wide.points, workshop.settings());
  one.dimension = wide.dimension;
  one.figures = wideRun(wide, workshop.settings());
  result.measurements.push_back(one);
}

void scaleRanks(Workshop& workshop, CaseResult& result)
{
  const RankRun run = { 0, static_cast<int>(workshop.shrunk(16.0 * scanTriangles)),
    static_cast<int>(workshop.shrunk(1e5)) };
  const Surface surface = bumpyTorus(run.triangles);
  Measurement one = described(surface, run.points, workshop.settings());
  one.figures = rankRuns(run, workshop.settings(), result.figures);
  result.measurements.push_back(one);
}

Case metricCase(const std::string& name, double surfacePoints, double points, bool isBent)
{
  return { name, "the embedding of a metric, and remeshing in it",
    [=](Workshop& workshop, CaseResult& result)
    {
      const MetricRun metric = { static_cast<int>(workshop.shrunk(surfacePoints)),
        static_cast<int>(workshop.shrunk(points)), isBent };
      const Surface surface = surfaceFor(metric);
      Measurement one = described(surface, metric.points, workshop.settings());
      one.figures = metricRun(metric, workshop.settings());
      result.measurements.push_back(one);
    } };
}

/** @param isUnit whether the metric decides the number of points, which is scaled to the same. */
Case metricRunCase(const std::string& name, bool isUnit)
{
  return { name, "the command line with a metric, from file to file",
    [=](Workshop& workshop, CaseResult& result)
    {
      const Surface surface = torusWithMetric(static_cast<double>(workshop.shrunk(1e5)));
      Measurement one = described(surface, workshop.shrunk(1e4), workshop.settings());
      std::vector<std::string> options = { "--metric", "Metric" };
      if (isUnit)
      {
        const double area = 0.5 * std::sqrt(3.0) * static_cast<double>(one.points);
        options.insert(options.end(), { "--unit", "--complexity", std::to_string(area) });
      }
      one.figures = programRun(surface, one.points, options, workshop.settings());
      result.measurements.push_back(one);
    } };
}
}

const Surface& Workshop::fine()
{
  if (!m_fine.data)
  {
    m_fine = m_settings.shrink == 1.0 ? scan(m_settings.data)
                                      : bumpyTorus(scanTriangles / m_settings.shrink);
  }
  return m_fine;
}

const Surface& Workshop::finest()
{
  if (!m_finest.data)
  {
    m_finest = subdivided(this->fine());
  }
  return m_finest;
}

Offset Workshop::shrunk(double number) const
{
  return static_cast<Offset>(std::max(20.0, std::round(number / m_settings.shrink)));
}

const std::vector<Case>& allCases()
{
  // Named by the numbers of triangles and points.
  static const std::vector<Case> cases = {
    evaluationCase("86k-10k", false, 1e4),
    evaluationCase("86k-100k", false, 1e5),
    evaluationCase("1.4M-10k", true, 1e4),
    evaluationCase("1.4M-100k", true, 1e5),
    evaluationCase("1.4M-1M", true, 1e6),
    plainCase("86k-10k", false, 1e4),
    plainCase("86k-100k", false, 1e5),
    plainCase("1.4M-1M", true, 1e6),
    runCase("86k-10k", false, 1e4),
    runCase("86k-100k", false, 1e5),
    runCase("1.4M-1M", true, 1e6),
    programCase("few-86k-100", "a run with too few points for the shape", false, 100, {}),
    { "energy-86k-10k", "how far from converged a default run ends", measureEnergy },
    { "exact-86k-10k", "what exact decisions cost over their filters alone", measureExactness },
    { "shell-40k-100", "the filter on two sheets, far closer than the points", measureShell },
    { "wide-100k-1k", "the filter in 5000 dimensions", measureWideRun },
    metricCase("metric-200k-10k", 1e5, 1e4, false),
    metricCase("metric-2M-10k", 1e6, 1e4, false),
    metricCase("metric_bent-200k-4k", 1e5, 4e3, true),
    metricRunCase("metric_run-200k-10k", false),
    metricRunCase("metric_unit-200k-10k", true),
    { "scaling-size", "over triangles m and points n: the fit a m + b n", scaleSize },
    { "scaling-ratio", "over a factor of 100 at fixed m / n: the exponent", scaleRatio },
    { "scaling-dimension", "over d from 3 to 1000", scaleDimension },
    { "scaling-ranks", "optimisation and distances on 1, 2 and 4 processes: the speed-up",
      scaleRanks },
    { "scaling-threads", "the filter with 1, 2, 4... threads: the speed-up", scaleThreads },
  };
  return cases;
}
}
