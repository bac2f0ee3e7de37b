#include "Features/CurveSampling.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace remesh
{
namespace
{
constexpr double maxOnBends = 1.0 / 3.0; // of the points
constexpr double coarser = 1.05;         // growth of the turn, until they do
constexpr double coarsestTurn = 2.1;     // radians: a circle has three places
constexpr int maxSteps = 40;
constexpr int narrowSteps = 4; // before the spacing doubles from one to the next
constexpr double narrowGrowth = 1.05;
constexpr double minShare = 0.95; // of the spacing without features
constexpr double accuracy = 1e-3; // of the spacing

double lengthOf(const Course& course)
{
  double length = 0.0;
  for (std::size_t k = 1; k < course.points.size(); ++k)
  {
    length += (course.points[k] - course.points[k - 1]).norm();
  }
  return length;
}

/**
 * The least number of pieces of each curve (step 3). Of several with the same ends the shortest has
 * one: the others bend more, and their places make triangles with an area.
 */
void setLeastPieces(const Features& features, std::vector<Course>& courses)
{
  std::map<std::pair<Index, Index>, std::size_t> shortest;
  for (std::size_t c = 0; c < features.curves.size(); ++c)
  {
    const FeatureCurve& curve = features.curves[c];
    courses[c].minPieces = curve.closed() ? 3 : 1;
    const std::pair<Index, Index> ends = std::minmax(curve.points.front(), curve.points.back());
    const auto [found, isFirst] = shortest.try_emplace(ends, c);
    if (!isFirst && !curve.closed())
    {
      std::size_t& best = found->second;
      const bool isShorter = lengthOf(courses[c]) < lengthOf(courses[best]);
      courses[isShorter ? best : c].minPieces = 2;
      best = isShorter ? c : best;
    }
  }
}
}

CurveSampler::CurveSampler(const FeaturedSurface& featured, const CurveSamplingOptions& options)
  : m_features(featured.features)
  , m_sizes(measurePatches(featured))
  , m_number(static_cast<double>(options.numberOfPoints))
{
  m_rule.maxError = options.maxError;
  for (std::size_t c = 0; c < m_features.curves.size(); ++c)
  {
    m_courses.push_back(courseOf(featured, static_cast<Index>(c), options.followsBends));
  }
  setLeastPieces(m_features, m_courses);
}

Offset CurveSampler::limitBends(const RunControl& control)
{
  m_rule.spacing = std::numeric_limits<double>::infinity();
  Offset count = this->divide(control);
  while (static_cast<double>(count) > maxOnBends * m_number && m_rule.maxTurn < coarsestTurn)
  {
    m_rule.maxTurn = std::min(coarser * m_rule.maxTurn, coarsestTurn);
    count = this->divide(control);
  }
  return count;
}

void CurveSampler::findSpacing(Offset otherPoints, const RunControl& control)
{
  const auto others = static_cast<double>(otherPoints);
  const double area = std::accumulate(m_sizes.area.begin(), m_sizes.area.end(), 0.0);
  double low = 0.0;
  double high = minShare * std::sqrt(area / (cellArea * m_number));
  const auto isTooFine = [&](double spacing)
  { return this->pointsAt(spacing, others, control) > m_number; };
  for (int step = 0; step < maxSteps && !control.cancelled() && isTooFine(high); ++step)
  {
    low = high;
    high *= step < narrowSteps ? narrowGrowth : 2.0;
  }
  const auto goesOn = [&]()
  { return low > 0.0 && high - low > accuracy * high && !control.cancelled(); };
  while (goesOn())
  {
    const double middle = 0.5 * (low + high);
    (isTooFine(middle) ? low : high) = middle;
  }
  m_rule.spacing = high;
  this->divide(control);
}

void CurveSampler::mark(Index curve, const std::vector<Station>& places)
{
  Course course = m_courses[curve];
  markPlaces(places, course);
  m_stations[curve] = divideCurve(course, m_rule);
}

/** Of the mesh, with the places on curves at some spacing. */
double CurveSampler::pointsAt(double spacing, double otherPoints, const RunControl& control)
{
  m_rule.spacing = spacing;
  return static_cast<double>(this->divide(control)) + otherPoints + m_sizes.totalDemand(spacing);
}

/** @return how many vertices there are on the features; none, and nothing done, when cancelled. */
Offset CurveSampler::divide(const RunControl& control)
{
  if (control.cancelled())
  {
    return 0;
  }
  m_stations.resize(m_courses.size());
  for (std::size_t c = 0; c < m_courses.size(); ++c)
  {
    m_stations[c] = divideCurve(m_courses[c], m_rule);
  }
  return countFeaturePoints(m_features, m_stations);
}

Offset countFeaturePoints(const Features& features, const Stations& stations)
{
  auto count = static_cast<Offset>(features.corners.size());
  for (std::size_t c = 0; c < stations.size(); ++c)
  {
    // A curve's ends are corners; a closed curve without corner begins and ends at one vertex.
    count += static_cast<Offset>(stations[c].size()) - (features.curves[c].hasCorners ? 2 : 1);
  }
  return count;
}
}
