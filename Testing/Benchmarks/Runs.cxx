#include "Runs.h"

#include "Measure.h"
#include "Optimization/Sampling.h"
#include "Run/FirstSites.h"
#include "RunParts.h"
#include "vtkAnisotropicRemesher.h"
#include "vtkMetricEmbedding.h"

#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLPolyDataReader.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <stdexcept>

namespace remesh::benchmark
{
namespace
{
constexpr int convergedIterations = 300;

/** What a default run starts from, where there are no features. */
Sites firstSites(const EmbeddedSurface& surface, Offset points)
{
  RemeshOptions options;
  options.numberOfSites = points;
  const SurfaceMesh mesh; // only for features
  RemeshResult start;
  orThrow(makeSites({ mesh, surface, nullptr, options }, RunControl(), start));
  return start.sites;
}

Figures evaluationOnce(const EmbeddedSurface& surface, const Sites& sites, const Settings& settings)
{
  Optimization optimization(surface);
  optimization.sites = sites;
  Elapsed total;
  inScope(settings,
    [&]()
    {
      total = timed(
        [&]() { optimization.run(surface, settings.lloydIterations, settings.newtonIterations); });
    });
  const double share = 1.0 / optimization.voronoi.evaluations();
  const auto average = [=](const Elapsed& sum) {
    return Elapsed{ share * sum.wall, share * sum.processor };
  };
  const EvaluationTimes& times = optimization.voronoi.times();
  Elapsed rest = total;
  for (const Elapsed& part : { times.neighbors, times.ownership, times.clipping, times.reduction })
  {
    rest.wall -= part.wall;
    rest.processor -= part.processor;
  }
  Figures figures;
  addTimes(figures, "", average(total));
  addTimes(figures, "neighbors", average(times.neighbors));
  addTimes(figures, "ownership", average(times.ownership));
  addTimes(figures, "clipping", average(times.clipping));
  addTimes(figures, "reduction", average(times.reduction));
  addTimes(figures, "optimizer", average(rest));
  return figures;
}

/** A default run of the filter, other things set. */
void runFilter(
  vtkAnisotropicRemesher* remesher, vtkPolyData* surface, Offset points, const Settings& settings)
{
  remesher->SetInputData(surface);
  remesher->SetNumberOfPoints(points);
  remesher->SetAnisotropy(anisotropy);
  remesher->SetNumberOfLloydIterations(settings.lloydIterations);
  remesher->SetNumberOfNewtonIterations(settings.newtonIterations);
  remesher->SetNumberOfThreads(settings.threads);
  remesher->Update();
  if (remesher->GetOutput()->GetNumberOfPolys() == 0)
  {
    throw std::runtime_error("the filter gave no triangles");
  }
}

/** A folder of its own for this process's files, with all in it removed at the end. */
class ScratchFolder
{
public:
  ScratchFolder()
    : m_path(
        std::filesystem::temp_directory_path() / ("remesh-benchmark-" + std::to_string(getpid())))
  {
    if (!std::filesystem::create_directory(m_path))
    {
      throw std::runtime_error("there is already a folder " + m_path.string());
    }
  }
  ~ScratchFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string file(const std::string& name) const { return (m_path / name).string(); }

private:
  std::filesystem::path m_path;
};
}

Figures evaluation(const EmbeddedSurface& surface, Offset points, const Settings& settings)
{
  Sites sites;
  orThrow(sampleSurface(surface, points, { SamplingMethod::Stratified, 0 }, sites));
  return repeated(settings, [&]() { return evaluationOnce(surface, sites, settings); });
}

Figures filterRun(vtkPolyData* surface, Offset points, const Settings& settings)
{
  return repeated(settings,
    [&]()
    {
      vtkNew<vtkAnisotropicRemesher> remesher;
      Figures figures;
      addTimes(figures, "", timed([&]() { runFilter(remesher, surface, points, settings); }));
      return figures;
    });
}

void runWide(const WideRun& wide, const Settings& settings)
{
  const Surface surface = bumpyTorus(wide.triangles);
  surface.data->GetPointData()->AddArray(smoothFunctions(surface.data, wide.dimension - 3));
  vtkNew<vtkAnisotropicRemesher> remesher;
  remesher->SetEmbeddingMode(vtkAnisotropicRemesher::POSITION);
  remesher->AddCoordinateArray("Smooth", 1.0);
  remesher->GenerateVoronoiCellsOff();
  runFilter(remesher, surface.data, wide.points, settings);
}

Figures wideRun(const WideRun& wide, const Settings& settings)
{
  const std::vector<std::string> command = { settings.self, "--lloyd",
    std::to_string(settings.lloydIterations), "--newton", std::to_string(settings.newtonIterations),
    "--threads", std::to_string(settings.threads), "--wide-run", std::to_string(wide.triangles),
    std::to_string(wide.points), std::to_string(wide.dimension) };
  const auto points = static_cast<double>(bumpyTorus(wide.triangles).data->GetNumberOfPoints());
  const double embedding = 1e-6 * sizeof(double) * points * wide.dimension;
  const Cost cost = costOf(settings.self, command);
  Figures figures;
  addTimes(figures, "", cost.elapsed);
  figures.push_back({ "memory", cost.megabytes, "MB" });
  figures.push_back({ "memory_multiple", cost.megabytes / embedding, "1" });
  return figures;
}

namespace
{
/** The surface with the point array Embedding. */
vtkSmartPointer<vtkPolyData> embeddedInMetric(
  vtkPolyData* surface, Offset points, const Settings& settings)
{
  vtkNew<vtkMetricEmbedding> embedding;
  embedding->SetInputData(surface);
  embedding->SetMetricArray("Metric");
  embedding->SetNumberOfPoints(points);
  embedding->SetNumberOfThreads(settings.threads);
  embedding->Update();
  if (!embedding->GetOutput()->GetPointData()->GetArray("Embedding"))
  {
    throw std::runtime_error("the metric was not embedded");
  }
  return embedding->GetOutput();
}
}

void runMetric(const MetricRun& metric, const Settings& settings)
{
  embeddedInMetric(surfaceFor(metric).data, metric.points, settings);
}

Figures metricRun(const MetricRun& metric, const Settings& settings)
{
  const Surface surface = surfaceFor(metric);
  const std::vector<std::string> command = { settings.self, "--threads",
    std::to_string(settings.threads), metric.isBent ? "--bent-run" : "--metric-run",
    std::to_string(metric.surfacePoints), std::to_string(metric.points) };
  return repeated(settings,
    [&]()
    {
      vtkSmartPointer<vtkPolyData> embedded;
      const Elapsed embedding =
        timed([&]() { embedded = embeddedInMetric(surface.data, metric.points, settings); });
      vtkNew<vtkAnisotropicRemesher> remesher;
      remesher->SetEmbeddingArray("Embedding");
      const Elapsed remeshing =
        timed([&]() { runFilter(remesher, embedded, metric.points, settings); });
      Figures figures;
      addTimes(figures, "", embedding);
      addTimes(figures, "remeshing", remeshing);
      figures.push_back({ "over_remeshing", embedding.processor / remeshing.processor, "1" });
      figures.push_back({ "memory", costOf(settings.self, command).megabytes, "MB" });
      return figures;
    });
}

namespace
{
double pointsIn(const std::string& mesh)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(mesh.c_str());
  reader->Update();
  return static_cast<double>(reader->GetOutput()->GetNumberOfPoints());
}
}

