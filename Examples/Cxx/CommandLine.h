/**
 * The options of remesh_surface: one table, read by CLI11, that parsing, --help and the shells'
 * completion share.
 *
 * Every option can be written `--name value` or `--name=value`. Of an option given twice the last
 * one counts, except for --coordinates, which adds up. `--` ends the options.
 */
#ifndef CommandLine_h
#define CommandLine_h

#include <string>
#include <vector>

struct CoordinateArray
{
  std::string Name;
  double Scale; // length per array unit
};

struct Options
{
  std::vector<std::string> Files; // as given: inputs and output
  std::string OutputPattern;
  std::string Format; // of standard output and in folders; "": that of the input
  std::string Input;
  std::string Output; // "": compare only

  long long NumberOfPoints = 10000;
  double Tolerance = 0.0; // fraction of the bounding-box diagonal; 0: none
  long long MaximumPoints = 1000000;
  double Anisotropy = 0.04; // fraction of the bounding-box diagonal
  bool PreserveFeatures = true;
  double FeatureAngle = 35.0;  // degrees
  std::string Labels;          // cell array; "": none
  std::string Seams;           // point array; "": the texture coordinates; "none"
  std::string Density;         // point array; "": none
  int MaximumExtraPoints = -2; // one percent of the points; -1: unlimited
  int LloydIterations = 5;
  int NewtonIterations = 30;
  double EnergyTolerance = 5e-6;
  int Seed = 0;
  int Threads = 0; // 0: as many as the back-end offers
  std::string Backend = "automatic";
  int Dimension = 6;
  std::string Normals; // "": the active ones; "none": estimate
  int NormalSmoothingPasses = -1;
  std::string EmbeddingArray;
  std::string Metric; // point array; "": none
  std::string MetricOrder = "vtk";
  double MetricGrowth = 5.0;
  bool LimitMetric = true;
  bool Unit = false;       // the metric decides the number of points
  double Complexity = 0.0; // area that the metric is scaled to; 0: as it is
  std::vector<std::string> Solutions; // point arrays that a metric is made for
  std::string ErrorNorm = "l2";
  double MinimumSize = 0.0; // of that metric, in the unit of the points; 0: none
  double MaximumSize = 0.0;
  int Eigenfunctions = 0; // so many are the embedding; 0: none
  std::string EigenfunctionScaling = "commute_time";
  double DiffusionTime = 0.0;
  std::vector<CoordinateArray> Coordinates;
  std::string InitialSites;
  double MergeTolerance = 0.0; // fraction of the bounding-box diagonal
  std::string Sampling = "stratified";
  std::string Placement = "fit";
  bool CoarseStart = true;
  bool MeasureDistance = true;

  // Further outputs; "": not written.
  std::string Cells;
  std::string Sites;
  std::string Edges;
  std::string EmbeddedSurface;
  std::string Convergence;
  std::string Report;

  std::string Compare; // a surface; "": no comparison
  bool Json = false;
  bool IsOneOfMany = false; // one of several inputs
  bool Quiet = false;
  bool Version = false;
  bool Help = false;
  std::string Completion; // a shell; "": none
};

/**
 * Reads the arguments, the program's name not among them. With --help, --version or --completion
 * the rest is not checked. Throws Failure with EXIT_USAGE.
 */
Options ParseCommandLine(const std::vector<std::string>& arguments);

/** What --help prints. */
std::string HelpText();

[[noreturn]] void UsageError(const std::string& sentence);

#endif
