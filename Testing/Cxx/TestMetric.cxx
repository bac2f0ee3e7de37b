// SetMetricArray: edges with the lengths of the metric, sizes, orders of the components, what is
// across the surface, other filters, errors.

#include "TestMetrics.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkGaussMapEmbedding.h"

#include <array>
#include <cmath>
#include <limits>

using namespace remesh;
using namespace remesh::test;

namespace
{
/** A layer across the square, at an angle: 0.1 along it, from 0.01 on across it. */
Eigen::Matrix3d layer(const Point3& p)
{
  const Point3 across(0.8, 0.6, 0.0);
  const Point3 along(-0.6, 0.8, 0.0);
  const double size = std::min(0.1, 0.01 + 0.3 * std::abs(across.dot(p) - 0.7));
  return across * across.transpose() / (size * size) + along * along.transpose() / 0.01;
}

/** Twice as long along x as along y at one side, and the other way round at the other. */
Eigen::Matrix3d gentle(const Point3& p)
{
  return Point3(1.0 + 3.0 * p[0], 4.0 - 3.0 * p[0], 1.0).asDiagonal();
}

/** Stretched 3 : 1 along a direction that turns with the height. */
Eigen::Matrix3d winding(const Point3& p)
{
  const double angle = 1.5 * p[2];
  const Point3 outward = Point3(p[0], p[1], 0.0).normalized();
  const Point3 around(-outward[1], outward[0], 0.0);
  const Point3 a = std::cos(angle) * around + std::sin(angle) * Point3(0.0, 0.0, 1.0);
  const Point3 b = outward.cross(a);
  return 9.0 * a * a.transpose() + b * b.transpose();
}

vtkSmartPointer<vtkAnisotropicRemesher> remesherOf(
  vtkPolyData* input, vtkIdType points, const char* metric = "Metric")
{
  auto filter = vtkSmartPointer<vtkAnisotropicRemesher>::New();
  filter->SetInputData(input);
  filter->SetNumberOfPoints(points);
  filter->SetMetricArray(metric);
  return filter;
}

double fact(vtkPolyData* mesh, const char* name)
{
  return vtkDataArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(name))
    ->GetComponent(0, 0);
}

void testLengths()
{
  struct Case
  {
    vtkSmartPointer<vtkPolyData> input;
    Tensor tensor;
    double least;
  };
  for (const Case& shape :
    { Case{ polyDataOf(gridPatch(80, 80)), layer, 0.99 }, Case{ tube(120, 40), winding, 0.97 } })
  {
    addMetric(shape.input, shape.tensor);
    const auto filter = remesherOf(shape.input, 1200);
    Messages messages(filter);
    filter->Update();
    CHECK(messages.errors().empty());
    CHECK(messages.warnings().empty());
    vtkPolyData* mesh = filter->GetOutput();
    CHECK_EQUAL(mesh->GetNumberOfPoints(), 1200);
    CHECK(filter->GetDimension() == 6);
    const double share = unitShare(mesh, shape.tensor);
    check(share > shape.least, __FILE__, __LINE__, "share " + std::to_string(share));
    CHECK(fact(mesh, "TopologyPreserved") == 1);
    CHECK(fact(mesh, "NumberOfFlippedTriangles") == 0);
    // Without the metric it is another mesh.
    filter->SetMetricArray(nullptr);
    filter->Update();
    CHECK(unitShare(filter->GetOutput(), shape.tensor) < 0.9);
  }
}

/** The same tensors in all ways to write them give the same mesh. */
void testComponents()
{
  const auto input = polyDataOf(gridPatch(40, 40));
  addMetric(input, layer);
  const auto add = [&](const char* name, const std::vector<std::array<int, 2>>& entries)
  {
    addPointArray<vtkDoubleArray>(input, name, static_cast<int>(entries.size()),
      [&](const Point3& p, int component)
      { return layer(p)(entries[component][0], entries[component][1]); });
  };
  add("Vtk", { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 1 }, { 1, 2 }, { 0, 2 } });
  add("Rows", { { 0, 0 }, { 0, 1 }, { 0, 2 }, { 1, 1 }, { 1, 2 }, { 2, 2 } });
  add("Sol", { { 0, 0 }, { 0, 1 }, { 1, 1 }, { 0, 2 }, { 1, 2 }, { 2, 2 } });
  add("Plane", { { 0, 0 }, { 1, 1 }, { 0, 1 } });
  // What is across the surface does not count.
  addMetric(
    input,
    [](const Point3& p) -> Eigen::Matrix3d
    { return layer(p) + 1e6 * Point3::UnitZ() * Point3::UnitZ().transpose(); },
    "Across");
  const auto run = [&](const char* name, int order)
  {
    const auto filter = remesherOf(input, 300, name);
    filter->SetMetricOrder(order);
    filter->Update();
    CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 300);
    return bytesOf(filter->GetOutput()->GetPoints()->GetData());
  };
  using Filter = vtkAnisotropicRemesher;
  const auto expected = run("Metric", Filter::METRIC_VTK);
  CHECK(run("Vtk", Filter::METRIC_VTK) == expected);
  CHECK(run("Rows", Filter::METRIC_ROWS) == expected);
  CHECK(run("Sol", Filter::METRIC_SOL) == expected);
  CHECK(run("Plane", Filter::METRIC_VTK) == expected);
  CHECK(run("Across", Filter::METRIC_VTK) == expected);
}