Figures programRun(const Surface& surface, Offset points, const std::vector<std::string>& options,
  const Settings& settings)
{
  const ScratchFolder folder;
  std::string input = surface.file;
  if (input.empty())
  {
    input = folder.file(std::string("surface") + extensionFor(surface.data));
    writeSurface(surface.data, input);
  }
  const std::string output = folder.file("mesh.vtp");
  std::vector<std::string> command = { settings.program, input, output, "--points",
    std::to_string(points), "--anisotropy", std::to_string(anisotropy), "--lloyd",
    std::to_string(settings.lloydIterations), "--newton", std::to_string(settings.newtonIterations),
    "--threads", std::to_string(settings.threads), "--quiet" };
  command.insert(command.end(), options.begin(), options.end());
  return repeated(settings,
    [&]()
    {
      const Cost cost = costOf(settings.self, command);
      Figures figures;
      addTimes(figures, "", cost.elapsed);
      figures.push_back({ "memory", cost.megabytes, "MB" });
      figures.push_back(
        { "points_over_asked", pointsIn(output) / static_cast<double>(points), "1" });
      return figures;
    });
}

Figures costOfExactness(const EmbeddedSurface& surface, Offset points, const Settings& settings)
{
  Optimization optimization(surface);
  orThrow(sampleSurface(surface, points, { SamplingMethod::Stratified, 0 }, optimization.sites));
  inScope(settings,
    [&]() { optimization.run(surface, settings.lloydIterations, settings.newtonIterations); });
  const auto diagram = [&](Decisions decisions)
  {
    RestrictedVoronoi voronoi(surface, widestInstructionSet(), decisions);
    CellSums sums;
    Diagram made;
    return timed(
      [&]() { orThrow(voronoi.decompose(optimization.sites, RunControl(), sums, made)); })
      .processor;
  };
  return repeated(settings,
    [&]()
    {
      double exact = 0.0;
      double filtered = 0.0;
      inScope(settings,
        [&]()
        {
          static_cast<void>(diagram(Decisions::Exact)); // for the caches
          for (int k = 0; k < 4; ++k)
          {
            filtered += diagram(Decisions::FilterAlone);
            exact += diagram(Decisions::Exact);
          }
        });
      return Figures{ { "processor", exact / 4.0, "s" },
        { "exactness", 100.0 * (exact / filtered - 1.0), "%" } };
    });
}

Figures energyLeft(const EmbeddedSurface& surface, Offset points, const Settings& settings)
{
  Optimization optimization(surface);
  inScope(settings,
    [&]()
    {
      optimization.sites = firstSites(surface, points);
      optimization.run(surface, settings.lloydIterations, convergedIterations);
    });
  // The default run is the beginning of the longer one.
  const std::vector<ConvergenceRow>& rows = optimization.convergence.rows;
  const std::size_t end = std::min(rows.size() - 1,
    static_cast<std::size_t>(settings.lloydIterations) +
      static_cast<std::size_t>(settings.newtonIterations));
  const double least = rows.back().energy;
  const auto near = std::find_if(rows.begin(), rows.end(),
    [=](const ConvergenceRow& row) { return row.energy <= 1.003 * least; });
  return { { "energy_above_converged", 100.0 * (rows[end].energy / least - 1.0), "%" },
    { "steps_to_0.3_percent", static_cast<double>(near - rows.begin()), "1" } };
}
}
