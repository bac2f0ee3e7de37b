// Flipped triangles: vertices that have changed places, and triangles without a height.
#include "Placement/TriangleShape.h"
#include "Repair/MeshRepair.h"
#include "Repair/Untangling.h"
#include "Support/Random.h"
#include "TestPlacements.h"

#include <algorithm>
#include <set>
#include <utility>

namespace
{
using namespace remesh;

SurfaceMesh torus()
{
  return test::meshOf(test::torus(1.0, 0.3, 60, 25));
}

/** A part of a plane whose points are on it but for rounding. */
SurfaceMesh tiltedPlane()
{
  TriangleSoup soup = test::gridPatch(40, 40);
  const Point3 u = Point3(2.0, 1.0, -1.5).normalized();
  const Point3 v = u.cross(Point3(0.3, 1.0, 0.2)).normalized();
  for (Point3& point : soup.points)
  {
    point = point[0] * u + point[1] * v;
  }
  return test::meshOf(soup);
}

/** A mesh whose vertices a test may misplace. */
struct Fixture
{
  explicit Fixture(const SurfaceMesh& surfaceMesh = torus())
    : mesh(surfaceMesh)
  {
  }

  SurfaceMesh mesh;
  EmbeddedSurface surface = test::gaussMapOf(mesh, 0.05);
  RemeshResult result = test::remeshed(mesh, 0.05, 300, VertexPlacement::Centroid);
  std::vector<char> fixed = std::vector<char>(result.placement.positions.size(), 0);
  PlacementProblem problem{ mesh, surface, result.sites, result.diagram, result.components,
    result.dual.triangles, fixed };
  NearbySurface near{ problem, RunControl() };

  std::vector<Index> flipped(const std::vector<Point3>& positions) const
  {
    std::vector<Index> found;
    CHECK(InvertedSearch(near).find(result.dual.triangles, positions, RunControl(), found).ok());
    return found;
  }
};

/** Two neighbours that have changed places: neither can get back as long as the other stays. */
void testSwapped(const SurfaceMesh& surfaceMesh)
{
  const Fixture fixture(surfaceMesh);
  const std::vector<Point3> sound = fixture.result.placement.positions;
  CHECK(fixture.flipped(sound).empty());
  int mended = 0;
  for (Index t = 0; t < 200; t += 10)
  {
    std::vector<Triple> triangles = fixture.result.dual.triangles;
    std::vector<Point3> positions = sound;
    const auto& [a, b, c] = triangles[t];
    std::swap(positions[a], positions[b]);
    CHECK(!fixture.flipped(positions).empty());
    const std::vector<Point3> swapped = positions;
    RepairedMesh mesh(fixture.problem, fixture.near, sound, triangles, positions);
    const Offset moved = untangle(fixture.near, t, 2, RunControl(), mesh);
    CHECK_EQUAL(moved > 0, positions != swapped);
    CHECK(moved == 0 || fixture.flipped(positions).empty());
    for (const Point3& place : positions)
    {
      CHECK(test::distanceTo(fixture.mesh.facetPoints, fixture.mesh.points, place) < 0.02);
    }
    mended += moved > 0 ? 1 : 0;
  }
  CHECK(mended >= 18); // of 20
}

/** Edges that were turned on the way, and need not be any more, are those of the dual again. */
void testTurnedBack()
{
  Fixture fixture;
  const std::vector<Triple>& dual = fixture.result.dual.triangles;
  const std::vector<Point3>& sound = fixture.result.placement.positions;
  std::set<std::pair<Index, Index>> edges;
  for (const Triple& triangle : dual)
  {
    for (int k = 0; k < 3; ++k)
    {
      edges.insert(std::minmax(triangle[k], triangle[(k + 1) % 3]));
    }
  }
  const double spacing = std::sqrt(test::surfaceArea(fixture.mesh) / 300.0);
  Offset turned = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed)
  {
    // Some of the misplaced vertices must stay: only turned edges are of use there.
    std::vector<Triple> triangles = dual;
    PlacedVertices placed;
    std::vector<Point3>& positions = placed.positions;
    positions = sound;
    for (std::size_t v = 0; v < positions.size(); ++v)
    {
      fixture.fixed[v] = uniform01(seed, v, 0) < 0.3 ? 1 : 0;
      for (int k = 0; k < 3; ++k)
      {
        positions[v][k] += 1.6 * spacing * (uniform01(seed, v, k + 1) - 0.5);
      }
    }
    InvertedSearch search(fixture.near);
    CHECK(repairMesh({ fixture.problem, fixture.near, sound, sound, RunControl() },
      MeshSteps::MoveAndFlip, search, triangles, placed)
            .ok());
    std::vector<Index> left;
    CHECK(search.find(triangles, positions, RunControl(), left).ok()); // judges what has changed
    std::vector<Index> all;
    CHECK(InvertedSearch(fixture.near).find(triangles, positions, RunControl(), all).ok());
    CHECK(left == all);
    CHECK_EQUAL(static_cast<Offset>(all.size()), placed.edits.inverted);
    RepairedMesh mesh(fixture.problem, fixture.near, sound, triangles, positions);
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      const Triple triangle = triangles[t];
      for (int k = 0; k < 3; ++k)
      {
        if (edges.count(std::minmax(triangle[(k + 1) % 3], triangle[(k + 2) % 3])) > 0)
        {
          continue;
        }
        ++turned;
        RepairedMesh::EdgeFlip turn;
        CHECK(!(mesh.canFlip(static_cast<Index>(t), k, turn) &&
          edges.count(std::minmax(turn.fresh[0][0], turn.fresh[0][2])) > 0 &&
          !mesh.isInverted(turn.fresh[0]) && !mesh.isInverted(turn.fresh[1])));
      }
    }
  }
  CHECK(turned > 20); // some are needed
}