/** A size: half as large, four times as many points for an area. */
void testSizes()
{
  const auto input = polyDataOf(gridPatch(60, 60));
  addPointArray<vtkDoubleArray>(
    input, "Size", 1, [](const Point3& p, int) { return p[0] < 0.5 ? 0.01 : 0.02; });
  const auto filter = remesherOf(input, 1500, "Size");
  filter->Update();
  vtkPolyData* mesh = filter->GetOutput();
  int fine = 0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    fine += mesh->GetPoint(i)[0] < 0.5 ? 1 : 0;
  }
  CHECK_NEAR(fine / 1500.0, 0.8, 0.03);
}

void checkError(vtkAlgorithm* filter, const std::string& part, int line)
{
  Messages messages(filter);
  filter->Update();
  const auto& errors = messages.errors();
  check(errors.size() == 1 && errors[0].find(part) != std::string::npos, __FILE__, line,
    part + ": " + (errors.empty() ? "none" : errors[0]));
  CHECK(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints() == 0);
}

/** The mean length of edges in the metric. */
double meanLength(vtkPolyData* mesh, const Tensor& tensor)
{
  double sum = 0.0;
  vtkIdType count = 0;
  forEachSide(mesh,
    [&](vtkIdType p, vtkIdType q)
    {
      const Point3 start = pointOf(mesh, p);
      const Point3 edge = pointOf(mesh, q) - start;
      sum += std::sqrt(edge.dot(tensor(start + 0.5 * edge) * edge));
      ++count;
    });
  return sum / static_cast<double>(count);
}

/** The metric decides the number of points; so does the area that it is scaled to. */
void testUnit()
{
  const auto input = polyDataOf(gridPatch(80, 80));
  addMetric(input, layer);
  const auto filter = remesherOf(input, 7);
  filter->UnitEdgesOn();
  filter->Update();
  const vtkIdType number = filter->GetOutput()->GetNumberOfPoints();
  const double mean = meanLength(filter->GetOutput(), layer);
  check(std::abs(mean - 1.0) < 0.03, __FILE__, __LINE__, "mean " + std::to_string(mean));
  CHECK_NEAR(fact(filter->GetOutput(), "MetricUnit"), 1.0, 1e-12);
  // The sizes of the layer, integrated over the square; plus half of the border.
  double area = 0.0;
  constexpr int steps = 400;
  for (int i = 0; i < steps * steps; ++i)
  {
    const Point3 p((i / steps + 0.5) / steps, (i % steps + 0.5) / steps, 0.0);
    area += std::sqrt(layer(p).topLeftCorner<2, 2>().determinant()) / (steps * steps);
  }
  double border = 0.0;
  for (int i = 0; i < 4 * steps; ++i)
  {
    const double t = (i % steps + 0.5) / steps;
    const int side = i / steps;
    const Point3 p = side < 2 ? Point3(t, side, 0.0) : Point3(side - 2.0, t, 0.0);
    border += std::sqrt(layer(p)(side < 2 ? 0 : 1, side < 2 ? 0 : 1)) / steps;
  }
  CHECK_NEAR(number / (2.0 / std::sqrt(3.0) * area + 0.5 * border), 1.0, 0.05);

  filter->SetMetricComplexity(400.0);
  filter->Update();
  CHECK_NEAR(fact(filter->GetOutput(), "MetricUnit"), std::sqrt(area / 400.0), 0.02);
  CHECK(filter->GetOutput()->GetNumberOfPoints() > 2.0 / std::sqrt(3.0) * 400.0);

  filter->SetMetricArray(nullptr);
  checkError(filter, "UnitEdges needs a metric", __LINE__);
  filter->SetMetricArray("Metric");
  filter->SetDistanceTolerance(0.01);
  checkError(filter, "both decide the number of points", __LINE__);
}

