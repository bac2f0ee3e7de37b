/**
 * The report of a run as JSON: what went in, what came out, what it took. Facts that a run does
 * not have are absent.
 */
#ifndef Report_h
#define Report_h

#include <string>
#include <vector>

class vtkAnisotropicRemesher;
class vtkPolyData;
class vtkTable;
struct Options;

/** Wall time in seconds, measured outside the filter. */
struct Seconds
{
  double Read = 0.0;
  double Write = 0.0; // all files but the report
  double Total = 0.0; // from the start of the program until the report
};

/**
 * `remesher` has run on `input`. Processor time (user and system, all threads) and peak memory
 * (megabytes of 10^6 bytes) are those of the process so far. `comparison`: the summary of a
 * comparison, or null.
 */
std::string ReportText(const Options& options, vtkPolyData* input, vtkAnisotropicRemesher* remesher,
  vtkTable* comparison, const Seconds& seconds, const std::vector<std::string>& warnings);

/** The report where nothing was remeshed. */
std::string ComparisonReportText(const Options& options, vtkTable* comparison);

#endif
