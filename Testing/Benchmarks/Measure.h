/**
 * @file Measure.h
 * @brief What a piece of work costs: time in this process; time and memory of another program.
 */
#ifndef remesh_benchmark_Measure_h
#define remesh_benchmark_Measure_h

#include "Support/PhaseTimer.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace remesh::benchmark
{
/** The middle value, or the mean of the two middle ones; of at least one. */
double median(std::vector<double> values);

/** Wall and processor seconds of `work()`. */
template <class Work>
Elapsed timed(const Work& work)
{
  Elapsed elapsed;
  {
    const PhaseTimer timer(elapsed);
    work();
  }
  return elapsed;
}

/**
 * Processor seconds of vtkQuadricDecimation from this surface to `points` points, the median of
 * five runs: the yardstick that carries figures from one machine to another.
 */
double calibrate(vtkPolyData* surface, int points);

/** A POSIX shell's command line. */
std::string commandLine(const std::vector<std::string>& words);

/** Peak resident memory of this process, of 10^6 bytes. */
double peakMegabytes();

/** What another program took. */
struct Cost
{
  Elapsed elapsed;
  double megabytes = 0.0; ///< peak resident memory, of 10^6 bytes
};

/**
 * Runs a program to its end. Throws std::runtime_error unless it succeeds.
 *
 * The system counts the memory of a forked process before it becomes another program, so that this
 * one's surfaces would be in the figure: a fresh copy of this program, `self --cost-of`, starts it.
 */
Cost costOf(const std::string& self, const std::vector<std::string>& command);

/** `self --cost-of`: runs the command and prints its cost. Returns the exit status. */
int printCost(const std::vector<std::string>& command);
}

#endif
