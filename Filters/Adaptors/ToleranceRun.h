/**
 * @file ToleranceRun.h
 * @brief Surface and mesh for a distance, instead of a number of points (Core/ToleranceSearch.h).
 */
#ifndef remesh_ToleranceRun_h
#define remesh_ToleranceRun_h

#include "Adaptors/NumberRun.h"
#include "ToleranceSearch.h"

namespace remesh
{
struct ToleranceRequest
{
  double tolerance = 0.0;  ///< 0: none
  bool isAbsolute = false; ///< in the unit of the points; else a fraction of the diagonal
  Offset mostPoints = 1000000;
  /** Whether RemeshOptions::maximumExtraPoints is one percent of the number of each run. */
  bool extraIsOnePercent = false;
};

/**
 * Prepares the surface for the number of points found, with the creases that count for it or for
 * more, and makes the mesh. Two surfaces and meshes are held while more creases are tried. Tells in
 * `outcome.result.distance` what was reached, and by a warning in `outcome.prepared` where that is
 * not the tolerance.
 *
 * @param options its number of sites is not looked at, nor are its extra points where they are one
 *        percent of what the runs find.
 * @return InvalidInput for a tolerance below 1e-7 of the diagonal, and as the run.
 */
Status remeshWithin(const ToleranceRequest& tolerance, NumberRequest request, RemeshOptions options,
  const RunControl& control, NumberOutcome& outcome);
}

#endif
