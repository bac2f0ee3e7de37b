// SharedIntegration.h, RankWork.h: the same bits for any number of ranks, what is sent, what fails.

#include "Embedding/SurfacePart.h"
#include "Optimization/Lloyd.h"
#include "Optimization/QuasiNewton.h"
#include "TestEmbeddings.h"
#include "TestSupport.h"
#include "Voronoi/RankWork.h"

#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <new>
#include <queue>
#include <thread>

using namespace remesh;
using namespace remesh::test;

namespace
{
/** What some ranks, which are threads here, send each other. */
class Post
{
public:
  explicit Post(int count)
    : m_count(count)
  {
  }

  int count() const { return m_count; }

  void send(int from, int to, const Packet& packet)
  {
    const std::lock_guard<std::mutex> guard(m_lock);
    m_boxes[{ from, to }].push(packet);
    m_bytes[from] += packet.bytes().size();
    m_arrived.notify_all();
  }

  Packet receive(int from, int to)
  {
    std::unique_lock<std::mutex> guard(m_lock);
    std::queue<Packet>& box = m_boxes[{ from, to }];
    m_arrived.wait(guard, [&] { return !box.empty(); });
    Packet packet = box.front();
    box.pop();
    return packet;
  }

  std::size_t bytesFrom(int rank) { return m_bytes[rank]; }
  bool isEmpty() const
  {
    return std::all_of(
      m_boxes.begin(), m_boxes.end(), [](const auto& box) { return box.second.empty(); });
  }

private:
  int m_count;
  std::mutex m_lock;
  std::condition_variable m_arrived;
  std::map<std::pair<int, int>, std::queue<Packet>> m_boxes;
  std::map<int, std::size_t> m_bytes;
};

class ThreadRanks : public Ranks
{
public:
  ThreadRanks(Post& post, int own)
    : m_post(post)
    , m_own(own)
  {
  }
  int count() const override { return m_post.count(); }
  int own() const override { return m_own; }
  void send(int rank, const Packet& packet) override { m_post.send(m_own, rank, packet); }
  Packet receive(int rank) override { return m_post.receive(rank, m_own); }

private:
  Post& m_post;
  int m_own;
};

/** Runs `work` on the first rank while the others work for it. */
void runOnRanks(Post& post, const std::function<void(Ranks&)>& work,
  const std::function<void(Ranks&)>& others = workForFirst)
{
  std::vector<std::thread> threads;
  for (int rank = 1; rank < post.count(); ++rank)
  {
    threads.emplace_back(
      [&post, &others, rank]
      {
        ThreadRanks ranks(post, rank);
        others(ranks);
      });
  }
  ThreadRanks first(post, 0);
  work(first);
  dismissOthers(first);
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}

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
    Post post(count);
    runOnRanks(post, [&](Ranks& ranks) { checkSame(optimize(surface, start, &ranks), alone); });
    CHECK(post.isEmpty());
  }
}

/** For each evaluation: the sites to each rank, and the sums of its blocks back. */
void testBytes(const EmbeddedSurface& surface)
{
  const Sites sites = sampled(surface, 400, 3);
  const auto sent = [&](int evaluations)
  {
    Post post(2);
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
    return std::make_pair(post.bytesFrom(0), post.bytesFrom(1));
  };
  const auto once = sent(1);
  const auto twice = sent(2);
  constexpr std::size_t head = 64;
  CHECK(twice.first - once.first <= sites.coordinates.size() * sizeof(double) + head);
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
  CHECK(twice.second - once.second <= entries * entry + (blocks.size() + 2) * head);
}

void testFailure(const EmbeddedSurface& surface)
{
  const Sites start = sampled(surface, 100, 3);
  const auto failing = [](Ranks& ranks)
  {
    for (;;)
    {
      Packet packet = ranks.receive(Ranks::first);
      RankOrder order = RankOrder::Leave;
      packet.take(order);
      if (order == RankOrder::Leave)
      {
        return;
      }
      Packet answer;
      answer.add(order == RankOrder::Integrate ? StatusCode::OutOfMemory : StatusCode::Ok);
      answer.add(std::string("There is not enough memory for this run."));
      ranks.send(Ranks::first, answer);
    }
  };
  Post post(3);
  runOnRanks(
    post,
    [&](Ranks& ranks)
    {
      const Optimized result = optimize(surface, start, &ranks);
      CHECK(result.status.code == StatusCode::OutOfMemory);
      CHECK(result.status.message == "Process 1: There is not enough memory for this run.");
    },
    failing);
  CHECK(post.isEmpty());
  // An order that makes no sense is answered.
  Post other(2);
  runOnRanks(other,
    [&](Ranks& ranks)
    {
      Packet order;
      order.add(RankOrder::Integrate);
      ranks.send(1, order);
      Packet answer = ranks.receive(1);
      StatusCode code = StatusCode::Ok;
      answer.take(code);
      CHECK(code == StatusCode::InvalidInput);
    });
}

/** Ranks that have no room for what comes with an order: the `failing`-th, from 0. */
class NarrowRanks : public ThreadRanks
{
public:
  NarrowRanks(Post& post, int own, int failing)
    : ThreadRanks(post, own)
    , m_failing(failing)
  {
  }
  Packet receive(int rank) override
  {
    Packet packet = ThreadRanks::receive(rank);
    if (m_failing-- == 0)
    {
      throw std::bad_alloc();
    }
    return packet;
  }

private:
  int m_failing;
};

/** Without memory for a part, or for sites, the first is told, and no one waits. */
void testNoRoom(const EmbeddedSurface& surface)
{
  const Sites start = sampled(surface, 100, 3);
  for (const int failing : { 0, 1, 3 })
  {
    Post post(3);
    runOnRanks(
      post,
      [&](Ranks& ranks)
      {
        const Status status = optimize(surface, start, &ranks).status;
        CHECK(status.code == StatusCode::OutOfMemory);
        CHECK(status.message == "Process 2: There is not enough memory for this run.");
      },
      [&](Ranks& ranks)
      {
        NarrowRanks narrow(post, ranks.own(), ranks.own() == 2 ? failing : -1);
        workForFirst(narrow);
      });
    CHECK(post.isEmpty());
  }
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
  testBytes(surface);
  testFailure(surface);
  testNoRoom(surface);
  testCancelled(surface);
  testDivision(surface);
  const EmbeddedSurface fine = embedded(meshOf(icosphere(5)), 6);
  testLists(fine);
  testSameBits(fine, 17000); // where only a sample tells when lists are worn
  return result();
}
