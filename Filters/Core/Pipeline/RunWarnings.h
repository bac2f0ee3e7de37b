/**
 * @file RunWarnings.h
 * @brief Tells the user where a result is not what was asked for.
 */
#ifndef remesh_RunWarnings_h
#define remesh_RunWarnings_h

#include "Pipeline/RunRequest.h"

#include <string>
#include <vector>

namespace remesh
{
/**
 * The warnings of a run: one string each, of whole sentences. Those that the preparation has made
 * come first. Documentation/Messages.md explains all of them.
 * Cost: O(F) at most.
 */
std::vector<std::string> warningsOf(const RunRequest& request, const RunOutcome& outcome);
}

#endif
