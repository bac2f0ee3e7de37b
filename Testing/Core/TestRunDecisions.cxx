// What decides between two runs, and how many points the next one has.

#include "Pipeline/NumberRun.h"
#include "Pipeline/ToleranceSearch.h"
#include "TestChecks.h"

using namespace remesh;

namespace
{
/** A mesh of a sphere, with 100 points as asked for, that is as it should be. */
RemeshResult flawless()
{
  RemeshResult result;
  result.wantedVertices = 100;
  result.components.sites.resize(100);
  result.topology.surface.eulerCharacteristic = 2;
  result.topology.surface.components = 1;
  result.topology.mesh = result.topology.surface;
  return result;
}

Verdict verdictOf(const RemeshResult& result)
{
  RemeshOptions options;
  options.numberOfSites = 100;
  options.maximumExtraPoints = 10;
  return verdictOf(result, options);
}

/** Each flaw makes its own entry of the verdict worse, and no other but what follows from it. */
void testVerdicts()
{
  CHECK(verdictOf(flawless()) == Verdict());
  RemeshResult more = flawless();
  more.components.sites.resize(160);
  CHECK_EQUAL(verdictOf(more).pointsOff, 1); // in halves of 100
  CHECK_EQUAL(verdictOf(more).pointsForced, 60);
  RemeshResult fewer = flawless();
  fewer.components.sites.resize(51);
  CHECK_EQUAL(verdictOf(fewer).pointsOff, 0);
  CHECK_EQUAL(verdictOf(fewer).pointsForced, 49);
  RemeshResult allowed = flawless();
  allowed.components.sites.resize(110);
  CHECK_EQUAL(verdictOf(allowed).pointsOff, 0);
  CHECK_EQUAL(verdictOf(allowed).pointsForced, 10);
  RemeshResult lost = flawless();
  lost.topology.mesh.eulerCharacteristic = 0;
  CHECK(verdictOf(lost).isUnproven);
  RemeshResult crossed = flawless();
  crossed.placement.crossings = 2;
  CHECK_EQUAL(verdictOf(crossed).crossings, 2);
  CHECK_EQUAL(verdictOf(lost).faults, 0);
  RemeshResult unproven = flawless();
  unproven.topology.certificate.cells = { 7 };
  CHECK(verdictOf(unproven).isUnproven);
  CHECK_EQUAL(verdictOf(unproven).faults, 1);
  RemeshResult wrong = flawless();
  wrong.placement.edits.inverted = 2;
  wrong.placement.edits.refilled = 4;
  wrong.placement.strays = 3;
  CHECK_EQUAL(verdictOf(wrong).inverted, 2);
  CHECK_EQUAL(verdictOf(wrong).strays, 3);
  CHECK_EQUAL(verdictOf(wrong).refilled, 4);
}

/** The mean distance falls as 1 over the number; features must not take all points. */
void testNumberForTolerance()
{
  const ToleranceRequest request{ 0.01, true, 50000 };
  const auto numberOf = [&](Offset number, double mean, Offset least) {
    return numberForTolerance({ number, mean, least }, request);
  };
  const Offset once = numberOf(2000, 0.01, 0);
  CHECK(once > 2000); // most of the mesh is to be within
  CHECK_EQUAL(numberOf(2000, 0.02, 0), 2 * once);
  CHECK_EQUAL(numberOf(4000, 0.01, 0), 2 * once);
  CHECK(numberOf(2000, 0.01, 30000) > 30000);
  CHECK_EQUAL(numberOf(2000, 1.0, 0), request.maxPoints);
  CHECK_EQUAL(numberOf(2000, 0.0, 0), 4);
}

/** Where the pilot has far too few points, its distance tells nothing. */
void testPilotAfter()
{
  CHECK_EQUAL(pilotAfter(2000, 225000, true), 16000);
  CHECK_EQUAL(pilotAfter(16000, 225000, true), 128000);
  CHECK_EQUAL(pilotAfter(128000, 225000, true), 0);
  CHECK_EQUAL(pilotAfter(2000, 225000, false), 0);
}
}

int TestRunDecisions(int, char*[])
{
  testVerdicts();
  testNumberForTolerance();
  testPilotAfter();
  return test::result();
}
