#include "Features/CurveDivision.h"

#include <algorithm>
#include <utility>

namespace remesh
{
namespace
{
constexpr double maxEdges = 1e9;

/** Of the spacing, from a point to those around it, from which on it is worth a place of its own.
 */
constexpr double minAlone = 0.8;

/** How many edges there are to be in so many spacings: those that differ from them the least. */
Index nearestNumber(double spacings)
{
  const double less = std::floor(std::min(spacings, maxEdges));
  const bool isMore = spacings * spacings > less * (less + 1.0); // nearer as a ratio
  return std::max(static_cast<Index>(isMore ? less + 1.0 : less), Index(1));
}

/** As many as bends take, but for rounding. */
Index minNumber(double bends)
{
  constexpr double rounding = 0.02;
  return static_cast<Index>(std::ceil(std::min(bends, maxEdges) - rounding));
}

double squaredDistanceToChord(const Point3& p, const Point3& a, const Point3& b)
{
  const Point3 chord = b - a;
  const double squared = chord.squaredNorm();
  const double t = squared > 0.0 ? std::clamp((p - a).dot(chord) / squared, 0.0, 1.0) : 0.0;
  return (p - a - t * chord).squaredNorm();
}

class Divider
{
public:
  Divider(const Course& course, const DivisionRule& rule)
    : m_course(course)
    , m_rule(rule)
    , m_turns(course.turns)
    , m_marks(course.marks)
  {
    this->markLonePoints();
    for (std::size_t k = 1; k + 1 < m_marks.size(); ++k)
    {
      m_turns[m_marks[k]].setZero();
    }
  }

  std::vector<Station> divide()
  {
    do
    {
      this->place(CurveSpacing(m_course, m_turns, m_marks, m_rule));
    } while (this->addMarks());
    std::vector<Station> stations;
    for (const Station& station : m_stations)
    {
      stations.push_back(m_course.onCurve(station));
    }
    return stations;
  }

private:
  std::size_t pieces() const { return m_marks.size() - 1; }

  /** Step 1. Where the points of a curve are as far apart as the places, these are best at them. */
  void markLonePoints()
  {
    const double least = minAlone * m_rule.spacing;
    const auto isFar = [&](Index k)
    { return m_course.lengths[k + 1] - m_course.lengths[k] >= least; };
    std::vector<Index> alone;
    for (Index k = 1; k < m_course.last(); ++k)
    {
      if (m_turns[k].norm() > bentTurn && isFar(k - 1) && isFar(k))
      {
        alone.push_back(k);
      }
    }
    this->mark(alone);
  }

  void mark(const std::vector<Index>& points)
  {
    const auto before = static_cast<std::ptrdiff_t>(m_marks.size());
    m_marks.insert(m_marks.end(), points.begin(), points.end());
    std::inplace_merge(m_marks.begin(), m_marks.begin() + before, m_marks.end());
    m_marks.erase(std::unique(m_marks.begin(), m_marks.end()), m_marks.end());
  }

  /** Step 2. */
  void place(const CurveSpacing& spacing)
  {
    std::vector<Index> numbers;
    Index sum = 0;
    for (std::size_t b = 0; b < this->pieces(); ++b)
    {
      const double count = spacing.countAt(m_marks[b + 1]) - spacing.countAt(m_marks[b]);
      const double bends = spacing.bendsAt(m_marks[b + 1]) - spacing.bendsAt(m_marks[b]);
      numbers.push_back(std::max(nearestNumber(count), minNumber(bends)));
      sum += numbers.back();
    }
    m_stations.clear();
    if (sum == 1 && m_course.minPieces == 2)
    {
      m_stations = { { 0, 0.0 }, this->top(), { m_course.last() - 1, 1.0 } };
      return;
    }
    for (; sum < m_course.minPieces; ++sum)
    {
      ++numbers[this->longestPiece(numbers)];
    }
    for (std::size_t b = 0; b < this->pieces(); ++b)
    {
      m_stations.push_back({ m_marks[b], 0.0 });
      this->placeInPiece(spacing, b, numbers[b]);
    }
    m_stations.push_back({ m_course.last() - 1, 1.0 });
  }

  /** The point that is farthest from the chord of the whole; the middle of what is straight. */
  Station top() const
  {
    Index farthest = noIndex;
    double most = 0.0;
    for (Index p = 1; p < m_course.last(); ++p)
    {
      const double squared =
        squaredDistanceToChord(m_course.points[p], m_course.points.front(), m_course.points.back());
      if (squared > most)
      {
        most = squared;
        farthest = p;
      }
    }
    return farthest == noIndex ? stationAt(m_course.lengths, 0.5 * m_course.length())
                               : Station{ farthest, 0.0 };
  }

  double lengthOf(std::size_t piece) const
  {
    return m_course.lengths[m_marks[piece + 1]] - m_course.lengths[m_marks[piece]];
  }

  /** By the lengths of its parts. */
  std::size_t longestPiece(const std::vector<Index>& numbers) const
  {
    std::size_t longest = 0;
    for (std::size_t b = 1; b < numbers.size(); ++b)
    {
      if (this->lengthOf(b) * numbers[longest] > this->lengthOf(longest) * numbers[b])
      {
        longest = b;
      }
    }
    return longest;
  }

  void placeInPiece(const CurveSpacing& spacing, std::size_t piece, Index number)
  {
    const Index first = m_marks[piece];
    const double begin = spacing.countAt(first);
    const double count = spacing.countAt(m_marks[piece + 1]) - begin;
    for (Index k = 1; k < number; ++k)
    {
      const double share = static_cast<double>(k) / static_cast<double>(number);
      const double length = count > 0.0 ? spacing.lengthAt(first, begin + share * count)
                                        : m_course.lengths[first] + share * this->lengthOf(piece);
      const Station station = stationAt(m_course.lengths, length);
      if (m_stations.back() < station && station.segment < m_marks[piece + 1])
      {
        m_stations.push_back(station);
      }
    }
  }

  /** The point between two stations that is farthest from their chord, and too far; or noIndex. */
  Index strayPoint(const Station& begin, const Station& end) const
  {
    const Point3 from = m_course.placeAt(begin);
    const Point3 to = m_course.placeAt(end);
    const double most = m_course.isRough
      ? m_rule.maxError
      : std::min(m_rule.maxError, m_rule.maxRise() * (to - from).norm());
    double farthest = most * most;
    Index point = noIndex;
    for (Index p = begin.segment + 1; p <= std::min(end.segment, m_course.last() - 1); ++p)
    {
      const double squared = squaredDistanceToChord(m_course.points[p], from, to);
      if (squared > farthest)
      {
        farthest = squared;
        point = p;
      }
    }
    return point;
  }

  /** Step 3. @return whether there are more. */
  bool addMarks()
  {
    std::vector<Index> added;
    for (std::size_t k = 0; k + 1 < m_stations.size(); ++k)
    {
      if (const Index point = this->strayPoint(m_stations[k], m_stations[k + 1]); point != noIndex)
      {
        added.push_back(point);
        m_turns[point].setZero();
      }
    }
    const std::size_t before = m_marks.size();
    this->mark(added);
    return m_marks.size() > before;
  }

  const Course& m_course;
  const DivisionRule& m_rule;
  std::vector<Point3> m_turns; ///< m + 1, those that count
  std::vector<Index> m_marks;
  std::vector<Station> m_stations; ///< as the course's points count
};
}

std::vector<Station> divideCurve(const Course& course, const DivisionRule& rule)
{
  return Divider(course, rule).divide();
}
}
