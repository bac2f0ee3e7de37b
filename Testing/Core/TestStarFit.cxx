// What the samples of a block of cells add to the triangles around their vertices: as found one
// sample and one triangle at a time.

#include "Mesh/ClosestPoint.h"
#include "Mesh/FacetGeometry.h"
#include "Placement/FitSystem.h"
#include "Placement/SurfaceSamples.h"
#include "TestLanes.h"
#include "TestMemory.h"
#include "TestPlacements.h"
#include "TestSurfaces.h"

#include <cstring>
#include <map>

using namespace remesh;

namespace
{
constexpr int samplesPerVertex = 11;

/** Of one vertex, over its triangles: a sample on an edge may count in either. */
struct VertexSums
{
  double weight = 0.0; ///< W b^2
  Point3 slope = Point3::Zero();
};

struct Found
{
  Index triangle = noIndex;
  double b[3];
  bool isAbove = false;
};

/** The nearest triangle right below a sample; else the closest one. */
Found footOf(const SurfaceSample& sample, const VertexStars& stars, Index vertex,
  const PlacementProblem& problem, const std::vector<Point3>& positions)
{
  Found found;
  double nearest = test::infinity;
  for (const bool above : { true, false })
  {
    for (Offset k = stars.begin(vertex); k < stars.end(vertex); ++k)
    {
      const Index t = stars.triangles[k];
      const auto& [i, j, l] = problem.triangles[t];
      const Point3 normal = facetNormal(positions[i], positions[j], positions[l]);
      if (!(normal.dot(sample.normal) > 0.0))
      {
        continue;
      }
      const ClosestPoint closest =
        closestOnTriangle(sample.point, positions[i], positions[j], positions[l]);
      const bool inside = std::min({ closest.b[0], closest.b[1], closest.b[2] }) > 0.0;
      if ((inside || !above) && closest.squared < nearest)
      {
        nearest = closest.squared;
        found = { t, { closest.b[0], closest.b[1], closest.b[2] }, inside };
      }
    }
    if (found.triangle != noIndex)
    {
      return found;
    }
  }
  return found;
}

void checkBlock(const PlacementProblem& problem, const std::vector<Point3>& positions)
{
  const VertexStars stars(problem.triangles, problem.numberOfVertices());
  FitSamples samples(problem, samplesPerVertex);
  const double unit2 = samples.unit() * samples.unit(); // of the weights
  StarFit fit(problem, stars, positions);
  int beside = 0;
  for (Offset block = 0; block < samples.blocks().count(); ++block)
  {
    const auto begin = static_cast<Index>(samples.blocks().begin(block));
    const auto end = static_cast<Index>(samples.blocks().end(block));
    StarBlock sums;
    fit.sum(samples, block, sums);
    std::map<Index, VertexSums> expected;
    for (Index vertex = begin; vertex < end; ++vertex)
    {
      forEachSample(problem, vertex, samplesPerVertex,
        [&](const SurfaceSample& sample)
        {
          const Found foot = footOf(sample, stars, vertex, problem, positions);
          if (foot.triangle == noIndex)
          {
            return;
          }
          beside += !foot.isAbove;
          const Triple& corners = problem.triangles[foot.triangle];
          Point3 place = Point3::Zero();
          for (int k = 0; k < 3; ++k)
          {
            place += foot.b[k] * positions[corners[k]];
          }
          const double residual = sample.normal.dot(sample.point - place);
          for (int k = 0; k < 3; ++k)
          {
            VertexSums& sum = expected[corners[k]];
            sum.weight += sample.weight * foot.b[k] * foot.b[k];
            sum.slope += (sample.weight * foot.b[k] * residual) * sample.normal;
          }
        });
    }
    std::vector<Index> met = sums.triangles;
    std::sort(met.begin(), met.end());
    CHECK(std::adjacent_find(met.begin(), met.end()) == met.end());
    for (std::size_t slot = 0; slot < sums.triangles.size(); ++slot)
    {
      for (int k = 0; k < 3; ++k)
      {
        VertexSums& sum = expected[problem.triangles[sums.triangles[slot]][k]];
        sum.weight -= unit2 * sums.sums[slot].pairs[k][6];
        for (int c = 0; c < 3; ++c)
        {
          sum.slope[c] -= unit2 * sums.sums[slot].slopes[k][c];
        }
      }
    }
    for (const auto& [vertex, rest] : expected)
    {
      CHECK_NEAR(rest.weight, 0.0, 1e-7); // of areas of 1e-2
      CHECK_NEAR(rest.slope.norm(), 0.0, 1e-8);
    }
  }
  CHECK(beside > 10);
}

/** Wherever memory runs out in one block, the sums of the next are those of a fit of its own. */
void checkShortage(const PlacementProblem& problem, const std::vector<Point3>& positions)
{
  const VertexStars stars(problem.triangles, problem.numberOfVertices());
  StarBlock expected;
  FitSamples whole(problem, samplesPerVertex);
  StarFit(problem, stars, positions).sum(whole, 0, expected);
  int shortages = 0;
  for (bool failed = true; failed; ++shortages)
  {
    FitSamples samples(problem, samplesPerVertex);
    StarFit fit(problem, stars, positions);
    StarBlock block;
    failed = false;
    test::allocationsLeft = shortages;
    try
    {
      fit.sum(samples, 0, block);
    }
    catch (const std::bad_alloc&)
    {
      failed = true;
    }
    test::allocationsLeft = test::noShortage;
    StarBlock next;
    fit.sum(samples, 0, next);
    CHECK(next.triangles == expected.triangles);
    CHECK_EQUAL(next.sums.size(), expected.sums.size());
    if (!next.sums.empty() && next.sums.size() == expected.sums.size())
    {
      CHECK(std::memcmp(next.sums.data(), expected.sums.data(),
              next.sums.size() * sizeof(TriangleSums)) == 0);
    }
  }
  CHECK(shortages > 10);
}

template <class T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

/** A system that has been assembled before keeps its memory, and nothing else. */
void checkRounds(const PlacementProblem& problem, const std::vector<Point3>& positions)
{
  const std::vector<Point3>& others = problem.components.centroids;
  const VertexStars stars(problem.triangles, problem.numberOfVertices());
  CellQuadrics planes;
  CellForms cells;
  CHECK(measureCells(problem, RunControl(), planes, cells));
  const FitTask task{ problem, stars, cells };
  FitSamples samples(problem, samplesPerVertex);
  FitSystem once = makeFitSystem(problem);
  FitSystem again = once;
  RunControl shuffled;
  shuffled.schedule = Schedule::ShuffledBlocks;
  const auto assemble = [&](const std::vector<Point3>& places, FitSystem& system)
  { CHECK(assembleFit(task, places, samples, shuffled, system)); };
  CHECK(assembleFit(task, positions, samples, RunControl(), once));
  assemble(others, again);
  CHECK(!again.blockSums.empty());
  const TriangleSums* const memory = again.blockSums.front().sums.data();
  CHECK(!sameBytes(once.vertexBlocks, again.vertexBlocks));
  assemble(positions, again);
  CHECK(memory == again.blockSums.front().sums.data());
  CHECK(sameBytes(once.vertexBlocks, again.vertexBlocks));
  CHECK(sameBytes(once.edgeBlocks, again.edgeBlocks));
  CHECK(sameBytes(once.slopes, again.slopes));
  CHECK(sameBytes(once.weights, again.weights));
  CHECK(sameBytes(once.triangleNormals, again.triangleNormals));
  CHECK(sameBytes(once.errors.squared, again.errors.squared));
  CHECK(sameBytes(once.errors.weights, again.errors.weights));
  CHECK_EQUAL(once.errors.farthest, again.errors.farthest);
}
}

int TestStarFit(int, char*[])
{
  SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.4, 60, 30));
  const RemeshResult result = test::remeshed(mesh, 0.02, 1200, VertexPlacement::Centroid);
  const EmbeddedSurface surface = test::gaussMapOf(mesh, 0.02);
  const std::vector<char> none;
  const PlacementProblem problem{ mesh, surface, result.sites, result.diagram, result.components,
    result.dual.triangles, none };
  // Vertices off their cells' middles, so that some samples lie beside all triangles around them.
  std::vector<Point3> positions = result.components.centroids;
  for (std::size_t v = 0; v < positions.size(); ++v)
  {
    positions[v] += 0.05 * (v % 3 == 0 ? 1.0 : 0.1) * test::randomPoint(1, v);
  }
  checkBlock(problem, positions);
  checkShortage(problem, positions);
  checkRounds(problem, positions);
  return test::result();
}
