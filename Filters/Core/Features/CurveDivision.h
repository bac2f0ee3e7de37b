/**
 * @file CurveDivision.h
 * @brief Places along one feature curve: as far apart as the mesh's points, nearer where it bends.
 */
#ifndef remesh_CurveDivision_h
#define remesh_CurveDivision_h

#include "Features/CurveSpacing.h"

namespace remesh
{
/**
 * 1. Points where it bends, and that are about a spacing or more from the next, become marks.
 * 2. Between its marks, a curve is divided evenly in its spacing (CurveSpacing.h).
 * 3. Where it is farther from the chord of two places than `maxRise` of its length, or than
 *    `maxError`, the farthest point becomes a mark: it is sharper than those around it. Its turn
 *    counts no more, and all is done again, until there is no such point.
 *
 * @return places with both ends. O(m + places), times the few rounds.
 */
std::vector<Station> divideCurve(const Course& course, const DivisionRule& rule);
}

#endif