/** A layer along a circle, thinner than the sagitta of the edges that are asked for along it. */
void testLimits()
{
  const auto ring = [](const Point3& p) -> Eigen::Matrix3d
  {
    const Point3 out = p.norm() > 0.0 ? p.normalized() : Point3(Point3::UnitX());
    const Point3 around(-out[1], out[0], 0.0);
    const double size = std::min(0.1, 0.001 + 0.3 * std::abs(p.norm() - 0.6));
    return out * out.transpose() / (size * size) + around * around.transpose() / 0.01;
  };
  const auto input = polyDataOf(gridPatch(120, 120));
  addMetric(input, ring);
  const auto filter = remesherOf(input, 500);
  filter->Update();
  const double limited = unitShare(filter->GetOutput(), ring);
  CHECK(fact(filter->GetOutput(), "MetricLimit") > 1.1);
  check(limited > 0.94, __FILE__, __LINE__, "limited " + std::to_string(limited));
  filter->LimitMetricOff();
  filter->Update();
  CHECK_NEAR(fact(filter->GetOutput(), "MetricLimit"), 1.0, 0.0);
  const double free = unitShare(filter->GetOutput(), ring);
  check(free < limited - 0.005, __FILE__, __LINE__, "share " + std::to_string(free));
}

/** The embedding that the remesher works on has the metric's lengths. */
void testEmbedding()
{
  const auto input = polyDataOf(gridPatch(60, 60));
  addMetric(input, gentle);
  vtkNew<vtkGaussMapEmbedding> filter;
  filter->SetInputData(input);
  filter->SetMetricArray("Metric");
  filter->SetMetricDimension(4);
  filter->Update();
  vtkDataArray* places = filter->GetOutput()->GetPointData()->GetArray("Embedding");
  CHECK(places && places->GetNumberOfComponents() == 4);
  double worst = 0.0;
  for (vtkIdType i = 0; i + 1 < 61 && places; ++i)
  {
    double squared = 0.0;
    for (int c = 0; c < 4; ++c)
    {
      squared += std::pow(places->GetComponent(i + 1, c) - places->GetComponent(i, c), 2);
    }
    const Point3 edge = pointOf(input, i + 1) - pointOf(input, i);
    const Point3 middle = pointOf(input, i) + 0.5 * edge;
    worst = std::max(worst, std::abs(std::sqrt(squared / edge.dot(gentle(middle) * edge)) - 1.0));
  }
  check(worst < 0.2, __FILE__, __LINE__, "worst " + std::to_string(worst));
}

void testErrors()
{
  const auto input = polyDataOf(gridPatch(10, 10));
  const auto fails = [&](const Tensor& tensor, const char* part, int line)
  {
    addMetric(input, tensor);
    checkError(remesherOf(input, 50), part, line);
  };
  const auto at = [](const Point3& p, double value)
  { return Point3(p[0] > 0.55 ? value : 1.0, 1.0, 1.0); };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  fails([&](const Point3& p) -> Eigen::Matrix3d { return at(p, -1.0).asDiagonal(); },
    "is not positive definite along the surface at point 6.", __LINE__);
  fails([&](const Point3& p) -> Eigen::Matrix3d { return at(p, nan).asDiagonal(); },
    "is not finite at point 6.", __LINE__);
  fails(
    [](const Point3& p) -> Eigen::Matrix3d
    {
      Eigen::Matrix3d tensor = Eigen::Matrix3d::Identity();
      tensor(0, 1) = p[0] > 0.55 ? 0.5 : 0.0;
      return tensor;
    },
    "is not symmetric at point 6.", __LINE__);
  addPointArray<vtkDoubleArray>(input, "Four", 4, [](const Point3&, int) { return 1.0; });
  checkError(remesherOf(input, 50, "Four"), "has 4 components", __LINE__);
  checkError(remesherOf(input, 50, "Absent"), "\"Absent\"", __LINE__);

  const auto ball = polyDataOf(icosphere(2));
  addPointArray<vtkDoubleArray>(ball, "Plane", 3, [](const Point3&, int c) { return c < 2; });
  checkError(remesherOf(ball, 50, "Plane"), "not in a plane of equal z", __LINE__);

  addMetric(input, layer);
  const auto both = remesherOf(input, 50);
  both->SetEmbeddingArray("Metric");
  checkError(both, "A metric is an embedding", __LINE__);
  const auto far = remesherOf(input, 50);
  far->SetMetricDimension(17);
  checkError(far, "MetricDimension", __LINE__);
}

/** A metric that the surface's triangles cannot follow is told. */
void testWarning()
{
  const auto input = polyDataOf(gridPatch(12, 12));
  addMetric(input,
    [](const Point3& p)
    {
      const double angle = 40.0 * p[0] * p[1];
      const Point3 a(std::cos(angle), std::sin(angle), 0.0);
      return Eigen::Matrix3d(Eigen::Matrix3d::Identity() + 400.0 * a * a.transpose());
    });
  const auto filter = remesherOf(input, 100);
  Messages messages(filter);
  filter->Update();
  CHECK(messages.errors().empty());
  const auto& warnings = messages.warnings();
  CHECK(std::any_of(warnings.begin(), warnings.end(),
    [](const std::string& text)
    { return text.find("The metric is met on ") != std::string::npos; }));
}
}

int TestMetric(int, char*[])
{
  testLengths();
  testComponents();
  testSizes();
  testEmbedding();
  testUnit();
  testLimits();
  testErrors();
  testWarning();
  return result();
}
