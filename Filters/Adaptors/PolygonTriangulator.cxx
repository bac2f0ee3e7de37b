/**
 * @file PolygonTriangulator.cxx
 *
 * 1. Take the polygon's points without consecutive repetitions: its loop.
 * 2. A loop of up to three points is one triangle as it is, one of none is nothing.
 * 3. Scale larger ones to a size of about 1: what cuts them has tolerances that are lengths.
 * 4. Four points: along one of the diagonals.
 * 5. More: by vtkPolygon or, where that does not find all triangles, by clipEars.
 * 6. What neither can cut, and what cannot be scaled, becomes a fan around its first point.
 *
 * Each way makes n - 2 triangles of a loop of n >= 3 points, and adds no points.
 * Cost: O(n), but about O(n^2) for step 5.
 */
#include "Adaptors/PolygonTriangulator.h"

#include "Adaptors/EarClipping.h"
#include "Adaptors/VTKCompatibility.h"

#include "vtkIdList.h"
#include "vtkPoints.h"
#include "vtkPolygon.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace remesh
{
PolygonTriangulator::PolygonTriangulator(const std::vector<Point3>& points)
  : Points(points)
{
  this->Polygon->Points->SetDataTypeToDouble();
}

PolygonTriangulator::~PolygonTriangulator() = default;

bool PolygonTriangulator::AppendTriangles(
  vtkIdType size, const vtkIdType* ids, Triangles& triangles)
{
  this->TakeLoop(size, ids);
  switch (this->Loop.size())
  {
    case 0:
      return true;
    case 1:
    case 2:
      triangles.push_back({ this->Loop.front(), this->Loop.back(), this->Loop.back() });
      return true;
    case 3:
      this->AppendFan(triangles);
      return true;
    case 4:
      this->AppendQuadrilateral(triangles);
      return true;
    default:
      return this->AppendLargePolygon(triangles);
  }
}

void PolygonTriangulator::TakeLoop(vtkIdType size, const vtkIdType* ids)
{
  this->Loop.assign(ids, ids + size);
  this->Loop.erase(std::unique(this->Loop.begin(), this->Loop.end()), this->Loop.end());
  while (this->Loop.size() > 1 && this->Loop.front() == this->Loop.back())
  {
    this->Loop.pop_back();
  }
}

/**
 * The loop's points multiplied by a power of two, which does not round, so that differences are
 * about 1 in size, and squares of areas stay in range. False for points that are not finite, or all
 * in one place.
 */
bool PolygonTriangulator::ScaleLoop()
{
  const Point3& origin = this->Points[this->Loop[0]];
  double extent = 0.0;
  for (const Offset id : this->Loop)
  {
    const Point3 difference = this->Points[id] - origin;
    if (!difference.allFinite()) // the intake will say so
    {
      return false;
    }
    extent = std::max(extent, difference.cwiseAbs().maxCoeff());
  }
  int exponent = 0;
  std::frexp(extent, &exponent);
  this->Scaled.clear();
  for (const Offset id : this->Loop)
  {
    this->Scaled.emplace_back(
      this->Points[id].unaryExpr([exponent](double x) { return std::ldexp(x, -exponent); }));
  }
  return extent > 0.0;
}

/** Whether the quadrilateral's diagonal from the corner cuts off two triangles that face alike. */
bool PolygonTriangulator::CutsInside(int corner) const
{
  constexpr double noShare = 1e-12; // of the larger triangle: a corner on a straight line
  const std::vector<Point3>& p = this->Scaled;
  const Point3 diagonal = p[(corner + 2) % 4] - p[corner];
  const Point3 first = (p[(corner + 1) % 4] - p[corner]).cross(diagonal);
  const Point3 second = diagonal.cross(p[(corner + 3) % 4] - p[corner]);
  const double larger = std::max(first.squaredNorm(), second.squaredNorm());
  return first.dot(second) > noShare * larger;
}

/** Cuts the four points of the loop into two triangles. */
void PolygonTriangulator::AppendQuadrilateral(Triangles& triangles)
{
  if (!this->ScaleLoop())
  {
    this->AppendFan(triangles);
    return;
  }
  const double first = (this->Scaled[0] - this->Scaled[2]).squaredNorm();
  const double second = (this->Scaled[1] - this->Scaled[3]).squaredNorm();
  const int shorter = first <= second ? 0 : 1;
  const int longer = 1 - shorter;
  const int cut = !this->CutsInside(shorter) && this->CutsInside(longer) ? longer : shorter;
  if (cut == 0)
  {
    this->AppendFan(triangles);
  }
  else
  {
    triangles.push_back({ this->Loop[0], this->Loop[1], this->Loop[3] });
    triangles.push_back({ this->Loop[1], this->Loop[2], this->Loop[3] });
  }
}

/** Cuts a loop of five points or more. */
bool PolygonTriangulator::AppendLargePolygon(Triangles& triangles)
{
  const bool isScaled = this->ScaleLoop();
  if (isScaled && this->TriangulateLoop())
  {
    for (const auto& [a, b, c] : this->Corners)
    {
      triangles.push_back({ this->Loop[a], this->Loop[b], this->Loop[c] });
    }
    return true;
  }
  this->AppendFan(triangles);
  return !isScaled || !this->HasArea();
}

/** The loop's triangles, by its corners, from its scaled points; false where there are none. */
bool PolygonTriangulator::TriangulateLoop()
{
  const auto size = static_cast<vtkIdType>(this->Loop.size());
  this->Polygon->Points->SetNumberOfPoints(size);
  this->Polygon->PointIds->SetNumberOfIds(size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    const Point3 point = this->Scaled[i] - this->Scaled[0];
    this->Polygon->Points->SetPoint(i, point.data());
    this->Polygon->PointIds->SetId(i, i);
  }
  this->PolygonIds->Reset();
  if (triangulate(this->Polygon, this->PolygonIds) == 0 ||
    this->PolygonIds->GetNumberOfIds() != 3 * (size - 2))
  {
    return clipEars(this->Scaled, this->Corners);
  }
  this->Corners.clear();
  for (vtkIdType t = 0; t < size - 2; ++t)
  {
    const vtkIdType* ids = this->PolygonIds->GetPointer(3 * t);
    this->Corners.push_back({ ids[0], ids[1], ids[2] });
  }
  return true;
}

/** Whether a triangle of the fan has an area, by the loop's scaled points. */
bool PolygonTriangulator::HasArea() const
{
  constexpr double noArea = 1e-12; // where differences are about 1: a corner on a straight line
  const std::vector<Point3>& p = this->Scaled;
  for (std::size_t k = 1; k + 1 < p.size(); ++k)
  {
    if ((p[k] - p[0]).cross(p[k + 1] - p[0]).norm() > noArea)
    {
      return true;
    }
  }
  return false;
}

void PolygonTriangulator::AppendFan(Triangles& triangles) const
{
  for (std::size_t k = 1; k + 1 < this->Loop.size(); ++k)
  {
    triangles.push_back({ this->Loop[0], this->Loop[k], this->Loop[k + 1] });
  }
}
}
