// vtkSolutionMetric: arrays of all kinds, what remeshing with it gains, errors, warnings, threads.

#include "TestBytes.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkFieldData.h"
#include "vtkSolutionMetric.h"

#include <cmath>
#include <functional>

using namespace remesh;
using namespace remesh::test;

namespace
{
double front(const Point3& p)
{
  return std::tanh(30.0 * (std::hypot(p[0], p[1]) - 0.5));
}

vtkSmartPointer<vtkSolutionMetric> metricFilter(vtkPolyData* input, vtkIdType points)
{
  auto filter = vtkSmartPointer<vtkSolutionMetric>::New();
  filter->SetInputData(input);
  filter->SetNumberOfPoints(points);
  return filter;
}

vtkDataArray* metricOf(vtkSolutionMetric* filter)
{
  filter->Update();
  return filter->GetOutput()->GetPointData()->GetArray("Metric");
}

double pointsOf(vtkSolutionMetric* filter)
{
  filter->Update();
  return arrayOf(filter->GetOutput()->GetFieldData(), "MetricPoints")->GetComponent(0, 0);
}

/** Root of the mean square between a function and its interpolation at the triangles' centres. */
double errorOf(vtkPolyData* mesh, const std::function<double(const Point3&)>& function)
{
  double sum = 0.0;
  double area = 0.0;
  for (vtkIdType t = 0; t < mesh->GetNumberOfCells(); ++t)
  {
    vtkNew<vtkIdList> ids;
    mesh->GetCellPoints(t, ids);
    Point3 corners[3];
    double mean = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = pointOf(mesh, ids->GetId(k));
      mean += function(corners[k]) / 3.0;
    }
    const double own = (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm();
    const double off = mean - function((corners[0] + corners[1] + corners[2]) / 3.0);
    sum += own * off * off;
    area += own;
  }
  return std::sqrt(sum / area);
}

/** Remeshed with the metric, the error is a small part of that of even triangles. */
void testGain()
{
  const auto input = polyDataOf(gridPatch(100, 100));
  addPointArray<vtkDoubleArray>(input, "U", 1, [](const Point3& p, int) { return front(p); });
  const auto metric = metricFilter(input, 800);
  metric->AddSolutionArray("U");
  CHECK_NEAR(pointsOf(metric), 800.0, 0.1);
  CHECK(metric->GetOutput()->GetPointData()->GetArray("U") != nullptr);
  CHECK(input->GetPointData()->GetArray("Metric") == nullptr);
  CHECK(input->GetFieldData()->GetArray("MetricPoints") == nullptr);
  double errors[2];
  for (const bool adapted : { false, true })
  {
    vtkNew<vtkAnisotropicRemesher> remesher;
    remesher->SetInputConnection(metric->GetOutputPort());
    remesher->SetNumberOfPoints(800);
    remesher->SetAnisotropy(0.0);
    remesher->SetMetricArray(adapted ? "Metric" : nullptr);
    remesher->Update();
    errors[adapted ? 1 : 0] = errorOf(remesher->GetOutput(), front);
  }
  check(errors[1] < 0.1 * errors[0], __FILE__, __LINE__,
    std::to_string(errors[0]) + " and " + std::to_string(errors[1]));
}

/** Hessians in all orders give one metric, and so do metrics. */
void testOrders()
{
  const auto input = polyDataOf(gridPatch(12, 12));
  const auto tensor = [](const Point3& p, int i, int j)
  { return (i == j ? 4.0 + i : 1.0) + (i + j < 1 ? 10.0 * p[0] : 0.0); };
  const auto add = [&](const char* name, const std::vector<std::array<int, 2>>& entries)
  {
    addPointArray<vtkDoubleArray>(input, name, static_cast<int>(entries.size()),
      [&](const Point3& p, int c) { return tensor(p, entries[c][0], entries[c][1]); });
  };
  add("Nine",
    { { 0, 0 }, { 0, 1 }, { 0, 2 }, { 1, 0 }, { 1, 1 }, { 1, 2 }, { 2, 0 }, { 2, 1 }, { 2, 2 } });
  add("Vtk", { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 1 }, { 1, 2 }, { 0, 2 } });
  add("Rows", { { 0, 0 }, { 0, 1 }, { 0, 2 }, { 1, 1 }, { 1, 2 }, { 2, 2 } });
  add("Sol", { { 0, 0 }, { 0, 1 }, { 1, 1 }, { 0, 2 }, { 1, 2 }, { 2, 2 } });
  add("Plane", { { 0, 0 }, { 1, 1 }, { 0, 1 } });
  for (const bool isHessian : { true, false })
  {
    std::vector<std::string> bytes;
    const std::pair<const char*, int> cases[] = { { "Nine", 0 }, { "Vtk", 0 }, { "Rows", 1 },
      { "Sol", 2 }, { "Plane", 0 } };
    for (const auto& [name, order] : cases)
    {
      const auto filter = metricFilter(input, 100);
      filter->SetMetricOrder(order);
      isHessian ? filter->AddHessianArray(name) : filter->AddMetricArray(name);
      bytes.push_back(bytesOf(metricOf(filter)));
      CHECK(bytes.back() == bytes.front());
    }
  }
}

