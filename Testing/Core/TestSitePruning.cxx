// Delaunay/SitePruning: sites added in one spot go to where they are missed; what is needed stays.

#include "Delaunay/SitePruning.h"
#include "TestDuals.h"
#include "TestEmbeddings.h"

#include <numeric>

using namespace remesh;

namespace
{
/** A diagram of a surface, and what is asked of it. */
struct State
{
  test::Computed result;
  test::DualOf made;
  bool holds = false;         ///< the certificate
  std::vector<Index> failing; ///< sites, ascending
  double energy = 0.0;
};

State stateOf(const SurfaceMesh& mesh, const EmbeddedSurface& surface, const Sites& sites)
{
  State state{ test::computed(surface, sites), {}, false, {}, 0.0 };
  state.made = test::dualOf(mesh, surface, state.result);
  Certificate certificate;
  CHECK(certify(surface, state.made.edges, state.result.diagram, state.made.components,
    state.made.dual, nullptr, RunControl(), certificate)
          .ok());
  std::set<Index> failing;
  const auto add = [&](Index component) { failing.insert(state.made.components.sites[component]); };
  for (const Index cell : certificate.cells)
  {
    add(cell);
  }
  for (const auto& [a, b] : certificate.edges)
  {
    add(a);
    add(b);
  }
  for (const Triple& vertex : certificate.vertices)
  {
    for (const Index component : vertex)
    {
      add(component);
    }
  }
  state.holds = certificate.holds();
  state.failing.assign(failing.begin(), failing.end());
  state.energy =
    std::accumulate(state.result.sums.energy.begin(), state.result.sums.energy.end(), 0.0);
  return state;
}

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

/** What is left when there is nothing more to try. */
struct Outcome
{
  Sites sites;
  Index added;
  Offset extraPoints;
  int refused = 0;
  bool allHold = true;
};

Outcome prune(const SurfaceMesh& mesh, const EmbeddedSurface& surface, const Sites& sites,
  Index added, Offset extraPoints)
{
  Outcome outcome{ sites, added, extraPoints };
  State state = stateOf(mesh, surface, sites);
  CHECK(state.holds);
  Offset wanted = state.made.components.count();
  SitePruning pruning;
  CHECK(!pruning.hasTried());
  int rounds = 0;
  while (pruning.choose({ surface, state.result.sites, state.result.diagram },
    state.made.components, state.made.dual,
    { std::make_shared<const Sites>(outcome.sites), outcome.added, state.made.components.count(),
      wanted, outcome.extraPoints }))
  {
    bool isAccepted = false;
    SitePruning::Trial trial;
    while (pruning.isTrying() && ++rounds < 100)
    {
      trial = pruning.next();
      CHECK(trial.sites.count() < outcome.sites.count() + 100);
      CHECK(trial.added < outcome.added);
      state = stateOf(mesh, surface, trial.sites);
      isAccepted = pruning.judge(state.holds, state.failing, state.made.components.count());
      outcome.refused += !isAccepted;
    }
    CHECK(rounds < 100);
    if (!isAccepted)
    {
      CHECK(pruning.next().sites.coordinates == outcome.sites.coordinates);
      CHECK_EQUAL(pruning.next().added, outcome.added);
      CHECK_EQUAL(pruning.next().extraPoints, outcome.extraPoints);
      state = stateOf(mesh, surface, outcome.sites);
      continue;
    }
    wanted -= outcome.extraPoints - trial.extraPoints;
    outcome.allHold = outcome.allHold && state.holds;
    CHECK_EQUAL(state.made.components.count(), wanted);
    outcome.sites = trial.sites;
    outcome.added = trial.added;
    outcome.extraPoints = trial.extraPoints;
  }
  return outcome;
}

/** On a sphere none of them is needed: nearly all go, the extra ones for good. */
void testSphere()
{
  const SurfaceMesh mesh = test::meshOf(test::icosphere(4));
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  const Index added = 100;
  const Sites sites = crowded(surface, 200, added, Point3(0.0, 0.0, 1.0), 0.2);
  const Outcome outcome = prune(mesh, surface, sites, added, 30);
  CHECK(outcome.allHold);
  CHECK_EQUAL(outcome.extraPoints, 0);
  CHECK_EQUAL(outcome.sites.count(), 270);
  CHECK(outcome.added < added / 4);
  CHECK(stateOf(mesh, surface, outcome.sites).energy < 0.8 * stateOf(mesh, surface, sites).energy);
  // Those that were there before stay where they are.
  CHECK(std::equal(
    sites.coordinates.begin(), sites.coordinates.begin() + 600, outcome.sites.coordinates.begin()));
}

/** Around the hole of a torus some are needed: they stay, and the mesh keeps the hole. */
void testNarrowHole()
{
  const SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.95, 120, 60));
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  const Index added = 300;
  const Sites sites = crowded(surface, 300, added, Point3(0.0, 0.0, 0.0), 0.5);
  const Outcome outcome = prune(mesh, surface, sites, added, 0);
  CHECK(outcome.allHold);
  CHECK(outcome.refused > 0);
  CHECK_EQUAL(outcome.sites.count(), sites.count());
  CHECK(outcome.added > 0);
  CHECK(outcome.added < added / 2);
  CHECK_EQUAL(stateOf(mesh, surface, outcome.sites).made.dual.eulerCharacteristic, 0);
}

