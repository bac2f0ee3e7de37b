/**
 * @file CurveSampling.h
 * @brief Where along the feature curves a mesh gets its points.
 */
#ifndef remesh_CurveSampling_h
#define remesh_CurveSampling_h

#include "Features/CurveDivision.h"
#include "Features/PatchSampling.h"
#include "Support/RunControl.h"

namespace remesh
{
struct CurveSamplingOptions
{
  Offset numberOfPoints = 0; ///< of the whole mesh
  /** Of chords, in the unit of the points; above 0. */
  double maxError = std::numeric_limits<double>::infinity();
  /** Whether curves get more points where they bend. */
  bool followsBends = true;
};

/**
 * Divides the curves as densely as the mesh beside them (CurveDivision.h).
 *
 * 1. Bends get as many points as make a curve turn by no more than 23 degrees between two. Where
 *    that takes more than a third of all points, they get fewer: so many, if there is room beside
 *    the corners and what the error asks for.
 * 2. The spacing is the one for which the points on curves and those that then fill the patches
 *    (PatchSampling.h) are as many as asked for.
 * 3. A closed curve has three places at least; no two curves share both ends without a place
 *    between them.
 */
class CurveSampler
{
public:
  /** The features must outlive it. O(F), and O(V) for V points on curves. */
  CurveSampler(const FeaturedSurface& featured, const CurveSamplingOptions& options);

  /** Step 1. @return the vertices that corners and bends alone take. O(V), times the few tries. */
  Offset limitBends(const RunControl& control);

  /**
   * Step 2; forgets all marks.
   *
   * @param otherPoints that are to come on curves besides.
   * @param control asked between the tries; when cancelled, what is found is of no use.
   * Cost: O(V + places), times some twenty tries.
   */
  void findSpacing(Offset otherPoints, const RunControl& control);

  /** Divides a curve anew, at the spacing that was found, with these places among its own. */
  void mark(Index curve, const std::vector<Station>& places);

  double spacing() const { return m_rule.spacing; } ///< embedded, of the mesh
  const Stations& stations() const { return m_stations; }

private:
  Offset divide(const RunControl& control);
  double pointsAt(double spacing, double otherPoints, const RunControl& control);

  const Features& m_features;
  PatchSizes m_sizes;
  std::vector<Course> m_courses;
  double m_number; ///< of points
  DivisionRule m_rule;
  Stations m_stations;
};

/** The vertices that a mesh has on its features: corners, and places between. */
Offset countFeaturePoints(const Features& features, const Stations& stations);
}

#endif
