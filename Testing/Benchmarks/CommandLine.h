/**
 * @file CommandLine.h
 * @brief The options of remesh_benchmark.
 */
#ifndef remesh_benchmark_CommandLine_h
#define remesh_benchmark_CommandLine_h

#include "Results.h"

#include <string>
#include <vector>

namespace remesh::benchmark
{
struct CommandLine
{
  Settings settings;
  std::vector<std::string> cases; ///< none: all
  std::string output;             ///< "": standard output
  bool list = false;
  bool help = false;
  ///@{
  /** What this program starts itself for (Measure.h, Runs.h). */
  std::vector<std::string> command; ///< of --cost-of
  WideRun wide;                     ///< of --wide-run
  MetricRun metric;                 ///< of --metric-run or --bent-run
  RankRun ranks;                    ///< of --rank-run
  ///@}
};

/** Throws std::invalid_argument with a sentence. */
CommandLine parseCommandLine(const std::vector<std::string>& arguments, const Settings& defaults);

std::string helpText(const Settings& defaults);
}

#endif
