#include "Adaptors/ComparisonData.h"

#include "Adaptors/BlockNames.h"
#include "Adaptors/SurfaceIntake.h"
#include "Mesh/Intake.h"
#include "Mesh/Weld.h"

#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace remesh
{
namespace
{
Status checkPoints(const ComparedSurface& surface, const std::string& name)
{
  Point3 lower = surface.points[surface.triangles.front()[0]];
  Point3 upper = lower;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    for (const Index id : surface.triangles[t])
    {
      const Point3& point = surface.points[id];
      if (!point.allFinite() || point.cwiseAbs().maxCoeff() > largestCoordinate)
      {
        return Status::invalid("Point " + std::to_string(id) + " of the " + name + ", in cell " +
          std::to_string(surface.inputCells[t]) + ", has a coordinate that is " +
          (point.allFinite() ? "too far away." : "not finite."));
      }
      lower = lower.cwiseMin(point);
      upper = upper.cwiseMax(point);
    }
  }
  const double extent = (upper - lower).maxCoeff();
  if (extent > 0.0 && extent < smallestExtent)
  {
    return Status::invalid("The " + name +
      " is too small: its extent is below 1e-50. Scale it up, both surfaces alike.");
  }
  return Status::success();
}

/** Joins blocks, if there are any; nothing is merged within one. */
void joinTriangles(vtkPolyData* input, ComparedSurface& surface)
{
  auto* array = vtkIntArray::SafeDownCast(input->GetPointData()->GetAbstractArray(blockName));
  if (!array)
  {
    return;
  }
  const int* blocks = array->GetPointer(0);
  std::vector<Point3> points = surface.points;
  for (Point3& point : points)
  {
    point = point.allFinite() ? point : Point3::Zero(); // no triangle uses it
  }
  const std::vector<Index> lowest = weldEqualPoints(points);
  surface.joined = surface.triangles;
  for (Triple& triangle : surface.joined)
  {
    for (Index& id : triangle)
    {
      id = blocks[lowest[id]] == blocks[id] ? id : lowest[id];
    }
  }
}
}

Status readComparedSurface(vtkPolyData* input, const std::string& name, ComparedSurface& surface)
{
  TriangleSoup soup;
  Status status = readTriangleSoup(input, soup);
  if (!status.ok())
  {
    status.message = "The " + name + " cannot be read. " + status.message;
    return status;
  }
  if (soup.triangles.empty())
  {
    return Status::invalid("The polygons and strips of the " + name + " have no points.");
  }
  if (static_cast<Offset>(soup.triangles.size()) > maximumInputTriangles ||
    static_cast<Offset>(soup.points.size()) > maximumIndex)
  {
    return Status::invalid("The " + name + " has " + std::to_string(soup.triangles.size()) +
      " triangles and " + std::to_string(soup.points.size()) + " points; at most " +
      std::to_string(maximumInputTriangles) + " and " + std::to_string(maximumIndex) +
      " can be compared.");
  }
  surface.points = std::move(soup.points);
  surface.inputCells = std::move(soup.inputCells);
  surface.triangles.resize(soup.triangles.size());
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      surface.triangles[t][k] = static_cast<Index>(soup.triangles[t][k]);
    }
  }
  status = checkPoints(surface, name);
  if (status.ok())
  {
    joinTriangles(input, surface);
  }
  return status;
}
}
