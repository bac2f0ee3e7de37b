/**
 * @file EarClipping.cxx
 *
 * 1. Project the loop along the axis closest to its normal, so that it turns to the left.
 * 2. Corner by corner, cut off triangles that no edge of what is left enters, and whose new edge no
 *    corner lies on.
 * 3. Where there is none, one with corners on the new edge, or at last one without area.
 *
 * All triangles turn to the left. Counted where they cover a place, they sum to the winding number
 * of the loop there: for a loop that does not cross itself that is 0 or 1, and nothing overlaps.
 *
 * An edge enters a triangle whose sides are edges, too, only from its end, or across the new edge;
 * then its other end is in the triangle. So it is enough to look at the edges from each corner in
 * the triangle, be it on the border: corners in one place are told apart by where they go.
 */
#include "Adaptors/EarClipping.h"

#include <Eigen/Geometry>

#include <cmath>
#include <utility>

namespace remesh
{
namespace
{
/** Polygons take one or two for each pair of corners; what crosses itself may take more and more.
 */
constexpr Offset looksForEach = 20;

class EarClipper
{
public:
  /** The loop projected; false if it has no area. */
  bool Project(const std::vector<Point3>& loop);
  bool Clip(std::vector<std::array<Offset, 3>>& triangles);

private:
  using Point2 = Eigen::Vector2d;

  /** In the order in which they are taken. */
  enum class Ear
  {
    Clear,    ///< no corner on the new edge
    Touching, ///< others
    Flat,     ///< without area
    None
  };

  int Side(const Point2& a, const Point2& b, const Point2& c) const;
  bool Enters(const std::array<Point2, 3>& triangle, Offset corner, bool& onNewEdge) const;
  Ear Classify(Offset corner);
  void CutOff(Offset corner, std::vector<std::array<Offset, 3>>& triangles);

  std::vector<Point2> Points;
  std::vector<Offset> Previous;
  std::vector<Offset> Next;
  Offset First = 0; ///< of the corners that are left
  Offset Left = 0;  ///< how many these are
  Offset Looks = 0; ///< at a corner, so far
};

bool EarClipper::Project(const std::vector<Point3>& loop)
{
  const auto size = static_cast<Offset>(loop.size());
  Point3 normal = Point3::Zero();
  for (Offset i = 0; i < size; ++i)
  {
    normal += (loop[i] - loop[0]).cross(loop[(i + 1) % size] - loop[0]);
  }
  int axis = 0;
  if (!(normal.cwiseAbs().maxCoeff(&axis) > 0.0))
  {
    return false;
  }
  int x = (axis + 1) % 3, y = (axis + 2) % 3;
  if (normal[axis] < 0.0)
  {
    std::swap(x, y);
  }
  for (Offset i = 0; i < size; ++i)
  {
    this->Points.emplace_back(loop[i][x], loop[i][y]);
    this->Previous.push_back((i + size - 1) % size);
    this->Next.push_back((i + 1) % size);
  }
  this->Left = size;
  return true;
}

/** 1: c is to the left of a -> b; -1: to the right; 0: straight on, but for rounding. */
int EarClipper::Side(const Point2& a, const Point2& b, const Point2& c) const
{
  constexpr double rounding = 1e-15; // times the coordinates, which are about 1
  const Point2 u = b - a;
  const Point2 v = c - a;
  const double area = u[0] * v[1] - u[1] * v[0];
  const double error = rounding * (u.lpNorm<1>() + v.lpNorm<1>());
  return area > error ? 1 : area < -error ? -1 : 0;
}

/** Whether an edge from the corner goes into the triangle; the new edge is its third. */
bool EarClipper::Enters(const std::array<Point2, 3>& triangle, Offset corner, bool& onNewEdge) const
{
  int sides[3];
  for (int k = 0; k < 3; ++k)
  {
    sides[k] = this->Side(triangle[k], triangle[(k + 1) % 3], this->Points[corner]);
    if (sides[k] < 0)
    {
      return false;
    }
  }
  onNewEdge = onNewEdge || (sides[0] > 0 && sides[1] > 0 && sides[2] == 0);
  for (const Offset other : { this->Previous[corner], this->Next[corner] })
  {
    bool enters = true;
    for (int k = 0; k < 3; ++k)
    {
      enters = enters &&
        (sides[k] > 0 || this->Side(triangle[k], triangle[(k + 1) % 3], this->Points[other]) > 0);
    }
    if (enters)
    {
      return true;
    }
  }
  return false;
}

EarClipper::Ear EarClipper::Classify(Offset corner)
{
  const std::array<Point2, 3> triangle = { this->Points[this->Previous[corner]],
    this->Points[corner], this->Points[this->Next[corner]] };
  const int turn = this->Side(triangle[0], triangle[1], triangle[2]);
  if (turn <= 0)
  {
    return turn < 0 ? Ear::None : Ear::Flat;
  }
  bool onNewEdge = false;
  Offset other = corner;
  do
  {
    ++this->Looks;
    if (this->Enters(triangle, other, onNewEdge))
    {
      return Ear::None;
    }
    other = this->Next[other];
  } while (other != corner);
  return onNewEdge ? Ear::Touching : Ear::Clear;
}

void EarClipper::CutOff(Offset corner, std::vector<std::array<Offset, 3>>& triangles)
{
  const Offset before = this->Previous[corner];
  const Offset after = this->Next[corner];
  triangles.push_back({ before, corner, after });
  this->Next[before] = after;
  this->Previous[after] = before;
  this->First = this->Next[after]; // not one fan, if that can be
  --this->Left;
}

bool EarClipper::Clip(std::vector<std::array<Offset, 3>>& triangles)
{
  const Offset most = looksForEach * this->Left * this->Left;
  while (this->Left >= 3)
  {
    Ear best = Ear::None;
    Offset where = this->First;
    Offset corner = this->First;
    do
    {
      const Ear ear = this->Classify(corner);
      if (ear < best)
      {
        best = ear;
        where = corner;
      }
      corner = this->Next[corner];
    } while (corner != this->First && best != Ear::Clear && this->Looks <= most);
    if (best == Ear::None || this->Looks > most)
    {
      return false;
    }
    this->CutOff(where, triangles);
  }
  return true;
}
}

bool clipEars(const std::vector<Point3>& loop, std::vector<std::array<Offset, 3>>& triangles)
{
  triangles.clear();
  EarClipper clipper;
  return loop.size() >= 3 && clipper.Project(loop) && clipper.Clip(triangles);
}
}
