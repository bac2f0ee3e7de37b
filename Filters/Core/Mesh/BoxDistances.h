/**
 * @file BoxDistances.h
 * @brief How far a point is from several boxes at once, and which of them another box meets.
 */
#ifndef remesh_BoxDistances_h
#define remesh_BoxDistances_h

#include "Support/InstructionSet.h"
#include "Support/Lanes.h"

namespace remesh
{
/** Boxes along the axes of R^3, side by side; one without a point has infinite distance. */
struct BoxGroup
{
  double lower[3][lanes];
  double upper[3][lanes];
};

/** Writes the squared distances of a point (3 coordinates) to all boxes of a group. */
struct BoxDistances
{
  const BoxGroup& boxes;
  const double* point;
  double* squared; ///< `lanes` numbers
};

using BoxDistanceEvaluation = void (*)(const BoxDistances&);

/** The box with these corners (3 coordinates each) against all boxes of a group. */
struct BoxMeeting
{
  const BoxGroup& boxes;
  const double* lower;
  const double* upper;
};

/** Returns a bit for each box that has a point in common with it. */
using BoxMeetingEvaluation = unsigned (*)(const BoxMeeting&);

/** Compiled for a set of instructions; all give the same bits. */
BoxDistanceEvaluation boxDistanceEvaluation(InstructionSet set);
BoxMeetingEvaluation boxMeetingEvaluation(InstructionSet set);
}

#endif
