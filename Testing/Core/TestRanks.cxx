// SharedIntegration.h, RankWork.h: the same bits for any number of ranks, what is sent, what fails.

#include "Embedding/SurfacePart.h"
#include "Optimization/Lloyd.h"
#include "Optimization/QuasiNewton.h"
#include "Support/RankTree.h"
#include "TestEmbeddings.h"
#include "TestRankThreads.h"
#include "TestSupport.h"

#include <new>

using namespace remesh;
using namespace remesh::test;

namespace
{
struct Optimized
{
  Sites sites;
  CellSums sums;
  Status status;
};

Optimized optimize(const EmbeddedSurface& surface, const Sites& start, Ranks* ranks)
{
  Optimized result{ start, {}, {} };
  RestrictedVoronoi voronoi(surface);
  voronoi.divideAmong(ranks);
  Convergence convergence;
  Index emptyCells = 0;
  result.status = relaxLloyd(
    { voronoi, surface, 0, result.sites, result.sums, convergence, emptyCells }, 2, RunControl());
  if (result.status.ok())
  {
    QuasiNewtonOptions options;
    options.iterations = 5;
    result.status = minimizeQuasiNewton(
      { voronoi, surface, 0, result.sites, result.sums, convergence, emptyCells }, options,
      RunControl());
  }
  return result;
}

void checkSame(const Optimized& found, const Optimized& expected)
{
  CHECK(found.status.ok());
  CHECK(found.sites.coordinates == expected.sites.coordinates);
  CHECK(found.sums.mass == expected.sums.mass);
  CHECK(found.sums.moment == expected.sums.moment);
  CHECK(found.sums.totalEnergy == expected.sums.totalEnergy);
}

void testSameBits(const EmbeddedSurface& surface, Index numberOfSites)
{
  const Sites start = sampled(surface, numberOfSites, 3);
  const Optimized alone = optimize(surface, start, nullptr);
  CHECK(alone.status.ok());
  for (const int count : { 1, 2, 3, 5 })
  {
    Post post(count, eachWaits);
    runOnRanks(post, [&](Ranks& ranks) { checkSame(optimize(surface, start, &ranks), alone); });
    CHECK(post.isEmpty());
  }
}

/** All hear once, from a rank that has heard before, after ceil(log2 p) sendings at most. */
void testTree()
{
  for (int count = 1; count < 70; ++count)
  {
    std::vector<int> sendings(static_cast<std::size_t>(count), -1); // until a rank has heard
    sendings[0] = 0;
    for (int rank = 0; rank < count; ++rank)
    {
      int after = sendings[rank];
      CHECK(after >= 0);
      for (const int hearer : hearersOf(rank, count))
      {
        CHECK(hearer > rank && hearer < count && sendings[hearer] == -1);
        sendings[hearer] = ++after;
      }
    }
    CHECK_EQUAL(static_cast<int>(hearersOf(0, count).size()), ceilLog2(count));
    CHECK_EQUAL(*std::max_element(sendings.begin(), sendings.end()), ceilLog2(count));
  }
}

/** What each rank sends for an evaluation. */
std::vector<std::size_t> sentForOne(
  const EmbeddedSurface& surface, const Sites& sites, const int count)
{
  const auto sent = [&](int evaluations)
  {
    Post post(count);
    runOnRanks(post,
      [&](Ranks& ranks)
      {
        RestrictedVoronoi voronoi(surface);
        voronoi.divideAmong(&ranks);
        CellSums sums;
        for (int k = 0; k < evaluations; ++k)
        {
          CHECK(voronoi.integrate(sites, RunControl(), sums).ok());
        }
      });
    std::vector<std::size_t> bytes;
    for (int rank = 0; rank < count; ++rank)
    {
      bytes.push_back(post.bytesFrom(rank));
    }
    return bytes;
  };
  std::vector<std::size_t> sums = sent(2);
  const std::vector<std::size_t> once = sent(1);
  std::transform(sums.begin(), sums.end(), once.begin(), sums.begin(), std::minus<>());
  return sums;
}

/** For each evaluation: the sites to all, handed on, and the sums of blocks back. */
void testBytes(const EmbeddedSurface& surface)
{
  const Sites sites = sampled(surface, 400, 3);
  const std::size_t size = sites.coordinates.size() * sizeof(double);
  constexpr std::size_t head = 64;
  for (const int count : { 2, 3, 4, 5, 8, 9 })
  {
    const std::size_t first = sentForOne(surface, sites, count)[0];
    const auto times = static_cast<std::size_t>(ceilLog2(count));
    CHECK(first >= times * size);
    CHECK(first <= times * (size + head));
  }
  // A block meets the sites of its own facets alone.
  RestrictedVoronoi voronoi(surface);
  std::vector<BlockSums> blocks;
  CHECK(voronoi.integrateBlocks(sites, facetBlocks(surface).length, RunControl(), blocks).ok());
  std::size_t entries = 0;
  for (std::size_t k = blocks.size() / 2; k < blocks.size(); ++k)
  {
    entries += blocks[k].sites.size();
  }
  const std::size_t entry = sizeof(Index) + 8 * sizeof(double); // of six dimensions
  CHECK(sentForOne(surface, sites, 2)[1] <= entries * entry + (blocks.size() + 2) * head);
}

/** An optimisation on ranks of which one fails; what the first is told. */
Status failedRun(
  const EmbeddedSurface& surface, Post& post, const std::function<void(Ranks&)>& others)
{
  Status status;
  runOnRanks(
    post,
    [&](Ranks& ranks) { status = optimize(surface, sampled(surface, 100, 3), &ranks).status; },
    others);
  return status;
}

void testFailure(const EmbeddedSurface& surface)
{
  const auto failing = [](Ranks& ranks)
  {
    for (;;)
    {
      Packet packet = hear(ranks);
      RankOrder order = RankOrder::Leave;
      packet.take(order);
      if (order == RankOrder::Leave)
      {
        return;
      }
      order == RankOrder::Integrate ? hear(ranks) : ranks.receive(Ranks::first);
      Packet answer;
      answer.add(order == RankOrder::Integrate ? StatusCode::OutOfMemory : StatusCode::Ok);
      answer.add(std::string("There is not enough memory for this run."));
      ranks.send(Ranks::first, answer);
    }
  };
  Post post(3);
  const Status refused = failedRun(surface, post, failing);
  CHECK(refused.code == StatusCode::OutOfMemory);
  CHECK(refused.message == "Process 1: There is not enough memory for this run.");
  CHECK(post.isEmpty());
  // An order that makes no sense is answered.
  Post other(2);
  runOnRanks(other,
    [&](Ranks& ranks)
    {
      OtherRanks others(ranks);
      others.tell(RankOrder::Integrate, Packet(), nullptr);
      Status status;
      others.takeAnswer(status);
      CHECK(status.code == StatusCode::InvalidInput);
    });
}

/** Without memory for a part, or for sites to hand on, the first is told, and no one waits. */
void testNoRoom(const EmbeddedSurface& surface)
{
  for (const int failing : { 1, 3, 5 }) // for a part, sites and later sites
  {
    Post post(4, eachWaits);
    const Status status = failedRun(surface, post,
      [&](Ranks& ranks)
      {
        // There is no room for one packet.
        FailingRanks narrow(post, ranks.own(), ranks.own() == 2 ? failing : -1, std::bad_alloc());
        workForFirst(narrow);
      });
    CHECK(status.code == StatusCode::OutOfMemory);
    CHECK(status.message == "Process 2: There is not enough memory for this run.");
    CHECK(post.isEmpty());
  }
}

/** Where a rank is lost that hands on, the run ends on all others, too. */
void testLost(const EmbeddedSurface& surface)
{
  const auto check = [&](const std::function<void(Ranks&, Post&)>& lost)
  {
    Post post(4, longOnesWait);
    const Status status = failedRun(surface, post,
      [&](Ranks& ranks) { ranks.own() == 2 ? lost(ranks, post) : workForFirst(ranks); });
    CHECK(status.code == StatusCode::InvalidInput);
    CHECK_EQUAL(status.message.substr(0, 8), "Process ");
  };
  check([](Ranks&, Post&) {});
  for (const int heard : { 0, 1, 2, 3, 5 })
  {
    check(
      [&](Ranks& ranks, Post& post)
      {
        const std::runtime_error broken("The line is broken.");
        FailingRanks failing(post, ranks.own(), heard, broken);
        workForFirst(failing);
      });
  }
}

/** A rank that cannot hand on works on: nothing is left on the way to it. */
void testLostHearer(const EmbeddedSurface& surface)
{
  Post post(4, longOnesWait);
  const Status status = failedRun(surface, post, [](Ranks& ranks) { workWithoutLast(ranks); });
  CHECK(status.code == StatusCode::InvalidInput);
  CHECK_EQUAL(status.message, "Process 3 cannot be reached.");
  CHECK(post.isEmpty());
}

/** A rank makes the neighbour lists that its facets ask for, and those of the sample. */
void testLists(const EmbeddedSurface& surface)
{
  constexpr Index n = 33000; // each fourth is in the sample
  Sites sites = sampled(surface, n, 3);
  const Offset half = surface.numberOfFacets() / 2;
  const EmbeddedSurface part = partOf(surface, 0, half);
  RestrictedVoronoi voronoi(part);
  voronoi.beShare(0.5);
  std::vector<BlockSums> blocks;
  for (const double moves : { 0.0, 1e-5, 0.02 }) // with the first lists, the same, and new ones
  {
    sites = shaken(sites, moves, 5);
    CHECK(voronoi.integrateBlocks(sites, half, RunControl(), blocks).ok());
    const Index lists = voronoi.numberOfNeighborLists();
    CHECK(lists >= static_cast<Index>(blocks[0].sites.size()));
    CHECK(lists < 0.68 * n);
  }
}

/** Ranks get facets by the time that they take: fewer where more sites are. */
void testDivision(EmbeddedSurface surface)
{
  const Index half = surface.numberOfFacets() / 2;
  for (Index facet = 0; facet < half; ++facet)
  {
    surface.constants[facet].mass *= 9.0;
  }
  surface.siteMeasure = 0.0;
  for (Index facet = 0; facet < surface.numberOfFacets(); ++facet)
  {
    surface.siteMeasure += surface.siteMeasureOf(facet);
  }
  const auto ownPart = [&](Index sites)
  {
    double part = 0.0;
    Post post(2);
    runOnRanks(post,
      [&](Ranks& ranks)
      {
        part = static_cast<double>(SharedIntegration(ranks, surface, sites).ownBlocks()) /
          static_cast<double>(facetBlocks(surface).count());
      });
    CHECK(post.isEmpty());
    return part;
  };
  CHECK_NEAR(ownPart(1), 0.5, 0.01);
  // Nine tenths of a work that is all for sites are in the first half.
  CHECK_NEAR(ownPart(100000), 0.5 / 1.8, 0.02);
}

/** A cancelled run leaves nothing on the way. */
void testCancelled(const EmbeddedSurface& surface)
{
  const Sites start = sampled(surface, 100, 3);
  Post post(2);
  runOnRanks(post,
    [&](Ranks& ranks)
    {
      RestrictedVoronoi voronoi(surface);
      voronoi.divideAmong(&ranks);
      CellSums sums;
      const RunControl cancelled(nullptr, [] { return true; });
      CHECK(voronoi.integrate(start, cancelled, sums).code == StatusCode::Cancelled);
      CHECK(voronoi.integrate(start, RunControl(), sums).ok());
    });
  CHECK(post.isEmpty());
}
}

int TestRanks(int, char*[])
{
  const EmbeddedSurface surface = embedded(meshOf(icosphere(4)), 6);
  testSameBits(surface, 300);
  testSameBits(embedded(meshOf(icosphere(2)), manyDimensions), 40);
  testSameBits(embedded(meshOf(gridPatch(1, 1)), 3), 4); // fewer facets than ranks
  testTree();
  testBytes(surface);
  testFailure(surface);
  testNoRoom(surface);
  testLost(surface);
  testLostHearer(surface);
  testCancelled(surface);
  testDivision(surface);
  const EmbeddedSurface fine = embedded(meshOf(icosphere(5)), 6);
  testLists(fine);
  testSameBits(fine, 17000); // where only a sample tells when lists are worn
  return result();
}
