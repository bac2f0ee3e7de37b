#include "Adaptors/FieldSurface.h"

#include "Adaptors/ArrayHelpers.h"
#include "Adaptors/SurfaceIntake.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
Status takeFieldSurface(FieldSurface& surface)
{
  TriangleSoup soup;
  std::string warning;
  Status status = readTriangleSoup(surface.input, soup, &warning);
  if (status.ok())
  {
    status = buildSurfaceMesh(
      soup, IntakeOptions(), surface.control.silent(), surface.mesh, surface.intake);
  }
  if (!status.ok())
  {
    return status;
  }
  if (!warning.empty())
  {
    surface.warnings.push_back(warning);
  }
  const Offset points = surface.input->GetNumberOfPoints();
  surface.meshPoints.assign(static_cast<std::size_t>(points), noIndex);
  surface.inputPoints.assign(surface.mesh.points.size(), points);
  for (Index facet = 0; facet < surface.mesh.numberOfFacets(); ++facet)
  {
    const auto inputs = surface.mesh.facetInputPoints[facet];
    for (int k = 0; k < 3; ++k)
    {
      const Index point = surface.mesh.facetPoints[facet][k];
      surface.meshPoints[inputs[k]] = point;
      surface.inputPoints[point] = std::min(surface.inputPoints[point], inputs[k]);
    }
  }
  surface.output->ShallowCopy(surface.input);
  vtkNew<vtkFieldData> own; // the copy shares the input's, to which facts are added
  own->ShallowCopy(surface.input->GetFieldData());
  surface.output->SetFieldData(own);
  return Status::success();
}

Status findNamedArray(
  const FieldSurface& surface, const std::string& name, const char* role, vtkDataArray*& array)
{
  array = surface.input->GetPointData()->GetArray(name.c_str());
  if (!array)
  {
    return Status::invalid(
      "The input has no numeric point array \"" + name + "\", chosen as " + role + ".");
  }
  const Offset points = surface.input->GetNumberOfPoints();
  return array->GetNumberOfTuples() == points
    ? Status::success()
    : Status::invalid("The point array \"" + name + "\" has " +
        std::to_string(array->GetNumberOfTuples()) + " tuples for " + std::to_string(points) +
        " points.");
}

Status readValues(const FieldSurface& surface, vtkDataArray* array,
  const std::function<void(Index, int, double)>& write)
{
  Offset first = surface.input->GetNumberOfPoints();
  for (Index point = 0; point < surface.mesh.numberOfPoints(); ++point)
  {
    const Offset input = surface.inputPoints[point];
    for (int component = 0; component < array->GetNumberOfComponents(); ++component)
    {
      const double value = array->GetComponent(input, component);
      first = std::isfinite(value) ? first : std::min(first, input);
      write(point, component, value);
    }
  }
  return first == surface.input->GetNumberOfPoints()
    ? Status::success()
    : Status::invalid(std::string("The point array \"") + array->GetName() +
        "\" has a value that is not a finite number at point " + std::to_string(first) + ".");
}

void addPointField(const FieldSurface& surface, const char* name, int components,
  const std::function<void(Index, double*)>& fill)
{
  const Columns columns{ surface.output->GetPointData(), surface.output->GetNumberOfPoints(),
    surface.control.silent() };
  columns.addTuples<vtkDoubleArray>(
    name, components, [&](Offset point, double* tuple) { fill(surface.meshPoints[point], tuple); });
}

void addFact(const FieldSurface& surface, const char* name, double value)
{
  const Columns columns{ surface.output->GetFieldData(), 1, surface.control.silent() };
  columns.add<vtkDoubleArray>(name, [&](Offset) { return value; });
}
}
