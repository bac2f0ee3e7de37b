// Splits of facets: conforming, with the same area and topology, and origins that are exact.

#include "TestChecks.h"
#include "TestSurfaces.h"

#include "Comparison/MeshTopology.h"
#include "Features/FeatureGraph.h"
#include "Mesh/FacetGeometry.h"
#include "Mesh/Intake.h"
#include "Mesh/Normals.h"
#include "Refinement/NormalVariation.h"

#include <algorithm>
#include <set>

using namespace remesh;
using namespace remesh::test;

namespace
{
const std::vector<FacetNormal> noneBorrowed;

SurfaceMesh meshOf(const TriangleSoup& soup)
{
  SurfaceMesh mesh;
  IntakeReport report;
  CHECK(buildSurfaceMesh(soup, {}, RunControl(), mesh, report).ok());
  return mesh;
}

/** A fan of long triangles around an apex, closed below. */
TriangleSoup coneFan(int sides, double height)
{
  std::vector<Point3> points{ { 0, 0, height }, { 0, 0, 0 } };
  std::vector<std::array<Offset, 3>> triangles;
  for (int k = 0; k < sides; ++k)
  {
    const double angle = 2.0 * pi * k / sides;
    points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    const Offset next = 2 + (k + 1) % sides;
    triangles.push_back({ 0, 2 + k, next });
    triangles.push_back({ 1, next, 2 + k });
  }
  return makeSoup(points, triangles);
}

double areaOf(const SurfaceMesh& mesh)
{
  double area = 0.0;
  for (Index f = 0; f < mesh.numberOfFacets(); ++f)
  {
    area += facetArea(mesh, f);
  }
  return area;
}

MeshTopology topologyOf(const SurfaceMesh& mesh)
{
  MeshTopology topology;
  const EdgeTable edges = buildEdgeTable(mesh.facetPoints);
  CHECK(measureConnectivity(mesh.facetPoints, edges, mesh.numberOfPoints(), {}, topology).ok());
  return topology;
}

Point3 placeOn(const SurfaceMesh& mesh, Index facet, const std::array<float, 3>& b)
{
  Point3 place = Point3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    place += static_cast<double>(b[k]) * mesh.points[mesh.facetPoints[facet][k]];
  }
  return place;
}

/** What holds of any refined surface. */
void checkRefined(const SurfaceMesh& before, const RefinedSurface& refined)
{
  const SurfaceMesh& mesh = refined.mesh;
  CHECK_NEAR(areaOf(mesh), areaOf(before), 1e-12 * areaOf(before));
  const MeshTopology old = topologyOf(before);
  const MeshTopology now = topologyOf(mesh);
  CHECK_EQUAL(now.eulerCharacteristic, old.eulerCharacteristic);
  CHECK_EQUAL(now.nonManifoldEdges, old.nonManifoldEdges);
  CHECK_EQUAL(now.boundaryLoops, old.boundaryLoops);
  std::vector<double> areas(before.facetPoints.size(), 0.0);
  Index last = 0;
  for (Index f = 0; f < mesh.numberOfFacets(); ++f)
  {
    const FacetOrigin& origin = refined.origins[f];
    CHECK(origin.facet >= last); // in the order of those they came from
    last = origin.facet;
    areas[origin.facet] += facetArea(mesh, f);
    CHECK_EQUAL(mesh.facetInputCells[f], before.facetInputCells[origin.facet]);
    for (int k = 0; k < 3; ++k)
    {
      CHECK_EQUAL(origin.corners[k][0] + origin.corners[k][1] + origin.corners[k][2], 1.0F);
      const Point3 place = placeOn(before, origin.facet, origin.corners[k]);
      CHECK((place - mesh.points[mesh.facetPoints[f][k]]).norm() < 1e-13);
    }
  }
  for (std::size_t f = 0; f < areas.size(); ++f)
  {
    const double area = facetArea(before, static_cast<Index>(f));
    CHECK_NEAR(areas[f], area, 1e-12 * area);
  }
}

