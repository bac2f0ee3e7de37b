#include "Preparation/IntakeWarnings.h"

#include "Mesh/FacetGeometry.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <sstream>

namespace remesh
{
namespace
{
/** Repeated triangles are told from one in so many on: a few are no sheet that is there twice. */
constexpr Offset maxRepeated = 100;

/** Of the spacing: the rounding of coordinates that turns triangles round begins some bits later.
 */
constexpr double maxRounding = 1.0 / 64.0;

double largestOf(const std::vector<Point3>& points, int axis)
{
  double largest = 0.0;
  for (const Point3& point : points)
  {
    largest = std::max(largest, std::abs(point[axis]));
  }
  return largest;
}

/** Whether all are such numbers, as they are of doubles that were in single precision before. */
bool areSingles(const std::vector<Point3>& points)
{
  return std::all_of(points.begin(), points.end(),
    [](const Point3& point) { return point.cast<float>().cast<double>() == point; });
}

/** Whether some need the last bit of the largest: whole numbers and coarser steps are as meant. */
bool needLastBit(const std::vector<Point3>& points, int axis, double largest)
{
  const double lastBit = std::ldexp(1.0, std::ilogb(largest) - (FLT_MANT_DIG - 1));
  return std::any_of(points.begin(), points.end(),
    [&](const Point3& point) { return std::fmod(point[axis], 2.0 * lastBit) != 0.0; });
}

std::string shortNumber(double number)
{
  std::ostringstream text;
  text.precision(2);
  text << number;
  return text.str();
}
}

void tellRounding(double precision, const SurfaceMesh& mesh, std::vector<std::string>& warnings)
{
  double area = 0.0;
  for (const Triple& facet : mesh.facetPoints)
  {
    const auto& points = mesh.points;
    area += facetArea(points[facet[0]], points[facet[1]], points[facet[2]]);
  }
  const double spacing = std::sqrt(area / static_cast<double>(mesh.numberOfPoints()));
  const std::array<double, 3> largest = { largestOf(mesh.points, 0), largestOf(mesh.points, 1),
    largestOf(mesh.points, 2) };
  const double farthest = *std::max_element(largest.begin(), largest.end());
  double share = precision * farthest / spacing;
  bool isSingle = precision > DBL_EPSILON;
  if (!isSingle && FLT_EPSILON * farthest / spacing > maxRounding && areSingles(mesh.points))
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double single = FLT_EPSILON * largest[axis] / spacing;
      if (single > maxRounding && needLastBit(mesh.points, axis, largest[axis]))
      {
        isSingle = true;
        share = std::max(share, single);
      }
    }
  }
  if (share > maxRounding)
  {
    warnings.push_back("The coordinates are rounded to " + shortNumber(share) +
      " of the spacing of their points. Subtract an offset from them" +
      (isSingle ? ", or read them in double precision." : "."));
  }
}

void tellIntake(
  const IntakeReport& intake, Offset numberOfFacets, std::vector<std::string>& warnings)
{
  if (!intake.orientable)
  {
    warnings.push_back("The surface is not orientable: the mesh cannot be oriented consistently.");
  }
  if (intake.gaps.points > 0)
  {
    warnings.push_back("Points on the border nearly coincide with others there: " +
      std::to_string(intake.gaps.points) + ". A MergeTolerance of " +
      shortNumber(intake.gaps.width) + " makes them one and closes the slits between them.");
  }
  if (maxRepeated * intake.droppedDuplicate >= numberOfFacets)
  {
    warnings.push_back(
      "A part of the surface is there twice: " + std::to_string(intake.droppedDuplicate) +
      " triangles lie on others with the same points, and are left out.");
  }
}
}
