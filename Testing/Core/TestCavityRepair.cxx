// Flipped triangles whose corners cannot move, and that no edge turns back alone.
#include "Placement/TriangleShape.h"
#include "Placement/WholeSurface.h"
#include "Repair/CavityRepair.h"
#include "Repair/InvertedSearch.h"
#include "Repair/MeshRepair.h"
#include "Support/Random.h"
#include "TestPlacements.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace
{
using namespace remesh;

/** Sites on a square, whose vertices a test may misplace, but no repair may move. */
struct Fixture
{
  SurfaceMesh mesh = test::meshOf(test::gridPatch(40, 40));
  EmbeddedSurface surface = test::gaussMapOf(mesh, 0.05);
  RemeshResult result = test::remeshed(mesh, 0.05, 300, VertexPlacement::Centroid);
  std::vector<char> fixed = std::vector<char>(result.placement.positions.size(), 1);
  std::vector<FeatureSegment> features;
  PlacementProblem problem{ mesh, surface, result.sites, result.diagram, result.components,
    result.dual.triangles, fixed, &features };
  NearbySurface near{ problem, RunControl() };

  std::vector<Index> flipped(
    const std::vector<Triple>& triangles, const std::vector<Point3>& positions) const
  {
    std::vector<Index> found;
    CHECK(InvertedSearch(near).find(triangles, positions, RunControl(), found).ok());
    return found;
  }
};

/** Each side of a triangle as it runs; each must be there once. */
std::set<std::pair<Index, Index>> sidesOf(const std::vector<Triple>& triangles)
{
  std::set<std::pair<Index, Index>> sides;
  for (const Triple& triangle : triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      CHECK(sides.emplace(triangle[k], triangle[(k + 1) % 3]).second);
    }
  }
  return sides;
}

std::set<std::pair<Index, Index>> bordersOf(const std::vector<Triple>& triangles)
{
  const std::set<std::pair<Index, Index>> sides = sidesOf(triangles);
  std::set<std::pair<Index, Index>> borders;
  for (const auto& [from, to] : sides)
  {
    if (sides.count({ to, from }) == 0)
    {
      borders.emplace(from, to);
    }
  }
  return borders;
}

/**
 * Refills around what is flipped, as long as that helps; the mesh's border and size stay.
 *
 * @return the number of edges that are others.
 */
Offset refillAll(
  const Fixture& fixture, const std::vector<Point3>& positions, std::vector<Triple>& triangles)
{
  const std::vector<Triple> before = triangles;
  std::vector<Point3> places = positions;
  RepairedMesh mesh(fixture.problem, fixture.near, positions, triangles, places);
  const RepairContext context{ fixture.problem, positions, RunControl(), true, strayCost };
  MeshEdits repair;
  for (bool any = true; any;)
  {
    any = false;
    for (const Index t : fixture.flipped(triangles, positions))
    {
      any = (mesh.isInverted(triangles[t]) && refillAround(context, t, mesh, repair)) || any;
    }
  }
  CHECK(places == positions);
  CHECK_EQUAL(triangles.size(), before.size());
  CHECK(bordersOf(triangles) == bordersOf(before));
  return repair.flippedEdges;
}

/** A vertex that was carried out of its star, over one or two triangles. */
void testCarriedAway()
{
  const Fixture fixture;
  const std::vector<Point3>& sound = fixture.result.placement.positions;
  const double spacing = std::sqrt(test::surfaceArea(fixture.mesh) / 300.0);
  int carried = 0;
  for (std::size_t v = 0; v < sound.size(); v += 7)
  {
    std::vector<Point3> positions = sound;
    positions[v][0] += 1.6 * spacing;
    const bool inside = std::all_of(positions[v].data(), positions[v].data() + 2,
      [&](double x) { return x > 2.0 * spacing && x < 1.0 - 2.0 * spacing; });
    if (!inside || sound[v][0] < 2.0 * spacing)
    {
      continue;
    }
    ++carried;
    std::vector<Triple> triangles = fixture.result.dual.triangles;
    CHECK(!fixture.flipped(triangles, positions).empty());
    CHECK(refillAll(fixture, positions, triangles) > 0);
    CHECK(fixture.flipped(triangles, positions).empty());
  }
  CHECK(carried >= 10);
}

/** Corners of a polygon without crossings, in turn: at any distance from its middle. */
std::vector<Point3> starPolygon(std::uint64_t seed, Index corners)
{
  std::vector<Point3> places;
  for (Index k = 0; k < corners; ++k)
  {
    const double angle = 2.0 * EIGEN_PI * k / corners;
    const double radius = 0.05 + 0.4 * uniform01(seed, static_cast<std::uint64_t>(k), 0);
    places.emplace_back(0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle), 0.0);
  }
  return places;
}

/** All triangles with its first corner: those that it does not see are flipped. */
std::vector<Triple> fan(Index corners)
{
  std::vector<Triple> triangles;
  for (Index k = 2; k < corners; ++k)
  {
    triangles.push_back({ 0, k - 1, k });
  }
  return triangles;
}

