// Samples put side by side: all of the surface's, and the same whether they are kept or made anew.

#include "Placement/FitSamples.h"
#include "Placement/SurfaceSamples.h"
#include "TestPlacements.h"
#include "TestSurfaces.h"

#include <cstring>

using namespace remesh;

namespace
{
constexpr int samplesPerVertex = 13;

bool areEqual(const SampleBlock& a, const SampleBlock& b)
{
  return a.begins == b.begins && a.counts == b.counts && a.groups.size() == b.groups.size() &&
    std::memcmp(a.groups.data(), b.groups.data(), a.groups.size() * sizeof(SampleGroup)) == 0;
}

void checkBlock(const PlacementProblem& problem, double unit, Index first, const SampleBlock& block)
{
  CHECK_EQUAL(block.begins.size(), block.counts.size() + 1);
  for (std::size_t v = 0; v < block.counts.size(); ++v)
  {
    const Index vertex = first + static_cast<Index>(v);
    Index count = 0;
    forEachSample(problem, vertex, samplesPerVertex,
      [&](const SurfaceSample& sample)
      {
        const SampleGroup& group = block.groups[block.begins[v] + count / lanes];
        const int lane = count % lanes;
        const Point3 point = problem.components.centroids[vertex] +
          unit * Point3(group.offset[0][lane], group.offset[1][lane], group.offset[2][lane]);
        CHECK((point - sample.point).norm() < 1e-6);
        const Point3 normal(group.normal[0][lane], group.normal[1][lane], group.normal[2][lane]);
        CHECK((normal - sample.normal).norm() < 1e-6);
        CHECK(std::abs(unit * unit * group.weight[lane] - sample.weight) <= 1e-7 * sample.weight);
        ++count;
      });
    CHECK_EQUAL(block.counts[v], count);
    CHECK_EQUAL(block.begins[v + 1] - block.begins[v], (count + lanes - 1) / lanes);
  }
}
}

int TestFitSamples(int, char*[])
{
  SurfaceMesh mesh = test::meshOf(test::icosphere(3));
  const RemeshResult result = test::remeshed(mesh, 0.02, 1500, VertexPlacement::Centroid);
  const EmbeddedSurface surface = test::gaussMapOf(mesh, 0.02);
  const std::vector<char> none;
  const PlacementProblem problem{ mesh, surface, result.sites, result.diagram, result.components,
    result.dual.triangles, none };

  FitSamples kept(problem, samplesPerVertex);
  FitSamples fresh(problem, samplesPerVertex, 0.0);
  CHECK(kept.blocks().count() > 1);
  for (Offset block = 0; block < kept.blocks().count(); ++block)
  {
    SampleBlock scratch;
    const SampleBlock& made = kept.of(block, scratch);
    scratch.clear(); // what is kept lies elsewhere
    checkBlock(problem, kept.unit(), static_cast<Index>(kept.blocks().begin(block)), made);
    CHECK(&kept.of(block, scratch) == &made);
    CHECK(scratch.groups.empty()); // and is not made again
    CHECK(areEqual(made, fresh.of(block, scratch)));
    CHECK(&fresh.of(block, scratch) == &scratch);
    CHECK(areEqual(made, fresh.of(block, scratch)));
  }
  return test::result();
}