void testSizes()
{
  const auto input = polyDataOf(gridPatch(20, 20));
  addPointArray<vtkDoubleArray>(input, "D", 1, [](const Point3& p, int) { return p[0] - 0.5; });
  addPointArray<vtkDoubleArray>(input, "H", 1, [](const Point3&, int) { return 0.1; });
  const auto filter = metricFilter(input, 100);
  filter->SetDistanceArray("D");
  filter->SetDistanceSize(0.02);
  filter->SetDistanceGrowth(0.5);
  filter->AddMetricArray("H");
  vtkDataArray* metric = metricOf(filter);
  CHECK_EQUAL(metric->GetNumberOfComponents(), 6);
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    const double size = std::min(0.1, 0.02 + 0.5 * std::abs(pointOf(input, i)[0] - 0.5));
    for (int c = 0; c < 6; ++c)
    {
      CHECK_NEAR(metric->GetComponent(i, c) * size * size, c < 3 ? 1.0 : 0.0, 1e-9);
    }
  }
}

/** Points that are equal, and those that no polygon uses. */
void testPoints()
{
  TriangleSoup soup = gridPatch(8, 8);
  append(soup, gridPatch(8, 8), Point3(1.0, 0.0, 0.0)); // with points of its own along x = 1
  soup.points.emplace_back(9.0, 9.0, 9.0);
  const auto input = polyDataOf(soup);
  addPointArray<vtkDoubleArray>(input, "U", 2, [](const Point3& p, int c) { return p[c] * p[0]; });
  const auto filter = metricFilter(input, 100);
  filter->AddSolutionArray("U");
  filter->SetMaximumSize(2.0);
  vtkDataArray* metric = metricOf(filter);
  CHECK_EQUAL(metric->GetNumberOfTuples(), input->GetNumberOfPoints());
  CHECK_NEAR(metric->GetComponent(8, 0), metric->GetComponent(81, 0), 0.0); // both at (1, 0)
  CHECK_NEAR(metric->GetComponent(162, 0), 0.25, 1e-12);
  CHECK_NEAR(metric->GetComponent(162, 3), 0.0, 0.0);
}

/** Where nothing is chosen, the active scalars are the solution; where something is, they are not.
 */
void testActiveScalars()
{
  const auto input = polyDataOf(gridPatch(12, 12));
  addPointArray<vtkDoubleArray>(
    input, "U", 1, [](const Point3& p, int) { return p[0] * p[0] + 2.0 * p[1] * p[1]; });
  addPointArray<vtkDoubleArray>(input, "V", 1, [](const Point3& p, int) { return p[0] * p[1]; });
  const auto run = [&](const char* active, const char* chosen)
  {
    input->GetPointData()->SetActiveScalars(active);
    const auto filter = metricFilter(input, 100);
    if (chosen)
    {
      filter->AddSolutionArray(chosen);
    }
    return contentsOf(filter);
  };
  checkSame(run("V", nullptr), run("V", "V"), "nothing is chosen");
  checkSame(run("V", "U"), run("U", nullptr), "a solution is chosen");
  vtkSmartPointer<vtkSolutionMetric> chord = metricFilter(input, 100);
  chord->SetChordTolerance(0.01);
  chord->SetMaximumSize(0.5);
  CHECK_NEAR(metricOf(chord)->GetComponent(0, 0), 4.0, 1e-9); // a plane: the scalars do not count
}

void checkError(vtkSolutionMetric* filter, const std::string& part, int line)
{
  Messages messages(filter);
  filter->Update();
  const auto& errors = messages.errors();
  check(errors.size() == 1 && errors[0].find(part) != std::string::npos, __FILE__, line,
    part + ": " + (errors.empty() ? "none" : errors[0]));
  CHECK(messages.warnings().empty());
  CHECK(outputsAreEmpty(filter));
}

