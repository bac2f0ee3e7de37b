// Progress rises from 0 to 1; an abort is heard soon, and leaves nothing behind.

#include "TestBytes.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkGaussMapEmbedding.h"
#include "vtkMetricEmbedding.h"
#include "vtkRestrictedVoronoiDiagram.h"
#include "vtkSolutionMetric.h"
#include "vtkSpectralEmbedding.h"

#include <chrono>
#include <functional>
#include <iostream>
#include <thread>

using namespace remesh;
using namespace remesh::test;

namespace
{
using Clock = std::chrono::steady_clock;

/** Calls `watch(progress)` at each progress event, as long as this object lives. */
class ProgressWatch
{
public:
  ProgressWatch(vtkAlgorithm* algorithm, std::function<void(double)> watch)
    : Algorithm(algorithm)
    , Watch(std::move(watch))
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback([](vtkObject*, unsigned long, void* self, void* progress)
      { static_cast<ProgressWatch*>(self)->Watch(*static_cast<double*>(progress)); });
    this->Tag = algorithm->AddObserver(vtkCommand::ProgressEvent, command);
  }
  ~ProgressWatch() { this->Algorithm->RemoveObserver(this->Tag); }
  ProgressWatch(const ProgressWatch&) = delete;
  void operator=(const ProgressWatch&) = delete;

private:
  vtkAlgorithm* Algorithm;
  std::function<void(double)> Watch;
  unsigned long Tag = 0;
};

std::vector<double> progressOf(vtkAlgorithm* filter)
{
  std::vector<double> values;
  const std::thread::id caller = std::this_thread::get_id();
  ProgressWatch watch(filter,
    [&](double progress)
    {
      CHECK(std::this_thread::get_id() == caller);
      values.push_back(progress);
    });
  filter->Modified();
  filter->Update();
  return values;
}

void testProgress(vtkAlgorithm* filter, std::size_t atLeast)
{
  const std::vector<double> values = progressOf(filter);
  CHECK(values.size() >= atLeast);
  CHECK_EQUAL(values.front(), 0.0);
  CHECK_EQUAL(values.back(), 1.0);
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    CHECK(values[k] >= 0.0 && values[k] <= 1.0);
    CHECK(k == 0 || values[k] >= values[k - 1]);
  }
  CHECK_EQUAL(filter->GetProgress(), 1.0);
}

void testAbort(vtkAlgorithm* filter, double moment)
{
  const std::string where = "abort at " + std::to_string(moment);
  Messages messages(filter);
  bool aborted = false;
  {
    ProgressWatch watch(filter,
      [&](double progress)
      {
        if (progress >= moment && !aborted)
        {
          aborted = true;
          filter->SetAbortExecute(1);
        }
      });
    filter->Modified();
    filter->Update();
  }
  check(aborted, __FILE__, __LINE__, where + ": not reached");
  check(outputsAreEmpty(filter), __FILE__, __LINE__, where + ": the outputs are not empty");
  check(messages.errors().empty(), __FILE__, __LINE__, where + ": an error");
  check(messages.warnings().empty(), __FILE__, __LINE__, where + ": a warning");
  check(messages.executiveErrors().empty(), __FILE__, __LINE__, where + ": an executive's error");
}

/** Sites that are put on the surface: that is reported, and ends where it is aborted. */
void testSites(vtkPolyData* input)
{
  vtkNew<vtkRestrictedVoronoiDiagram> diagram;
  diagram->SetInputData(input);
  diagram->SetSitesData(polyDataOf(ellipsoid(5)));
  for (const int last : { VTK_INT_MAX, 3 })
  {
    int reports = 0;
    std::string text;
    ProgressWatch watch(diagram,
      [&](double)
      {
        text = diagram->GetProgressText() ? diagram->GetProgressText() : "";
        reports += text == "Sites" ? 1 : 0;
        if (reports == last)
        {
          diagram->SetAbortExecute(1);
        }
      });
    diagram->Modified();
    diagram->Update();
    CHECK(reports >= 3);
    CHECK_EQUAL(outputsAreEmpty(diagram), last == 3);
    CHECK_EQUAL(text == "Sites", last == 3);
  }
}

