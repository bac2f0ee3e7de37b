// Triangles that go through each other: found as by definition, and parted where sheets are thin.
#include "Repair/CrossingRepair.h"
#include "Repair/PartableCrossings.h"
#include "Support/Random.h"
#include "TestPushedBand.h"

#include <atomic>
#include <limits>
#include <utility>

namespace
{
using namespace remesh;
using test::crossingsOf;
using test::PushedBand;

using Pairs = std::vector<std::pair<Index, Index>>;

constexpr Offset noLimit = std::numeric_limits<Offset>::max();

/** A segment through a triangle, next to it, in its plane, and with a common corner. */
void testPairs()
{
  const std::vector<Point3> points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.2, 0.2, -1 },
    { 0.2, 0.2, 1 }, { 3, 3, 1 }, { 0.8, 0.8, -1 }, { 0.8, 0.8, 1 }, { 0.3, 0.3, 0 } };
  const Triple base{ 0, 1, 2 };
  const auto cross = [&](const Triple& other)
  {
    const bool found = areCrossing(base, other, points);
    CHECK_EQUAL(areCrossing(other, base, points), found);
    return found;
  };
  CHECK(cross({ 3, 4, 5 }));
  CHECK(!cross({ 6, 7, 5 }));
  CHECK(!cross({ 8, 5, 7 })); // one corner touches it
  CHECK(cross({ 0, 3, 4 }));
  CHECK(cross({ 0, 6, 7 })); // an edge of the first goes through it
  CHECK(!cross({ 0, 5, 7 }));
  CHECK(!cross({ 0, 1, 4 }));
  CHECK(!cross({ 0, 1, 2 }));
}

/** The tree against all pairs, also after triangles have changed. */
void testSearch()
{
  const TriangleSoup soup = test::torus(1.0, 0.3, 24, 12);
  std::vector<Triple> triangles;
  for (const auto& [a, b, c] : soup.triangles)
  {
    triangles.push_back({ static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(c) });
  }
  std::vector<Point3> positions = soup.points;
  CHECK(crossingsOf(triangles, positions).empty());
  const auto byDefinition = [&]()
  {
    Pairs pairs;
    for (std::size_t a = 0; a < triangles.size(); ++a)
    {
      for (std::size_t b = a + 1; b < triangles.size(); ++b)
      {
        if (areCrossing(triangles[a], triangles[b], positions))
        {
          pairs.emplace_back(static_cast<Index>(a), static_cast<Index>(b));
        }
      }
    }
    return pairs;
  };
  CrossingSearch search(triangles, positions, RunControl());
  for (std::size_t v = 0; v < positions.size(); v += 9)
  {
    positions[v] *= 0.6;
  }
  const Pairs expected = byDefinition();
  CHECK(expected.size() > 20);
  CHECK(crossingsOf(triangles, positions) == expected);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (triangles[t][0] % 9 == 0 || triangles[t][1] % 9 == 0 || triangles[t][2] % 9 == 0)
    {
      search.setChanged(static_cast<Index>(t));
    }
  }
  Pairs found;
  CHECK(search.find(RunControl(), found).ok());
  CHECK(found == expected);
  Offset sum = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    sum += search.count(static_cast<Index>(t));
  }
  CHECK_EQUAL(sum, 2 * static_cast<Offset>(expected.size()));
}

/** Triangles without area go through others, too, before and after they have changed. */
void testWithoutArea()
{
  const std::vector<Triple> triangles{ { 0, 1, 2 }, { 3, 4, 5 }, { 3, 5, 6 }, { 7, 8, 9 } };
  std::vector<Point3> positions{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.2, 0.2, -1 },
    { 0.2, 0.2, -2 }, { 0.2, 0.2, 1 }, { 0.2, 0.2, 3 }, { 4, 0, 0 }, { 5, 0, 0 }, { 4, 1, 0 } };
  const Pairs through{ { 0, 1 }, { 0, 2 } };
  CHECK(crossingsOf(triangles, positions) == through);
  CrossingSearch search(triangles, positions, RunControl());
  CHECK_EQUAL(search.count(0), 0); // as told
  for (int k = 3; k < 7; ++k)
  {
    positions[k] += Point3(4.0, 0.0, 0.0);
  }
  search.setChanged(1);
  search.setChanged(2);
  const Pairs later{ { 1, 3 }, { 2, 3 } };
  Pairs found;
  CHECK(search.find(RunControl(), found).ok());
  CHECK(found == later);
  CHECK_EQUAL(search.count(3), 2);
}