/** Where triangles stay flipped as they were, nothing else has moved or turned in vain. */
void testUndone()
{
  Fixture fixture;
  const std::vector<Point3>& sound = fixture.result.placement.positions;
  const std::vector<Triple>& dual = fixture.result.dual.triangles;
  int hopeless = 0;
  for (std::size_t t = 0; t < dual.size(); t += 20)
  {
    std::vector<Triple> triangles = dual;
    PlacedVertices placed;
    std::vector<Point3>& positions = placed.positions;
    positions = sound;
    std::fill(fixture.fixed.begin(), fixture.fixed.end(), 0);
    const auto& [a, b, c] = triangles[t];
    for (const Index corner : { a, b, c })
    {
      fixture.fixed[corner] = 1;
    }
    positions[a] += 2.2 * (0.5 * (sound[b] + sound[c]) - sound[a]); // beyond the other side
    const std::vector<Point3> before = positions;
    const auto flipped = static_cast<Offset>(fixture.flipped(positions).size());
    CHECK(flipped > 0);
    InvertedSearch search(fixture.near);
    CHECK(repairMesh({ fixture.problem, fixture.near, sound, sound, RunControl() },
      MeshSteps::MoveAndFlip, search, triangles, placed)
            .ok());
    if (placed.edits.inverted == flipped)
    {
      CHECK(positions == before);
      CHECK(triangles == dual);
      ++hopeless;
    }
  }
  CHECK(hopeless > 0);
}

/** Where far too much is flipped, no edges are turned: that would take long, and help little. */
void testTooMany()
{
  Fixture fixture;
  std::vector<Triple> triangles = fixture.result.dual.triangles;
  PlacedVertices placed;
  std::vector<Point3>& positions = placed.positions;
  positions = fixture.result.placement.positions;
  for (std::size_t v = 0; v < positions.size(); ++v)
  {
    fixture.fixed[v] = 1;
    for (int k = 0; k < 3; ++k)
    {
      positions[v][k] += uniform01(4, v, k) - 0.5;
    }
  }
  const auto count = static_cast<Offset>(triangles.size());
  CHECK(static_cast<Offset>(fixture.flipped(positions).size()) > maxInverted(count));
  const std::vector<Point3> before = positions;
  InvertedSearch search(fixture.near);
  CHECK(repairMesh({ fixture.problem, fixture.near, before, before, RunControl() },
    MeshSteps::MoveAndFlip, search, triangles, placed)
          .ok());
  CHECK_EQUAL(placed.edits.flippedEdges, 0);
  CHECK(triangles == fixture.result.dual.triangles);
}

/** Fixed vertices stay; without any other, nothing happens. */
void testFixed()
{
  Fixture fixture;
  std::vector<Triple> triangles = fixture.result.dual.triangles;
  std::vector<Point3> positions = fixture.result.placement.positions;
  const auto& [a, b, c] = triangles.front();
  std::swap(positions[a], positions[b]);
  const std::vector<Point3> before = positions;
  fixture.fixed[a] = 1;
  {
    RepairedMesh mesh(fixture.problem, fixture.near, before, triangles, positions);
    untangle(fixture.near, 0, 2, RunControl(), mesh);
    CHECK(positions[a] == before[a]);
  }
  fixture.fixed.assign(fixture.fixed.size(), 1);
  positions = before;
  RepairedMesh mesh(fixture.problem, fixture.near, before, triangles, positions);
  CHECK_EQUAL(untangle(fixture.near, 0, 3, RunControl(), mesh), 0);
  CHECK(positions == before);
}

/** A triangle whose corners are collinear but for rounding has no normal. */
void testFlat()
{
  const Fixture fixture;
  const Triple& triangle = fixture.result.dual.triangles.front();
  Corners corners = cornersOf(triangle, fixture.result.placement.positions);
  const NearbySurface strict(fixture.problem, RunControl(), minHeight(fixture.mesh));
  CHECK(!strict.isInverted(triangle, corners));
  const Point3 height = corners[2] - 0.5 * (corners[0] + corners[1]);
  for (const double share : { 1e-3, 1e-8 })
  {
    corners[2] = 0.5 * (corners[0] + corners[1]) + share * height;
    CHECK(!fixture.near.isInverted(triangle, corners));
    CHECK_EQUAL(strict.isInverted(triangle, corners), share < 1e-6);
  }
}
}

int TestUntangling(int, char*[])
{
  testSwapped(torus());
  testSwapped(tiltedPlane());
  testTurnedBack();
  testTooMany();
  testUndone();
  testFixed();
  testFlat();
  return test::result();
}