/** After an abort the filter runs again at the next Update(), and only then. */
void testRunAgain(vtkPolyData* input)
{
  vtkNew<vtkGaussMapEmbedding> filter;
  filter->SetInputData(input);
  for (int run = 0; run < 2; ++run)
  {
    filter->Modified();
    {
      ProgressWatch watch(filter, [&](double) { filter->SetAbortExecute(1); });
      filter->Update();
    }
    CHECK(outputsAreEmpty(filter));
    CHECK_EQUAL(filter->GetAbortExecute(), 0);
    filter->Update();
    CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), input->GetNumberOfPoints());
    int reports = 0;
    ProgressWatch watch(filter, [&](double) { ++reports; });
    filter->Update();
    CHECK_EQUAL(reports, 0);
  }
}

/** Who observes AbortCheckEvent is asked by the thread that executes, and may stop the run. */
void testAbortCheck(vtkPolyData* input)
{
  vtkNew<vtkAnisotropicRemesher> filter;
  filter->SetInputData(input);
  filter->SetNumberOfPoints(2000);
  filter->SetNumberOfLloydIterations(100000);
  int checks = 0;
  const std::thread::id caller = std::this_thread::get_id();
  vtkNew<vtkCallbackCommand> command;
  const auto check = [&]()
  {
    CHECK(std::this_thread::get_id() == caller);
    ++checks;
    filter->SetAbortExecute(checks == 5);
  };
  std::function<void()> called = check;
  command->SetClientData(&called);
  command->SetCallback([](vtkObject*, unsigned long, void* function, void*)
    { (*static_cast<std::function<void()>*>(function))(); });
  filter->AddObserver(vtkCommand::AbortCheckEvent, command);
  filter->Update();
  CHECK_EQUAL(checks, 5);
  CHECK(outputsAreEmpty(filter));
}

/** Who observes progress may stop a run in which it hardly rises. */
void testAbortFromProgress(vtkPolyData* input)
{
  vtkNew<vtkAnisotropicRemesher> filter;
  filter->SetInputData(input);
  filter->SetNumberOfPoints(2000);
  filter->SetNumberOfLloydIterations(100000); // half a percent takes long
  int repeated = 0;
  double last = -1.0;
  const ProgressWatch watch(filter,
    [&](double progress)
    {
      repeated += progress == last ? 1 : 0;
      last = progress;
      filter->SetAbortExecute(repeated == 3);
    });
  filter->Update();
  CHECK_EQUAL(repeated, 3);
  CHECK(outputsAreEmpty(filter));
}

/** Seconds from an abort, `delay` seconds after the start, to the end; negative if it came late. */
double secondsToStop(vtkAlgorithm* filter, double delay)
{
  Clock::time_point aborted;
  std::thread user(
    [&]()
    {
      std::this_thread::sleep_for(std::chrono::duration<double>(delay));
      aborted = Clock::now();
      filter->SetAbortExecute(1);
    });
  filter->Modified();
  filter->Update();
  const Clock::time_point end = Clock::now();
  user.join();
  return std::chrono::duration<double>(end - aborted).count();
}

/** A long run listens at any moment. Best of three: the machine may have other work. */
void testResponsiveness()
{
  const auto input = polyDataOf(torus(1.0, 0.3, 500, 200)); // 200 000 triangles
  vtkNew<vtkAnisotropicRemesher> filter;
  filter->SetInputData(input);
  filter->SetNumberOfPoints(50000);
  filter->SetNumberOfLloydIterations(100000);
  for (const double delay : { 0.02, 0.1, 0.25, 0.5, 1.0 })
  {
    double best = HUGE_VAL;
    for (int attempt = 0; attempt < 3 && best > 0.5; ++attempt)
    {
      best = std::min(best, secondsToStop(filter, delay));
    }
    std::cout << "Aborted after " << delay << " s, stopped " << best << " s later.\n";
    CHECK(best > 0.0 && best < 0.5);
    CHECK(outputsAreEmpty(filter));
  }
}

/** The filters that compute fields, on 100 000 points. */
void testFieldResponsiveness()
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  const auto input = polyDataOf(torus(1.0, 0.3, 250, 80)); // they take ten times as long
#else
  const auto input = polyDataOf(torus(1.0, 0.3, 500, 200));