/** All ways in which the sides of two facets may be split. @param open facets, or none. */
void testPatterns(const std::vector<char>& open)
{
  const SurfaceMesh mesh = meshOf(gridPatch(1, 1));
  const EdgeTable edges = buildEdgeTable(mesh.facetPoints);
  for (unsigned pattern = 0; pattern < 32; ++pattern)
  {
    EdgesToSplit wanted;
    wanted.open = open;
    for (Index e = 0; e < edges.numberOfEdges(); ++e)
    {
      wanted.lengths.push_back(e == 2 ? 1.5 : 1.0);
      wanted.marked.push_back(static_cast<char>(pattern >> e & 1));
    }
    const std::vector<char> asked = wanted.marked;
    closeMarks(edges, wanted);
    CHECK(open != std::vector<char>(2, 1) || wanted.marked == asked);
    RefinedSurface refined = wholeSurface(mesh, nullptr);
    splitEdges(edges, wanted, nullptr, RunControl(), refined);
    Index added = 0;
    for (Index e = 0; e < edges.numberOfEdges(); ++e)
    {
      added += wanted.marked[e] ? edges.valence(e) : 0;
    }
    CHECK_EQUAL(refined.mesh.numberOfFacets(), mesh.numberOfFacets() + added);
    checkRefined(mesh, refined);
    if (pattern == 0)
    {
      CHECK(refined.mesh.facetPoints == mesh.facetPoints);
      CHECK(refined.mesh.points == mesh.points);
    }
  }
}

/** Any criterion, down to a length; and never beyond the room there is. */
void testCriterion()
{
  const SurfaceMesh mesh = meshOf(cube());
  const auto shorterThan = [](double most)
  {
    return [most](const RefinedSurface& surface, const EdgeTable& edges, EdgesToSplit& wanted)
    {
      wanted.lengths.resize(static_cast<std::size_t>(edges.numberOfEdges()));
      wanted.marked.resize(wanted.lengths.size());
      for (Index f = 0; f < surface.mesh.numberOfFacets(); ++f)
      {
        for (int k = 0; k < 3; ++k)
        {
          const Triple& points = surface.mesh.facetPoints[f];
          const Index edge = edges.facetEdges[f][k];
          wanted.lengths[edge] =
            (surface.mesh.points[points[k]] - surface.mesh.points[points[(k + 1) % 3]]).norm();
          wanted.marked[edge] = wanted.lengths[edge] > most;
        }
      }
    };
  };
  RefinedSurface refined = wholeSurface(mesh, nullptr);
  CHECK(!refine(shorterThan(2.0), { 1000 }, RunControl(), refined));
  CHECK(refine(shorterThan(0.3), { 100000 }, RunControl(), refined));
  checkRefined(mesh, refined);
  for (const Triple& points : refined.mesh.facetPoints)
  {
    for (int k = 0; k < 3; ++k)
    {
      CHECK(
        (refined.mesh.points[points[k]] - refined.mesh.points[points[(k + 1) % 3]]).norm() <= 0.3);
    }
  }
  RefinedSurface limited = wholeSurface(mesh, nullptr);
  refine(shorterThan(0.01), { 200 }, RunControl(), limited);
  CHECK(limited.mesh.numberOfFacets() <= 200);
  checkRefined(mesh, limited);
}

/** How many points are within the facets before. */
std::size_t innerPoints(const RefinedSurface& refined)
{
  std::set<Index> inner;
  for (std::size_t f = 0; f < refined.origins.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto& corner = refined.origins[f].corners[k];
      if (*std::min_element(corner.begin(), corner.end()) > 0.0F)
      {
        inner.insert(refined.mesh.facetPoints[f][k]);
      }
    }
  }
  return inner.size();
}

/** Sides of the facets before down to half, and all edges within these, which are the longest. */
void wantSidesAndLongInside(
  const RefinedSurface& surface, const EdgeTable& edges, EdgesToSplit& wanted)
{
  wanted.lengths.resize(static_cast<std::size_t>(edges.numberOfEdges()));
  wanted.marked.resize(wanted.lengths.size());
  for (Index e = 0; e < edges.numberOfEdges(); ++e)
  {
    const Index* facets = &edges.edgeFacets[edges.edgeFacetsBegin[e]];
    const bool isInner =
      edges.valence(e) == 2 && surface.origins[facets[0]].facet == surface.origins[facets[1]].facet;
    const Triple& points = surface.mesh.facetPoints[facets[0]];
    const int k = edges.sideOf(facets[0], e);
    const double length =
      (surface.mesh.points[points[k]] - surface.mesh.points[points[(k + 1) % 3]]).norm();
    wanted.lengths[e] = isInner ? 100.0 : 1.02 * length;
    wanted.marked[e] = wanted.lengths[e] > 0.5;
  }
}

