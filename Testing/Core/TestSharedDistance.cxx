// SharedDistance.h, MeshDistance.h: the same bits for any number of ranks, what is sent, what
// fails.

#include "Run/MeshDistance.h"
#include "Support/RankTree.h"
#include "TestRankThreads.h"
#include "TestSupport.h"

#include <cstring>

using namespace remesh;
using namespace remesh::test;

namespace
{
/** A surface, and a mesh that is compared with it. */
struct Compared
{
  SurfaceMesh surface;
  RemeshResult result;

  Compared(const TriangleSoup& of, const TriangleSoup& mesh)
    : surface(meshOf(of))
  {
    const SurfaceMesh made = meshOf(mesh);
    this->result.placement.positions = made.points;
    this->result.dual.triangles = made.facetPoints;
  }

  Status measure(Ranks* ranks, const RunControl& control = RunControl())
  {
    return findDistance(this->surface, ranks, control, this->result);
  }

  /** Whether this distance was found, to the bit. */
  bool found(const TwoSidedDistance& expected) const
  {
    return this->result.distance &&
      std::memcmp(&*this->result.distance, &expected, sizeof(expected)) == 0;
  }
};

Compared spheres()
{
  return { icosphere(5), icosphere(3) }; // 20 480 and 1 280 triangles
}

void testSameBits(Compared compared)
{
  CHECK(compared.measure(nullptr).ok());
  CHECK(compared.result.distance);
  const TwoSidedDistance alone = *compared.result.distance;
  CHECK(alone.forward.area > 0.0 && alone.backward.area > 0.0);
  for (const int count : { 1, 2, 3, 4, 7 })
  {
    compared.result.distance.reset();
    Post post(count, eachWaits);
    runOnRanks(post, [&](Ranks& ranks) { CHECK(compared.measure(&ranks).ok()); });
    CHECK(post.isEmpty());
    CHECK(compared.found(alone));
  }
}

/** The mesh handed on, and each triangle of the surface once; sums of blocks back. */
void testBytes(Compared compared)
{
  const std::size_t mesh = 24 * compared.result.placement.positions.size() +
    sizeof(Triple) * compared.result.dual.triangles.size();
  const auto surface = static_cast<std::size_t>(75 * compared.surface.numberOfFacets());
  constexpr std::size_t head = 64;
  for (const int count : { 2, 3, 4, 5, 8 })
  {
    Post post(count);
    runOnRanks(post, [&](Ranks& ranks) { CHECK(compared.measure(&ranks).ok()); });
    const auto times = static_cast<std::size_t>(ceilLog2(count));
    const std::size_t sent = post.bytesFrom(0);
    CHECK(sent >= times * mesh + surface);
    CHECK(sent <= times * (mesh + head) + surface + count * 2 * head);
    CHECK(post.bytesFrom(1) <= 32 * 1024 + head); // the last in the tree: it hands nothing on
  }
}

/**
 * Without memory for the mesh, which is handed on, or for triangles: no one waits, and the first
 * rank measures both ways.
 */
void testNoRoom(Compared compared)
{
  CHECK(compared.measure(nullptr).ok());
  const TwoSidedDistance alone = compared.result.distance.value();
  for (const int failing : { 1, 2 }) // after the word
  {
    compared.result.distance.reset();
    Post post(4, eachWaits);
    runOnRanks(
      post, [&](Ranks& ranks) { CHECK(compared.measure(&ranks).ok()); },
      [&](Ranks& ranks)
      {
        FailingRanks narrow(post, ranks.own(), ranks.own() == 2 ? failing : -1, std::bad_alloc());
        workForFirst(narrow);
      });
    CHECK(post.isEmpty());
    CHECK(compared.found(alone));
  }
}

void testLost(Compared compared)
{
  const auto runWith = [&](const std::string& told, const std::function<void(Ranks&)>& others)
  {
    Post post(4, longOnesWait);
    runOnRanks(
      post,
      [&](Ranks& ranks)
      {
        const Status status = compared.measure(&ranks);
        CHECK(status.code == StatusCode::InvalidInput);
        CHECK_EQUAL(status.message.substr(0, told.size()), told);
      },
      others);
    CHECK(!compared.result.distance);
    return post.isEmpty();
  };
  runWith("Process ", [](Ranks& ranks) { ranks.own() == 2 ? void() : workForFirst(ranks); });
  // A rank that cannot hand on works on: nothing is left on the way to it.
  CHECK(runWith("Process 3 cannot be reached.", workWithoutLast));
}

/** A cancelled run leaves nothing on the way. */
void testCancelled(Compared compared)
{
  Post post(3);
  runOnRanks(post,
    [&](Ranks& ranks)
    {
      const RunControl cancelled(nullptr, [] { return true; });
      CHECK(compared.measure(&ranks, cancelled).code == StatusCode::Cancelled);
      CHECK(!compared.result.distance);
      CHECK(compared.measure(&ranks).ok());
    });
  CHECK(post.isEmpty());
}

/** Where a part cannot be made, that rank gets an empty one, and the others theirs. */
void testNoPart(Compared compared)
{
  Post post(4);
  runOnRanks(post,
    [&](Ranks& ranks)
    {
      bool failed = false;
      try
      {
        OtherRanks others(ranks);
        others.tell(
          RankOrder::TakeSurface, Packet(), [](int) -> Packet { throw std::bad_alloc(); });
      }
      catch (const std::bad_alloc&)
      {
        failed = true;
      }
      CHECK(failed);
      CHECK(compared.measure(&ranks).ok()); // all of them still follow
    });
  CHECK(post.isEmpty());
}
}

int TestSharedDistance(int, char*[])
{
  testSameBits(spheres());
  testSameBits({ gridPatch(1, 1), gridPatch(2, 1) }); // fewer triangles than ranks
  testBytes(spheres());
  testNoRoom(spheres());
  testLost(spheres());
  testCancelled(spheres());
  testNoPart(spheres());
  // Without an area there is no distance, and nobody is asked.
  Compared flat(icosphere(1), icosphere(0));
  std::fill(
    flat.result.placement.positions.begin(), flat.result.placement.positions.end(), Point3::Zero());
  Post post(2);
  runOnRanks(post, [&](Ranks& ranks) { CHECK(flat.measure(&ranks).ok()); });
  CHECK(!flat.result.distance);
  CHECK(post.isEmpty());
  return result();
}