/** Vertices pushed through the other side of a thin sheet come back, and nothing is inverted. */
void testThinBand()
{
  PushedBand band;
  const std::vector<Point3> pushed = band.placed.positions;
  const double far = band.distance();
  std::vector<Point3>& positions = band.placed.positions;
  CrossingSearch search(band.triangles, positions, RunControl());
  RepairedMesh repaired(band.problem, band.near, band.sound, band.triangles, positions);
  MeshEdits edits;
  const RunControl control;
  partCrossings({ band.problem, band.sound, control, true, 0.0 },
    crossingsOf(band.triangles, positions), search, repaired, edits);
  CHECK(edits.movedVertices > 0);
  CHECK(crossingsOf(band.triangles, positions).empty());
  CHECK(band.inverted().empty());
  CHECK(positions[0] == pushed[0]);
  CHECK(band.distance() < far);
}

/** Where the surface goes through itself, no pair is to be parted: two spheres. */
void testCrossingSurface()
{
  TriangleSoup soup = test::icosphere(4);
  test::append(soup, test::icosphere(4), { 0.9, 0.31, 0.17 });
  const SurfaceMesh mesh = test::meshOf(soup);
  const EmbeddedSurface surface = test::gaussMapOf(mesh, 0.02);
  RemeshResult result = test::remeshed(mesh, 0.02, 300, VertexPlacement::Centroid);
  const std::vector<char> none;
  const PlacementProblem problem{ mesh, surface, result.sites, result.diagram, result.components,
    result.dual.triangles, none };
  std::vector<Point3>& positions = result.placement.positions;
  const auto partable = [&]()
  {
    const CrossingSearch search(result.dual.triangles, positions, RunControl());
    Pairs pairs;
    CHECK(findPartable(problem, search, noLimit, RunControl(), pairs).ok());
    return pairs;
  };
  CHECK(crossingsOf(result.dual.triangles, positions).size() > 20);
  const std::size_t before = partable().size();
  CHECK(before < crossingsOf(result.dual.triangles, positions).size() / 10);
  // Far from where they cross, a vertex through its own sphere is to be brought back.
  const auto leftmost = std::min_element(positions.begin(), positions.end(),
    [](const Point3& a, const Point3& b) { return a[0] < b[0]; });
  *leftmost = Point3(0.9, 0.1, 0.1) - *leftmost;
  CHECK(partable().size() > before + 3);
}

/** A torus whose vertices are anywhere near: triangles cross, but the surface does not. */
struct ShakenTorus
{
  SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.3, 60, 25));
  EmbeddedSurface surface = test::gaussMapOf(mesh, 0.05);
  RemeshResult result = test::remeshed(mesh, 0.05, 300, VertexPlacement::Centroid);
  std::vector<char> none;
  PlacementProblem problem{ mesh, surface, result.sites, result.diagram, result.components,
    result.dual.triangles, none };

  ShakenTorus()
  {
    std::vector<Point3>& positions = this->result.placement.positions;
    for (std::size_t v = 0; v < positions.size(); ++v)
    {
      for (int k = 0; k < 3; ++k)
      {
        positions[v][k] += 0.8 * (uniform01(4, v, k) - 0.5);
      }
    }
  }

  /** @param asked counts how often the work could have been cancelled: how much there was. */
  Pairs partable(Offset most, Schedule schedule, int& asked) const
  {
    std::atomic<int> count(0);
    RunControl control(nullptr, [&]() { return ++count < 0; });
    control.schedule = schedule;
    const std::vector<Triple>& triangles = this->result.dual.triangles;
    const CrossingSearch search(triangles, this->result.placement.positions, RunControl());
    Pairs pairs;
    CHECK(findPartable(this->problem, search, most, control, pairs).ok());
    asked = count;
    return pairs;
  }
};

/** Where more pairs can be parted than are of use, the first; others are not even tried. */
void testLimit()
{
  const ShakenTorus torus;
  int askedForAll = 0;
  const Pairs all = torus.partable(noLimit, Schedule::Smp, askedForAll);
  CHECK(all.size() > 1000);
  CHECK(all == crossingsOf(torus.result.dual.triangles, torus.result.placement.positions));
  const auto count = static_cast<Offset>(all.size());
  for (const Schedule schedule :
    { Schedule::Smp, Schedule::ShuffledBlocks, Schedule::EightThreads })
  {
    int asked = 0;
    for (const Offset most : { Offset(0), Offset(127), Offset(128), Offset(300) })
    {
      CHECK(torus.partable(most, schedule, asked) == Pairs(all.begin(), all.begin() + most + 1));
      CHECK(asked < askedForAll);
    }
    CHECK(torus.partable(count - 1, schedule, asked) == all);
    CHECK(torus.partable(count, schedule, asked) == all);
    CHECK_EQUAL(asked, askedForAll);
  }
}
}

int TestCrossings(int, char*[])
{
  testPairs();
  testSearch();
  testWithoutArea();
  testThinBand();
  testCrossingSurface();
  testLimit();
  return test::result();
}