/** Edges between pieces of needles wait for the sides, also where there is no room for all. */
void testNeedles()
{
  const SurfaceMesh mesh = meshOf(gridPatch(1, 1));
  PieceShapes shapes;
  shapes.energy = [](const FacetOrigin&) { return 1.0; };
  shapes.enough = 1.0; // nothing is flipped
  shapes.needle = 0.5; // all are
  RefinementLimits limits{ 20, 2, &shapes };
  // Halves of sides are 0.51 long, or 0.72, and inner edges wait: 2, 8, 20 facets.
  RefinedSurface refined = wholeSurface(mesh, nullptr);
  CHECK(refine(wantSidesAndLongInside, limits, RunControl(), refined));
  checkRefined(mesh, refined);
  CHECK_EQUAL(refined.mesh.numberOfFacets(), 20);
  CHECK_EQUAL(innerPoints(refined), 0U);
  // Without room for all sides, the longest of them come first, however long inner edges are.
  limits.maxFacets = 16;
  refined = wholeSurface(mesh, nullptr);
  CHECK(refine(wantSidesAndLongInside, limits, RunControl(), refined));
  checkRefined(mesh, refined);
  CHECK_EQUAL(refined.mesh.numberOfFacets(), 12);
  CHECK_EQUAL(innerPoints(refined), 0U);
  CHECK_EQUAL(refined.mesh.numberOfPoints(), 9 + 2); // the diagonal has both
  // By default no facet is a needle: edges within are split with the sides.
  shapes.needle = PieceShapes().needle;
  limits = { 1000, 2, &shapes };
  refined = wholeSurface(mesh, nullptr);
  CHECK(refine(wantSidesAndLongInside, limits, RunControl(), refined));
  checkRefined(mesh, refined);
  CHECK(innerPoints(refined) > 0);
}

/** Creases go along, and so do apexes; interior edges are none. */
void testFeatures()
{
  SurfaceMesh mesh = meshOf(coneFan(24, 10.0));
  FeatureOptions options;
  options.spacing = 0.2;
  const Features features = findFeatures(mesh, options);
  CHECK_EQUAL(features.apexes.size(), 1U); // the fan's tip, not the middle of the base
  CHECK_EQUAL(features.numberOfPatches, 2);
  const std::vector<Point3> normals = estimateCornerNormals(mesh, 0);
  const OwnNormals own(mesh, noneBorrowed, normals, nullptr);
  RefinedSurface refined;
  std::vector<Point3> fineNormals;
  CHECK(refineForNormals(own, &features, 0.2, 3000, RunControl(), refined, fineNormals));
  checkRefined(mesh, refined);
  CHECK(refined.features.has_value());
  CHECK_EQUAL(refined.features->numberOfPatches, 2);
  CHECK_EQUAL(refined.features->curves.size(), features.curves.size());
  CHECK_EQUAL(refined.features->apexes.size(), 1U);
  CHECK(refined.mesh.points[refined.features->apexes[0]] == Point3(0, 0, 10));
  CHECK_EQUAL(fineNormals.size(), refined.mesh.cornerPoints.size());
  double length = 0.0;
  for (Index e = 0; e < refined.features->edges.numberOfEdges(); ++e)
  {
    if (refined.features->kinds[e] == FeatureKind::Crease)
    {
      const Index f =
        refined.features->edges.edgeFacets[refined.features->edges.edgeFacetsBegin[e]];
      const int k = refined.features->edges.sideOf(f, e);
      const Triple& points = refined.mesh.facetPoints[f];
      length += (refined.mesh.points[points[k]] - refined.mesh.points[points[(k + 1) % 3]]).norm();
    }
  }
  CHECK_NEAR(length, 48.0 * std::sin(pi / 24.0), 1e-12);
}

