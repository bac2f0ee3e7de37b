// The comparison of a mesh with a reference: bad input, back-ends, threads, progress, abort.

#include "TestBytes.h"
#include "TestComparisons.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

using namespace remesh;
using namespace remesh::test;

namespace
{
/** One error with these words and empty outputs; then a good run. */
void checkFails(vtkPolyData* mesh, vtkPolyData* reference, const std::string& words)
{
  const Comparison filter = compare(mesh, reference);
  Messages messages(filter);
  filter->Update();
  CHECK_EQUAL(messages.errors().size(), std::size_t(1));
  CHECK_EQUAL(messages.executiveErrors().size(), std::size_t(1));
  check(!messages.errors().empty() && messages.errors()[0].find(words) != std::string::npos,
    __FILE__, __LINE__,
    words + " is not in: " + (messages.errors().empty() ? "" : messages.errors()[0]));
  CHECK(outputsAreEmpty(filter));
  filter->SetInputData(polyDataOf(cube()));
  filter->SetReferenceData(polyDataOf(cube()));
  messages.clear();
  filter->Update();
  CHECK(messages.errors().empty());
  CHECK_NEAR(summaryOf(filter, "MaximumDistance"), 0.0, 1e-15);
}

void testErrors()
{
  const auto good = polyDataOf(cube());
  const auto spoilt = [](double x)
  {
    const auto data = polyDataOf(cube());
    data->GetPoints()->SetPoint(3, 0.0, x, 0.0);
    return data;
  };
  const auto lines = polyDataOf(cube());
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1 });
  lines->SetPolys(nullptr);
  lines->SetLines(cells);
  const auto outOfRange = polyDataOf(cube());
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 77 });
  outOfRange->SetPolys(polygons);
  const auto tiny = polyDataOf(scaled(cube(), 1e-200));
  TriangleSoup flat = cube();
  flat.triangles = { { 0, 1, 1 } };

  checkFails(lines, good, "The mesh cannot be read. The input has no polygons");
  checkFails(good, lines, "The reference surface cannot be read. The input has no polygons");
  checkFails(spoilt(std::numeric_limits<double>::quiet_NaN()), good,
    "Point 3 of the mesh, in cell 0, has a coordinate that is not finite");
  checkFails(good, spoilt(-std::numeric_limits<double>::infinity()), "Point 3 of the reference");
  checkFails(good, spoilt(1e200), "too far away");
  checkFails(outOfRange, good, "refers to point 77");
  checkFails(good, outOfRange, "refers to point 77");
  checkFails(tiny, good, "too small");
  checkFails(polyDataOf(flat), good, "The mesh has no triangle with an area");
  checkFails(good, polyDataOf(flat), "The reference surface has no triangle with an area");

  const Comparison empty = compare(vtkSmartPointer<vtkPolyData>::New(), good);
  Messages messages(empty);
  empty->Update();
  CHECK(messages.errors().empty() && messages.warnings().empty());
  CHECK(outputsAreEmpty(empty));
}

/** The same bytes for any back-end and number of threads; an abort leaves nothing. */
void testExecution()
{
  const auto mesh = polyDataOf(ellipsoid(3));
  const auto reference = polyDataOf(ellipsoid(4));
  std::vector<Content> expected;
  for (const int backend : { vtkSurfaceMeshComparison::SMP_SEQUENTIAL,
         vtkSurfaceMeshComparison::SMP_STDTHREAD, vtkSurfaceMeshComparison::SMP_AUTOMATIC })
  {
    for (const int threads : { 1, 2, 0 })
    {
      const Comparison filter = compare(mesh, reference);
      filter->SetSMPBackend(backend);
      filter->SetNumberOfThreads(threads);
      filter->Update();
      const std::vector<Content> contents = contentsOf(filter);
      expected = expected.empty() ? contents : expected;
      checkSame(contents, expected,
        "back-end " + std::to_string(backend) + ", threads " + std::to_string(threads));
    }
  }

  const Comparison filter = compare(mesh, reference);
  Messages messages(filter);
  std::vector<double> progress;
  vtkNew<vtkCallbackCommand> watch;
  watch->SetClientData(&progress);
  watch->SetCallback([](vtkObject*, unsigned long, void* list, void* value)
    { static_cast<std::vector<double>*>(list)->push_back(*static_cast<double*>(value)); });
  filter->AddObserver(vtkCommand::ProgressEvent, watch);
  filter->Update();
  CHECK(progress.size() > 10 && std::is_sorted(progress.begin(), progress.end()));
  CHECK_EQUAL(progress.back(), 1.0);

  for (const double limit : { 0.1, 0.4, 0.9 })
  {
    std::pair<vtkAlgorithm*, double> state(filter, limit);
    vtkNew<vtkCallbackCommand> stop;
    stop->SetClientData(&state);
    stop->SetCallback(
      [](vtkObject*, unsigned long, void* data, void* value)
      {
        const auto& [algorithm, most] = *static_cast<std::pair<vtkAlgorithm*, double>*>(data);
        if (*static_cast<double*>(value) >= most)
        {
          algorithm->SetAbortExecute(1);
        }
      });
    const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, stop);
    filter->Modified();
    filter->Update();
    filter->RemoveObserver(tag);
    CHECK(messages.errors().empty());
    CHECK(outputsAreEmpty(filter));
  }
}

void testProperties()
{
  vtkNew<vtkSurfaceMeshComparison> filter;
  CHECK_EQUAL(filter->GetNumberOfSamples(), 200000);
  CHECK(filter->GetBoundMaximumDistance());
  CHECK_EQUAL(filter->GetNumberOfBins(), 30);
  CHECK_EQUAL(filter->GetNumberOfThreads(), 0);
  CHECK_EQUAL(filter->GetSMPBackend(), static_cast<int>(vtkSurfaceMeshComparison::SMP_AUTOMATIC));
  std::ostringstream text;
  filter->Print(text);
  for (const char* name : { "NumberOfSamples: ", "BoundMaximumDistance: ", "NumberOfBins: ",
         "NumberOfThreads: ", "SMPBackend: " })
  {
    check(text.str().find(name) != std::string::npos, __FILE__, __LINE__,
      std::string("not printed: ") + name);
  }
}
}

int TestComparisonExecution(int, char*[])
{
  testErrors();
  testExecution();
  testProperties();
  return result();
}
