#include "Adaptors/ArrayHelpers.h"
#include "Adaptors/CarriedArrays.h"
#include "Mesh/FacetGeometry.h"

#include "vtkPointData.h"

#include <cmath>

namespace remesh
{
namespace
{
/** The surface's normals at the vertices' places, unit vectors; the facet's where they cancel. */
void addNormals(const DiagramSource& source, const Columns& columns)
{
  constexpr double cancelled = 1e-12; // of unit vectors: nothing but rounding error is left
  const auto& locations = source.result.locations;
  columns.addTuples<vtkDoubleArray>("Normals", 3,
    [&](Offset k, double* values)
    {
      const Triple& corners = source.prepared.mesh.facetCorners[locations[k].facet];
      Point3 normal = Point3::Zero();
      for (int c = 0; c < 3; ++c)
      {
        normal += locations[k].b[c] * source.prepared.normals[corners[c]];
      }
      if (!(normal.norm() > cancelled))
      {
        const Triple& points = source.prepared.mesh.facetPoints[locations[k].facet];
        const auto& places = source.prepared.mesh.points;
        normal = facetNormal(places[points[0]], places[points[1]], places[points[2]]);
      }
      Point3::Map(values) = normal.normalized();
    });
}

void addSiteArrays(const DiagramSource& source, const Columns& columns)
{
  const Components& components = source.result.components;
  columns.add<vtkIdTypeArray>("SiteId", [&](Offset k) { return components.sites[k]; });
  columns.add<vtkIdTypeArray>("ComponentId", [&](Offset k) { return components.ranks[k]; });
  columns.add<vtkIntArray>(
    "CellColor", [&](Offset k) { return source.result.cellColors[components.sites[k]]; });
  columns.add<vtkDoubleArray>("CellArea", [&](Offset k) { return components.area[k]; });
  columns.add<vtkDoubleArray>(
    "CellMass", [&](Offset k) { return source.componentMass()[k] * source.massUnit(); });
  columns.add<vtkDoubleArray>(
    "CellEnergy", [&](Offset k) { return source.componentEnergy()[k] * source.energyUnit(); });
  if (source.hasDensity())
  {
    columns.add<vtkDoubleArray>("CellWeightedMass",
      [&](Offset k) { return components.mass[k] * source.massUnit() * source.densityUnit(); });
  }
  columns.addTuples<vtkDoubleArray>("Embedding", source.dimension(),
    [&](Offset k, double* values)
    { source.surface().toCaller(source.result.sites.site(components.sites[k]), values); });
}

/** Whether a surface is the mesh of an earlier run, by the arrays that all of them have. */
bool isRemeshed(vtkPolyData* surface)
{
  const auto has = [data = surface->GetPointData()](const char* name)
  { return data->HasArray(name) != 0; };
  return has("SiteId") && has("ComponentId") && has("CellMass") && has("CellEnergy");
}

void addFacts(const DiagramSource& source, vtkFieldData* data)
{
  const RemeshResult& result = source.result;
  const Columns columns{ data, 1, source.control };
  const auto add = [&columns](const char* name, Offset value)
  { columns.add<vtkIdTypeArray>(name, [value](Offset) { return value; }); };
  add("NumberOfFlippedTriangles", result.placement.repair.flippedTriangles);
  add("NumberOfStrayTriangles", result.placement.strays());
  add("NumberOfNonManifoldEdges", result.topology.mesh.nonManifoldEdges);
  add("EulerCharacteristic", result.topology.mesh.eulerCharacteristic);
  add("TopologyPreserved", result.topology.preserved() ? 1 : 0);
  add("NumberOfExtraPoints", result.extraVertices());
  add("Seed", source.seed);
  if (source.prepared.smoothingRadius)
  {
    columns.add<vtkDoubleArray>(
      "NormalSmoothingRadius", [&](Offset) { return *source.prepared.smoothingRadius; });
  }
  if (const std::optional<TwoSidedDistance>& distance = result.distance)
  {
    columns.add<vtkDoubleArray>("MaximumDistance",
      [&](Offset)
      {
        const double bound = distance->maximumBound();
        return std::isfinite(bound) ? bound : distance->maximum();
      });
    columns.add<vtkDoubleArray>("RMSDistance", [&](Offset) { return distance->rms(); });
  }
}
}

void writeSurface(
  const DiagramSource& source, vtkPolyData* output, std::vector<std::string>& warnings)
{
  const auto& positions = source.result.placement.positions;
  const auto& triangles = source.result.dual.triangles;
  const auto count = static_cast<Offset>(positions.size());
  output->SetPoints(makePoints(
    count, [&](Offset k) -> const Point3& { return positions[k]; }, source.control));
  output->SetPolys(makeCells(static_cast<Offset>(triangles.size()), 3, source.control,
    [&](Offset k, vtkIdType* ids) { std::copy(triangles[k].begin(), triangles[k].end(), ids); }));
  vtkPointData* data = output->GetPointData();
  const Columns columns{ data, count, source.control };
  addSiteArrays(source, columns);
  addNormals(source, columns);
  data->SetActiveNormals("Normals");
  LostArrays lost;
  lost.inputIsMesh = isRemeshed(source.input);
  carryPointArrays(source, output, lost);
  carryCellArrays(source, output, lost);
  addFacts(source, output->GetFieldData());
  carryFieldData(source.input, output, lost);
  if (const std::string warning = lost.describe(); !warning.empty())
  {
    warnings.push_back(warning);
  }
}
}
