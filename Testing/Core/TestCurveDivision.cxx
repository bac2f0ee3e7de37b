// Features/CurveDivision: places along a curve are as far apart as asked for; nearer where it
// bends, by as much as that takes; at its kinks; nowhere for the sake of noise; and they become
// denser and sparser gradually.

#include "Features/CurveDivision.h"
#include "Support/Random.h"
#include "TestSupport.h"

#include <algorithm>

using namespace remesh;

namespace
{
/** The embedded length is that in R^3, times a scale. */
Course courseThrough(const std::vector<Point3>& points, bool isRound = false, double scale = 1.0)
{
  std::vector<double> lengths{ 0.0 };
  for (std::size_t k = 1; k < points.size(); ++k)
  {
    lengths.push_back(lengths.back() + scale * (points[k] - points[k - 1]).norm());
  }
  return makeCourse(points, lengths, isRound);
}

std::vector<Point3> arc(double radius, double angle, int segments)
{
  std::vector<Point3> points;
  for (int k = 0; k <= segments; ++k)
  {
    const double at = angle * k / segments;
    points.emplace_back(radius * std::cos(at), radius * std::sin(at), 0.0);
  }
  return points;
}

/** The embedded lengths of the sections, after a check that the places are in order. */
std::vector<double> gapsOf(const Course& course, const std::vector<Station>& places)
{
  CHECK(std::is_sorted(places.begin(), places.end()));
  CHECK_EQUAL(lengthAt(course.lengths, places.front()), 0.0);
  CHECK_EQUAL(lengthAt(course.lengths, places.back()), course.length());
  std::vector<double> gaps;
  for (std::size_t k = 1; k < places.size(); ++k)
  {
    gaps.push_back(lengthAt(course.lengths, places[k]) - lengthAt(course.lengths, places[k - 1]));
    CHECK(gaps.back() > 0.0);
  }
  return gaps;
}

std::vector<double> gapsOf(const Course& course, const DivisionRule& rule)
{
  return gapsOf(course, divideCurve(course, rule));
}

DivisionRule ruleOf(double spacing)
{
  DivisionRule rule;
  rule.spacing = spacing;
  return rule;
}

double minOf(const std::vector<double>& values)
{
  return *std::min_element(values.begin(), values.end());
}

double maxOf(const std::vector<double>& values)
{
  return *std::max_element(values.begin(), values.end());
}

/** Straight, with points anywhere: even, and as near to the spacing as a whole number allows. */
void testStraight()
{
  std::vector<Point3> points;
  for (const double x : { 0.0, 0.03, 0.5, 0.51, 0.9, 1.0 })
  {
    points.emplace_back(x, 2.0 * x, 0.0);
  }
  const Course course = courseThrough(points, false, 1.0 / std::sqrt(5.0)); // 1 long
  for (const double spacing : { 0.04, 0.3, 0.7, 1.4, 50.0 })
  {
    const std::vector<double> gaps = gapsOf(course, ruleOf(spacing));
    CHECK_NEAR(minOf(gaps), maxOf(gaps), 1e-9);
    CHECK(gaps.size() == 1 || gaps[0] > spacing / std::sqrt(2.0) - 1e-9);
    CHECK(gaps[0] < spacing * std::sqrt(2.0) + 1e-9);
  }
}

/** 23 degrees from place to place, however sparse the mesh is; else four fifths of its spacing. */
void testCircle()
{
  const Course course = courseThrough(arc(1.0, 2.0 * pi, 400), true);
  for (const double spacing : { 1e3, 10.0, 1.0 })
  {
    const std::vector<double> gaps = gapsOf(course, ruleOf(spacing));
    CHECK_EQUAL(gaps.size(), std::size_t(16)); // of 22.5 degrees
    CHECK_NEAR(minOf(gaps), maxOf(gaps), 1e-3);
  }
  CHECK_EQUAL(gapsOf(course, ruleOf(2.0 * pi / 40.0)).size(), std::size_t(50));
  DivisionRule rule = ruleOf(10.0);
  rule.maxTurn = 1.2;
  CHECK_EQUAL(gapsOf(course, rule).size(), std::size_t(6));
  rule.maxError = 1e-3; // that of 71 chords
  const std::size_t chords = gapsOf(course, rule).size();
  CHECK(chords >= 70 && chords <= 73);
}

/** A straight line, a bend much smaller than the spacing, and on: few places, and a gradual way. */
void testBend()
{
  constexpr double radius = 0.02;
  std::vector<Point3> points{ { -10.0, 0.0, 0.0 } };
  for (int k = 0; k <= 60; ++k)
  {
    const double angle = 0.5 * pi * k / 60.0;
    points.emplace_back(radius * std::sin(angle), radius * (1.0 - std::cos(angle)), 0.0);
  }
  points.emplace_back(radius, 10.0, 0.0);
  const Course course = courseThrough(points);
  const std::vector<double> gaps = gapsOf(course, ruleOf(1.0));
  CHECK(minOf(gaps) > 0.12 * pi * radius / 2.0);
  CHECK(minOf(gaps) < 0.42 * radius);
  CHECK(maxOf(gaps) > 0.8);
  CHECK(gaps.size() < 50); // 20 of the spacing, some in the bend, and what is between on both sides
  for (std::size_t k = 1; k < gaps.size(); ++k)
  {
    CHECK(gaps[k] < 2.0 * gaps[k - 1] && gaps[k - 1] < 2.0 * gaps[k]);
  }
}

/** A kink is a place, and nothing is denser there. Where embedded length decides, it is none. */
void testKinks()
{
  const std::vector<Point3> points{ { 0.0, 0.0, 0.0 }, { 3.3, 0.0, 0.0 }, { 6.0, 2.7, 0.0 } };
  const Course course = courseThrough(points);
  const std::vector<Station> places = divideCurve(course, ruleOf(1.0));
  CHECK(std::count(places.begin(), places.end(), Station{ 1, 0.0 }) == 1);
  const std::vector<double> gaps = gapsOf(course, places);
  CHECK(minOf(gaps) > 0.7 && maxOf(gaps) < 1.4);

  // A polygon that is to the mesh what it is: the corners, and nothing between.
  const Course polygon = courseThrough(arc(1.0, 2.0 * pi, 12), true);
  CHECK_EQUAL(gapsOf(polygon, ruleOf(0.6)).size(), std::size_t(12));

  const Course embedded = makeCourse(course.points, course.lengths, false, false);
  const std::vector<double> even = gapsOf(embedded, ruleOf(1.0));
  CHECK_NEAR(minOf(even), maxOf(even), 1e-9);
}

/** A line that runs to and fro like the edges of a scan, and one that waves as much. */
void testNoise()
{
  std::vector<Point3> noisy;
  std::vector<Point3> smooth;
  for (int k = 0; k <= 200; ++k)
  {
    noisy.emplace_back(0.1 * k, 0.1 * uniform01(1, k, 0), 0.1 * uniform01(1, k, 1));
    smooth.emplace_back(0.1 * k, 0.2 * std::sin(0.5 * k), 0.0);
  }
  const Course course = courseThrough(noisy);
  CHECK(course.isRough);
  const std::vector<double> gaps = gapsOf(course, ruleOf(0.5));
  CHECK_NEAR(minOf(gaps), 0.5, 0.05);
  CHECK_NEAR(maxOf(gaps), minOf(gaps), 1e-6);
  DivisionRule exact = ruleOf(0.5);
  exact.maxError = 1e-6; // is kept, whatever it takes
  CHECK_EQUAL(gapsOf(course, exact).size(), std::size_t(200));

  CHECK(!courseThrough(smooth).isRough);
  CHECK(minOf(gapsOf(courseThrough(smooth), ruleOf(2.0))) < 0.3);
}

/** Marked places are among those found, wherever they are, and the others even between them. */
void testMarks()
{
  Course course = courseThrough(arc(1.0, 1.0, 10));
  markPlaces({ { 2, 0.0 }, { 2, 0.25 }, { 7, 0.5 } }, course);
  const std::vector<Station> places = divideCurve(course, ruleOf(0.2));
  for (const Station& mark : { Station{ 2, 0.0 }, Station{ 2, 0.25 }, Station{ 7, 0.5 } })
  {
    CHECK(std::count(places.begin(), places.end(), mark) == 1);
  }
  const Course plain = courseThrough(arc(1.0, 1.0, 10));
  for (const double gap : gapsOf(plain, places))
  {
    CHECK(gap < 0.3);
  }
  CHECK_EQUAL(places.back().segment, 9);
  CHECK_EQUAL(places.back().t, 1.0);

  Course least = courseThrough(arc(0.001, 2.0 * pi, 50), true);
  least.minPieces = 3;
  DivisionRule rule = ruleOf(10.0);
  rule.maxTurn = 10.0;
  CHECK_EQUAL(gapsOf(least, rule).size(), std::size_t(3));
}

/** The one place that a curve must have is where it is farthest from its chord. */
void testTop()
{
  Course course = courseThrough({ { 0, 0, 0 }, { 1, 0.1, 0 }, { 3, 0.2, 0 }, { 4, 0, 0 } });
  CHECK_EQUAL(gapsOf(course, ruleOf(10.0)).size(), std::size_t(1));
  course.minPieces = 2;
  const std::vector<Station> places = divideCurve(course, ruleOf(10.0));
  CHECK_EQUAL(places.size(), std::size_t(3));
  CHECK(places[1] == (Station{ 2, 0.0 }));
}
}

int TestCurveDivision(int, char*[])
{
  testStraight();
  testCircle();
  testBend();
  testKinks();
  testNoise();
  testMarks();
  testTop();
  return test::result();
}
