/**
 * @file Convergence.h
 * @brief The history of an optimisation.
 */
#ifndef remesh_Convergence_h
#define remesh_Convergence_h

#include <chrono>
#include <vector>

namespace remesh
{
/** State after a step; row 0 is the initial sampling. Scaled units. */
struct ConvergenceRow
{
  int iteration = 0;
  double energy = 0.0;
  double gradientNorm = 0.0;
  double stepLength = 0.0; ///< 0 in row 0, 1 for a Lloyd step
  double seconds = 0.0;    ///< since the clock's start
};

struct Convergence
{
  std::vector<ConvergenceRow> rows;
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();

  void add(double energy, double gradientNorm, double stepLength)
  {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - this->start;
    this->rows.push_back(
      { static_cast<int>(this->rows.size()), energy, gradientNorm, stepLength, elapsed.count() });
  }
};
}

#endif
