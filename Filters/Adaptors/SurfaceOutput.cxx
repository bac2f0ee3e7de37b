#include "Adaptors/ArrayHelpers.h"
#include "Adaptors/DiagramOutput.h"

#include "vtkIdList.h"
#include "vtkPointData.h"

#include <cstring>

namespace remesh
{
namespace
{
/** The input's point arrays but ghost marks and those that do not fit its points. */
vtkSmartPointer<vtkPointData> soundArrays(vtkPolyData* input)
{
  auto sound = vtkSmartPointer<vtkPointData>::New();
  sound->ShallowCopy(input->GetPointData());
  for (int k = sound->GetNumberOfArrays() - 1; k >= 0; --k)
  {
    vtkAbstractArray* array = sound->GetAbstractArray(k);
    const bool isGhost = array->GetName() &&
      std::strcmp(array->GetName(), vtkDataSetAttributes::GhostArrayName()) == 0;
    if (isGhost || array->GetNumberOfTuples() != input->GetNumberOfPoints())
    {
      sound->RemoveArray(k);
    }
  }
  return sound;
}

/** The input's point arrays, interpolated where each vertex lies on the input. */
void interpolateArrays(const DiagramSource& source, vtkPointData* data)
{
  const vtkSmartPointer<vtkPointData> input = soundArrays(source.input);
  const auto& locations = source.result.locations;
  const auto count = static_cast<vtkIdType>(locations.size());
  data->InterpolateAllocate(input, count);
  vtkNew<vtkIdList> points;
  points->SetNumberOfIds(3);
  for (vtkIdType k = 0; k < count; ++k)
  {
    const auto& inputPoints = source.prepared.mesh.facetInputPoints[locations[k].facet];
    double weights[3];
    for (int c = 0; c < 3; ++c)
    {
      points->SetId(c, inputPoints[c]);
      weights[c] = locations[k].b[c];
    }
    data->InterpolatePoint(input, k, points, weights);
  }
}

/** The surface's normals, interpolated there and normalised. */
void addNormals(const DiagramSource& source, vtkPointData* data)
{
  const auto& locations = source.result.locations;
  const auto array =
    addArray<vtkDoubleArray>(data, "Normals", static_cast<Offset>(locations.size()), 3);
  for (std::size_t k = 0; k < locations.size(); ++k)
  {
    const Triple& corners = source.prepared.mesh.facetCorners[locations[k].facet];
    Point3 normal = Point3::Zero();
    for (int c = 0; c < 3; ++c)
    {
      normal += locations[k].b[c] * source.prepared.normals[corners[c]];
    }
    normal.stableNormalize();
    array->SetTuple(static_cast<vtkIdType>(k), normal.data());
  }
  data->SetActiveNormals("Normals");
}

void addSiteArrays(const DiagramSource& source, vtkPointData* data)
{
  const Components& components = source.result.components;
  const Offset count = components.count();
  addColumn<vtkIdTypeArray>(data, "SiteId", count, [&](Offset k) { return components.sites[k]; });
  addColumn<vtkIdTypeArray>(
    data, "ComponentId", count, [&](Offset k) { return components.ranks[k]; });
  addColumn<vtkDoubleArray>(data, "CellArea", count, [&](Offset k) { return components.area[k]; });
  addColumn<vtkDoubleArray>(
    data, "CellMass", count, [&](Offset k) { return components.mass[k] * source.massUnit(); });
  addColumn<vtkDoubleArray>(data, "CellEnergy", count,
    [&](Offset k) { return components.energy[k] * source.energyUnit(); });
  const int d = source.surface().dimension;
  const auto embedding = addArray<vtkDoubleArray>(data, "Embedding", count, d);
  for (Offset k = 0; k < count; ++k)
  {
    const double* x = source.result.sites.site(components.sites[k]);
    for (int c = 0; c < d; ++c)
    {
      embedding->SetTypedComponent(k, c, source.surface().toCaller(x[c], c));
    }
  }
}

void addFacts(const DiagramSource& source, vtkFieldData* data)
{
  const RemeshResult& result = source.result;
  const auto cells = static_cast<Offset>(result.sites.count() - result.emptyCells);
  const auto add = [data](const char* name, Offset value)
  { addColumn<vtkIdTypeArray>(data, name, 1, [value](Offset) { return value; }); };
  add("NumberOfNonManifoldEdges", result.dual.numberOfNonManifoldEdges);
  add("EulerCharacteristic", result.dual.eulerCharacteristic);
  add("NumberOfExtraPoints", result.components.count() - cells);
  add("Seed", source.seed);
}
}

void writeSurface(const DiagramSource& source, vtkPolyData* output)
{
  const auto& centroids = source.result.components.centroids;
  output->SetPoints(makePoints(static_cast<Offset>(centroids.size()),
    [&](Offset k) -> const Point3& { return centroids[k]; }));
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(static_cast<vtkIdType>(source.result.dual.triangles.size()),
    3 * static_cast<vtkIdType>(source.result.dual.triangles.size()));
  for (const Triple& triangle : source.result.dual.triangles)
  {
    triangles->InsertNextCell({ triangle[0], triangle[1], triangle[2] });
  }
  output->SetPolys(triangles);
  interpolateArrays(source, output->GetPointData());
  addSiteArrays(source, output->GetPointData());
  addNormals(source, output->GetPointData());
  output->GetFieldData()->PassData(source.input->GetFieldData());
  addFacts(source, output->GetFieldData());
}
}
