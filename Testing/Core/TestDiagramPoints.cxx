// Voronoi/DiagramPoints: one point for all vertices at a place; the complex keeps the topology.

#include "TestDiagrams.h"
#include "Voronoi/DiagramPoints.h"

#include <set>

using namespace remesh;

namespace
{
/** Vertices with one point lie at one place; points with one place in one facet are one. */
void checkPlaces(
  const EmbeddedSurface& surface, const test::PlacedDiagram& diagram, const DiagramPoints& points)
{
  double largest = 0.0;
  for (Offset p = 0; p < diagram.numberOfPieces(); ++p)
  {
    for (Offset v = diagram.vertexBegin[p]; v < diagram.vertexBegin[p + 1]; ++v)
    {
      const DiagramPoint& point = points.points[points.ofVertex[v]];
      const double* b = diagram.vertices[v].b;
      const auto here = test::pointAt(surface, diagram.facets[p], { b[0], b[1], b[2] });
      const auto there =
        test::pointAt(surface, point.facet, { point.b[0], point.b[1], point.b[2] });
      largest =
        std::max(largest, test::exactDistance2(here.data(), there.data(), surface.dimension));
    }
  }
  CHECK_NEAR(std::sqrt(largest), 0.0, 1e-15);
}

/** Points - edges + pieces: the diagram subdivides the surface. */
Offset eulerCharacteristic(const Diagram& diagram, const DiagramPoints& points)
{
  std::set<std::pair<Offset, Offset>> edges;
  std::set<Offset> used;
  for (Offset p = 0; p < diagram.numberOfPieces(); ++p)
  {
    const Offset begin = diagram.vertexBegin[p];
    const Offset end = diagram.vertexBegin[p + 1];
    for (Offset v = begin; v < end; ++v)
    {
      const Offset a = points.ofVertex[v];
      const Offset b = points.ofVertex[v + 1 == end ? begin : v + 1];
      CHECK(a != b);
      used.insert(a);
      edges.insert(std::minmax(a, b));
    }
  }
  CHECK_EQUAL(used.size(), points.points.size());
  return static_cast<Offset>(used.size()) - static_cast<Offset>(edges.size()) +
    diagram.numberOfPieces();
}

void checkCase(const SurfaceMesh& mesh, const EmbeddedSurface& surface, const Sites& sites)
{
  const test::Computed result = test::computed(surface, sites);
  DiagramPoints points;
  CHECK(numberDiagramPoints(mesh, buildEdgeTable(mesh.facetPoints),
    { surface, sites, result.diagram }, RunControl(), points)
          .ok());
  checkPlaces(surface, result.diagram, points);
  CHECK_EQUAL(eulerCharacteristic(result.diagram, points), Offset(test::eulerCharacteristic(mesh)));
}
}

int TestDiagramPoints(int, char*[])
{
  for (const auto& [name, mesh] : test::smallMeshes())
  {
    for (const int d : { 3, 6 })
    {
      const EmbeddedSurface surface = test::embedded(mesh, d);
      for (const Offset n : { 1, 3, 60 })
      {
        checkCase(mesh, surface, test::sampled(surface, n, 1));
      }
    }
  }
  // Ties: sites at the corners and all at one place.
  const SurfaceMesh mesh = test::meshOf(test::gridPatch(4, 4));
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  Sites sites;
  sites.dimension = 3;
  sites.coordinates = surface.corners;
  checkCase(mesh, surface, sites);
  checkCase(mesh, surface, test::sitesAt(surface, std::vector<Point3>(9, { 0.5, 0.5, 0.0 })));
  return test::result();
}
