/**
 * @file StarHeights.h
 * @brief How high a point is above the triangles around a vertex, several at once.
 */
#ifndef remesh_StarHeights_h
#define remesh_StarHeights_h

#include "Support/InstructionSet.h"
#include "Support/Lanes.h"

#include <vector>

namespace remesh
{
/** Triangles with a common corner, side by side. Places without one have no normal. */
struct StarGroup
{
  // Their products with a way from the common corner are the weights of the other two corners.
  double first[3][lanes];
  double second[3][lanes];
  double normal[3][lanes]; ///< unit
};

/** Writes the squared heights of a point above the triangles that it lies right above. */
struct StarHeights
{
  const std::vector<StarGroup>& groups;
  const double* way;    ///< from the common corner to the point
  const double* facing; ///< only triangles with normals along this are looked at
  double* squared;      ///< `lanes` for each group; infinity where the point is not above
};

using StarHeightEvaluation = void (*)(const StarHeights&);

/** Compiled for a set of instructions; all give the same bits. */
StarHeightEvaluation starHeightEvaluation(InstructionSet set);
}

#endif
