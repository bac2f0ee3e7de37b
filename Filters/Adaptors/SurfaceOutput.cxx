#include "Adaptors/ArrayHelpers.h"
#include "Adaptors/BlockNames.h"
#include "Adaptors/CarriedArrays.h"
#include "Adaptors/MeshBlocks.h"
#include "Adaptors/SeamPoints.h"
#include "Mesh/FacetGeometry.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"

#include <cmath>
#include <numeric>

namespace remesh
{
namespace
{
/** The surface's normals at the vertices' places, unit vectors; the facet's where they cancel. */
void addNormals(const DiagramSource& source, const std::vector<SurfaceLocation>& locations,
  const Columns& columns)
{
  constexpr double cancelled = 1e-12; // of unit vectors: nothing but rounding error is left
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

/** The vertex of the mesh that a point is, and how many points that vertex has. */
class PointVertices
{
public:
  /** @param vertices of the points; empty: each vertex is a point. */
  PointVertices(const std::vector<Index>& vertices, Index numberOfVertices)
    : Vertices(vertices)
  {
    this->Counts.resize(vertices.empty() ? 0 : static_cast<std::size_t>(numberOfVertices), 0);
    for (const Index vertex : vertices)
    {
      ++this->Counts[vertex];
    }
  }

  Offset operator()(Offset point) const
  {
    return this->Vertices.empty() ? point : Offset(this->Vertices[point]);
  }
  double numberOfPoints(Offset vertex) const
  {
    return this->Counts.empty() ? 1.0 : static_cast<double>(this->Counts[vertex]);
  }

private:
  const std::vector<Index>& Vertices;
  std::vector<Index> Counts;
};

void addSiteArrays(
  const DiagramSource& source, const PointVertices& vertexOf, const Columns& columns)
{
  const Components& components = source.result.components;
  // What a cell has is divided evenly among its points, so that sums stay the whole's.
  const auto add = [&](const char* name, const auto& value)
  {
    columns.add<vtkDoubleArray>(name,
      [&](Offset k)
      {
        const Offset vertex = vertexOf(k);
        return value(vertex) / vertexOf.numberOfPoints(vertex);
      });
  };
  columns.add<vtkIdTypeArray>("SiteId", [&](Offset k) { return components.sites[vertexOf(k)]; });
  columns.add<vtkIdTypeArray>(
    "ComponentId", [&](Offset k) { return components.ranks[vertexOf(k)]; });
  columns.add<vtkIntArray>(
    "CellColor", [&](Offset k) { return source.result.cellColors[components.sites[vertexOf(k)]]; });
  add("CellArea", [&](Offset v) { return components.area[v]; });
  add("CellMass", [&](Offset v) { return source.componentMass()[v] * source.massUnit(); });
  add("CellEnergy", [&](Offset v) { return source.componentEnergy()[v] * source.energyUnit(); });
  if (source.hasDensity())
  {
    add("CellWeightedMass",
      [&](Offset v) { return components.mass[v] * source.massUnit() * source.densityUnit(); });
  }
  columns.addTuples<vtkDoubleArray>("Embedding", source.dimension(),
    [&](Offset k, double* values)
    {
      const Index site = components.sites[vertexOf(k)];
      source.surface().toCaller(source.result.sites.site(site), values);
    });
}

/** What tells the blocks apart, where there are some. */
void addBlocks(const MeshBlocks& blocks, vtkPolyData* output, const RunControl& control)
{
  if (!blocks.pointBlocks.empty())
  {
    const Columns points{ output->GetPointData(), output->GetNumberOfPoints(), control };
    points.add<vtkIntArray>(blockName, [&](Offset k) { return blocks.pointBlocks[k]; });
    const Columns cells{ output->GetCellData(), output->GetNumberOfCells(), control };
    cells.add<vtkIntArray>(blockName, [&](Offset k) { return blocks.triangleBlocks[k]; });
  }
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
  add("NumberOfFlippedTriangles", result.placement.edits.inverted);
  add("NumberOfStrayTriangles", result.placement.strays);
  add("NumberOfSelfIntersections", result.placement.crossings);
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
  if (const std::optional<MetricFit>& fit = source.prepared.metricFit)
  {
    columns.add<vtkDoubleArray>("MetricUnit", [&](Offset) { return fit->unit; });
    columns.add<vtkDoubleArray>("MetricLimit", [&](Offset) { return fit->limit; });
    columns.add<vtkDoubleArray>("MetricShare", [&](Offset) { return fit->within; });
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

/** The points, where they are not just the vertices. */
MeshBlocks findPoints(const DiagramSource& source)
{
  MeshBlocks mesh = source.cellBlocks ? findMeshBlocks(source) : MeshBlocks();
  if (source.prepared.charts.empty())
  {
    return mesh;
  }
  if (!source.cellBlocks)
  {
    mesh.triangles = source.result.dual.triangles;
    mesh.locations = source.result.locations;
    mesh.vertices.resize(mesh.locations.size());
    std::iota(mesh.vertices.begin(), mesh.vertices.end(), 0);
  }
  splitAlongSeams(source, mesh);
  return mesh;
}
}

void writeSurface(
  const DiagramSource& source, vtkPolyData* output, std::vector<std::string>& warnings)
{
  const auto& positions = source.result.placement.positions;
  const MeshBlocks blocks = findPoints(source);
  const bool isSplit = !blocks.vertices.empty();
  const auto& triangles = isSplit ? blocks.triangles : source.result.dual.triangles;
  const auto& locations = isSplit ? blocks.locations : source.result.locations;
  const PointVertices vertexOf(blocks.vertices, source.result.components.count());
  const auto count = static_cast<Offset>(locations.size());
  output->SetPoints(makePoints(
    count, [&](Offset k) -> const Point3& { return positions[vertexOf(k)]; }, source.control));
  output->SetPolys(makeCells(static_cast<Offset>(triangles.size()), 3, source.control,
    [&](Offset k, vtkIdType* ids) { std::copy(triangles[k].begin(), triangles[k].end(), ids); }));
  vtkPointData* data = output->GetPointData();
  const Columns columns{ data, count, source.control };
  addSiteArrays(source, vertexOf, columns);
  addNormals(source, locations, columns);
  data->SetActiveNormals("Normals");
  LostArrays lost;
  lost.inputIsMesh = isRemeshed(source.input);
  carryPointArrays(source, locations, output, lost);
  carryCellArrays(source, blocks.triangleBlocks, output, lost);
  addBlocks(blocks, output, source.control);
  addFacts(source, output->GetFieldData());
  carryFieldData(source.input, output, lost);
  if (const std::string warning = lost.describe(); !warning.empty())
  {
    warnings.push_back(warning);
  }
}
}
