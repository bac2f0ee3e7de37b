#include "Features/CurveSpacing.h"

#include <algorithm>

namespace remesh
{
namespace
{
/** Of the way. Edges next to each other differ by no more than 1.65 times, the root of e. */
constexpr double grading = 0.5;
constexpr int knotsPerSpacing = 8;
constexpr double maxParts = 1e6; // of an edge
constexpr int halvings = 8;      // of the way between knots

/**
 * Fitted chords of an arc are 1.5 times as far from it, in the mean of squares, as fitted triangles
 * with such edges are from the cylinder that it is the rim of. By this share of their length, they
 * are as near as these.
 */
constexpr double bentShare = 0.8;

/** Where a spacing changes less, as a share, it counts as even. */
constexpr double minChange = 1e-9;
}

CurveSpacing::CurveSpacing(const Course& course, const std::vector<Point3>& turns,
  const std::vector<Index>& marks, const DivisionRule& rule)
  : m_rule(rule)
{
  this->layKnots(course, turns);
  this->limitToPieces(course, marks);
  if (course.isRound)
  {
    std::vector<Knot> around = this->threeRounds();
    this->shortenBent(around);
    this->limitToBends(around);
    this->grade(around);
    const std::size_t before = m_knots.size() - 1;
    for (std::size_t k = 0; k < m_knots.size(); ++k)
    {
      m_knots[k].spacing = around[before + k].spacing;
      m_knots[k].reach = around[before + k].reach;
    }
  }
  else
  {
    this->shortenBent(m_knots);
    this->limitToBends(m_knots);
    this->grade(m_knots);
  }
  this->count();
}

/** At all points of the curve, and between them where these are far apart. */
void CurveSpacing::layKnots(const Course& course, const std::vector<Point3>& turns)
{
  const double most = std::min(m_rule.spacing, course.length()) / knotsPerSpacing;
  m_knots.push_back({ 0.0, 0.0, 0.0, m_rule.spacing });
  m_knotOfPoint.push_back(0);
  for (Index k = 0; k < course.last(); ++k)
  {
    const Knot from = m_knots.back();
    const double length = course.lengths[k + 1] - course.lengths[k];
    const double extent = (course.points[k + 1] - course.points[k]).norm();
    const double turn = 0.5 * (turns[k] + turns[k + 1]).norm();
    const double parts = most > 0.0 ? std::min(std::ceil(length / most), maxParts) : 1.0;
    for (double part = 1.0; part < parts; part += 1.0)
    {
      const double share = part / parts;
      m_knots.push_back({ course.lengths[k] + share * length, from.extent + share * extent,
        from.turn + share * turn, m_rule.spacing });
    }
    m_knots.push_back(
      { course.lengths[k + 1], from.extent + extent, from.turn + turn, m_rule.spacing });
    m_knotOfPoint.push_back(m_knots.size() - 1);
  }
}

/** The knots of a round curve three times, so that those in the middle have others around them. */
std::vector<CurveSpacing::Knot> CurveSpacing::threeRounds() const
{
  std::vector<Knot> around;
  const Knot& whole = m_knots.back();
  for (int round = 0; round < 3; ++round)
  {
    for (std::size_t k = round == 0 ? 0 : 1; k < m_knots.size(); ++k)
    {
      const Knot& knot = m_knots[k];
      around.push_back({ knot.length + round * whole.length, knot.extent + round * whole.extent,
        knot.turn + round * whole.turn, knot.spacing });
    }
  }
  return around;
}

/** Whether an edge from one knot may reach another. */
bool CurveSpacing::reaches(const Knot& from, const Knot& to) const
{
  const double turn = std::abs(to.turn - from.turn);
  return turn <= m_rule.maxTurn &&
    turn * std::abs(to.extent - from.extent) <= 8.0 * m_rule.maxError; // the rise of an arc
}

/** How far it may reach, if it may the near knot and not the far one. */
double CurveSpacing::reachBetween(const Knot& from, Knot near, Knot far) const
{
  for (int step = 0; step < halvings; ++step)
  {
    const Knot middle{ 0.5 * (near.length + far.length), 0.5 * (near.extent + far.extent),
      0.5 * (near.turn + far.turn), 0.0 };
    (this->reaches(from, middle) ? near : far) = middle;
  }
  return std::abs(near.length - from.length);
}

void CurveSpacing::shortenBent(std::vector<Knot>& knots) const
{
  const double half = 0.5 * m_rule.spacing;
  const std::size_t count = knots.size();
  for (std::size_t k = 0, begin = 0, end = 0; k < count; ++k)
  {
    for (; knots[k].length - knots[begin].length > half; ++begin)
    {
    }
    for (; end + 1 < count && knots[end + 1].length - knots[k].length <= half; ++end)
    {
    }
    const double bent = std::min((knots[end].turn - knots[begin].turn) / bentTurn, 1.0);
    knots[k].spacing *= 1.0 - (1.0 - bentShare) * bent;
  }
}

void CurveSpacing::limitToBends(std::vector<Knot>& knots) const
{
  const std::size_t count = knots.size();
  for (std::size_t k = 0, end = 0; k < count; ++k)
  {
    for (end = std::max(end, k); end + 1 < count && this->reaches(knots[k], knots[end + 1]); ++end)
    {
    }
    if (end + 1 < count)
    {
      knots[k].reach = this->reachBetween(knots[k], knots[end], knots[end + 1]);
    }
  }
  for (std::size_t k = count, begin = count; k-- > 0;)
  {
    for (begin = std::min(begin, k); begin > 0 && this->reaches(knots[k], knots[begin - 1]);
         --begin)
    {
    }
    if (begin > 0)
    {
      const double back = this->reachBetween(knots[k], knots[begin], knots[begin - 1]);
      knots[k].reach = std::min(knots[k].reach, back);
    }
    knots[k].spacing = std::min(knots[k].spacing, knots[k].reach);
  }
}

/** But a round curve without a mark is no piece: where it begins is nothing special. */
void CurveSpacing::limitToPieces(const Course& course, const std::vector<Index>& marks)
{
  for (std::size_t b = 0; b + 1 < marks.size() && !(course.isRound && marks.size() == 2); ++b)
  {
    const double length = course.lengths[marks[b + 1]] - course.lengths[marks[b]];
    for (std::size_t k = m_knotOfPoint[marks[b]]; k <= m_knotOfPoint[marks[b + 1]]; ++k)
    {
      m_knots[k].spacing = std::min(m_knots[k].spacing, length);
    }
  }
}

void CurveSpacing::grade(std::vector<Knot>& knots) const
{
  for (std::size_t k = 1; k < knots.size(); ++k)
  {
    knots[k].spacing = std::min(
      knots[k].spacing, knots[k - 1].spacing + grading * (knots[k].length - knots[k - 1].length));
  }
  for (std::size_t k = knots.size() - 1; k-- > 0;)
  {
    knots[k].spacing = std::min(
      knots[k].spacing, knots[k + 1].spacing + grading * (knots[k + 1].length - knots[k].length));
  }
}

/** The integrals of one over the spacing, and over the reach, which are linear between knots. */
void CurveSpacing::count()
{
  const auto between = [](double length, double from, double to)
  {
    const bool isFinite = std::max(from, to) < std::numeric_limits<double>::infinity();
    return !isFinite || !(std::min(from, to) > 0.0) ? 0.0
      : std::abs(to - from) > minChange * from      ? length * std::log(to / from) / (to - from)
                                                    : length / from;
  };
  for (std::size_t k = 0; k + 1 < m_knots.size(); ++k)
  {
    const Knot& from = m_knots[k];
    Knot& to = m_knots[k + 1];
    const double length = to.length - from.length;
    to.count = from.count + between(length, from.spacing, to.spacing);
    to.bends = from.bends + between(length, from.reach, to.reach);
  }
}

double CurveSpacing::lengthAt(Index point, double count) const
{
  const auto first = m_knots.begin() + static_cast<std::ptrdiff_t>(m_knotOfPoint[point]);
  const auto after = std::lower_bound(first + 1, m_knots.end() - 1, count,
    [](const Knot& knot, double wanted) { return knot.count < wanted; });
  const Knot& from = *(after - 1);
  const Knot& to = *after;
  const double share = to.count > from.count
    ? std::clamp((count - from.count) / (to.count - from.count), 0.0, 1.0)
    : 0.0;
  const double growth = to.spacing / from.spacing;
  const double way =
    std::abs(growth - 1.0) > minChange ? (std::pow(growth, share) - 1.0) / (growth - 1.0) : share;
  return from.length + way * (to.length - from.length);
}
}
