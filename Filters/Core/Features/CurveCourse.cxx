#include "Features/CurveCourse.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace remesh
{
namespace
{
// Of scans it is 0.55 and less, of parts, also rounded ones, above 0.8.
constexpr double noisyShare = 0.7;   // of its turning that is left between neighbouring turns
constexpr double noisyTurning = 1.0; // radians in all; with less, there is little to tell it by

Point3 turnOf(const Point3& in, const Point3& out)
{
  const Point3 axis = in.cross(out);
  return std::atan2(axis.norm(), in.dot(out)) * axis.stableNormalized();
}

std::vector<Point3> turnsOf(const std::vector<Point3>& points, bool isRound)
{
  std::vector<Point3> turns(points.size(), Point3::Zero());
  for (std::size_t k = 1; k + 1 < points.size(); ++k)
  {
    turns[k] = turnOf(points[k] - points[k - 1], points[k + 1] - points[k]);
  }
  if (isRound)
  {
    turns.front() = turnOf(points.back() - points[points.size() - 2], points[1] - points[0]);
    turns.back() = turns.front();
  }
  return turns;
}

bool isNoise(const std::vector<Point3>& turns)
{
  double turning = 0.0;
  double inPairs = 0.0;
  for (std::size_t k = 1; k + 1 < turns.size(); ++k)
  {
    turning += turns[k].norm();
    inPairs += k > 1 ? 0.5 * (turns[k - 1] + turns[k]).norm() : 0.0;
  }
  return turning > noisyTurning && inPairs < noisyShare * turning;
}

/** Where a station's segment ends between two places of which it is between. */
double endOf(const Station& from, const Station& to)
{
  return to.segment == from.segment ? to.t : 1.0;
}
}

Station Course::onCurve(const Station& station) const
{
  const Station& from = this->places[station.segment];
  const Station& to = this->places[station.segment + 1];
  return station.t == 0.0 ? from
    : station.t == 1.0    ? to
                       : Station{ from.segment, from.t + station.t * (endOf(from, to) - from.t) };
}

Course makeCourse(
  std::vector<Point3> points, std::vector<double> lengths, bool isRound, bool followsBends)
{
  Course course;
  course.points = std::move(points);
  course.lengths = std::move(lengths);
  const Index last = course.last();
  for (Index k = 0; k <= last; ++k)
  {
    course.places.push_back(k < last ? Station{ k, 0.0 } : Station{ k - 1, 1.0 });
  }
  course.marks = { 0, last };
  course.isRound = isRound;
  course.turns = turnsOf(course.points, isRound);
  course.isRough = !followsBends || isNoise(course.turns);
  if (course.isRough)
  {
    std::fill(course.turns.begin(), course.turns.end(), Point3::Zero());
  }
  return course;
}

Course courseOf(const FeaturedSurface& featured, Index curve, bool followsBends)
{
  const FeatureCurve& own = featured.features.curves[curve];
  std::vector<Point3> points;
  for (const Index point : own.points)
  {
    points.push_back(featured.mesh.points[point]);
  }
  return makeCourse(
    std::move(points), measureCurve(featured, curve), !own.hasCorners, followsBends);
}

void markPlaces(const std::vector<Station>& marked, Course& course)
{
  const Course before = std::exchange(course, Course{});
  course.isRound = before.isRound;
  course.isRough = before.isRough;
  course.minPieces = before.minPieces;
  const auto add = [&](const Point3& point, double length, const Point3& turn, const Station& place)
  {
    course.points.push_back(point);
    course.lengths.push_back(length);
    course.turns.push_back(turn);
    course.places.push_back(place);
  };
  auto next = marked.begin();
  auto mark = before.marks.begin();
  for (Index k = 0; k <= before.last(); ++k)
  {
    const Station& at = before.places[k];
    for (; next != marked.end() && *next < at; ++next)
    {
      const Station& from = before.places[k - 1];
      const Station between{ k - 1, (next->t - from.t) / (endOf(from, at) - from.t) };
      add(before.placeAt(between), lengthAt(before.lengths, between), Point3::Zero(), *next);
      course.marks.push_back(course.last());
    }
    add(before.points[k], before.lengths[k], before.turns[k], at);
    const bool isNew = next != marked.end() && *next == at;
    const bool wasMarked = mark != before.marks.end() && *mark == k;
    next += isNew ? 1 : 0;
    mark += wasMarked ? 1 : 0;
    if (isNew || wasMarked)
    {
      course.marks.push_back(course.last());
    }
  }
}
}
