#include "Adaptors/ArrayHelpers.h"
#include "Adaptors/BlockNames.h"
#include "Adaptors/DiagramOutput.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"
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

void addEmbedding(const DiagramSource& source, const DiagramPoints& points, vtkPointData* data)
{
  const CornerCoordinates& coordinates = source.prepared.coordinates;
  const int d = coordinates.dimension;
  const Columns columns{ data, static_cast<Offset>(points.points.size()), source.control };
  columns.addTuples<vtkDoubleArray>("Embedding", d,
    [&](Offset k, double* values)
    {
      const DiagramPoint& point = points.points[k];
      const Triple& corners = source.prepared.mesh.facetCorners[point.facet];
      std::fill_n(values, d, 0.0);
      std::vector<double> scratch;
      for (int v = 0; v < 3; ++v)
      {
        const double* row = coordinates.row(corners[v], scratch);
        for (int c = 0; c < d; ++c)
        {
          values[c] += point.b[v] * row[c];
        }
      }
    });
}

/**
 * The pieces that become polygons. Where cells tie, the symbolic perturbation leaves pieces that
 * lie in one point or on a line: right in the diagram, but no polygons.
 */
class DrawnPieces
{
public:
  explicit DrawnPieces(const DiagramSource& source)
    : m_diagram(source.result.diagram)
  {
    const VertexPlaces places{ source.surface(), source.result.sites, m_diagram };
    const auto isDrawn = [&](Offset piece)
    {
      constexpr double clearlyWide = 1e-10; // share of the facet
      return m_diagram.weights[piece].fraction() > clearlyWide || this->hasWidth(places, piece);
    };
    static_cast<void>(packItems(
      m_diagram.numberOfPieces(), source.control, isDrawn,
      [&](Offset count) { m_pieces.resize(static_cast<std::size_t>(count)); },
      [&](Offset piece, Offset number) { m_pieces[number] = piece; }));
    if (this->count() == m_diagram.numberOfPieces())
    {
      m_pieces = std::vector<Offset>(); // all, as nearly always
      m_all = true;
    }
  }

  Offset count() const
  {
    return m_all ? m_diagram.numberOfPieces() : static_cast<Offset>(m_pieces.size());
  }
  Offset operator[](Offset polygon) const { return m_all ? polygon : m_pieces[polygon]; }

private:
  /** Whether the piece is wider than the rounding of its vertices, in barycentric coordinates. */
  bool hasWidth(const VertexPlaces& places, Offset piece) const
  {
    constexpr double rounding = 1e-13; // some times that of placeInside
    PiecePlaces vertices(places, piece);
    const Offset first = m_diagram.vertexBegin[piece];
    const std::array<double, 3> start = vertices.at(first);
    double length = 0.0;
    for (Offset v = first + 1; v < m_diagram.vertexBegin[piece + 1]; ++v)
    {
      const std::array<double, 3> b = vertices.at(v);
      length = std::max(length, std::hypot(b[1] - start[1], b[2] - start[2]));
    }
    return m_diagram.weights[piece].fraction() > rounding * length;
  }

  const Diagram& m_diagram;
  std::vector<Offset> m_pieces;
  bool m_all = false;
};

vtkSmartPointer<vtkCellArray> makePolygons(
  const Diagram& diagram, const DiagramPoints& points, const DrawnPieces& drawn)
{
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(drawn.count() + 1);
  vtkIdType* begins = offsets->GetPointer(0);
  begins[0] = 0;
  for (Offset polygon = 0; polygon < drawn.count(); ++polygon)
  {
    const Offset piece = drawn[polygon];
    begins[polygon + 1] =
      begins[polygon] + diagram.vertexBegin[piece + 1] - diagram.vertexBegin[piece];
  }
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(begins[drawn.count()]);
  vtkIdType* id = connectivity->GetPointer(0);
  for (Offset polygon = 0; polygon < drawn.count(); ++polygon)
  {
    const Offset piece = drawn[polygon];
    id = std::copy(points.ofVertex.begin() + diagram.vertexBegin[piece],
      points.ofVertex.begin() + diagram.vertexBegin[piece + 1], id);
  }
  auto polygons = vtkSmartPointer<vtkCellArray>::New();
  polygons->SetData(offsets, connectivity);
  return polygons;
}

/** Of the whole cell of each polygon's site. */
template <class SiteOf>
void addCellSums(const DiagramSource& source, const Columns& columns, const SiteOf& site)
{
  const CellSums& sums = source.result.sums;
  columns.add<vtkDoubleArray>(
    "CellArea", [&](Offset polygon) { return source.result.cellAreas[site(polygon)]; });
  columns.add<vtkDoubleArray>("CellMass",
    [&](Offset polygon) { return source.siteMass()[site(polygon)] * source.massUnit(); });
  columns.add<vtkDoubleArray>("CellEnergy",
    [&](Offset polygon) { return source.siteEnergy()[site(polygon)] * source.energyUnit(); });
  if (source.hasDensity())
  {
    columns.add<vtkDoubleArray>("CellWeightedMass",
      [&](Offset polygon)
      { return sums.mass[site(polygon)] * source.massUnit() * source.densityUnit(); });
  }
}

