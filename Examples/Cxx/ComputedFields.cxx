#include "ComputedFields.h"

#include "CommandLine.h"
#include "Failure.h"
#include "InputBytes.h"
#include "MeshWriter.h"
#include "RemesherSetup.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSolutionMetric.h>
#include <vtkSpectralEmbedding.h>

#include <algorithm>
#include <iterator>

namespace
{
/** Point arrays that each mesh has of its own (Outputs.md): those of the input are not on it. */
constexpr std::initializer_list<const char*> ownArrays = { "SiteId", "ComponentId", "CellColor",
  "CellArea", "CellMass", "CellEnergy", "CellWeightedMass", "Embedding", "Normals" };

/** The place of a choice among the names that the option has, in the order of the filter's. */
int NumberOf(const std::string& choice, std::initializer_list<const char*> names)
{
  return static_cast<int>(
    std::distance(names.begin(), std::find(names.begin(), names.end(), choice)));
}

void SetExecution(vtkSurfaceFieldAlgorithm* filter, const Options& options)
{
  filter->SetSMPBackend(BackendNumber(options.Backend));
  filter->SetNumberOfThreads(options.Threads);
}
} // namespace

vtkSmartPointer<vtkSurfaceFieldAlgorithm> MetricForSolutions(const Options& options)
{
  if (options.Solutions.empty())
  {
    return nullptr;
  }
  auto filter = vtkSmartPointer<vtkSolutionMetric>::New();
  SetExecution(filter, options);
  for (const std::string& solution : options.Solutions)
  {
    filter->AddSolutionArray(solution.c_str());
  }
  filter->SetErrorNorm(NumberOf(options.ErrorNorm, { "l1", "l2", "l4", "maximum" }));
  filter->SetNumberOfPoints(options.NumberOfPoints);
  filter->SetMinimumSize(options.MinimumSize);
  filter->SetMaximumSize(options.MaximumSize);
  return filter;
}

vtkSmartPointer<vtkSurfaceFieldAlgorithm> EigenfunctionsFor(const Options& options)
{
  if (options.Eigenfunctions == 0)
  {
    return nullptr;
  }
  auto filter = vtkSmartPointer<vtkSpectralEmbedding>::New();
  SetExecution(filter, options);
  filter->SetDimension(options.Eigenfunctions);
  filter->SetScaling(
    NumberOf(options.EigenfunctionScaling, { "none", "commute_time", "diffusion", "biharmonic" }));
  filter->SetDiffusionTime(options.DiffusionTime);
  return filter;
}

void CheckEmbeddings(const Options& options)
{
  const int embeddings = (options.Metric.empty() ? 0 : 1) + (options.Solutions.empty() ? 0 : 1) +
    (options.EmbeddingArray.empty() ? 0 : 1) + (options.Eigenfunctions == 0 ? 0 : 1);
  if (embeddings > 1)
  {
    UsageError("--metric, --solution, --embedding-array and --eigenfunctions all replace position "
               "and normal: choose one");
  }
  if (!MetricNameFor(options).empty() &&
    std::find(ownArrays.begin(), ownArrays.end(), options.Metric) != ownArrays.end())
  {
    UsageError("--metric " + options.Metric +
      ": the mesh has an array of its own with that name, " +
      "so that the metric cannot be written to '" + MetricNameFor(options) +
      "': give the array another name");
  }
}

Options WithComputedFields(const Options& options)
{
  Options changed = options;
  if (!options.Solutions.empty())
  {
    changed.Metric = "Metric";
    changed.MetricOrder = "vtk";
  }
  if (options.Eigenfunctions != 0)
  {
    changed.EmbeddingArray = "Embedding";
  }
  return changed;
}

std::string MetricNameFor(const Options& options)
{
  return WithComputedFields(options).Metric.empty() ? "" : SolutionNameFor(options.Output);
}

std::string MetricBytes(vtkPolyData* mesh, const Options& options)
{
  const Options computed = WithComputedFields(options);
  vtkDataArray* metric = mesh->GetPointData()->GetArray(computed.Metric.c_str());
  if (metric == nullptr)
  {
    throw Failure("the mesh has no point array '" + computed.Metric + "'");
  }
  return SolutionBytes(metric, computed.MetricOrder,
    MeshFormatFor(LowerCaseExtension(MetricNameFor(options)), metric->GetNumberOfTuples()));
}
