/**
 * @file Results.h
 * @brief The figures of a case, and the file they are written to.
 *
 * The file (JSON): `calibration` {surface, triangles, points, seconds}, `machine`, `settings`, and
 * `cases`, each with its `name`, the processor seconds of the `calibration` run before it,
 * `figures` that sum it up, and its `measurements`: what was measured (surface, triangles, points,
 * dimension, threads) and the `figures` found. A figure has a `value` and a `unit`; one in seconds
 * has its `ratio` to the calibration, too.
 */
#ifndef remesh_benchmark_Results_h
#define remesh_benchmark_Results_h

#include "Support/PhaseTimer.h"

#include <string>
#include <vector>

namespace remesh::benchmark
{
struct Settings
{
  std::string data;    ///< folder of armadillo.ply; "" or without it: generated surfaces
  std::string self;    ///< path of this program
  std::string program; ///< path of remesh_surface
  int threads = 1;
  int repetitions = 3; ///< of which the medians are taken
  double shrink = 1.0; ///< divides the triangles and points; not 1: of generated surfaces
  int lloydIterations = 5;
  int newtonIterations = 30;
};

/** A run of the filter in many dimensions. */
struct WideRun
{
  int triangles = 0; ///< about; 0: no run
  int points = 0;
  int dimension = 0; ///< more than 3
};

/** An embedding of a metric. */
struct MetricRun
{
  int surfacePoints = 0; ///< about; 0: no run
  int points = 0;        ///< of the mesh that it is for
  bool isBent = false;   ///< of gridWithLayer() instead of torusWithMetric()
};

/** An optimisation that several processes share. */
struct RankRun
{
  int ranks = 0; ///< 0: no run
  int triangles = 0;
  int points = 0;
};

struct Figure
{
  std::string name;
  double value = 0.0;
  std::string unit; ///< "s", "MB", "%" or "1"
};
using Figures = std::vector<Figure>;

/** `name_processor` and `name_wall`; `processor` and `wall` for no name. */
void addTimes(Figures& figures, const std::string& name, const Elapsed& elapsed);

double value(const Figures& figures, const std::string& name);

/** The median of each figure over runs that have the same ones. */
Figures medians(const std::vector<Figures>& runs);

struct Measurement
{
  std::string surface;
  long long triangles = 0;
  long long points = 0; ///< sites
  int dimension = 6;
  int threads = 1;
  Figures figures;
};

struct CaseResult
{
  std::string name;
  double calibration = 0.0; ///< processor seconds
  std::vector<Measurement> measurements;
  Figures figures; ///< drawn from all measurements
};

struct Calibration
{
  std::string surface;
  long long triangles = 0;
  int points = 0; ///< that it is decimated to
};

std::string toJson(
  const Settings& settings, const Calibration& calibration, const std::vector<CaseResult>& results);
}

#endif
