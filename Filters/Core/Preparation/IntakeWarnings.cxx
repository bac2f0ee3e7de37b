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
  double largest = 0.0;
  double area = 0.0;
  for (const Point3& point : mesh.points)
  {
    largest = std::max(largest, point.cwiseAbs().maxCoeff());
  }
  for (const Triple& facet : mesh.facetPoints)
  {
    const auto& points = mesh.points;
    area += facetArea(points[facet[0]], points[facet[1]], points[facet[2]]);
  }
  const double spacing = std::sqrt(area / static_cast<double>(mesh.numberOfPoints()));
  const double share = precision * largest / spacing;
  if (share > mostRounding)
  {
    warnings.push_back("The coordinates are rounded to " + shortNumber(share) +
      " of the spacing of their points. Subtract an offset from them" +
      (precision > DBL_EPSILON ? ", or read them in double precision." : "."));
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