/** Polygons in which many triangles must change together. */
void testPolygons()
{
  const Fixture fixture;
  constexpr Index corners = 24;
  int flipped = 0;
  int refilled = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed)
  {
    std::vector<Point3> positions = fixture.result.placement.positions;
    const std::vector<Point3> places = starPolygon(seed, corners);
    std::copy(places.begin(), places.end(), positions.begin());
    std::vector<Triple> triangles = fan(corners);
    flipped += fixture.flipped(triangles, positions).empty() ? 0 : 1;
    refillAll(fixture, positions, triangles);
    CHECK(fixture.flipped(triangles, positions).empty());

    triangles = fan(corners);
    const std::vector<Point3> before = positions;
    InvertedSearch search(fixture.near);
    PlacedVertices placed;
    placed.positions = before;
    CHECK(repairMesh({ fixture.problem, fixture.near, before, before, RunControl() },
      MeshSteps::Refill, search, triangles, placed)
            .ok());
    CHECK_EQUAL(placed.edits.inverted, Offset(0));
    refilled += placed.edits.refilled > 0 ? 1 : 0; // told apart from what needs no refilling
    CHECK(bordersOf(triangles) == bordersOf(fan(corners)));
  }
  CHECK(refilled > 50);
  CHECK(flipped > 50);
}

/** Nothing is taken out across a feature, where that would double an edge, or when cancelled. */
void testKept()
{
  Fixture fixture;
  std::vector<Point3> positions = fixture.result.placement.positions;
  const Point3 corners[] = { { 0.2, 0.2, 0.0 }, { 0.8, 0.2, 0.0 }, { 0.5, 0.4, 0.0 },
    { 0.5, 0.9, 0.0 } };
  std::copy(std::begin(corners), std::end(corners), positions.begin());
  // The first triangle is turned over by vertex 2, which is on the wrong side of its edge to 1.
  const std::vector<Triple> bent{ { 0, 2, 1 }, { 0, 1, 3 } };
  const std::vector<Triple> doubled{ { 0, 2, 1 }, { 0, 1, 3 }, { 2, 3, 4 }, { 3, 2, 5 } };
  positions[4] = Point3(0.9, 0.6, 0.0);
  positions[5] = Point3(0.1, 0.6, 0.0);

  std::vector<Triple> triangles = bent;
  CHECK(refillAll(fixture, positions, triangles) == 1);
  CHECK(fixture.flipped(triangles, positions).empty());

  triangles = doubled;
  CHECK(refillAll(fixture, positions, triangles) == 0);
  CHECK(triangles == doubled);

  std::vector<Point3> places = positions;
  triangles = bent;
  RepairedMesh mesh(fixture.problem, fixture.near, positions, triangles, places);
  const RunControl cancelled({}, []() { return true; });
  MeshEdits repair;
  CHECK(!refillAround({ fixture.problem, positions, cancelled, true, strayCost }, 0, mesh, repair));
  CHECK(triangles == bent);

  fixture.features.push_back({});
  fixture.features.back().ends = { 0, 1 };
  triangles = bent;
  CHECK(refillAll(fixture, positions, triangles) == 0);
  CHECK(triangles == bent);
}

/** A triangle that is closer to a facet turned the other way changes only if nothing can move. */
void testStrays()
{
  Fixture fixture;
  const double spacing = std::sqrt(test::surfaceArea(fixture.mesh) / 300.0);
  std::vector<Point3> positions = fixture.result.placement.positions;
  for (Point3& place : positions)
  {
    place[2] += 0.1 * spacing;
  }
  int refilled = 0;
  for (Index t = 0; t < 200; t += 10)
  {
    std::vector<Triple> triangles = fixture.result.dual.triangles;
    const auto [a, b, c] = cornersOf(triangles[t], positions);
    const Point3 center = (a + b + c) / 3.0;
    TriangleSoup both = test::gridPatch(40, 40);
    const auto first = static_cast<Offset>(both.points.size());
    for (const Point3& corner : { a, c, b })
    {
      both.points.push_back(center + 0.1 * (corner - center));
    }
    both.triangles.push_back({ first, first + 1, first + 2 });
    both.inputCells.push_back(static_cast<Offset>(both.inputCells.size()));
    const SurfaceMesh sheets = test::meshOf(both);
    const WholeSurface whole(sheets);
    const NearbySurface near(NearbySurface(fixture.problem, RunControl()), whole);
    RepairedMesh mesh(fixture.problem, near, positions, triangles, positions);
    const RepairContext context{ fixture.problem, positions, RunControl(), true, strayCost };
    MeshEdits repair;
    CHECK(mesh.isInverted(triangles[t]) && mesh.cost(triangles[t]) < invertedCost);
    fixture.fixed[triangles[t][1]] = 0;
    CHECK(!refillAround(context, t, mesh, repair));
    CHECK(triangles == fixture.result.dual.triangles);
    fixture.fixed[triangles[t][1]] = 1;
    refilled += refillAround(context, t, mesh, repair) ? 1 : 0;
  }
  CHECK(refilled >= 10); // of 20
}
}

int TestCavityRepair(int, char*[])
{
  testCarriedAway();
  testPolygons();
  testKept();
  testStrays();
  return test::result();
}
