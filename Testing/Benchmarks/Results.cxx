#include "Results.h"

#include "Measure.h"

#include "../../Examples/Cxx/JsonWriter.h"

#include <vtkSMPTools.h>
#include <vtkVersion.h>

#include <fstream>
#include <stdexcept>
#include <thread>

namespace remesh::benchmark
{
namespace
{
/** As Linux names it; "" elsewhere. */
std::string processorModel()
{
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
  {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos)
    {
      return line.substr(colon + 2);
    }
  }
  return "";
}

void addFigures(JsonWriter& json, const Figures& figures, double calibration)
{
  json.BeginObject("figures");
  for (const Figure& figure : figures)
  {
    json.BeginObject(figure.name);
    json.Add("value", figure.value);
    json.Add("unit", figure.unit);
    if (figure.unit == "s")
    {
      json.Add("ratio", figure.value / calibration);
    }
    json.EndObject();
  }
  json.EndObject();
}

void addCase(JsonWriter& json, const CaseResult& result)
{
  json.BeginObject();
  json.Add("name", result.name);
  json.Add("calibration", result.calibration);
  addFigures(json, result.figures, result.calibration);
  json.BeginArray("measurements");
  for (const Measurement& measurement : result.measurements)
  {
    json.BeginObject();
    json.Add("surface", measurement.surface);
    json.Add("triangles", measurement.triangles);
    json.Add("points", measurement.points);
    json.Add("dimension", measurement.dimension);
    json.Add("threads", measurement.threads);
    addFigures(json, measurement.figures, result.calibration);
    json.EndObject();
  }
  json.EndArray();
  json.EndObject();
}
}

void addTimes(Figures& figures, const std::string& name, const Elapsed& elapsed)
{
  const std::string prefix = name.empty() ? "" : name + "_";
  figures.push_back({ prefix + "processor", elapsed.processor, "s" });
  figures.push_back({ prefix + "wall", elapsed.wall, "s" });
}

double value(const Figures& figures, const std::string& name)
{
  for (const Figure& figure : figures)
  {
    if (figure.name == name)
    {
      return figure.value;
    }
  }
  throw std::logic_error("no figure " + name);
}

Figures medians(const std::vector<Figures>& runs)
{
  Figures figures = runs.front();
  for (Figure& figure : figures)
  {
    std::vector<double> values;
    for (const Figures& run : runs)
    {
      values.push_back(value(run, figure.name));
    }
    figure.value = median(values);
  }
  return figures;
}

std::string toJson(
  const Settings& settings, const Calibration& calibration, const std::vector<CaseResult>& results)
{
  std::vector<double> calibrations;
  for (const CaseResult& result : results)
  {
    calibrations.push_back(result.calibration);
  }
  JsonWriter json;
  json.BeginObject();
  json.BeginObject("calibration");
  json.Add("surface", calibration.surface);
  json.Add("triangles", calibration.triangles);
  json.Add("points", calibration.points);
  json.Add("seconds", median(calibrations));
  json.EndObject();
  json.BeginObject("machine");
  json.Add("processor", processorModel());
  json.Add("threads", static_cast<int>(std::thread::hardware_concurrency()));
  json.Add("compiler", REMESH_BENCHMARK_COMPILER);
  json.Add("build_type", REMESH_BENCHMARK_BUILD_TYPE);
  json.Add("vtk", vtkVersion::GetVTKVersion());
  json.Add("backend", vtkSMPTools::GetBackend());
  json.EndObject();
  json.BeginObject("settings");
  json.Add("repetitions", settings.repetitions);
  json.Add("shrink", settings.shrink);
  json.Add("lloyd_iterations", settings.lloydIterations);
  json.Add("newton_iterations", settings.newtonIterations);
  json.EndObject();
  json.BeginArray("cases");
  for (const CaseResult& result : results)
  {
    addCase(json, result);
  }
  json.EndArray();
  json.EndObject();
  return json.GetText();
}
}