void addPieceArrays(const DiagramSource& source, const DrawnPieces& drawn, vtkCellData* data)
{
  const Diagram& diagram = source.result.diagram;
  const Columns columns{ data, drawn.count(), source.control };
  const auto site = [&](Offset polygon) { return diagram.sites[drawn[polygon]]; };
  columns.add<vtkIdTypeArray>("SiteId", site);
  columns.add<vtkIdTypeArray>("MergedSiteId",
    [&](Offset polygon) { return source.result.featureSites.mergedSite(site(polygon)); });
  const Components& components = source.result.components;
  columns.add<vtkIdTypeArray>("ComponentId",
    [&](Offset polygon) { return components.ranks[components.ofPiece[drawn[polygon]]]; });
  columns.add<vtkIdTypeArray>(
    "PatchId", [&](Offset polygon) { return source.patchOfFacet(diagram.facets[drawn[polygon]]); });
  auto* cellIds =
    vtkIdTypeArray::SafeDownCast(source.input->GetCellData()->GetAbstractArray(blockCellName));
  columns.add<vtkIdTypeArray>("InputCellId",
    [&](Offset polygon)
    {
      const Offset cell = source.prepared.mesh.facetInputCells[diagram.facets[drawn[polygon]]];
      return cellIds ? cellIds->GetValue(cell) : cell;
    });
  if (source.cellBlocks)
  {
    columns.add<vtkIntArray>(blockName,
      [&](Offset polygon) { return source.blockOfFacet(diagram.facets[drawn[polygon]]); });
  }
  columns.add<vtkIntArray>(
    "CellColor", [&](Offset polygon) { return source.result.cellColors[site(polygon)]; });
  data->SetActiveScalars("CellColor"); // what viewers then colour by
  addCellSums(source, columns, site);
}

enum EdgeType
{
  Hidden = -1, ///< between two facets, or drawn for another piece or facet
  CellBorder = 0,
  Feature = 1,
  Boundary = 2,
  NonManifold = 3
};

/** Whether a facet is the first at an edge among those of its block. */
bool isFirst(const DiagramSource& source, const EdgeTable& edges, Index edge, Index facet)
{
  for (Offset k = edges.edgeFacetsBegin[edge];; ++k)
  {
    const Index other = edges.edgeFacets[k];
    if (other == facet || source.blockOfFacet(other) == source.blockOfFacet(facet))
    {
      return other == facet;
    }
  }
}

/**
 * What the edge that starts at a vertex of a piece is drawn as; each edge is drawn once, in each
 * block at it.
 */
EdgeType typeOf(const DiagramSource& source, const EdgeTable& cutEdges, Offset piece, Index across)
{
  const Diagram& diagram = source.result.diagram;
  const std::optional<Features>& features = source.prepared.features;
  const EdgeTable& edges = features ? features->edges : cutEdges;
  if (across >= 0)
  {
    return across < diagram.sites[piece] ? Hidden : CellBorder;
  }
  const Index facet = diagram.facets[piece];
  const Index edge = edges.facetEdges[facet][-1 - across];
  const bool first = isFirst(source, edges, edge, facet);
  if (first && features && features->kinds[edge] == FeatureKind::Crease)
  {
    return Feature;
  }
  if (edges.valence(edge) == 2 || !first)
  {
    return Hidden;
  }
  return edges.valence(edge) == 1 ? Boundary : NonManifold;
}

/** Calls `visit(line, piece, vertex, next, type)` for all that is drawn; `begin(count)` before. */
template <class Begin, class Visit>
void forEachLine(
  const DiagramSource& source, const EdgeTable& cutEdges, const Begin& begin, const Visit& visit)
{
  const Diagram& diagram = source.result.diagram;
  const Blocks blocks = longBlocks(diagram.numberOfPieces());
  const auto forEachEdge = [&](Offset block, const auto& draw)
  {
    for (Offset piece = blocks.begin(block); piece < blocks.end(block); ++piece)
    {
      const Offset first = diagram.vertexBegin[piece];
      const Offset end = diagram.vertexBegin[piece + 1];
      for (Offset v = first; v < end; ++v)
      {
        if (const EdgeType type = typeOf(source, cutEdges, piece, diagram.across[v]);
            type != Hidden)
        {
          draw(piece, v, v + 1 == end ? first : v + 1, type);
        }
      }
    }
  };
  std::vector<Offset> lines(static_cast<std::size_t>(blocks.count()), 0);
  fillBlocks(blocks.count(), source.control,
    [&](Offset block)
    { forEachEdge(block, [&](Offset, Offset, Offset, EdgeType) { ++lines[block]; }); });
  begin(scanCounts(lines));
  fillBlocks(blocks.count(), source.control,
    [&](Offset block)
    {
      forEachEdge(block,
        [&](Offset piece, Offset v, Offset next, EdgeType type)
        { visit(lines[block]++, piece, v, next, type); });
    });
}

