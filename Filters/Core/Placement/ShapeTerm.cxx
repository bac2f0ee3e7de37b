#include "Placement/ShapeTerm.h"

#include <cmath>

namespace remesh
{
namespace
{
constexpr double roundedEdge = 1e-4; ///< of the energy's edge at phi = 1: half a degree
const double equilateral = 4.0 * std::sqrt(3.0);
}

bool findShapeTerm(const Corners& corners, const Symmetric3<double>& metric, ShapeTerm& term)
{
  constexpr double flat = 1e-14; // squared sine of an angle
  term = { Symmetric3<double>::Zero(), { Point3::Zero(), Point3::Zero(), Point3::Zero() } };
  const Point3 u = corners[1] - corners[0];
  const Point3 v = corners[2] - corners[0];
  const double uu = u.squaredNorm();
  const double uv = u.dot(v);
  const double vv = v.squaredNorm();
  const double square = uu * vv - uv * uv; // of twice the area
  const Point3 metricV = multiply(metric, v);
  const double guu = u.dot(multiply(metric, u));
  const double guv = u.dot(metricV);
  const double gvv = v.dot(metricV);
  const double metricSquare = guu * gvv - guv * guv;
  if (!(square > flat * uu * vv) || !(metricSquare > flat * guu * gvv))
  {
    return false;
  }
  // The metric in the plane, by vectors whose products with u and v are 0 and 1, and scaled so that
  // areas are those of R^3.
  const double unit = std::sqrt(square / metricSquare);
  const Point3 first = (vv * u - uv * v) / square;
  const Point3 second = (uu * v - uv * u) / square;
  const Symmetric3<double> plane = unit *
    (guu * symmetricProduct(first, first) + gvv * symmetricProduct(second, second) +
      2.0 * guv * symmetricProduct(first, second));
  const double area = 0.5 * std::sqrt(square);
  const double phi = unit * 2.0 * (guu + gvv - guv) / (equilateral * area);
  const double slope = 0.75 / std::sqrt(std::sqrt(std::max(phi - 1.0, 0.0) + roundedEdge));
  term.block = 2.0 * slope / (equilateral * area) * plane;
  // A corner that moves by x changes the area by this . x: `first` and `second` point from the
  // opposite edges to the corners, and are as long as one over the heights.
  const Point3 ofAreas[3] = { -area * (first + second), area * first, area * second };
  const Point3 ways[3] = { -u - v, 2.0 * u - v, 2.0 * v - u };
  for (int k = 0; k < 3; ++k)
  {
    term.slopes[k] =
      slope / area * (phi * ofAreas[k] - 2.0 / equilateral * multiply(plane, ways[k]));
  }
  return true;
}
}
