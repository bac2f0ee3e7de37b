/**
 * @file CurveSpacing.h
 * @brief How far apart the places on a curve are to be, from one of its ends to the other.
 */
#ifndef remesh_CurveSpacing_h
#define remesh_CurveSpacing_h

#include "Features/CurveCourse.h"

#include <cmath>
#include <limits>

namespace remesh
{
/** Radians within a spacing: what turns by less is as good as straight. */
constexpr double bentTurn = 0.01;

/** How a curve is to be divided. */
struct DivisionRule
{
  double spacing = std::numeric_limits<double>::infinity(); ///< embedded; of the mesh
  double maxTurn = 0.4; ///< radians, of the curve between two places
  double maxError = std::numeric_limits<double>::infinity(); ///< of chords; unit of the points

  /**
   * How far an arc of that turn is from its chord at most, over the chord's length: 0.05; and by a
   * twentieth more, as whole numbers of edges have it.
   */
  double maxRise() const { return 1.05 * 0.5 * std::tan(0.25 * this->maxTurn); }
};

/**
 * 1. The spacing is that of the rule, four fifths of it where the curve bends. It is less where the
 *    curve turns by `maxTurn` in less, or an arc rises by `maxError` over less, to either side;
 *    and no more than what is between two marks. A point's turn counts half along each of its two
 *    edges, where it adds up with that of the edge's other end: to and fro cancel.
 * 2. From where it is small, it grows by no more than a half of the way.
 */
class CurveSpacing
{
public:
  /** @param turns m + 1, those that count. O(m), and the parts of long edges. */
  CurveSpacing(const Course& course, const std::vector<Point3>& turns,
    const std::vector<Index>& marks, const DivisionRule& rule);

  /** How many spacings there are from the curve's begin to a point of it. */
  double countAt(Index point) const { return m_knots[m_knotOfPoint[point]].count; }

  /** How many edges the bends and the error take alone, up to there. */
  double bendsAt(Index point) const { return m_knots[m_knotOfPoint[point]].bends; }

  /** The length up to where there are so many of them, after a point; 0 if there are none. */
  double lengthAt(Index point, double count) const;

private:
  /** A place on the curve, with what there is of it up to there. */
  struct Knot
  {
    double length;                                          ///< embedded
    double extent;                                          ///< in R^3
    double turn;                                            ///< radians
    double spacing;                                         ///< around it
    double reach = std::numeric_limits<double>::infinity(); ///< of an edge, as bends allow
    double count = 0.0;                                     ///< of spacings
    double bends = 0.0;                                     ///< of reaches
  };

  void layKnots(const Course& course, const std::vector<Point3>& turns);
  void shortenBent(std::vector<Knot>& knots) const;
  void limitToBends(std::vector<Knot>& knots) const;
  void limitToPieces(const Course& course, const std::vector<Index>& marks);
  void grade(std::vector<Knot>& knots) const;
  std::vector<Knot> threeRounds() const;
  void count();
  bool reaches(const Knot& from, const Knot& to) const;
  double reachBetween(const Knot& from, Knot near, Knot far) const;

  DivisionRule m_rule;
  std::vector<Knot> m_knots;
  std::vector<std::size_t> m_knotOfPoint; ///< m + 1
};
}

#endif