/** Numbers the diagram's points in the order in which the ids name them; returns the points. */
std::vector<Offset> renumber(
  vtkIdTypeArray* ids, std::size_t numberOfPoints, const RunControl& control)
{
  vtkIdType* points = ids->GetPointer(0);
  const Offset uses = ids->GetNumberOfValues();
  std::vector<Offset> used;
  LowestItems firstUses(numberOfPoints);
  std::vector<Offset> numbers(numberOfPoints);
  fillItems(uses, control, [&](Offset use) { firstUses.add(points[use], use); });
  static_cast<void>(packItems(
    uses, control, [&](Offset use) { return firstUses[points[use]] == use; },
    [&](Offset count) { used.resize(static_cast<std::size_t>(count)); },
    [&](Offset use, Offset number)
    {
      used[number] = points[use];
      numbers[points[use]] = number;
    }));
  fillItems(uses, control, [&](Offset use) { points[use] = numbers[points[use]]; });
  return used;
}
}

void writeVoronoiCells(const DiagramSource& source, const DiagramPoints& points,
  int embeddingDimension, vtkPolyData* output)
{
  const Diagram& diagram = source.result.diagram;
  output->SetPoints(makePoints(
    static_cast<Offset>(points.points.size()),
    [&](Offset k) { return placeOf(source.prepared.mesh, points.points[k]); }, source.control));
  const DrawnPieces drawn(source);
  output->SetPolys(makePolygons(diagram, points, drawn));
  addPieceArrays(source, drawn, output->GetCellData());
  if (source.dimension() <= embeddingDimension)
  {
    addEmbedding(source, points, output->GetPointData());
  }
}

namespace
{
/** What is written of each line, in any order. */
struct LineArrays
{
  const DiagramSource& source;
  vtkNew<vtkIdTypeArray> connectivity;
  vtkIdType* types = nullptr;
  vtkIdType* sites = nullptr;
  int* blocks = nullptr;

  void allocate(Offset count, vtkCellData* data)
  {
    const Columns columns{ data, count, this->source.control };
    this->types = columns.addEmpty<vtkIdTypeArray>("EdgeType", 1)->GetPointer(0);
    this->sites = columns.addEmpty<vtkIdTypeArray>("SiteId", 2)->GetPointer(0);
    data->SetActiveScalars("EdgeType"); // what viewers then colour by
    if (this->source.cellBlocks)
    {
      this->blocks = columns.addEmpty<vtkIntArray>(blockName, 1)->GetPointer(0);
    }
    this->connectivity->SetNumberOfValues(2 * count);
  }

  /** @param across site or edge beyond the line, which is drawn for this piece. */
  void write(Offset line, Offset piece, Index across, EdgeType type)
  {
    const Diagram& diagram = this->source.result.diagram;
    this->types[line] = type;
    this->sites[2 * line] = diagram.sites[piece];
    this->sites[2 * line + 1] = across < 0 ? -1 : across;
    if (this->blocks)
    {
      this->blocks[line] = this->source.blockOfFacet(diagram.facets[piece]);
    }
  }
};
}

void writeEdges(const DiagramSource& source, const EdgeTable& edges, const DiagramPoints& points,
  vtkPolyData* output)
{
  LineArrays arrays{ source, {} };
  vtkIdType* ends = nullptr;
  forEachLine(
    source, edges,
    [&](Offset count)
    {
      arrays.allocate(count, output->GetCellData());
      ends = arrays.connectivity->GetPointer(0);
    },
    [&](Offset line, Offset piece, Offset v, Offset next, EdgeType type)
    {
      ends[2 * line] = points.ofVertex[v];
      ends[2 * line + 1] = points.ofVertex[next];
      arrays.write(line, piece, source.result.diagram.across[v], type);
    });
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(arrays.connectivity->GetNumberOfValues() / 2 + 1);
  for (vtkIdType line = 0; line < offsets->GetNumberOfValues(); ++line)
  {
    offsets->SetValue(line, 2 * line);
  }
  const std::vector<Offset> used =
    renumber(arrays.connectivity, points.points.size(), source.control);
  output->SetPoints(makePoints(
    static_cast<Offset>(used.size()),
    [&](Offset k) { return placeOf(source.prepared.mesh, points.points[used[k]]); },
    source.control));
  vtkNew<vtkCellArray> lines;
  lines->SetData(offsets, arrays.connectivity);
  output->SetLines(lines);
}
}
