/**
 * @file RunWarnings.h
 * @brief What a user should know of a result that is not as good as it could be.
 */
#ifndef remesh_RunWarnings_h
#define remesh_RunWarnings_h

#include "Adaptors/NumberRun.h"

#include <string>
#include <vector>

namespace remesh
{
/**
 * In whole sentences, those of the intake first.
 *
 * @param hasNumber whether a number of points was asked for, and not a distance.
 * Cost: O(F) at most.
 */
std::vector<std::string> warningsOf(
  const NumberOutcome& outcome, const RemeshOptions& options, bool hasNumber);
}

#endif
