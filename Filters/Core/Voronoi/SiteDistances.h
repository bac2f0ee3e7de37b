/**
 * @file SiteDistances.h
 * @brief How far many sites are from one of them, several at once.
 */
#ifndef remesh_SiteDistances_h
#define remesh_SiteDistances_h

#include "Support/InstructionSet.h"
#include "Support/Lanes.h"

namespace remesh
{
/** Writes the squared distances of a point of R^d to all sites of some groups. */
struct SiteDistances
{
  /** Group by group, `lanes` values of each of the d coordinates. */
  const double* coordinates;
  int numberOfGroups;
  int dimension;
  const double* point;
  double* squared; ///< `lanes` for each group; summed coordinate by coordinate
};

using SiteDistanceEvaluation = void (*)(const SiteDistances&);

/** Compiled for a set of instructions; all give the same bits. */
SiteDistanceEvaluation siteDistanceEvaluation(InstructionSet set);
}

#endif
