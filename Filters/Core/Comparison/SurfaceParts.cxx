#include "Comparison/SurfaceParts.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
constexpr double overlap = 0.01; // of the accuracy
constexpr double maxSize = 4.0;  // of a part that is cut along a triangle, squared
constexpr double minCosine = 0.8;
constexpr double thin = 0.25;      // height over the longest edge
constexpr double muchLonger = 8.0; // than the triangle that is close: worth slices
constexpr Offset minPieces = 16;   // likewise

double squaredLength(const std::array<Point3, 3>& corners, int edge)
{
  return (corners[(edge + 1) % 3] - corners[edge]).squaredNorm();
}

/** The first of a triangle's longest edges; edge k begins at corner k. */
int longestEdge(const std::array<Point3, 3>& corners)
{
  int longest = 0;
  for (int k = 1; k < 3; ++k)
  {
    longest = squaredLength(corners, k) > squaredLength(corners, longest) ? k : longest;
  }
  return longest;
}

/** The square of a triangle's longest edge. */
double squaredSize(const std::array<Point3, 3>& corners)
{
  return squaredLength(corners, longestEdge(corners));
}

/** Cuts a triangle across, from its tip to its base, into slices of that height or less. */
void slice(
  const std::array<Point3, 3>& triangle, double height, Index hint, std::vector<SurfacePart>& parts)
{
  const auto& [tip, left, right] = triangle;
  const double length = std::max((left - tip).norm(), (right - tip).norm());
  const double slices = std::max(std::ceil(length / height), 1.0);
  Point3 lastLeft = tip;
  Point3 lastRight = tip;
  for (double k = 1.0; k <= slices; ++k)
  {
    const Point3 nextLeft = tip + k / slices * (left - tip);
    const Point3 nextRight = tip + k / slices * (right - tip);
    parts.push_back({ { lastLeft, nextLeft, nextRight }, hint });
    if (k > 1.0)
    {
      parts.push_back({ { lastLeft, nextRight, lastRight }, hint });
    }
    lastLeft = nextLeft;
    lastRight = nextRight;
  }
}

void cutIntoFour(Index hint, const SurfacePart& part, std::vector<SurfacePart>& parts)
{
  const auto& [a, b, c] = part.corners;
  const Point3 ab = 0.5 * (a + b);
  const Point3 bc = 0.5 * (b + c);
  const Point3 ca = 0.5 * (c + a);
  parts.push_back({ { a, ab, ca }, hint });
  parts.push_back({ { ab, b, bc }, hint });
  parts.push_back({ { ca, bc, c }, hint });
  parts.push_back({ { bc, ca, ab }, hint });
}

void pushFan(
  const std::vector<Point3>& polygon, Index hint, bool isInside, std::vector<SurfacePart>& parts)
{
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
  {
    parts.push_back({ { polygon[0], polygon[k], polygon[k + 1] }, hint, isInside });
  }
}
}

Point3 SurfacePart::centroid() const
{
  return (this->corners[0] + this->corners[1] + this->corners[2]) / 3.0;
}

double SurfacePart::reach() const
{
  const Point3 middle = this->centroid();
  double squared = 0.0;
  for (const Point3& corner : this->corners)
  {
    squared = std::max(squared, (corner - middle).squaredNorm());
  }
  return std::sqrt(squared);
}

PartCutter::PartCutter(const TriangleTree& to, double accuracy)
  : m_to(to)
  , m_overlap(overlap * accuracy)
{
}

bool PartCutter::cutAlong(Index slot, const SurfacePart& part, std::vector<SurfacePart>& parts)
{
  const std::array<Point3, 3> t = m_to.cornersOf(slot);
  const Point3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const auto& [a, b, c] = part.corners;
  const Point3 own = (b - a).cross(c - a);
  if (squaredSize(part.corners) > maxSize * squaredSize(t) ||
    std::abs(own.dot(normal)) < minCosine * own.norm() * normal.norm())
  {
    return false;
  }
  double lowest = -m_overlap;
  Point3 origin = t[0];
  Point3 inwards = Point3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    const Point3 side = normal.cross(t[(k + 1) % 3] - t[k]).normalized();
    for (const Point3& corner : part.corners)
    {
      if (const double height = (corner - t[k]).dot(side); height < 2.0 * lowest)
      {
        lowest = 0.5 * height;
        origin = t[k];
        inwards = side;
      }
    }
  }
  return inwards.squaredNorm() > 0.0 && this->cutByPlane(slot, part, origin, inwards, parts);
}

/**
 * Cuts a part by a plane, moved outwards by the overlap. Corners a tenth of that beyond are inside
 * still, as those that earlier cuts made are. False if nothing is truly inside.
 */
bool PartCutter::cutByPlane(Index slot, const SurfacePart& part, const Point3& origin,
  const Point3& inwards, std::vector<SurfacePart>& parts)
{
  std::array<double, 3> heights{};
  for (int k = 0; k < 3; ++k)
  {
    heights[k] = (part.corners[k] - origin).dot(inwards);
  }
  if (!(*std::max_element(heights.begin(), heights.end()) > 0.0))
  {
    return false;
  }
  const auto isInside = [&](int k) { return heights[k] >= -1.1 * m_overlap; };
  m_inner.clear();
  m_outer.clear();
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    (isInside(k) ? m_inner : m_outer).push_back(part.corners[k]);
    if (isInside(k) != isInside(next))
    {
      const double along = (heights[k] + m_overlap) / (heights[k] - heights[next]);
      const Point3 crossing =
        part.corners[k] + std::clamp(along, 0.0, 1.0) * (part.corners[next] - part.corners[k]);
      m_inner.push_back(crossing);
      m_outer.push_back(crossing);
    }
  }
  pushFan(m_inner, slot, true, parts);
  pushFan(m_outer, slot, false, parts);
  return true;
}

bool PartCutter::cutAcross(
  Index slot, const SurfacePart& part, Offset maxPieces, std::vector<SurfacePart>& parts)
{
  const double size = std::sqrt(squaredSize(m_to.cornersOf(slot)));
  const int longest = longestEdge(part.corners);
  const Point3& a = part.corners[longest];
  const Point3& b = part.corners[(longest + 1) % 3];
  const Point3& c = part.corners[(longest + 2) % 3];
  const Point3 along = b - a;
  const double squared = along.squaredNorm();
  if (maxPieces < minPieces || !(along.cross(c - a).norm() < thin * squared) ||
    !(std::sqrt(squared) > muchLonger * size))
  {
    return false;
  }
  const Point3 foot = a + std::clamp(along.dot(c - a) / squared, 0.0, 1.0) * along;
  // A slice is two pieces but for that at a tip, and there are two tips; both sides are less than
  // 5/4 of the longest edge.
  const double height = std::max(size, 2.6 * std::sqrt(squared) / (maxPieces - 2));
  slice({ a, foot, c }, height, slot, parts);
  slice({ b, c, foot }, height, slot, parts);
  return true;
}

void PartCutter::cut(Index slot, const SurfacePart& part, std::vector<SurfacePart>& parts)
{
  if (!this->cutAlong(slot, part, parts))
  {
    cutIntoFour(slot, part, parts);
  }
}
}
