// Repair/ReserveRelease: sites added in one spot go to where they are missed; what is needed stays.

#include "Repair/ReserveRelease.h"
#include "TestDuals.h"
#include "TestEmbeddings.h"

#include <numeric>

using namespace remesh;

namespace
{
/** Sites all over a surface, and the last `added` ones within `radius` of a place on it. */
Sites crowded(
  const EmbeddedSurface& surface, Offset count, Index added, const Point3& place, double radius)
{
  Sites sites = test::sampled(surface, count, 1, SamplingMethod::Stratified);
  const Sites many = test::sampled(surface, 20000, 2);
  Index found = 0;
  for (Index i = 0; i < many.count() && found < added; ++i)
  {
    std::array<double, 3> at{};
    for (int k = 0; k < 3; ++k)
    {
      at[k] = many.site(i)[k] * surface.unit + surface.center[k];
    }
    if ((Point3(at[0], at[1], at[2]) - place).norm() < radius)
    {
      sites.coordinates.insert(sites.coordinates.end(), many.site(i), many.site(i) + 3);
      ++found;
    }
  }
  CHECK_EQUAL(found, added);
  return sites;
}

/** Sites whose last ones are said to be added by repairs, and the run of the one proposal. */
struct Reserve
{
  SurfaceMesh mesh;
  EmbeddedSurface surface;
  RemeshOptions options;
  RemeshResult result;
  Index added = 0;
  Offset extraPoints = 0;

  Reserve(const TriangleSoup& soup)
    : mesh(test::meshOf(soup))
    , surface(test::embedded(mesh, 3))
  {
    this->options.exactNumber = true;
  }

  double energy() const
  {
    return std::accumulate(this->result.sums.energy.begin(), this->result.sums.energy.end(), 0.0);
  }

  /** @param extra of these vertices are beyond those asked for. */
  void release(const Sites& sites, Index numberAdded, Offset extra)
  {
    this->result.sites = sites;
    this->options.numberOfSites = sites.count() - extra;
    const Task task{ this->mesh, this->surface, nullptr, this->options };
    SiteCandidate candidate(task, false, this->result);
    candidate.replaceSites(sites, numberAdded, extra);
    CHECK(candidate.judge(RunControl()).ok());
    CHECK(!candidate.verdict().isUnproven);
    CHECK_EQUAL(candidate.verdict().pointsOff, 0);
    this->before = this->energy();
    SiteTable table;
    table.push_back({ "release reserve", std::make_unique<ReserveRelease>(), 32, 0 });
    CHECK(Improvement<SiteCandidate>(table, candidate).run(RunControl()).ok());
    CHECK(!candidate.verdict().isUnproven);
    CHECK_EQUAL(candidate.verdict().pointsOff, 0);
    this->added = candidate.added();
    this->extraPoints = candidate.extraPoints();
  }

  double before = 0.0; ///< energy
};

/** On a sphere none of them is needed: nearly all go, the extra ones for good. */
void testSphere()
{
  Reserve reserve(test::icosphere(4));
  const Index added = 100;
  const Sites sites = crowded(reserve.surface, 200, added, Point3(0.0, 0.0, 1.0), 0.2);
  reserve.release(sites, added, 30);
  CHECK_EQUAL(reserve.extraPoints, 0);
  CHECK_EQUAL(reserve.result.sites.count(), 270);
  CHECK(reserve.added < added / 4);
  CHECK(reserve.energy() < 0.8 * reserve.before);
  // Those that were there before stay where they are.
  CHECK(std::equal(sites.coordinates.begin(), sites.coordinates.begin() + 600,
    reserve.result.sites.coordinates.begin()));
}

/** Around the hole of a torus some are needed: they stay, and the mesh keeps the hole. */
void testNarrowHole()
{
  Reserve reserve(test::torus(1.0, 0.95, 120, 60));
  const Index added = 300;
  const Sites sites = crowded(reserve.surface, 300, added, Point3(0.0, 0.0, 0.0), 0.5);
  reserve.release(sites, added, 0);
  CHECK_EQUAL(reserve.result.sites.count(), sites.count());
  CHECK(reserve.added > 0);
  CHECK(reserve.added < added / 2);
  CHECK_EQUAL(reserve.result.dual.eulerCharacteristic, 0);
}

/** Few sites are not worth it, nor are those that are as large as others. */
void testNothingToDo()
{
  for (const auto& [added, isCrowded] : { std::pair(2, true), std::pair(100, false) })
  {
    Reserve reserve(test::icosphere(4));
    const Sites sites = isCrowded
      ? crowded(reserve.surface, 300, added, Point3(0.0, 0.0, 1.0), 0.05)
      : test::sampled(reserve.surface, 300, 3, SamplingMethod::Stratified);
    reserve.release(sites, added, 0);
    CHECK_EQUAL(reserve.added, added);
    CHECK(reserve.result.sites.coordinates == sites.coordinates);
  }
}

/** More than there are free sites may be said to be added: fixed ones stay the first all the same.
 */
void testFixed()
{
  Reserve reserve(test::icosphere(4));
  Sites sites = crowded(reserve.surface, 200, 100, Point3(0.0, 0.0, 1.0), 0.2);
  sites.fixed = 50;
  reserve.release(sites, 1000, 0);
  CHECK_EQUAL(reserve.result.sites.fixed, 50);
  CHECK_EQUAL(reserve.result.sites.count(), sites.count());
  CHECK(reserve.result.sites.coordinates != sites.coordinates);
  CHECK(std::equal(sites.coordinates.begin(), sites.coordinates.begin() + 150,
    reserve.result.sites.coordinates.begin()));
}
}

int TestReserveRelease(int, char*[])
{
  testSphere();
  testNarrowHole();
  testNothingToDo();
  testFixed();
  return test::result();
}