void testErrors()
{
  const auto input = polyDataOf(gridPatch(6, 6));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  addPointArray<vtkDoubleArray>(
    input, "U", 1, [&](const Point3& p, int) { return p[0] > 0.6 ? nan : 1.0; });
  addPointArray<vtkDoubleArray>(input, "Two", 2, [](const Point3&, int) { return 1.0; });
  addPointArray<vtkDoubleArray>(input, "Zero", 6, [](const Point3&, int) { return 0.0; });
  vtkNew<vtkDoubleArray> few;
  few->SetName("Few");
  few->SetNumberOfTuples(3);
  input->GetPointData()->AddArray(few);
  const auto fails =
    [&](const std::function<void(vtkSolutionMetric*)>& change, const char* part, int line)
  {
    const auto filter = metricFilter(input, 50);
    change(filter);
    checkError(filter, part, line);
  };
  using Filter = vtkSolutionMetric;
  fails([](Filter*) {}, "There is nothing to make a metric from", __LINE__);
  fails([](Filter* f) { f->AddSolutionArray("None"); },
    "The input has no numeric point array \"None\", chosen as a solution.", __LINE__);
  fails([](Filter* f) { f->AddSolutionArray("U"); },
    "The point array \"U\" has a value that is not a finite number at point 4.", __LINE__);
  fails([](Filter* f) { f->AddSolutionArray("Few"); }, "has 3 tuples for 49 points", __LINE__);
  fails([](Filter* f) { f->AddHessianArray("Two"); },
    "The point array \"Two\" has 2 components; a Hessian has 9, 6 or 3 (in the plane).", __LINE__);
  fails([](Filter* f) { f->AddMetricArray("Zero"); }, "is not positive definite", __LINE__);
  fails(
    [](Filter* f)
    {
      f->SetDistanceArray("Two");
      f->SetDistanceSize(1.0);
    },
    "The point array \"Two\" has 2 components; a distance has 1.", __LINE__);
  fails([](Filter* f) { f->SetDistanceArray("U"); },
    "DistanceSize must be above 0 where there is a distance array, but is 0.", __LINE__);
}

void testWarnings()
{
  const auto input = polyDataOf(gridPatch(20, 20));
  addPointArray<vtkDoubleArray>(input, "U", 1, [](const Point3& p, int) { return p[0] * p[0]; });
  addPointArray<vtkDoubleArray>(input, "One", 1, [](const Point3&, int) { return 1.0; });
  const auto warns = [&](const char* array, double least, double most, const char* part)
  {
    const auto filter = metricFilter(input, 100);
    filter->AddSolutionArray(array);
    filter->SetMinimumSize(least);
    filter->SetMaximumSize(most);
    Messages messages(filter);
    filter->Update();
    CHECK(messages.errors().empty());
    const auto& warnings = messages.warnings();
    check(warnings.size() == (*part ? 1u : 0u) &&
        (warnings.empty() || warnings[0].find(part) != std::string::npos),
      __FILE__, __LINE__, std::string(part) + ": " + (warnings.empty() ? "none" : warnings[0]));
  };
  warns("U", 0.0, 0.0, "");
  warns("One", 0.0, 0.0, "The solutions do not bend anywhere: they ask for no points.");
  warns("U", 0.0, 0.05, "ask for 462 points, of 100 that all may ask for");
  warns("U", 0.5, 0.0, "instead of 100: the smallest size allows for no more.");
}

void testLists()
{
  vtkNew<vtkSolutionMetric> filter;
  filter->AddSolutionArray("A");
  filter->AddSolutionArray("B");
  filter->AddHessianArray("C");
  filter->AddMetricArray("D");
  CHECK_EQUAL(filter->GetNumberOfSolutionArrays(), 2);
  CHECK_EQUAL(std::string(filter->GetSolutionArrayName(1)), "B");
  CHECK(filter->GetSolutionArrayName(2) == nullptr);
  CHECK_EQUAL(std::string(filter->GetHessianArrayName(0)), "C");
  CHECK_EQUAL(std::string(filter->GetMetricArrayName(0)), "D");
  const vtkMTimeType time = filter->GetMTime();
  filter->ClearSolutionArrays();
  CHECK(filter->GetMTime() > time);
  CHECK_EQUAL(filter->GetNumberOfSolutionArrays(), 0);
  Messages messages(filter);
  filter->AddMetricArray("");
  CHECK_EQUAL(messages.errors().size(), 1u);
  CHECK_EQUAL(filter->GetNumberOfMetricArrays(), 1);
}

void testThreads()
{
  const auto input = polyDataOf(icosphere(5));
  addPointArray<vtkDoubleArray>(
    input, "U", 1, [](const Point3& p, int) { return std::sin(9.0 * p[0]) * p[1]; });
  std::vector<Content> contents;
  for (const int threads : { 1, 2, 0 })
  {
    for (const int backend :
      { vtkSolutionMetric::SMP_SEQUENTIAL, vtkSolutionMetric::SMP_STDTHREAD })
    {
      const auto filter = metricFilter(input, 1000);
      filter->AddSolutionArray("U");
      filter->SetChordTolerance(0.01);
      filter->SetNumberOfThreads(threads);
      filter->SetSMPBackend(backend);
      filter->Update();
      contents.push_back(contentOf(filter->GetOutput()));
      CHECK(contents.back() == contents.front());
    }
  }
}
}

int TestSolutionMetric(int, char*[])
{
  testGain();
  testOrders();
  testSizes();
  testPoints();
  testActiveScalars();
  testErrors();
  testWarnings();
  testLists();
  testThreads();
  return result();
}
