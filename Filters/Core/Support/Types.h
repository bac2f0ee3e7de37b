/**
 * @file Types.h
 * @brief Index types and the few aliases that every stage shares.
 *
 * Facets, corners, points and sites are counted with 32 bits (half the memory traffic of the hot
 * loops); sizes are checked where data enters (Mesh/Intake, Optimization/Sampling), and that of a
 * diagram where it is made (Voronoi/DiagramBlocks). Places in arrays of several values for each of
 * these, and ids of the caller's data, have 64 bits; where such places are stored by the million,
 * 32.
 */
#ifndef remesh_Types_h
#define remesh_Types_h

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include <Eigen/Core>

namespace remesh
{
using Index = std::int32_t;  ///< facet, corner, point or site
using Offset = std::int64_t; ///< position in an array of pieces; id in the caller's data

using Point3 = Eigen::Vector3d;
using Triple = std::array<Index, 3>;

constexpr Index noIndex = -1;
constexpr std::int64_t maximumIndex = std::numeric_limits<Index>::max() - 1;
constexpr double pi = 3.14159265358979323846;

/** Whether it is one of the three. */
inline bool has(const Triple& triangle, Index vertex)
{
  return std::find(triangle.begin(), triangle.end(), vertex) != triangle.end();
}
}

#endif
