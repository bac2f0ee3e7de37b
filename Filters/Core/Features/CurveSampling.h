/**
 * @file CurveSampling.h
 * @brief Where along the feature curves a mesh gets its points.
 */
#ifndef remesh_CurveSampling_h
#define remesh_CurveSampling_h

#include "Features/CurveStations.h"
#include "Features/FeaturedSurface.h"

namespace remesh
{
/**
 * Divides each curve evenly in embedded length.
 *
 * 1. Breaks at points of the curve, as few as keep the chords within a distance of it, and so that
 *    the chords' errors are balanced. The distance is the finest for which the curves take no more
 *    than two fifths of the points, from 1e-6 to 2e-5 of the diagonal. Where even that takes more
 *    than half of them for the bends alone, or three fifths in all, it grows on, up to a twentieth
 *    of the points' spacing, until two fifths do for the bends: the rest of the surface needs its
 *    points, too.
 *    No distance is above `mostError`: then the curves take more points, if they must.
 *    Creases that zigzag, as on scans, say little by their bends: their distance is a fifth of the
 *    points' spacing from the beginning.
 * 2. Chords longer than the spacing that `numberOfPoints` give are divided evenly. Where the curves
 *    would take more than three fifths of the points, distance and spacing grow along them.
 * 3. A closed curve has three places at least; no two curves share both ends without a place
 *    between them.
 *
 * @param numberOfPoints of the whole mesh.
 * @param mostError in the unit of the points, above 0.
 * @param needed vertices that corners and bends alone take, at the coarsest distance.
 * @return of no use when cancelled: asked between the tries.
 * Cost: O(V log V) for V points on curves, times the tries for the distance.
 */
Stations sampleCurves(const FeaturedSurface& featured, Offset numberOfPoints, double mostError,
  const RunControl& control, Offset& needed);

/** The vertices that a mesh has on its features: corners, and places between. */
Offset countFeaturePoints(const Features& features, const Stations& stations);
}

#endif
