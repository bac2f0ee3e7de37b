// The same bytes on all ports for any number of threads and any back-end, run after run; and what
// vtkSMPTools was set to is left alone.

#include "TestBytes.h"

#include "Adaptors/ExecutionScope.h"
#include "Support/Parallel.h"
#include "vtkAnisotropicRemesher.h"
#include "vtkRestrictedVoronoiDiagram.h"

#include "vtkSMPTools.h"

#include <chrono>
#include <iostream>
#include <mutex>
#include <set>
#include <thread>

using namespace remesh;
using namespace remesh::test;

namespace
{
vtkSmartPointer<vtkAnisotropicRemesher> makeFilter(vtkPolyData* input)
{
  auto filter = vtkSmartPointer<vtkAnisotropicRemesher>::New();
  filter->SetInputData(input);
  filter->SetNumberOfPoints(400);
  filter->SetNumberOfLloydIterations(4);
  filter->SetNumberOfNewtonIterations(8);
  return filter;
}

struct Backend
{
  int choice;
  const char* name;
};
const std::vector<Backend> backends = { { vtkAnisotropicRemesher::SMP_SEQUENTIAL, "Sequential" },
  { vtkAnisotropicRemesher::SMP_STDTHREAD, "STDThread" },
  { vtkAnisotropicRemesher::SMP_TBB, "TBB" } };

/** Whether this VTK has the back-end; sets it. */
bool setGlobalBackend(const char* name)
{
  return vtkSMPTools::SetBackend(name) && std::string(vtkSMPTools::GetBackend()) == name;
}

/** How many threads run blocks that are long enough for all to get some. */
std::size_t countThreads(const std::string& backend, int limit)
{
  std::mutex lock;
  std::set<std::thread::id> threads;
  Execution execution{ backend, limit };
  runInScope(execution,
    [&]()
    {
      CHECK(forEachBlock(64, RunControl(),
        [&](Offset)
        {
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
          const std::lock_guard<std::mutex> guard(lock);
          threads.insert(std::this_thread::get_id());
        }));
    });
  return threads.size();
}

/** A limit holds again and again. */
void testLimit()
{
  const std::string before = vtkSMPTools::GetBackend();
  for (const Backend& backend : backends)
  {
    const bool available = setGlobalBackend(backend.name);
    vtkSMPTools::SetBackend(before.c_str());
    for (int run = 0; available && run < 3; ++run)
    {
      CHECK_EQUAL(countThreads(backend.name, 1), std::size_t(1));
    }
  }
}

void testSameBytes(vtkPolyData* input)
{
  const auto reference = makeFilter(input);
  reference->SetSMPBackend(vtkAnisotropicRemesher::SMP_SEQUENTIAL);
  reference->Update();
  const std::vector<Content> expected = contentsOf(reference);
  const std::string before = vtkSMPTools::GetBackend();
  for (const Backend& backend : backends)
  {
    const bool available = setGlobalBackend(backend.name);
    vtkSMPTools::SetBackend(before.c_str());
    for (const int threads : { 1, 2, 8 })
    {
      const auto filter = makeFilter(input);
      filter->SetSMPBackend(backend.choice);
      filter->SetNumberOfThreads(threads);
      Messages messages(filter);
      for (int run = 0; run < 2; ++run)
      {
        messages.clear();
        filter->Modified();
        filter->Update();
        checkSame(contentsOf(filter), expected,
          std::string(backend.name) + " with " + std::to_string(threads) + " threads, run " +
            std::to_string(run));
        // One that is not there is named in a warning, and another is taken.
        CHECK(messages.errors().empty());
        CHECK_EQUAL(messages.warnings().size(), std::size_t(available ? 0 : 1));
        CHECK(available ||
          (!messages.warnings().empty() &&
            messages.warnings()[0].find(backend.name) != std::string::npos));
      }
      std::cout << backend.name << (available ? "" : " (not there)") << ", asked for " << threads
                << " threads: ran " << filter->GetUsedBackend() << " with "
                << filter->GetNumberOfUsedThreads() << "\n";
      if (available)
      {
        CHECK_EQUAL(std::string(filter->GetUsedBackend()), backend.name);
      }
      CHECK(filter->GetNumberOfUsedThreads() >= 1);
    }
  }
}

/** Sites that are put on the surface, some equally far from many places of it. */
void testSameSites(vtkPolyData* input)
{
  std::vector<Point3> places = { Point3::Zero(), ellipsoidCenter() };
  for (const Point3& p : icosphere(2).points)
  {
    places.push_back(ellipsoidCenter() + 0.3 * p);
    places.push_back(ellipsoidCenter() + Point3(0.0, 0.0, p[2]));
  }
  const auto sites = pointsOnly(places);
  std::vector<Content> expected;
  for (const Backend& backend : backends)
  {
    for (const int threads : { 1, 2 })
    {
      vtkNew<vtkRestrictedVoronoiDiagram> diagram;
      diagram->SetInputData(input);
      diagram->SetSitesData(sites);
      diagram->SetSMPBackend(backend.choice);
      diagram->SetNumberOfThreads(threads);
      Messages messages(diagram);
      diagram->Update();
      const std::vector<Content> contents = contentsOf(diagram);
      expected = expected.empty() ? contents : expected;
      checkSame(contents, expected, std::string("sites with ") + backend.name);
    }
  }
}

/** The automatic choice: VTK's current one, but threads where that is sequential. */
void testAutomatic(vtkPolyData* input)
{
  for (const Backend& backend : backends)
  {
    if (setGlobalBackend(backend.name))
    {
      const auto filter = makeFilter(input);
      filter->Update();
      const bool sequential = backend.choice == vtkAnisotropicRemesher::SMP_SEQUENTIAL;
      CHECK_EQUAL(std::string(filter->GetUsedBackend()), sequential ? "STDThread" : backend.name);
    }
  }
}

/** Back-end and threads of the rest of the program are as before, after success and failure. */
void testRestored(vtkPolyData* input)
{
  vtkNew<vtkPolyData> points;
  points->SetPoints(input->GetPoints());
  for (const Backend& global : backends)
  {
    if (!setGlobalBackend(global.name))
    {
      continue;
    }
    vtkSMPTools::Initialize(2);
    const int threads = vtkSMPTools::GetEstimatedNumberOfThreads();
    for (const Backend& own : backends)
    {
      for (vtkPolyData* data : { input, points.Get() })
      {
        const auto filter = makeFilter(data);
        filter->SetNumberOfLloydIterations(0);
        filter->SetNumberOfNewtonIterations(0);
        filter->SetSMPBackend(own.choice);
        filter->SetNumberOfThreads(1);
        Messages messages(filter);
        filter->Update();
        CHECK_EQUAL(messages.errors().empty(), data == input);
        CHECK_EQUAL(std::string(vtkSMPTools::GetBackend()), global.name);
        CHECK_EQUAL(vtkSMPTools::GetEstimatedNumberOfThreads(), threads);
      }
    }
    vtkSMPTools::Initialize();
  }
}
}

int TestBackends(int, char*[])
{
  const std::string before = vtkSMPTools::GetBackend();
  std::cout << "VTK's back-end: " << before << "\n";
  const auto input = polyDataOf(ellipsoid(4));
  addPointArray<vtkDoubleArray>(input, "Height", 1, [](const Point3& p, int) { return p[2]; });
  testSameBytes(input);
  testSameSites(input);
  testAutomatic(input);
  testRestored(input);
  testLimit();
  vtkSMPTools::SetBackend(before.c_str());
  return result();
}
