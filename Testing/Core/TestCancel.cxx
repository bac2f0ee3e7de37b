// Remesh: a run stops soon after it is told to; progress only grows, and only the caller reports.

#include "Remesh.h"
#include "TestEmbeddings.h"

#include <atomic>
#include <set>
#include <thread>

using namespace remesh;

namespace
{
/** Sees to it that reports keep their promises. */
struct Listener
{
  std::thread::id caller = std::this_thread::get_id();
  double last = 0.0;
  int reports = 0;
  int falls = 0;
  int outside = 0;
  int strangers = 0;
  std::vector<std::string> phases;

  void hear(double fraction, const char* phase)
  {
    ++this->reports;
    this->falls += fraction < this->last;
    this->outside += !(fraction >= 0.0 && fraction <= 1.0);
    this->strangers += std::this_thread::get_id() != this->caller;
    this->last = fraction;
    if (this->phases.empty() || this->phases.back() != phase)
    {
      this->phases.emplace_back(phase);
    }
  }

  void check() const
  {
    CHECK(this->reports > 0);
    CHECK_EQUAL(this->falls, 0);
    CHECK_EQUAL(this->outside, 0);
    CHECK_EQUAL(this->strangers, 0);
  }
};

RemeshOptions shortRun()
{
  RemeshOptions options;
  options.numberOfSites = 150;
  options.lloydIterations = 2;
  options.quasiNewton.iterations = 3;
  return options;
}

/** A run that is told to stop when it asks for the k-th time; returns how often it asked. */
int runUntil(const SurfaceMesh& mesh, const EmbeddedSurface& surface, const RemeshOptions& options,
  Schedule schedule, int k, StatusCode expected)
{
  Listener listener;
  std::atomic<int> asked(0);
  RunControl control([&](double fraction, const char* phase) { listener.hear(fraction, phase); },
    [&]() { return ++asked >= k; });
  control.schedule = schedule;
  RemeshResult result;
  const Status status = remesh::remesh({ mesh, surface, nullptr, options }, control, result);
  CHECK(status.code == expected);
  CHECK_EQUAL(status.message.empty(), status.ok());
  listener.check();
  if (status.ok())
  {
    CHECK_EQUAL(listener.last, 1.0);
    // Each phase comes once.
    const std::set<std::string> distinct(listener.phases.begin(), listener.phases.end());
    CHECK_EQUAL(distinct.size(), listener.phases.size());
    CHECK(distinct.size() >= 4);
  }
  return asked;
}

/** Whenever it is told so, and without asking on and on. */
void testCancel()
{
  const SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.4, 20, 12));
  const EmbeddedSurface surface = test::embedded(mesh, 6);
  for (const Schedule schedule :
    { Schedule::Smp, Schedule::ShuffledBlocks, Schedule::EightThreads })
  {
    const int never = 1000000;
    const int all = runUntil(mesh, surface, shortRun(), schedule, never, StatusCode::Ok);
    CHECK(all > 100);
    for (int k = 1; k <= all; k += 1 + all / 11)
    {
      const int asked = runUntil(mesh, surface, shortRun(), schedule, k, StatusCode::Cancelled);
      CHECK(asked < k + 32); // loops that end before their first block
    }
    runUntil(mesh, surface, shortRun(), schedule, all, StatusCode::Cancelled);
  }
}

/** Nor does a coarse start go on, or report less than what was reached. */
void testCancelCoarseStart()
{
  const SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.4, 20, 12));
  const EmbeddedSurface surface = test::embedded(mesh, 6);
  RemeshOptions options = shortRun();
  options.numberOfSites = 500;
  options.coarseStart = false;
  const int without = runUntil(mesh, surface, options, Schedule::Smp, 1000000, StatusCode::Ok);
  options.coarseStart = true;
  const int all = runUntil(mesh, surface, options, Schedule::Smp, 1000000, StatusCode::Ok);
  CHECK(all > without);
  for (int k = 1; k <= all; k += 1 + all / 31)
  {
    const int asked = runUntil(mesh, surface, options, Schedule::Smp, k, StatusCode::Cancelled);
    CHECK(asked < k + 32);
  }
}

/** Told from outside by another thread, as a user does. */
void testCancelFromOutside()
{
  const SurfaceMesh mesh = test::meshOf(test::icosphere(4));
  const EmbeddedSurface surface = test::embedded(mesh, 6);
  RemeshOptions options;
  options.numberOfSites = 3000;
  options.lloydIterations = 100000;
  std::atomic<bool> stop(false);
  std::atomic<bool> running(false);
  std::thread user(
    [&]()
    {
      while (!running)
      {
        std::this_thread::yield();
      }
      stop = true;
    });
  const RunControl control([&](double, const char* phase)
    { running = running || std::string(phase) != "Sampling"; },
    [&]() { return stop.load(); });
  RemeshResult result;
  CHECK(remesh::remesh({ mesh, surface, nullptr, options }, control, result).code ==
    StatusCode::Cancelled);
  user.join();
}

/** Empty cells cost further diagrams within a step: progress must not go back. */
void testProgressWithEmptyCells()
{
  const SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.4, 20, 12));
  const EmbeddedSurface surface = test::embedded(mesh, 6);
  RemeshOptions options = shortRun();
  options.initialSites = test::sampled(surface, 200, 1);
  for (Index site = 1; site < options.initialSites.count(); ++site)
  {
    std::copy_n(options.initialSites.site(0), 6, options.initialSites.site(site));
  }
  runUntil(mesh, surface, options, Schedule::Smp, 1000000, StatusCode::Ok);
}

/** Thin spikes, where the dual is repaired in further rounds: none sets the progress back. */
void testProgressWithRepairs()
{
  TriangleSoup soup = test::icosphere(5);
  for (Point3& point : soup.points)
  {
    const double angle = std::acos(std::min(1.0, point.cwiseAbs().maxCoeff()));
    point *= 1.0 + 3.0 * std::exp(-std::pow(angle / 0.1, 2.0));
  }
  const SurfaceMesh mesh = test::meshOf(soup);
  const EmbeddedSurface surface = test::embedded(mesh, 3);
  RemeshOptions options = shortRun();
  options.numberOfSites = 800;
  int repaired = 0;
  for (options.seed = 0; options.seed < 3; ++options.seed)
  {
    runUntil(mesh, surface, options, Schedule::Smp, 1000000, StatusCode::Ok);
    RemeshResult result;
    CHECK(remesh::remesh({ mesh, surface, nullptr, options }, RunControl(), result).ok());
    repaired += result.movedSites > 0;
  }
  CHECK(repaired > 0);
}
}

int TestCancel(int, char*[])
{
  testCancel();
  testCancelCoarseStart();
  testCancelFromOutside();
  testProgressWithEmptyCells();
  testProgressWithRepairs();
  return test::result();
}
