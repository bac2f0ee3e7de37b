#include "Report.h"

#include "CommandLine.h"
#include "JsonWriter.h"

#include <vtkAnisotropicRemesher.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>

#include <sys/resource.h>

namespace
{
void AddInput(
  JsonWriter& json, const Options& options, vtkPolyData* input, vtkAnisotropicRemesher* remesher)
{
  json.BeginObject("input");
  json.Add("file", options.Input);
  json.Add("points", static_cast<long long>(input->GetNumberOfPoints()));
  json.Add("cells", static_cast<long long>(input->GetNumberOfCells()));
  json.Add("components", static_cast<long long>(remesher->GetNumberOfInputComponents()));
  json.Add("dropped", static_cast<long long>(remesher->GetNumberOfDroppedTriangles()));
  json.EndObject();
}

void AddParameters(JsonWriter& json, const Options& options)
{
  json.BeginObject("parameters");
  json.Add("points", options.NumberOfPoints);
  json.Add("tolerance", options.Tolerance);
  json.Add("max_points", options.MaximumPoints);
  json.Add("anisotropy", options.Anisotropy);
  json.Add("features", options.PreserveFeatures);
  json.Add("feature_angle", options.FeatureAngle);
  json.Add("labels", options.Labels);
  json.Add("density", options.Density);
  json.Add("max_extra_points", options.MaximumExtraPoints);
  json.Add("lloyd", options.LloydIterations);
  json.Add("newton", options.NewtonIterations);
  json.Add("seed", options.Seed);
  json.Add("sampling", options.Sampling);
  json.Add("placement", options.Placement);
  json.Add("coarse_start", options.CoarseStart);
  json.Add("measure_distance", options.MeasureDistance);
  json.Add("threads", options.Threads);
  json.Add("backend", options.Backend);
  json.Add("dimension", options.Dimension);
  json.Add("normals", options.Normals);
  json.Add("normal_smoothing", options.NormalSmoothingPasses);
  json.Add("embedding_array", options.EmbeddingArray);
  json.BeginArray("coordinates");
  for (const CoordinateArray& array : options.Coordinates)
  {
    json.BeginObject();
    json.Add("name", array.Name);
    json.Add("scale", array.Scale);
    json.EndObject();
  }
  json.EndArray();
  json.Add("initial_sites", options.InitialSites);
  json.Add("merge_tolerance", options.MergeTolerance);
  json.EndObject();
}

/** A number of the surface's field data, 0 if it is not there. */
long long FactOf(vtkPolyData* surface, const char* name)
{
  vtkDataArray* fact = surface->GetFieldData()->GetArray(name);
  return fact != nullptr && fact->GetNumberOfTuples() > 0
    ? static_cast<long long>(fact->GetComponent(0, 0))
    : 0;
}

void AddOutput(JsonWriter& json, vtkPolyData* surface)
{
  json.BeginObject("output");
  json.Add("points", static_cast<long long>(surface->GetNumberOfPoints()));
  json.Add("triangles", static_cast<long long>(surface->GetNumberOfPolys()));
  json.Add("extra_points", FactOf(surface, "NumberOfExtraPoints"));
  json.Add("flipped_triangles", FactOf(surface, "NumberOfFlippedTriangles"));
  json.Add("stray_triangles", FactOf(surface, "NumberOfStrayTriangles"));
  for (const auto& [name, array] :
    { std::pair<const char*, const char*>{ "normal_smoothing_radius", "NormalSmoothingRadius" },
      { "maximum_distance", "MaximumDistance" }, { "rms_distance", "RMSDistance" } })
  {
    if (vtkDataArray* length = surface->GetFieldData()->GetArray(array))
    {
      json.Add(name, length->GetComponent(0, 0));
    }
  }
  json.EndObject();
}

void AddTopology(JsonWriter& json, vtkAnisotropicRemesher* remesher)
{
  json.BeginObject("topology");
  json.Add("preserved", FactOf(remesher->GetOutput(), "TopologyPreserved"));
  json.Add("report", remesher->GetTopologyReport());
  json.EndObject();
}

void AddSeconds(JsonWriter& json, vtkAnisotropicRemesher* remesher, const Seconds& seconds)
{
  json.BeginObject("seconds");
  json.Add("read", seconds.Read);
  for (const char* phase :
    { "intake", "sampling", "lloyd", "newton", "diagram", "repair", "placement", "distance" })
  {
    json.Add(phase, remesher->GetPhaseSeconds(phase));
  }
  json.Add("write", seconds.Write);
  json.Add("total", seconds.Total);
  json.EndObject();
}

void AddResources(JsonWriter& json)
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time)
  { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
  json.Add("processor_seconds", seconds(usage.ru_utime) + seconds(usage.ru_stime));
  json.Add("peak_megabytes", static_cast<double>(usage.ru_maxrss) * 1024.0 / 1e6);
}
} // namespace

std::string ReportText(const Options& options, vtkPolyData* input, vtkAnisotropicRemesher* remesher,
  const Seconds& seconds, const std::vector<std::string>& warnings)
{
  JsonWriter json;
  json.BeginObject();
  AddInput(json, options, input, remesher);
  AddParameters(json, options);
  AddOutput(json, remesher->GetOutput());
  AddTopology(json, remesher);
  json.Add("iterations", remesher->GetNumberOfIterations());
  json.Add("evaluations", remesher->GetNumberOfEvaluations());
  json.Add("energy", remesher->GetEnergy());
  AddSeconds(json, remesher, seconds);
  AddResources(json);
  json.Add("threads", remesher->GetNumberOfUsedThreads());
  json.Add("backend", remesher->GetUsedBackend());
  json.BeginArray("warnings");
  for (const std::string& warning : warnings)
  {
    json.Add("", warning);
  }
  json.EndArray();
  json.EndObject();
  return json.GetText();
}
