/**
 * remesh_benchmark: what the library costs, beside a yardstick that every VTK has.
 *
 * For each case: decimate the scan by VTK, measure the case, and write both as JSON (Results.h).
 * compare.py compares two such files, or two builds pair by pair.
 */
#include "Cases.h"
#include "CommandLine.h"
#include "Measure.h"
#include "RankRun.h"
#include "Runs.h"

#include <vtksys/SystemTools.hxx>

#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>

using namespace remesh::benchmark;

namespace
{
bool matches(const std::string& pattern, const std::string& name)
{
  return !pattern.empty() && pattern.back() == '*'
    ? name.compare(0, pattern.size() - 1, pattern, 0, pattern.size() - 1) == 0
    : name == pattern;
}

/** The cases asked for, in the order of the table. Throws std::invalid_argument for none. */
std::vector<Case> chosenCases(const std::vector<std::string>& patterns)
{
  std::vector<bool> chosen(allCases().size(), patterns.empty());
  for (const std::string& pattern : patterns)
  {
    bool found = false;
    for (std::size_t k = 0; k < chosen.size(); ++k)
    {
      const bool match = matches(pattern, allCases()[k].name);
      chosen[k] = chosen[k] || match;
      found = found || match;
    }
    if (!found)
    {
      throw std::invalid_argument("there is no case " + pattern);
    }
  }
  std::vector<Case> cases;
  for (std::size_t k = 0; k < chosen.size(); ++k)
  {
    if (chosen[k])
    {
      cases.push_back(allCases()[k]);
    }
  }
  return cases;
}

void print(const Figures& figures)
{
  for (const Figure& figure : figures)
  {
    std::cerr << ' ' << figure.name << ' ' << figure.value << ' ' << figure.unit << ';';
  }
  std::cerr << '\n';
}

void print(const CaseResult& result)
{
  for (const Measurement& one : result.measurements)
  {
    std::cerr << result.name << ": " << one.surface << ", " << one.triangles << " triangles, "
              << one.points << " points, d = " << one.dimension << ", " << one.threads
              << " threads:";
    print(one.figures);
  }
  std::cerr << result.name << ": calibration " << result.calibration << " s;";
  print(result.figures);
}

void write(const std::string& path, const std::string& text)
{
  if (path.empty())
  {
    std::cout << text << std::flush;
    return;
  }
  std::ofstream file(path, std::ios::binary);
  file << text << std::flush;
  if (!file)
  {
    throw std::runtime_error("cannot write " + path);
  }
}

/** A file has the results so far after each case: a long session may be ended. */
void measure(const CommandLine& line)
{
  const std::vector<Case> cases = chosenCases(line.cases);
  Workshop workshop(line.settings);
  const Surface& scanned = workshop.fine();
  const Calibration calibration = { scanned.name, scanned.data->GetNumberOfPolys(),
    static_cast<int>(workshop.shrunk(1e4)) };
  std::vector<CaseResult> results;
  for (const Case& one : cases)
  {
    CaseResult result;
    result.name = one.name;
    result.calibration = calibrate(scanned.data, calibration.points);
    one.run(workshop, result);
    print(result);
    results.push_back(std::move(result));
    if (!line.output.empty() || results.size() == cases.size())
    {
      write(line.output, toJson(line.settings, calibration, results));
    }
  }
}

Settings defaultSettings(const char* self)
{
  Settings settings;
  std::string error;
  if (!vtksys::SystemTools::FindProgramPath(self, settings.self, error))
  {
    throw std::runtime_error(error);
  }
  settings.program = vtksys::SystemTools::GetFilenamePath(settings.self) + "/remesh_surface";
  settings.data = REMESH_BENCHMARK_DATA;
  return settings;
}

int run(const char* self, const std::vector<std::string>& arguments)
{
  const Settings defaults = defaultSettings(self);
  const CommandLine line = parseCommandLine(arguments, defaults);
  if (!line.command.empty())
  {
    return printCost(line.command);
  }
  if (line.wide.triangles > 0)
  {
    runWide(line.wide, line.settings);
  }
  else if (line.metric.surfacePoints > 0)
  {
    runMetric(line.metric, line.settings);
  }
  else if (line.ranks.ranks > 0)
  {
    runOnRanks(line.ranks, line.settings);
  }
  else if (line.help)
  {
    std::cout << helpText(defaults);
  }
  else if (line.list)
  {
    for (const Case& one : allCases())
    {
      std::cout << one.name << ": " << one.what << '\n';
    }
  }
  else
  {
    measure(line);
  }
  return EXIT_SUCCESS;
}
}

int main(int argc, char* argv[])
{
  try
  {
    return run(argv[0], std::vector<std::string>(argv + 1, argv + argc));
  }
  catch (const std::invalid_argument& error)
  {
    std::cerr << "remesh_benchmark: " << error.what() << "; see --help\n";
    return 2;
  }
  catch (const std::exception& error)
  {
    std::cerr << "remesh_benchmark: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
