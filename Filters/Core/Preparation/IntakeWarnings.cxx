#include "Preparation/IntakeWarnings.h"

#include "Mesh/FacetGeometry.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <sstream>

namespace remesh
{
namespace
{
/** Repeated triangles are told from one in so many on: a few are no sheet that is there twice. */
constexpr Offset mostRepeated = 100;

/** Of the spacing: the rounding of coordinates that turns triangles round begins some bits later.
 */
constexpr double mostRounding = 1.0 / 64.0;

double largestOf(const std::vector<Point3>& points, int axis)
{
  double largest = 0.0;
  for (const Point3& point : points)
  {
    largest = std::max(largest, std::abs(point[axis]));
  }
  return largest;
}

/**
 * Whether double coordinates come from single precision: all are such numbers, and some need the
 * last bit of the largest. Whole numbers and multiples of a coarser step are no such case.
 */
bool isOfSingles(const std::vector<Point3>& points, int axis, double largest)
{
  const double lastBit = std::ldexp(1.0, std::ilogb(largest) - (FLT_MANT_DIG - 1));
  bool isNeeded = false;
  for (const Point3& point : points)
  {
    if (static_cast<double>(static_cast<float>(point[axis])) != point[axis])
    {
      return false;
    }
    isNeeded = isNeeded || std::fmod(point[axis], 2.0 * lastBit) != 0.0;
  }
  return isNeeded;
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
  bool isSingle = precision > DBL_EPSILON;
  double share = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double largest = largestOf(mesh.points, axis);
    const double single = FLT_EPSILON * largest / spacing;
    const bool wasSingle =
      precision <= DBL_EPSILON && single > mostRounding && isOfSingles(mesh.points, axis, largest);
    isSingle = isSingle || wasSingle;
    share = std::max(share, wasSingle ? single : precision * largest / spacing);
  }
  if (share > mostRounding)
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
  if (mostRepeated * intake.droppedDuplicate >= numberOfFacets)
  {
    warnings.push_back(
      "A part of the surface is there twice: " + std::to_string(intake.droppedDuplicate) +
      " triangles lie on others with the same points, and are left out.");
  }
}
}
