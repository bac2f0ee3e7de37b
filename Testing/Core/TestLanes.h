/**
 * @file TestLanes.h
 * @brief What tests of functions that work on several things at once share.
 */
#ifndef remesh_TestLanes_h
#define remesh_TestLanes_h

#include "Support/Random.h"
#include "Support/Types.h"
#include "TestInstructionSets.h"

#include <limits>

namespace remesh::test
{
constexpr double infinity = std::numeric_limits<double>::infinity();

/** In the unit cube around the origin. */
inline Point3 randomPoint(std::uint64_t seed, std::uint64_t index)
{
  return { uniform01(seed, index, 0) - 0.5, uniform01(seed, index, 1) - 0.5,
    uniform01(seed, index, 2) - 0.5 };
}
}

#endif