/** Few sites are not worth it, nor are those that are as large as others. */
void testNothingToDo()
{
  const SurfaceMesh mesh = test::meshOf(test::icosphere(4));
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  for (const auto& [added, isCrowded] : { std::pair(2, true), std::pair(100, false) })
  {
    const Sites sites = isCrowded ? crowded(surface, 300, added, Point3(0.0, 0.0, 1.0), 0.05)
                                  : test::sampled(surface, 300, 3, SamplingMethod::Stratified);
    const State state = stateOf(mesh, surface, sites);
    SitePruning pruning;
    CHECK(!pruning.choose({ surface, state.result.sites, state.result.diagram },
      state.made.components, state.made.dual,
      { std::make_shared<const Sites>(sites), added, state.made.components.count(),
        state.made.components.count(), 0 }));
    CHECK(!pruning.isTrying());
    CHECK(!pruning.hasTried());
  }
}

/** More than there are free sites may be said to be added: fixed ones stay the first all the same.
 */
void testFixed()
{
  const SurfaceMesh mesh = test::meshOf(test::icosphere(4));
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  Sites sites = crowded(surface, 200, 100, Point3(0.0, 0.0, 1.0), 0.2);
  sites.fixed = 50;
  const State state = stateOf(mesh, surface, sites);
  const Offset count = state.made.components.count();
  SitePruning pruning;
  CHECK(pruning.choose({ surface, sites, state.result.diagram }, state.made.components,
    state.made.dual, { std::make_shared<const Sites>(sites), 1000, count, count, 0 }));
  const SitePruning::Trial trial = pruning.next();
  CHECK_EQUAL(trial.sites.fixed, 50);
  CHECK_EQUAL(trial.sites.count(), sites.count());
  CHECK(std::equal(
    sites.coordinates.begin(), sites.coordinates.begin() + 150, trial.sites.coordinates.begin()));
  // Where the certificate fails and nobody can be blamed, all come back.
  CHECK(!pruning.judge(false, {}, count));
  CHECK(!pruning.isTrying());
  CHECK(pruning.next().sites.coordinates == sites.coordinates);
}

/** Where there are too many vertices at first, and no others come, fewer will do. */
void testNumberOff()
{
  const SurfaceMesh mesh = test::meshOf(test::icosphere(4));
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  const Sites sites = crowded(surface, 200, 100, Point3(0.0, 0.0, 1.0), 0.2);
  const State state = stateOf(mesh, surface, sites);
  const Offset count = state.made.components.count();
  SitePruning pruning;
  CHECK(pruning.choose({ surface, sites, state.result.diagram }, state.made.components,
    state.made.dual, { std::make_shared<const Sites>(sites), 100, count, count - 200, 0 }));
  const Sites fewer = pruning.next().sites;
  CHECK(fewer.count() < sites.count());
  CHECK(pruning.judge(true, {}, fewer.count()));
  CHECK(!pruning.isTrying());
}
}

int TestSitePruning(int, char*[])
{
  testSphere();
  testNarrowHole();
  testNothingToDo();
  testFixed();
  testNumberOff();
  return test::result();
}
