/**
 * @file RunWarnings.h
 * @brief What a user should know of a result that is not as good as it could be.
 */
#ifndef remesh_RunWarnings_h
#define remesh_RunWarnings_h

#include "Pipeline/RunRequest.h"

#include <string>
#include <vector>

namespace remesh
{
/**
 * In whole sentences, those of the intake first.
 * Cost: O(F) at most.
 */
std::vector<std::string> warningsOf(const RunRequest& request, const RunOutcome& outcome);
}

#endif
