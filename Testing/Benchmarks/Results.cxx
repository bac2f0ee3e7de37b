#include "Results.h"

#include "Measure.h"

#include <vtkSMPTools.h>
#include <vtkVersion.h>

// Newer VTK headers bring a copy of this library, and two do not go together.
#ifdef VTK_NLOHMANN_JSON
#include VTK_NLOHMANN_JSON(json.hpp)
#else
#include <nlohmann/json.hpp>
#endif

#include <fstream>
#include <stdexcept>
#include <thread>

namespace remesh::benchmark
{
namespace
{
using Json = nlohmann::ordered_json;

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

Json toJson(const Figures& figures, double calibration)
{
  Json json = Json::object();
  for (const Figure& figure : figures)
  {
    Json& entry = json[figure.name];
    entry = { { "value", figure.value }, { "unit", figure.unit } };
    if (figure.unit == "s")
    {
      entry["ratio"] = figure.value / calibration;
    }
  }
  return json;
}

Json toJson(const CaseResult& result)
{
  Json measurements = Json::array();
  for (const Measurement& one : result.measurements)
  {
    measurements.push_back({ { "surface", one.surface }, { "triangles", one.triangles },
      { "points", one.points }, { "dimension", one.dimension }, { "threads", one.threads },
      { "figures", toJson(one.figures, result.calibration) } });
  }
  return { { "name", result.name }, { "calibration", result.calibration },
    { "figures", toJson(result.figures, result.calibration) }, { "measurements", measurements } };
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
  Json cases = Json::array();
  for (const CaseResult& result : results)
  {
    calibrations.push_back(result.calibration);
    cases.push_back(toJson(result));
  }
  const Json json = { { "calibration",
                        { { "surface", calibration.surface },
                          { "triangles", calibration.triangles }, { "points", calibration.points },
                          { "seconds", median(calibrations) } } },
    { "machine",
      { { "processor", processorModel() }, { "threads", std::thread::hardware_concurrency() },
        { "compiler", REMESH_BENCHMARK_COMPILER }, { "build_type", REMESH_BENCHMARK_BUILD_TYPE },
        { "vtk", vtkVersion::GetVTKVersion() }, { "backend", vtkSMPTools::GetBackend() } } },
    { "settings",
      { { "repetitions", settings.repetitions }, { "shrink", settings.shrink },
        { "lloyd_iterations", settings.lloydIterations },
        { "newton_iterations", settings.newtonIterations } } },
    { "cases", cases } };
  return json.dump(2) + "\n";
}
}
