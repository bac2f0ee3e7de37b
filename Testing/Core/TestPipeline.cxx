// Triangles and options to a mesh, without VTK: for a number, for a distance, from given sites, and
// with normals that are smoothed after all.

#include "TestCancels.h"
#include "TestRequests.h"

#include "Mesh/Extent.h"
#include "Mesh/NormalFlow.h"

#include <cmath>

using namespace remesh;

namespace
{
void testNumber()
{
  const TriangleSoup soup = test::torus(1.0, 0.4, 60, 30);
  int reads = 0;
  const RunRequest request = test::requestOf(soup, 400, &reads);
  const RunOutcome outcome = test::outcomeOf(request);
  CHECK_EQUAL(reads, 1);
  CHECK_EQUAL(outcome.result.components.count(), 400);
  CHECK(outcome.result.topology.preserved());
  CHECK_EQUAL(outcome.result.topology.mesh.eulerCharacteristic, 0);
  CHECK_EQUAL(outcome.prepared.surface.dimension, 6);
  CHECK(outcome.prepared.warnings.empty());
  CHECK(outcome.result.distance && outcome.result.distance->rms() < 0.02);
  for (const Schedule schedule : { Schedule::ShuffledBlocks, Schedule::EightThreads })
  {
    RunControl control;
    control.schedule = schedule;
    RunOutcome again;
    CHECK(makeMesh(request, control, again).ok());
    CHECK(again.result.placement.positions == outcome.result.placement.positions);
    CHECK(again.result.dual.triangles == outcome.result.dual.triangles);
  }
}

/** Creases are kept: each edge of the mesh is on one side of the cube. */
void testFeatures()
{
  const TriangleSoup soup = test::cube();
  RunRequest request = test::requestOf(soup, 200);
  request.preparation.preserveFeatures = true;
  request.options.exactNumber = true;
  const RunOutcome outcome = test::outcomeOf(request);
  CHECK_EQUAL(outcome.result.components.count(), 200);
  CHECK_EQUAL(outcome.prepared.features->numberOfPatches, 6);
  CHECK(outcome.result.distance->maximum() < 1e-6);
}

/** Its bound, as it is measured: with so many points as that takes, or told where it cannot be. */
void testTolerance()
{
  TriangleSoup soup = test::icosphere(3);
  for (Point3& point : soup.points)
  {
    point[2] *= 0.5;
  }
  RunRequest request = test::requestOf(soup, 0);
  request.tolerance.tolerance = 0.005;
  const RunOutcome kept = test::outcomeOf(request);
  const double limit = 0.005 * boundingBoxDiagonal(soup.points);
  CHECK(kept.result.distance->maximumBound() <= limit);
  CHECK(kept.prepared.warnings.empty());

  request.tolerance = { limit, true }; // the same in the unit of the points
  const RunOutcome absolute = test::outcomeOf(request);
  CHECK(absolute.result.placement.positions == kept.result.placement.positions);

  request.tolerance.maxPoints = kept.result.components.count() / 3;
  const RunOutcome limited = test::outcomeOf(request);
  CHECK(limited.result.components.count() <= request.tolerance.maxPoints);
  CHECK(limited.result.distance->maximumBound() > limit);
  CHECK_EQUAL(limited.prepared.warnings.size(), 1u);

  request.tolerance = { 1e-9 };
  RunOutcome none;
  CHECK(makeMesh(request, RunControl(), none).code == StatusCode::InvalidInput);
}

/** A point for each given site, whatever the number and the tolerance are. */
void testSites()
{
  const TriangleSoup soup = test::torus(1.0, 0.4, 60, 30);
  const TriangleSoup coarse = test::torus(1.0, 0.4, 20, 10);
  const std::vector<double> places = test::positionsOf(coarse);
  int reads = 0;
  RunRequest request = test::requestOf(soup, 1000, &reads);
  request.tolerance.tolerance = 0.001;
  request.sites = GivenSites{ test::arrayOf(places, 3), {} };
  const RunOutcome outcome = test::outcomeOf(request);
  CHECK_EQUAL(reads, 1);
  CHECK_EQUAL(outcome.result.sites.count(), 200);
  CHECK_EQUAL(outcome.given.places.size(), 200u);
  CHECK(outcome.prepared.warnings.empty());
  request.sites->embedding = test::arrayOf(places, 3); // not that of the surface
  const RunOutcome projected = test::outcomeOf(request);
  CHECK_EQUAL(projected.prepared.warnings.size(), 1u);
  CHECK(projected.result.placement.positions == outcome.result.placement.positions);
}

/** Waves along one direction are kept as they are; where cells fall apart, they are smoothed. */
void testSmoothedAfterAll()
{
  const TriangleSoup soup = test::wavyPatch(120, 0.0, 0.0);
  int reads = 0;
  RunRequest request = test::requestOf(soup, 600, &reads);
  request.preparation.anisotropy = 0.1;
  const RunOutcome sharp = test::outcomeOf(request);
  CHECK_EQUAL(reads, 1);
  CHECK_EQUAL(*sharp.prepared.smoothingRadius, 0.0);

  request.options.numberOfSites = 200;
  request.preparation.anisotropy = 0.5;
  reads = 0;
  const RunOutcome smoothed = test::outcomeOf(request);
  CHECK_EQUAL(reads, 2);
  CHECK_EQUAL(*smoothed.prepared.smoothingRadius, smoothingRadius(smoothed.prepared.mesh, 200));

  request.preparation.smoothingRadius = *smoothed.prepared.smoothingRadius;
  reads = 0;
  const RunOutcome given = test::outcomeOf(request);
  CHECK_EQUAL(reads, 1);
  CHECK(given.result.placement.positions == smoothed.result.placement.positions);
  CHECK(given.result.evaluations < smoothed.result.evaluations);
}

/** What a run says before it begins. */
void testErrors()
{
  const TriangleSoup soup = test::icosphere(2);
  RunOutcome outcome;
  RunRequest request = test::requestOf(soup, 1000000);
  request.memory = 1e8;
  CHECK(makeMesh(request, RunControl(), outcome).code == StatusCode::OutOfMemory);
  request.preparation.source.read = [](TriangleSoup&, std::string&)
  { return Status::invalid("It cannot be read."); };
  CHECK_EQUAL(makeMesh(request, RunControl(), outcome).message, std::string("It cannot be read."));
}

/** A run with creases and too few points, one to a tolerance, and one with a metric. */
void testCancelled()
{
  const auto runs = [](const RunRequest& request)
  {
    return [&request](const RunControl& control)
    {
      RunOutcome outcome;
      return makeMesh(request, control, outcome);
    };
  };
  const TriangleSoup cube = test::cube();
  RunRequest creases = test::requestOf(cube, 60);
  creases.preparation.preserveFeatures = true;
  creases.options.exactNumber = true;
  test::checkCancels("creases", runs(creases), 60);

  const TriangleSoup torus = test::torus(1.0, 0.15, 60, 20);
  test::checkCancels("few points", runs(test::requestOf(torus, 40)), 60);

  const TriangleSoup sphere = test::icosphere(3);
  RunRequest tolerance = test::requestOf(sphere, 0);
  tolerance.tolerance.tolerance = 0.01;
  test::checkCancels("tolerance", runs(tolerance), 40);

  const std::vector<double> sizes(sphere.points.size(), 0.2);
  RunRequest metric = test::requestOf(sphere, 200);
  metric.preparation.metric = test::arrayOf(sizes, 1);
  test::checkCancels("metric", runs(metric), 40);
}
}

int TestPipeline(int, char*[])
{
  testNumber();
  testFeatures();
  testTolerance();
  testSites();
  testSmoothedAfterAll();
  testErrors();
  testCancelled();
  return test::result();
}