/** Half-way down from the tip the normal is the side's, not half-way to the axis. */
void testNormals()
{
  SurfaceMesh mesh = meshOf(coneFan(24, 10.0));
  const std::vector<Point3> normals = estimateCornerNormals(mesh, 0);
  for (const bool areGiven : { false, true })
  {
    std::vector<Point3> given{ { 0, 0, 1 }, { 0, 0, -1 } };
    for (int k = 0; k < 24; ++k)
    {
      const double angle = 2.0 * pi * k / 24;
      given.emplace_back(std::cos(angle), std::sin(angle), 0.1);
    }
    std::vector<Point3> corners = normals;
    if (areGiven)
    {
      CHECK(givenCornerNormals(mesh, given, corners).ok());
    }
    const OwnNormals own(mesh, noneBorrowed, corners, areGiven ? &given : nullptr);
    RefinedSurface refined;
    std::vector<Point3> fine;
    CHECK(refineForNormals(own, nullptr, 0.4, 3000, RunControl(), refined, fine));
    bool isFound = false;
    for (std::size_t c = 0; c < fine.size(); ++c)
    {
      CHECK_NEAR(fine[c].norm(), 1.0, 1e-12);
      const Point3& place = refined.mesh.points[refined.mesh.cornerPoints[c]];
      if (place[2] > 4.0 && place[2] < 8.0)
      {
        isFound = true;
        CHECK(fine[c][2] < 0.15);
      }
    }
    CHECK(isFound);
  }
}

/** Where facets are small, flat, or normals count for nothing, nothing is done. */
void testNothing()
{
  RefinedSurface refined;
  std::vector<Point3> fine;
  for (const TriangleSoup& soup : { icosphere(4), gridPatch(1, 1) })
  {
    const SurfaceMesh mesh = meshOf(soup);
    const std::vector<Point3> normals = estimateCornerNormals(mesh, 0);
    const OwnNormals own(mesh, noneBorrowed, normals, nullptr);
    CHECK(!refineForNormals(own, nullptr, 0.2, 1000, RunControl(), refined, fine));
  }
  const SurfaceMesh cone = meshOf(coneFan(24, 10.0));
  const std::vector<Point3> normals = estimateCornerNormals(cone, 0);
  const OwnNormals own(cone, noneBorrowed, normals, nullptr);
  CHECK(!refineForNormals(own, nullptr, 0.0, 1000, RunControl(), refined, fine));
}

/** Rows are linear in the facets before, and old corners keep theirs to the bit. */
void testRows()
{
  const SurfaceMesh mesh = meshOf(coneFan(12, 10.0));
  CornerCoordinates rows;
  rows.dimension = 2;
  for (const Index point : mesh.cornerPoints)
  {
    const Point3& p = mesh.points[point];
    rows.values.push_back(1.0 + 3.0 * p[0] - p[2]);
    rows.values.push_back(p[1]);
  }
  const std::vector<Point3> normals = estimateCornerNormals(mesh, 0);
  const OwnNormals own(mesh, noneBorrowed, normals, nullptr);
  RefinedSurface refined;
  std::vector<Point3> fine;
  CHECK(refineForNormals(own, nullptr, 0.4, 1000, RunControl(), refined, fine));
  const CornerCoordinates made =
    interpolateCorners(mesh, refined.mesh, FacetOrigins(refined.origins), rows);
  CHECK_EQUAL(made.count(), refined.mesh.numberOfCorners());
  for (Index c = 0; c < refined.mesh.numberOfCorners(); ++c)
  {
    const Point3& p = refined.mesh.points[refined.mesh.cornerPoints[c]];
    CHECK_NEAR(made.values[2 * c], 1.0 + 3.0 * p[0] - p[2], 1e-13);
    CHECK_NEAR(made.values[2 * c + 1], p[1], 1e-13);
  }
}
}

int TestRefinement(int, char*[])
{
  for (const std::vector<char>& open : { std::vector<char>{}, { 1, 0 }, { 0, 1 }, { 1, 1 } })
  {
    testPatterns(open);
  }
  testCriterion();
  testNeedles();
  testFeatures();
  testNormals();
  testNothing();
  testRows();
  return test::result();
}
