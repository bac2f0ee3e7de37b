/**
 * @file CurveCourse.h
 * @brief A feature curve as those see it who divide it.
 */
#ifndef remesh_CurveCourse_h
#define remesh_CurveCourse_h

#include "Features/CurveStations.h"

namespace remesh
{
/** The points of a curve, and of the places that are to be among those found. */
struct Course
{
  std::vector<Point3> points;  ///< m + 1
  std::vector<double> lengths; ///< m + 1, embedded, up to each point
  std::vector<Point3> turns;   ///< m + 1, radians, along the axis; 0 at ends, and where it is noise
  std::vector<Station> places; ///< m + 1, of the points
  std::vector<Index> marks;    ///< the points to be found; ascending, both ends among them
  bool isRound = false;        ///< closed, and without a corner
  bool isRough = false;        ///< its bends are noise
  Index minPieces = 1;

  Index last() const { return static_cast<Index>(this->points.size()) - 1; }
  double length() const { return this->lengths.back(); }
  /** Of a place between the points, as these count. */
  Point3 placeAt(const Station& station) const
  {
    const Point3& start = this->points[station.segment];
    return start + station.t * (this->points[station.segment + 1] - start);
  }
  /** The same place as the curve's own points count. */
  Station onCurve(const Station& station) const;
};

/**
 * The course of a curve, its ends the only marks. It is rough where it turns to and fro, as curves
 * do that follow the edges of a scan: turns in opposite directions next to each other cancel, which
 * those of an arc or a corner do not.
 *
 * @param points m + 1, and their embedded lengths.
 * @param followsBends false: every curve is rough.
 */
Course makeCourse(
  std::vector<Point3> points, std::vector<double> lengths, bool isRound, bool followsBends = true);

/** Of a curve of the surface. */
Course courseOf(const FeaturedSurface& featured, Index curve, bool followsBends);

/** Marks these places, too: ascending, and between the ends. */
void markPlaces(const std::vector<Station>& marked, Course& course);
}

#endif
