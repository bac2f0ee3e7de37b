#include "Adaptors/ArrayHelpers.h"
#include "Adaptors/DiagramOutput.h"

#include "vtkCellData.h"
#include "vtkPointData.h"

namespace remesh
{
namespace
{
/** Where a point of the diagram lies in R^3. */
Point3 placeOf(const SurfaceMesh& mesh, const DiagramPoint& point)
{
  const Triple& corners = mesh.facetPoints[point.facet];
  return point.b[0] * mesh.points[corners[0]] + point.b[1] * mesh.points[corners[1]] +
    point.b[2] * mesh.points[corners[2]];
}

vtkSmartPointer<vtkPoints> placePoints(const DiagramSource& source, const DiagramPoints& points)
{
  return makePoints(static_cast<Offset>(points.points.size()),
    [&](Offset k) { return placeOf(source.prepared.mesh, points.points[k]); });
}

void addEmbedding(const DiagramSource& source, const DiagramPoints& points, vtkPointData* data)
{
  const CornerCoordinates& coordinates = source.prepared.coordinates;
  const int d = coordinates.dimension;
  const auto count = static_cast<Offset>(points.points.size());
  const auto array = addArray<vtkDoubleArray>(data, "Embedding", count, d);
  for (Offset k = 0; k < count; ++k)
  {
    const DiagramPoint& point = points.points[k];
    const Triple& corners = source.prepared.mesh.facetCorners[point.facet];
    double* tuple = array->GetPointer(k * d);
    for (int c = 0; c < d; ++c)
    {
      tuple[c] = 0.0;
      for (int v = 0; v < 3; ++v)
      {
        tuple[c] += point.b[v] * coordinates.values[static_cast<std::size_t>(corners[v]) * d + c];
      }
    }
  }
}

void addPieceArrays(const DiagramSource& source, vtkCellData* data)
{
  const Diagram& diagram = source.result.diagram;
  const Offset count = diagram.numberOfPieces();
  const auto site = [&](Offset piece) { return diagram.sites[piece]; };
  addColumn<vtkIdTypeArray>(data, "SiteId", count, site);
  addColumn<vtkIdTypeArray>(data, "MergedSiteId", count, site);
  const Components& components = source.result.components;
  addColumn<vtkIdTypeArray>(data, "ComponentId", count,
    [&](Offset piece) { return components.ranks[components.ofPiece[piece]]; });
  addColumn<vtkIdTypeArray>(data, "PatchId", count, [](Offset) { return 0; });
  addColumn<vtkIdTypeArray>(data, "InputCellId", count,
    [&](Offset piece) { return source.prepared.mesh.facetInputCells[diagram.facets[piece]]; });
  const CellSums& sums = source.result.sums;
  addColumn<vtkDoubleArray>(
    data, "CellArea", count, [&](Offset piece) { return sums.area[site(piece)]; });
  addColumn<vtkDoubleArray>(data, "CellMass", count,
    [&](Offset piece) { return sums.mass[site(piece)] * source.massUnit(); });
  addColumn<vtkDoubleArray>(data, "CellEnergy", count,
    [&](Offset piece) { return sums.energy[site(piece)] * source.energyUnit(); });
}
}

void writeVoronoiCells(const DiagramSource& source, const DiagramPoints& points,
  int embeddingDimension, vtkPolyData* output)
{
  const Diagram& diagram = source.result.diagram;
  output->SetPoints(placePoints(source, points));
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(diagram.numberOfPieces() + 1);
  std::copy(diagram.vertexBegin.begin(), diagram.vertexBegin.end(), offsets->GetPointer(0));
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(points.ofVertex.size()));
  std::copy(points.ofVertex.begin(), points.ofVertex.end(), connectivity->GetPointer(0));
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, connectivity);
  output->SetPolys(polygons);
  addPieceArrays(source, output->GetCellData());
  if (source.surface().dimension <= embeddingDimension)
  {
    addEmbedding(source, points, output->GetPointData());
  }
}

void writeEdges(const DiagramSource& source, const DiagramPoints& points, vtkPolyData* output)
{
  enum EdgeType
  {
    CellBorder = 0,
    Boundary = 2,
    NonManifold = 3
  };
  const Diagram& diagram = source.result.diagram;
  const EdgeTable& edges = source.result.edges;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIdTypeArray> types;
  types->SetName("EdgeType");
  vtkNew<vtkIdTypeArray> sites;
  sites->SetName("SiteId");
  sites->SetNumberOfComponents(2);
  std::vector<Offset> outputPoint(points.points.size(), -1);
  std::vector<Offset> used;
  const auto pointOf = [&](Offset vertex)
  {
    Offset& id = outputPoint[points.ofVertex[vertex]];
    if (id < 0)
    {
      id = static_cast<Offset>(used.size());
      used.push_back(points.ofVertex[vertex]);
    }
    return id;
  };
  for (Offset piece = 0; piece < diagram.numberOfPieces(); ++piece)
  {
    const Index facet = diagram.facets[piece];
    const Offset begin = diagram.vertexBegin[piece];
    const Offset end = diagram.vertexBegin[piece + 1];
    for (Offset v = begin; v < end; ++v)
    {
      const Index across = diagram.vertices[v].across;
      Index type = CellBorder;
      if (across < 0)
      {
        const Index edge = edges.facetEdges[facet][-1 - across];
        const bool first = edges.edgeFacets[edges.edgeFacetsBegin[edge]] == facet;
        if (edges.valence(edge) == 2 || !first)
        {
          continue;
        }
        type = edges.valence(edge) == 1 ? Boundary : NonManifold;
      }
      else if (across < diagram.sites[piece])
      {
        continue;
      }
      lines->InsertNextCell({ pointOf(v), pointOf(v + 1 == end ? begin : v + 1) });
      types->InsertNextValue(type);
      sites->InsertNextTuple2(diagram.sites[piece], across < 0 ? -1 : across);
    }
  }
  output->SetPoints(makePoints(static_cast<Offset>(used.size()),
    [&](Offset k) { return placeOf(source.prepared.mesh, points.points[used[k]]); }));
  output->SetLines(lines);
  output->GetCellData()->AddArray(types);
  output->GetCellData()->AddArray(sites);
}
}
