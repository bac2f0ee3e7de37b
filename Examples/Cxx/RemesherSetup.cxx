#include "RemesherSetup.h"

#include "CommandLine.h"
#include "Failure.h"

#include <vtkAnisotropicRemesher.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

namespace
{
/** Throws Failure unless `surface` has a point array `name`, of 3 components if `normals`. */
void CheckArray(vtkPolyData* surface, const std::string& name, bool normals)
{
  vtkDataArray* array = surface->GetPointData()->GetArray(name.c_str());
  if (array == nullptr)
  {
    throw Failure("the surface has no point array '" + name + "'");
  }
  if (normals && array->GetNumberOfComponents() != 3)
  {
    throw Failure("the point array '" + name + "' has " +
      std::to_string(array->GetNumberOfComponents()) + " components, normals have 3");
  }
}

int PlacementNumber(const std::string& name)
{
  return name == "centroid" ? vtkAnisotropicRemesher::CENTROID
    : name == "surface"     ? vtkAnisotropicRemesher::SURFACE_POINT
    : name == "quadric"     ? vtkAnisotropicRemesher::QUADRIC
                            : vtkAnisotropicRemesher::FIT;
}

} // namespace

int BackendNumber(const std::string& name)
{
  return name == "sequential" ? vtkEmbeddedSurfaceAlgorithm::SMP_SEQUENTIAL
    : name == "stdthread"     ? vtkEmbeddedSurfaceAlgorithm::SMP_STDTHREAD
    : name == "tbb"           ? vtkEmbeddedSurfaceAlgorithm::SMP_TBB
                              : vtkEmbeddedSurfaceAlgorithm::SMP_AUTOMATIC;
}

void CheckArrays(vtkPolyData* surface, const Options& options)
{
  if (options.Normals == "none")
  {
    surface->GetPointData()->SetActiveAttribute(-1, vtkDataSetAttributes::NORMALS);
  }
  else if (!options.Normals.empty())
  {
    CheckArray(surface, options.Normals, true);
  }
  for (const std::string& solution : options.Solutions)
  {
    CheckArray(surface, solution, false);
  }
  if (!options.Metric.empty())
  {
    CheckArray(surface, options.Metric, false);
  }
  if (!options.EmbeddingArray.empty())
  {
    CheckArray(surface, options.EmbeddingArray, false);
  }
  for (const CoordinateArray& coordinates : options.Coordinates)
  {
    CheckArray(surface, coordinates.Name, false);
  }
  if (!options.Density.empty())
  {
    CheckArray(surface, options.Density, false);
  }
  if (!options.Seams.empty() && options.Seams != "none")
  {
    CheckArray(surface, options.Seams, false);
  }
  if (!options.Labels.empty() &&
    surface->GetCellData()->GetAbstractArray(options.Labels.c_str()) == nullptr)
  {
    throw Failure("the surface has no cell array '" + options.Labels + "'");
  }
}

void SetEmbedding(vtkEmbeddedSurfaceAlgorithm* filter, const Options& options)
{
  filter->SetEmbeddingMode(options.Dimension == 3 ? vtkEmbeddedSurfaceAlgorithm::POSITION
                                                  : vtkEmbeddedSurfaceAlgorithm::GAUSS_MAP);
  filter->SetAnisotropy(options.Anisotropy);
  filter->SetNormalSmoothingPasses(options.NormalSmoothingPasses);
  filter->SetMergeTolerance(options.MergeTolerance);
  if (!options.Normals.empty() && options.Normals != "none")
  {
    filter->SetInputArrayToProcess(
      0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, options.Normals.c_str());
  }
  if (!options.EmbeddingArray.empty())
  {
    filter->SetEmbeddingArray(options.EmbeddingArray.c_str());
  }
  if (!options.Metric.empty())
  {
    filter->SetMetricArray(options.Metric.c_str());
    filter->SetMetricOrder(options.MetricOrder == "rows" ? vtkEmbeddedSurfaceAlgorithm::METRIC_ROWS
        : options.MetricOrder == "sol"                   ? vtkEmbeddedSurfaceAlgorithm::METRIC_SOL
                                                         : vtkEmbeddedSurfaceAlgorithm::METRIC_VTK);
    filter->SetLimitMetric(options.LimitMetric);
    filter->SetMetricGrowth(options.MetricGrowth);
  }
  for (const CoordinateArray& coordinates : options.Coordinates)
  {
    filter->AddCoordinateArray(coordinates.Name.c_str(), coordinates.Scale);
  }
  filter->SetSMPBackend(BackendNumber(options.Backend));
  filter->SetNumberOfThreads(options.Threads);
}

void SetRemeshing(vtkAnisotropicRemesher* remesher, const Options& options)
{
  remesher->SetNumberOfPoints(options.NumberOfPoints);
  remesher->SetUnitEdges(options.Unit || options.Complexity > 0.0);
  remesher->SetMetricComplexity(options.Complexity);
  remesher->SetDistanceTolerance(options.Tolerance);
  remesher->SetMaximumNumberOfPoints(options.MaximumPoints);
  remesher->SetPreserveFeatures(options.PreserveFeatures);
  remesher->SetMaximumNumberOfExtraPoints(options.MaximumExtraPoints);
  remesher->SetFeatureAngle(options.FeatureAngle);
  if (!options.Labels.empty())
  {
    remesher->SetFeatureLabelArray(options.Labels.c_str());
  }
  if (!options.Seams.empty())
  {
    remesher->SetSeamArray(options.Seams == "none" ? "None" : options.Seams.c_str());
  }
  if (!options.Density.empty())
  {
    remesher->SetDensityArray(options.Density.c_str());
  }
  remesher->SetNumberOfLloydIterations(options.LloydIterations);
  remesher->SetNumberOfNewtonIterations(options.NewtonIterations);
  remesher->SetEnergyTolerance(options.EnergyTolerance);
  remesher->SetSeed(options.Seed);
  remesher->SetSamplingMethod(options.Sampling == "random" ? vtkAnisotropicRemesher::RANDOM
                                                           : vtkAnisotropicRemesher::STRATIFIED);
  remesher->SetVertexPlacement(PlacementNumber(options.Placement));
  remesher->SetCoarseStart(options.CoarseStart);
  remesher->SetMeasureDistance(options.MeasureDistance);
  remesher->SetGenerateVoronoiCells(!options.Cells.empty());
  remesher->SetGenerateEdges(!options.Edges.empty());
}
