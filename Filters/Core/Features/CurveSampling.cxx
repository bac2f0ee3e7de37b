#include "Features/CurveSampling.h"

#include "Mesh/Extent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace remesh
{
namespace
{
constexpr double finestError = 1e-6;     // of the diagonal: single precision
constexpr double coarsestError = 0.05;   // of the spacing
constexpr double fineError = 2e-5;       // of the diagonal
constexpr double fineShare = 0.4;        // of the points, for the sake of the curves' bends
constexpr double largestBendShare = 0.5; // for the fine error; before it grows to the fine share
constexpr double largestShare = 0.6;     // of all on curves; before it grows, and the spacing
constexpr double growth = 1.25;
constexpr int mostGrowths = 20;
constexpr int balancingSteps = 10;
constexpr double hexagonal = 0.86602540378443864676; // area per point over spacing squared

constexpr double roughError = 0.2;   // of the spacing, of creases that zigzag
constexpr double leastTurning = 1.0; // radians in all, of a curve that may zigzag
constexpr double roughShare = 0.6;   // of its turning that is left between neighbouring turns

/** One curve as the sampler sees it. */
struct Course
{
  std::vector<Point3> points;  ///< m + 1
  std::vector<double> lengths; ///< m + 1, embedded
  bool isRough = false;        ///< a crease that zigzags
};

/**
 * Whether a curve turns to and fro, as creases do that follow the edges of a scan: turns in
 * opposite directions next to each other cancel, which those of an arc or a corner do not.
 */
bool zigzags(const std::vector<Point3>& points)
{
  double turning = 0.0;
  double inPairs = 0.0;
  Point3 last = Point3::Zero();
  for (std::size_t k = 1; k + 1 < points.size(); ++k)
  {
    const Point3 in = points[k] - points[k - 1];
    const Point3 out = points[k + 1] - points[k];
    const Point3 axis = in.cross(out);
    const double angle = std::atan2(axis.norm(), in.dot(out));
    const Point3 turn = angle * axis.stableNormalized();
    turning += angle;
    inPairs += k > 1 ? 0.5 * (turn + last).norm() : 0.0;
    last = turn;
  }
  return turning > leastTurning && inPairs < roughShare * turning;
}

double squaredDistanceToChord(const Point3& p, const Point3& a, const Point3& b)
{
  const Point3 chord = b - a;
  const double squared = chord.squaredNorm();
  const double t = squared > 0.0 ? std::clamp((p - a).dot(chord) / squared, 0.0, 1.0) : 0.0;
  return (p - a - t * chord).squaredNorm();
}

bool isWithin(const Course& course, Index i, Index j, double error)
{
  for (Index k = i + 1; k < j; ++k)
  {
    if (squaredDistanceToChord(course.points[k], course.points[i], course.points[j]) >
      error * error)
    {
      return false;
    }
  }
  return true;
}

/** The farthest point up to which one chord from point i does, by doubling and halving. */
Index reach(const Course& course, Index i, double error)
{
  const auto last = static_cast<Index>(course.points.size()) - 1;
  Index good = i + 1;
  Index step = 1;
  while (good + step <= last && isWithin(course, i, good + step, error))
  {
    good += step;
    step *= 2;
  }
  for (; step > 0; step /= 2)
  {
    if (good + step <= last && isWithin(course, i, good + step, error))
    {
      good += step;
    }
  }
  return good;
}

std::vector<Index> breakGreedily(const Course& course, double error)
{
  const auto last = static_cast<Index>(course.points.size()) - 1;
  std::vector<Index> breaks{ 0 };
  while (breaks.back() < last)
  {
    breaks.push_back(reach(course, breaks.back(), error));
  }
  return breaks;
}

/** As few breaks as the error allows, with the smallest error for that many. */
std::vector<Index> breakEvenly(const Course& course, double error)
{
  std::vector<Index> best = breakGreedily(course, error);
  if (best.size() <= 2)
  {
    return best;
  }
  double low = 0.0;
  double high = error;
  for (int step = 0; step < balancingSteps; ++step)
  {
    const double middle = 0.5 * (low + high);
    std::vector<Index> breaks = breakGreedily(course, middle);
    if (breaks.size() <= best.size())
    {
      best = std::move(breaks);
      high = middle;
    }
    else
    {
      low = middle;
    }
  }
  return best;
}

/** Pieces of about the spacing in a chord of some length. */
Index piecesOf(double length, double spacing)
{
  return static_cast<Index>(std::clamp(std::ceil(length / spacing - 0.25), 1.0, 1e9));
}

std::vector<Station> divide(
  const Course& course, const std::vector<Index>& breaks, double spacing, Index least)
{
  std::vector<Index> pieces(breaks.size() - 1);
  Index total = 0;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
  {
    pieces[k] = piecesOf(course.lengths[breaks[k + 1]] - course.lengths[breaks[k]], spacing);
    total += pieces[k];
  }
  while (total < least) // the longest pieces first
  {
    std::size_t longest = 0;
    double length = -1.0;
    for (std::size_t k = 0; k < pieces.size(); ++k)
    {
      const double piece = (course.lengths[breaks[k + 1]] - course.lengths[breaks[k]]) / pieces[k];
      if (piece > length)
      {
        length = piece;
        longest = k;
      }
    }
    ++pieces[longest];
    ++total;
  }
  std::vector<Station> stations;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
  {
    const double begin = course.lengths[breaks[k]];
    const double end = course.lengths[breaks[k + 1]];
    stations.push_back({ breaks[k], 0.0 });
    for (Index piece = 1; piece < pieces[k]; ++piece)
    {
      const Station station = stationAt(course.lengths, begin + (end - begin) * piece / pieces[k]);
      if (stations.back() < station && station.segment < breaks[k + 1])
      {
        stations.push_back(station);
      }
    }
  }
  stations.push_back({ static_cast<Index>(course.points.size()) - 2, 1.0 });
  return stations;
}

/** The least number of pieces of each curve (step 3), the first of several with the same ends. */
std::vector<Index> leastPieces(const Features& features)
{
  std::map<std::pair<Index, Index>, int> between;
  std::vector<Index> least(features.curves.size(), 1);
  for (std::size_t c = 0; c < features.curves.size(); ++c)
  {
    const FeatureCurve& curve = features.curves[c];
    const std::pair<Index, Index> ends = std::minmax(curve.points.front(), curve.points.back());
    if (curve.closed())
    {
      least[c] = 3;
    }
    else if (between[ends]++ > 0)
    {
      least[c] = 2;
    }
  }
  return least;
}

std::vector<Course> coursesOf(const FeaturedSurface& featured)
{
  const Features& features = featured.features;
  std::vector<Course> courses(features.curves.size());
  for (std::size_t c = 0; c < courses.size(); ++c)
  {
    for (const Index point : features.curves[c].points)
    {
      courses[c].points.push_back(featured.mesh.points[point]);
    }
    courses[c].lengths = measureCurve(featured, static_cast<Index>(c));
    courses[c].isRough =
      features.curves[c].kind == FeatureKind::Crease && zigzags(courses[c].points);
  }
  return courses;
}

/** Samples all curves, coarser and coarser until they leave room for other points. */
class CurveSampler
{
public:
  /**
   * @param featured its features must outlive it.
   * @param numberOfPoints of the mesh.
   * @param mostError unit of the points.
   */
  CurveSampler(const FeaturedSurface& featured, Offset numberOfPoints, double mostError)
    : m_features(featured.features)
    , m_courses(coursesOf(featured))
    , m_least(leastPieces(featured.features))
    , m_numberOfPoints(static_cast<double>(numberOfPoints))
    , m_mostError(mostError)
  {
    const EmbeddedSurface& surface = featured.surface;
    const double length = std::accumulate(m_courses.begin(), m_courses.end(), 0.0,
      [](double sum, const Course& course) { return sum + course.lengths.back(); });
    // Slivers have next to no area.
    m_spacing = std::max(
      std::sqrt(surface.siteMeasure / (hexagonal * m_numberOfPoints)), length / m_numberOfPoints);
    const double diagonal = boundingBoxDiagonal(featured.mesh);
    const double spacing = m_spacing * surface.unit; // a power of two
    m_error = std::min(mostError, finestError * diagonal);
    m_fine = std::min(mostError, fineError * diagonal);
    m_coarsest = std::clamp(std::max(m_error, coarsestError * spacing), m_fine, mostError);
    m_rough = std::min(roughError * spacing, mostError);
  }

  /** With the finest error of chords that leaves enough points for the rest of the surface. */
  void chooseError(const RunControl& control)
  {
    this->sample(control);
    while (m_count > fineShare * m_numberOfPoints && m_error < m_fine)
    {
      m_error = std::min(2.0 * m_error, m_fine);
      this->sample(control);
    }
    const bool bendy =
      m_error == m_fine && this->countBends(m_error, control) > largestBendShare * m_numberOfPoints;
    const auto isTooFine = [&]()
    {
      return m_count > largestShare * m_numberOfPoints ||
        (bendy && this->countBends(m_error, control) > fineShare * m_numberOfPoints);
    };
    while (m_error < m_coarsest && isTooFine())
    {
      m_error = std::min(2.0 * m_error, m_coarsest);
      this->sample(control);
    }
  }

  /** Where no error does, with a wider spacing, too. */
  void widen(const RunControl& control)
  {
    for (int k = 0; k < mostGrowths && m_count > largestShare * m_numberOfPoints; ++k)
    {
      m_spacing *= growth;
      m_error = std::min(m_mostError, growth * m_error);
      this->sample(control);
    }
  }

  /** Points that corners and bends take with the coarsest error. */
  Offset neededPoints(const RunControl& control) const
  {
    return static_cast<Offset>(this->countBends(m_coarsest, control));
  }

  Stations take() { return std::move(m_stations); }

private:
  Stations sampleWith(double error, double spacing) const
  {
    Stations stations(m_courses.size());
    for (std::size_t c = 0; c < m_courses.size(); ++c)
    {
      const double own = m_courses[c].isRough ? std::max(error, m_rough) : error;
      stations[c] = divide(m_courses[c], breakEvenly(m_courses[c], own), spacing, m_least[c]);
    }
    return stations;
  }

  /** When cancelled, there are no points, so that no other try follows. */
  void sample(const RunControl& control)
  {
    m_count = 0.0;
    if (!control.cancelled())
    {
      m_stations = this->sampleWith(m_error, m_spacing);
      m_count = static_cast<double>(countFeaturePoints(m_features, m_stations));
    }
  }

  double countBends(double error, const RunControl& control) const
  {
    const double any = std::numeric_limits<double>::infinity();
    return control.cancelled()
      ? 0.0
      : static_cast<double>(countFeaturePoints(m_features, this->sampleWith(error, any)));
  }

  const Features& m_features;
  std::vector<Course> m_courses;
  std::vector<Index> m_least; ///< pieces of each curve
  double m_numberOfPoints;
  double m_mostError;
  double m_spacing;  ///< embedded
  double m_error;    ///< of chords, and those below, too: unit of the points
  double m_fine;     ///< before bends get fewer points than they could use
  double m_coarsest; ///< before the spacing grows
  double m_rough;    ///< of creases that zigzag, if it is larger
  Stations m_stations;
  double m_count = 0.0; ///< of points
};
}

Stations sampleCurves(const FeaturedSurface& featured, Offset numberOfPoints, double mostError,
  const RunControl& control, Offset& needed)
{
  CurveSampler sampler(featured, numberOfPoints, mostError);
  sampler.chooseError(control);
  if (!control.cancelled())
  {
    needed = sampler.neededPoints(control);
    sampler.widen(control);
  }
  return sampler.take();
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
