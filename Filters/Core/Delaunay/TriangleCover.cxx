#include "Delaunay/TriangleCover.h"

#include "Mesh/FacetGeometry.h"

#include <Eigen/Geometry>

#include <array>

namespace remesh
{
namespace
{
using Point2 = Eigen::Vector2d;

/** Coordinates in which a triangle is { u, v >= 0, u + v <= 1 }, along its normal. */
struct TriangleFrame
{
  Point3 origin;
  Point3 u;
  Point3 v;

  explicit TriangleFrame(const std::array<Point3, 3>& corners)
    : origin(corners[0])
  {
    const Point3 first = corners[1] - corners[0];
    const Point3 second = corners[2] - corners[0];
    const Point3 normal = first.cross(second);
    const double squared = normal.squaredNorm();
    this->u = second.cross(normal) / squared;
    this->v = normal.cross(first) / squared;
  }

  bool isUsable() const { return this->u.allFinite() && this->v.allFinite(); }
  Point2 operator()(const Point3& point) const
  {
    const Point3 offset = point - this->origin;
    return { this->u.dot(offset), this->v.dot(offset) };
  }
};

/** How far inside a side of the triangle a point is. */
double inside(int side, const Point2& point)
{
  return side < 2 ? point[side] : 1.0 - point[0] - point[1];
}

/** Cuts off what is beyond a side of the triangle (Sutherland and Hodgman). */
void cut(int side, std::vector<Point2>& polygon, std::vector<Point2>& scratch)
{
  scratch.clear();
  for (std::size_t k = 0; k < polygon.size(); ++k)
  {
    const Point2& from = polygon[k];
    const Point2& to = polygon[k + 1 < polygon.size() ? k + 1 : 0];
    const double first = inside(side, from);
    const double second = inside(side, to);
    if (first >= 0.0)
    {
      scratch.push_back(from);
    }
    if ((first < 0.0) != (second < 0.0))
    {
      scratch.emplace_back(from + first / (first - second) * (to - from));
    }
  }
  polygon.swap(scratch);
}

double signedArea(const std::vector<Point2>& polygon)
{
  double twice = 0.0;
  for (std::size_t k = 2; k < polygon.size(); ++k)
  {
    const Point2 first = polygon[k - 1] - polygon[0];
    const Point2 second = polygon[k] - polygon[0];
    twice += first[0] * second[1] - first[1] * second[0];
  }
  return 0.5 * twice;
}

/** Area of the part of a polygon within the triangle, in the triangle's own coordinates. */
double areaWithin(std::vector<Point2>& polygon, std::vector<Point2>& scratch)
{
  for (int side = 0; side < 3; ++side)
  {
    std::size_t beyond = 0;
    for (const Point2& point : polygon)
    {
      beyond += inside(side, point) < 0.0 ? 1 : 0;
    }
    if (beyond == polygon.size())
    {
      return 0.0;
    }
    if (beyond > 0)
    {
      cut(side, polygon, scratch);
    }
  }
  return std::max(0.0, signedArea(polygon));
}

/** The vertices of a piece in the triangle's coordinates. */
void project(
  const TriangleCover& cover, const TriangleFrame& frame, Index piece, std::vector<Point2>& polygon)
{
  const Diagram& diagram = cover.places.diagram;
  const Index facet = diagram.facets[piece];
  std::array<Point2, 3> corners;
  for (int k = 0; k < 3; ++k)
  {
    corners[k] = frame(cover.mesh.points[cover.mesh.facetPoints[facet][k]]);
  }
  polygon.clear();
  if (diagram.facetBegin[facet + 1] - diagram.facetBegin[facet] == 1)
  {
    polygon.assign(corners.begin(), corners.end()); // the whole facet: most are
    return;
  }
  for (Offset v = diagram.vertexBegin[piece]; v < diagram.vertexBegin[piece + 1]; ++v)
  {
    const auto b = cover.places.at(piece, v);
    polygon.emplace_back(b[0] * corners[0] + b[1] * corners[1] + b[2] * corners[2]);
  }
}
}

void TriangleCover::measure(
  const Triple& triangle, const std::array<Point3, 3>& corners, std::vector<CoverPart>& parts) const
{
  parts.clear();
  const Diagram& diagram = this->places.diagram;
  const TriangleFrame frame(corners);
  double total = 0.0;
  if (frame.isUsable())
  {
    std::vector<Point2> polygon;
    std::vector<Point2> scratch;
    this->forEachPiece(triangle,
      [&](Index piece)
      {
        project(*this, frame, piece, polygon);
        if (const double area = areaWithin(polygon, scratch); area > 0.0)
        {
          parts.push_back({ diagram.facets[piece], area });
          total += area;
        }
      });
  }
  if (!(total > 0.0) || !std::isfinite(total))
  {
    parts.clear();
    this->forEachPiece(triangle,
      [&](Index piece)
      {
        const Index facet = diagram.facets[piece];
        const double share = std::max(0.0, diagram.weights[piece].fraction());
        parts.push_back({ facet, share * facetArea(this->mesh, facet) });
      });
  }
}
}