#endif
  addPointArray<vtkDoubleArray>(
    input, "Size", 1, [](const Point3& p, int) { return 0.02 + 0.01 * std::sin(5.0 * p[0]); });
  vtkNew<vtkMetricEmbedding> embedding;
  embedding->SetMetricArray("Size");
  vtkNew<vtkSpectralEmbedding> spectrum;
  spectrum->SetDimension(400);
  vtkNew<vtkSolutionMetric> metric;
  metric->AddSolutionArray("Size");
  const std::pair<vtkSurfaceFieldAlgorithm*, std::vector<double>> runs[] = {
    { embedding, { 0.05, 0.2, 0.5, 1.0 } }, { spectrum, { 0.05, 0.2, 0.5, 1.0, 3.0 } },
    { metric, { 0.05, 0.1 } }
  };
  for (const auto& [filter, delays] : runs)
  {
    filter->SetInputDataObject(input);
    for (const double delay : delays)
    {
      double best = HUGE_VAL;
      for (int attempt = 0; attempt < 5 && best > 0.3; ++attempt)
      {
        best = std::min(best, secondsToStop(filter, delay));
      }
      std::cout << filter->GetClassName() << " aborted after " << delay << " s, stopped " << best
                << " s later.\n";
      CHECK(best > 0.0 && best < 0.3);
      CHECK(outputsAreEmpty(filter));
    }
  }
}
}

int TestProgressAbort(int, char*[])
{
  const auto input = polyDataOf(ellipsoid(4));
  vtkNew<vtkAnisotropicRemesher> remesher;
  remesher->SetInputData(input);
  remesher->SetNumberOfPoints(500);
  remesher->SetNumberOfLloydIterations(20);
  vtkNew<vtkRestrictedVoronoiDiagram> diagram;
  diagram->SetInputData(input);
  diagram->SetSitesData(polyDataOf(ellipsoid(2)));
  vtkNew<vtkGaussMapEmbedding> embedding;
  embedding->SetInputData(input);

  testProgress(remesher, 25);
  testProgress(diagram, 5);
  testProgress(embedding, 3);
  testSites(input);
  testRunAgain(input);
  testAbortCheck(input);
  testAbortFromProgress(input);

  const std::vector<Content> remeshed = contentsOf(remesher);
  for (const double moment :
    { 0.001, 0.03, 0.1, 0.2, 0.5, 0.8, 0.85, 0.9, 0.94, 0.951, 0.97, 0.99 })
  {
    testAbort(remesher, moment);
  }
  const std::vector<Content> cells = contentsOf(diagram);
  for (const double moment : { 0.001, 0.2, 0.9, 0.94, 0.951, 0.97, 0.99 })
  {
    testAbort(diagram, moment);
  }
  const std::vector<Content> embedded = contentsOf(embedding);
  for (const double moment : { 0.001, 0.5, 0.9 })
  {
    testAbort(embedding, moment);
  }
  // All work afterwards, as before.
  for (vtkAlgorithm* filter : std::initializer_list<vtkAlgorithm*>{ remesher, diagram, embedding })
  {
    filter->Modified();
    filter->Update();
  }
  checkSame(contentsOf(remesher), remeshed, "the remesher after an abort");
  checkSame(contentsOf(diagram), cells, "the diagram after an abort");
  checkSame(contentsOf(embedding), embedded, "the embedding after an abort");

  // Several runs in one: with normals smoothed farther, and at last compared.
  vtkNew<vtkAnisotropicRemesher> wrinkled;
  wrinkled->SetInputData(bumpyPlate(60, 0.08, 40.0));
  wrinkled->SetNumberOfPoints(500);
  wrinkled->SetAnisotropy(1.0);
  testProgress(wrinkled, 30);
  for (const double moment : { 0.3, 0.58, 0.7, 0.85, 0.9 })
  {
    testAbort(wrinkled, moment);
  }

  // Two: with normals as they are, until cells fall apart, and smoothed.
  wrinkled->SetInputData(wavyPlate(120, 0.0, 0.0));
  wrinkled->SetNumberOfPoints(200);
  testProgress(wrinkled, 30);
  for (const double moment : { 0.5, 0.93, 0.98 })
  {
    testAbort(wrinkled, moment);
  }

  testResponsiveness();
  testFieldResponsiveness();
  return result();
}
