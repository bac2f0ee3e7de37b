// Delaunay/Components: the connected parts of the cells, against a flood fill; thin plates.

#include "TestDuals.h"
#include "Voronoi/DiagramPoints.h"

#include <numeric>

using namespace remesh;

namespace
{
/** Two unit squares of k x k squares at a distance, facing away from each other. */
TriangleSoup twoSheets(int k, double distance)
{
  TriangleSoup soup = test::gridPatch(k, k, Point3(0, 0, distance));
  TriangleSoup below = test::gridPatch(k, k);
  for (std::size_t t = 0; t < below.triangles.size(); ++t)
  {
    test::flip(below, t);
  }
  test::append(soup, below, Point3::Zero());
  return soup;
}

/** The same with a wall around: a closed plate. */
TriangleSoup thinPlate(int k, double thickness)
{
  TriangleSoup soup = twoSheets(k, thickness);
  const Offset below = Offset(k + 1) * (k + 1);
  const auto wall = [&](Offset a, Offset b) // outside to the right of a -> b in the lower sheet
  {
    soup.triangles.push_back({ below + a, below + b, b });
    soup.triangles.push_back({ below + a, b, a });
  };
  for (Offset s = 0; s < k; ++s)
  {
    wall(s, s + 1);
    wall(s * (k + 1) + k, (s + 1) * (k + 1) + k);
    wall(Offset(k) * (k + 1) + s + 1, Offset(k) * (k + 1) + s);
    wall((s + 1) * (k + 1), s * (k + 1));
  }
  soup.inputCells.resize(soup.triangles.size());
  std::iota(soup.inputCells.begin(), soup.inputCells.end(), Offset(0));
  return soup;
}

/** Two triangles that have only a point in common. */
TriangleSoup bowTie()
{
  return test::makeSoup(
    { { 0, 0, 0 }, { 1, -0.5, 0 }, { 1, 0.5, 0 }, { -1, 0.5, 0 }, { -1, -0.5, 0 } },
    { { 0, 1, 2 }, { 0, 3, 4 } });
}

/** Joined pieces by definition: same site, and two consecutive points or a corner in common. */
std::vector<Index> flood(
  const SurfaceMesh& mesh, const EmbeddedSurface& surface, const test::Computed& result)
{
  const Diagram& diagram = result.diagram;
  DiagramPoints points;
  CHECK(numberDiagramPoints(mesh, buildEdgeTable(mesh.facetPoints),
    { surface, result.sites, diagram }, RunControl(), points)
          .ok());
  std::map<std::array<Offset, 3>, std::vector<Offset>> shared; // site and two points
  for (Offset p = 0; p < diagram.numberOfPieces(); ++p)
  {
    const Offset begin = diagram.vertexBegin[p];
    const Offset end = diagram.vertexBegin[p + 1];
    for (Offset v = begin; v < end; ++v)
    {
      const Offset a = points.ofVertex[v];
      const Offset b = points.ofVertex[v + 1 == end ? begin : v + 1];
      const Offset site = diagram.sites[p];
      shared[{ site, std::min(a, b), std::max(a, b) }].push_back(p);
      if (a < mesh.numberOfCorners())
      {
        shared[{ site, a, a }].push_back(p);
      }
    }
  }
  // The lowest piece that can be reached, passed on until nothing changes.
  std::vector<Index> lowest(static_cast<std::size_t>(diagram.numberOfPieces()));
  std::iota(lowest.begin(), lowest.end(), Index(0));
  for (bool changed = true; changed;)
  {
    changed = false;
    for (const auto& [place, pieces] : shared)
    {
      Index least = lowest[pieces.front()];
      for (const Offset p : pieces)
      {
        least = std::min(least, lowest[p]);
      }
      for (const Offset p : pieces)
      {
        changed = changed || lowest[p] != least;
        lowest[p] = least;
      }
    }
  }
  return lowest;
}

/** Ids, ranks and lists fit together. */
void checkNumbering(const Diagram& diagram, const Components& components)
{
  Index wrong = 0;
  for (Index k = 0; k < components.count(); ++k)
  {
    const bool sameSite = k > 0 && components.sites[k] == components.sites[k - 1];
    wrong += k > 0 && components.sites[k] < components.sites[k - 1];
    wrong += components.ranks[k] != (sameSite ? components.ranks[k - 1] + 1 : 0);
    wrong += components.pieceBegin[k] >= components.pieceBegin[k + 1];
    for (Offset p = components.pieceBegin[k]; p < components.pieceBegin[k + 1]; ++p)
    {
      const Offset piece = components.pieces[p];
      wrong += components.ofPiece[piece] != k || diagram.sites[piece] != components.sites[k];
      wrong += p > components.pieceBegin[k] && components.pieces[p - 1] >= piece;
    }
  }
  CHECK_EQUAL(wrong, 0);
  CHECK_EQUAL(components.pieces.size(), std::size_t(diagram.numberOfPieces()));
}

/** Sums over a site's components are the site's, centroids the moments' ones. */
void checkSums(const SurfaceMesh& mesh, const test::Computed& result, const Components& components)
{
  const CellSums& sums = result.sums;
  std::vector<double> mass = sums.mass, energy = sums.energy;
  std::vector<double> area =
    measureCellAreas(mesh, result.diagram, static_cast<Index>(mass.size()));
  Point3 moment = Point3::Zero();
  for (Index k = 0; k < components.count(); ++k)
  {
    mass[components.sites[k]] -= components.mass[k];
    area[components.sites[k]] -= components.area[k];
    energy[components.sites[k]] -= components.energy[k];
    moment += components.area[k] * components.centroids[k];
  }
  for (const std::vector<double>& rest : { mass, area, energy })
  {
    CHECK(std::all_of(rest.begin(), rest.end(), [](double r) { return std::abs(r) < 1e-12; }));
  }
  // In R^3 mass is area but for the unit: together the centroids give the surface's.
  for (const auto& [a, b, c] : mesh.facetPoints)
  {
    const Point3& p = mesh.points[a];
    const Point3& q = mesh.points[b];
    const Point3& r = mesh.points[c];
    moment -= 0.5 * (q - p).cross(r - p).norm() * (p + q + r) / 3.0;
  }
  CHECK_NEAR(moment.norm(), 0.0, 1e-12);
}

test::DualOf checkCase(const SurfaceMesh& mesh, const EmbeddedSurface& surface, const Sites& sites)
{
  const test::Computed result = test::computed(surface, sites);
  const test::DualOf made = test::dualOf(mesh, surface, result);
  checkNumbering(result.diagram, made.components);
  if (surface.dimension == 3)
  {
    checkSums(mesh, result, made.components);
  }
  const std::vector<Index> lowest = flood(mesh, surface, result);
  std::map<Index, Index> componentOf;
  Index different = 0;
  for (std::size_t p = 0; p < lowest.size(); ++p)
  {
    const Index component = made.components.ofPiece[p];
    different += componentOf.try_emplace(lowest[p], component).first->second != component;
  }
  CHECK_EQUAL(different, 0);
  CHECK_EQUAL(Index(componentOf.size()), made.components.count());
  return made;
}

void testFloodFill()
{
  std::vector<test::NamedMesh> meshes = test::smallMeshes();
  meshes.push_back({ "three sheets", test::meshOf(test::threeSheets()) });
  meshes.push_back({ "plate", test::meshOf(thinPlate(6, 0.02)) });
  for (const auto& [name, mesh] : meshes)
  {
    for (const int d : { 3, 6 })
    {
      const EmbeddedSurface surface = test::embedded(mesh, d);
      for (const Offset n : { 1, 5, 60 })
      {
        checkCase(mesh, surface, test::sampled(surface, n, 1));
      }
    }
  }
}

/** Sites half way between two sheets, on a grid: each cell reaches both. */
void testTwoSheets()
{
  const SurfaceMesh mesh = test::meshOf(twoSheets(7, 0.01));
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  std::vector<Point3> places;
  for (int s = 0; s < 64; ++s)
  {
    const double shift = 0.02 * uniform01(1, s, 0);
    places.emplace_back((s % 8 + 0.5) / 8.0 + shift, (s / 8 + 0.5) / 8.0 - shift, 0.005);
  }
  const test::DualOf made = checkCase(mesh, surface, test::sitesAt(surface, places));
  CHECK_EQUAL(made.components.count(), 128);
  const test::Shape shape = test::shapeOf(made.dual.triangles);
  CHECK(shape.isManifold());
  CHECK_EQUAL(shape.pieces, 2);
  CHECK_EQUAL(shape.vertices, 128);
  CHECK_EQUAL(made.dual.eulerCharacteristic, 2);
  for (const auto& [a, b, c] : made.dual.triangles)
  {
    // The upper sheet faces up, the lower one down.
    const Point3 p = made.vertex(a);
    const Point3 normal = (made.vertex(b) - p).cross(made.vertex(c) - p);
    CHECK(normal.z() * (p.z() - 0.005) > 0.0);
  }
}

/** A closed plate, thin against its cells: the dual has its two sides, and goes round its rim. */
void testThinPlate()
{
  const SurfaceMesh mesh = test::meshOf(thinPlate(16, 0.01));
  CHECK_EQUAL(test::eulerCharacteristic(mesh), 2);
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  std::vector<Point3> places;
  for (int s = 0; s < 64; ++s)
  {
    // Towards a disk: the cell at each corner of the plate then has an inner cell beside it.
    const double u = (s % 8 + 0.5) / 4.0 - 1.0 + 0.01 * uniform01(2, s, 0);
    const double v = (s / 8 + 0.5) / 4.0 - 1.0 + 0.01 * uniform01(2, s, 1);
    places.emplace_back(0.5 + 0.5 * u * std::sqrt(1.0 - 0.2 * v * v),
      0.5 + 0.5 * v * std::sqrt(1.0 - 0.2 * u * u), 0.005);
  }
  const test::DualOf made = checkCase(mesh, surface, test::sitesAt(surface, places));
  CHECK_EQUAL(made.components.count(), 64 + 36); // 28 cells go round the rim
  const test::Shape shape = test::shapeOf(made.dual.triangles);
  CHECK(shape.isManifold());
  CHECK_EQUAL(shape.pieces, 1);
  CHECK_EQUAL(shape.borderEdges, 0);
  CHECK_EQUAL(made.dual.eulerCharacteristic, 2);
}

void testBowTie()
{
  const SurfaceMesh mesh = test::meshOf(bowTie());
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  // One cell through the knot; or, without the knot, two components.
  CHECK_EQUAL(
    checkCase(mesh, surface, test::sitesAt(surface, { { 0.1, 0, 0 } })).components.count(), 1);
  const Sites three = test::sitesAt(surface, { { 0, 0, 0 }, { 0, 0.9, 0 }, { 0, -0.9, 0 } });
  const test::DualOf made = checkCase(mesh, surface, three);
  CHECK_EQUAL(made.components.count(), 5);
  CHECK(made.components.sites == std::vector<Index>({ 0, 1, 1, 2, 2 }));
  CHECK(made.components.ranks == std::vector<Index>({ 0, 0, 1, 0, 1 }));
}
}

int TestComponents(int, char*[])
{
  testFloodFill();
  testTwoSheets();
  testThinPlate();
  testBowTie();
  return test::result();
}
