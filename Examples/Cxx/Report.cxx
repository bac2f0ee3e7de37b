#include "Report.h"

#include "CommandLine.h"

#include <vtkAnisotropicRemesher.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkVariant.h>

// Newer VTK headers bring a copy of this library, and two do not go together.
#ifdef VTK_NLOHMANN_JSON
#include VTK_NLOHMANN_JSON(json.hpp)
#else
#include <nlohmann/json.hpp>
#endif

#include <cstdio>
#include <sys/resource.h>

using Json = nlohmann::ordered_json;

namespace
{
Json InputOf(const Options& options, vtkPolyData* input, vtkAnisotropicRemesher* remesher)
{
  return { { "file", options.Input }, { "points", input->GetNumberOfPoints() },
    { "cells", input->GetNumberOfCells() },
    { "components", remesher->GetNumberOfInputComponents() },
    { "dropped", remesher->GetNumberOfDroppedTriangles() } };
}

Json ParametersOf(const Options& options)
{
  Json coordinates = Json::array();
  for (const CoordinateArray& array : options.Coordinates)
  {
    coordinates.push_back({ { "name", array.Name }, { "scale", array.Scale } });
  }
  return { { "points", options.NumberOfPoints }, { "tolerance", options.Tolerance },
    { "max_points", options.MaximumPoints }, { "anisotropy", options.Anisotropy },
    { "features", options.PreserveFeatures }, { "feature_angle", options.FeatureAngle },
    { "labels", options.Labels }, { "seams", options.Seams }, { "density", options.Density },
    { "max_extra_points", options.MaximumExtraPoints }, { "lloyd", options.LloydIterations },
    { "newton", options.NewtonIterations }, { "energy_tolerance", options.EnergyTolerance },
    { "seed", options.Seed },
    { "sampling", options.Sampling }, { "placement", options.Placement },
    { "coarse_start", options.CoarseStart }, { "measure_distance", options.MeasureDistance },
    { "threads", options.Threads }, { "backend", options.Backend },
    { "dimension", options.Dimension }, { "normals", options.Normals },
    { "normal_smoothing", options.NormalSmoothingPasses },
    { "embedding_array", options.EmbeddingArray }, { "metric", options.Metric },
    { "metric_order", options.MetricOrder }, { "metric_growth", options.MetricGrowth },
    { "limit_metric", options.LimitMetric }, { "unit", options.Unit },
    { "complexity", options.Complexity }, { "solutions", options.Solutions },
    { "error_norm", options.ErrorNorm }, { "min_size", options.MinimumSize },
    { "max_size", options.MaximumSize }, { "eigenfunctions", options.Eigenfunctions },
    { "eigenfunction_scaling", options.EigenfunctionScaling },
    { "diffusion_time", options.DiffusionTime }, { "coordinates", coordinates },
    { "initial_sites", options.InitialSites }, { "merge_tolerance", options.MergeTolerance } };
}

/** A number of the surface's field data, 0 if it is not there. */
long long FactOf(vtkPolyData* surface, const char* name)
{
  vtkDataArray* fact = surface->GetFieldData()->GetArray(name);
  return fact != nullptr && fact->GetNumberOfTuples() > 0
    ? static_cast<long long>(fact->GetComponent(0, 0))
    : 0;
}

Json OutputOf(vtkPolyData* surface)
{
  Json json = { { "points", surface->GetNumberOfPoints() },
    { "triangles", surface->GetNumberOfPolys() },
    { "extra_points", FactOf(surface, "NumberOfExtraPoints") },
    { "flipped_triangles", FactOf(surface, "NumberOfFlippedTriangles") },
    { "stray_triangles", FactOf(surface, "NumberOfStrayTriangles") },
    { "self_intersections", FactOf(surface, "NumberOfSelfIntersections") } };
  for (const auto& [name, array] :
    { std::pair<const char*, const char*>{ "normal_smoothing_radius", "NormalSmoothingRadius" },
      { "maximum_distance", "MaximumDistance" }, { "rms_distance", "RMSDistance" } })
  {
    if (vtkDataArray* length = surface->GetFieldData()->GetArray(array))
    {
      json[name] = length->GetComponent(0, 0);
    }
  }
  return json;
}

Json SecondsOf(vtkAnisotropicRemesher* remesher, const Seconds& seconds)
{
  Json json = { { "read", seconds.Read } };
  for (const char* phase :
    { "intake", "sampling", "lloyd", "newton", "diagram", "repair", "placement", "distance" })
  {
    json[phase] = remesher->GetPhaseSeconds(phase);
  }
  json["write"] = seconds.Write;
  json["total"] = seconds.Total;
  return json;
}

/** All columns of the comparison's summary, as numbers. */
Json ComparisonOf(vtkTable* summary)
{
  Json json = Json::object();
  for (vtkIdType column = 0; column < summary->GetNumberOfColumns(); ++column)
  {
    json[summary->GetColumnName(column)] = summary->GetValue(0, column).ToDouble();
  }
  return json;
}

/** On one line if it is one of many. File names may hold what is no text. */
std::string TextOf(const Json& json, bool oneLine)
{
  return json.dump(oneLine ? -1 : 2, ' ', false, Json::error_handler_t::replace) + '\n';
}
} // namespace

std::string ReportText(const Options& options, vtkPolyData* input, vtkAnisotropicRemesher* remesher,
  vtkTable* comparison, const Seconds& seconds, const std::vector<std::string>& warnings)
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto inSeconds = [](const timeval& time)
  { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
  Json json = { { "input", InputOf(options, input, remesher) },
    { "parameters", ParametersOf(options) }, { "output", OutputOf(remesher->GetOutput()) },
    { "topology",
      { { "preserved", FactOf(remesher->GetOutput(), "TopologyPreserved") },
        { "report", remesher->GetTopologyReport() } } },
    { "iterations", remesher->GetNumberOfIterations() },
    { "evaluations", remesher->GetNumberOfEvaluations() }, { "energy", remesher->GetEnergy() },
    { "seconds", SecondsOf(remesher, seconds) },
    { "processor_seconds", inSeconds(usage.ru_utime) + inSeconds(usage.ru_stime) },
    { "peak_megabytes", static_cast<double>(usage.ru_maxrss) * 1024.0 / 1e6 },
    { "threads", remesher->GetNumberOfUsedThreads() }, { "backend", remesher->GetUsedBackend() },
    { "warnings", warnings } };
  if (comparison != nullptr)
  {
    json["comparison"] = ComparisonOf(comparison);
  }
  return TextOf(json, options.IsOneOfMany);
}

std::string ComparisonReportText(const Options& options, vtkTable* comparison)
{
  return TextOf({ { "mesh", options.Input }, { "reference", options.Compare },
                  { "comparison", ComparisonOf(comparison) } },
    options.IsOneOfMany);
}

std::string ResultText(vtkPolyData* mesh, double diagonal, double seconds)
{
  std::string line = std::to_string(mesh->GetNumberOfPoints()) + " points, " +
    std::to_string(mesh->GetNumberOfPolys()) + " triangles, topology " +
    (FactOf(mesh, "TopologyPreserved") > 0 ? "preserved" : "not proven");
  char text[80];
  if (vtkDataArray* distance = mesh->GetFieldData()->GetArray("RMSDistance"))
  {
    std::snprintf(text, sizeof(text), ", RMS distance %.1e of the diagonal",
      distance->GetComponent(0, 0) / diagonal);
    line += text;
  }
  std::snprintf(text, sizeof(text), ", %.1f s", seconds);
  return line + text;
}
