// Placement/EvenTriangles: with a metric, the fit slides points until triangles are even in it, on
// a plane and on a tube; not with a density, and the same bytes on any threads.

#include "TestMetrics.h"

#include "vtkAnisotropicRemesher.h"

#include <cmath>

using namespace remesh;
using namespace remesh::test;

namespace
{
/** Stretched 4 : 1 along a direction of the plane that turns. */
Eigen::Matrix3d swirl(const Point3& p)
{
  const double angle = 3.0 * p[0] + 2.0 * p[1];
  const Point3 a(std::cos(angle), std::sin(angle), 0.0);
  return Eigen::Matrix3d::Identity() + 15.0 * a * a.transpose();
}

/** The same around a cylinder. */
Eigen::Matrix3d winding(const Point3& p)
{
  const Point3 outward = Point3(p[0], p[1], 0.0).normalized();
  const Point3 around(-outward[1], outward[0], 0.0);
  const Point3 a = std::cos(2.0 * p[2]) * around + std::sin(2.0 * p[2]) * Point3(0.0, 0.0, 1.0);
  return Eigen::Matrix3d::Identity() + 15.0 * a * a.transpose();
}

/** 4 sqrt 3 times the area over the sum of the squared edges, with the tensor at the centre: mean.
 */
double meanQuality(vtkPolyData* mesh, const Tensor& tensor)
{
  double sum = 0.0;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    vtkIdList* ids = mesh->GetCell(cell)->GetPointIds();
    const Point3 p = pointOf(mesh, ids->GetId(0));
    const Point3 a = pointOf(mesh, ids->GetId(1)) - p;
    const Point3 b = pointOf(mesh, ids->GetId(2)) - p;
    const Eigen::Matrix3d m = tensor(p + (a + b) / 3.0);
    const double aa = a.dot(m * a);
    const double ab = a.dot(m * b);
    const double bb = b.dot(m * b);
    sum += 2.0 * std::sqrt(3.0) * std::sqrt(aa * bb - ab * ab) / (2.0 * (aa + bb - ab));
  }
  return sum / static_cast<double>(mesh->GetNumberOfCells());
}

vtkSmartPointer<vtkPolyData> remeshed(
  vtkPolyData* input, int placement, int threads, const char* density = nullptr)
{
  const auto filter = vtkSmartPointer<vtkAnisotropicRemesher>::New();
  filter->SetInputData(input);
  filter->SetNumberOfPoints(600);
  filter->SetMetricArray("Metric");
  filter->SetDensityArray(density);
  filter->SetVertexPlacement(placement);
  filter->SetNumberOfThreads(threads);
  filter->Update();
  return filter->GetOutput();
}

void testQuality(vtkPolyData* input, const Tensor& tensor)
{
  using Filter = vtkAnisotropicRemesher;
  addMetric(input, tensor);
  const auto fitted = remeshed(input, Filter::FIT, 1);
  const double before = meanQuality(remeshed(input, Filter::SURFACE_POINT, 1), tensor);
  const double after = meanQuality(fitted, tensor);
  check(after > before + 0.004, __FILE__, __LINE__,
    "mean quality " + std::to_string(before) + " to " + std::to_string(after));
  const auto inverted = fitted->GetFieldData()->GetArray("NumberOfFlippedTriangles");
  CHECK_EQUAL(inverted->GetComponent(0, 0), 0.0);
  CHECK(bytesOf(remeshed(input, Filter::FIT, 3)->GetPoints()->GetData()) ==
    bytesOf(fitted->GetPoints()->GetData()));
}

/** A density makes triangles of different sizes: points stay where it puts them. */
void testDensity()
{
  const auto input = polyDataOf(gridPatch(40, 40));
  addMetric(input, swirl);
  addPointArray<vtkDoubleArray>(
    input, "Density", 1, [](const Point3& p, int) { return 1.0 + 9.0 * p[0]; });
  using Filter = vtkAnisotropicRemesher;
  const auto fitted = remeshed(input, Filter::FIT, 1, "Density");
  const auto placed = remeshed(input, Filter::SURFACE_POINT, 1, "Density");
  double farthest = 0.0;
  for (vtkIdType p = 0; p < fitted->GetNumberOfPoints(); ++p)
  {
    farthest = std::max(farthest, (pointOf(fitted, p) - pointOf(placed, p)).norm());
  }
  CHECK(farthest < 1e-6);
}
}

int TestEvenTriangles(int, char*[])
{
  testQuality(polyDataOf(gridPatch(60, 60)), swirl);
  testQuality(tube(80, 30), winding);
  testDensity();
  return test::result();
}
