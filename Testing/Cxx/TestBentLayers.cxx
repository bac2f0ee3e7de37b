// Layers that bend, thinner than straight edges can follow: a sine at 1e-4 and a circle at 1e-5, on
// surfaces whose rows follow them, and the sine on a grid. Edges have the lengths of the metric as
// limited; and a grid whose points are far apart for the layer is told.

#include "TestMetrics.h"

#include "vtkAnisotropicRemesher.h"

#include <vtkGenericCell.h>
#include <vtkStaticCellLocator.h>

#include <Eigen/Eigenvalues>

#include <array>

using namespace remesh;
using namespace remesh::test;

namespace
{
Eigen::Matrix3d tensorOf(const Point3& across, double thin, double along)
{
  const Point3 direction = across.normalized();
  const Point3 other(-direction[1], direction[0], 0.0);
  return direction * direction.transpose() / (thin * thin) +
    other * other.transpose() / (along * along) + Point3::UnitZ() * Point3::UnitZ().transpose();
}

double sineAt(double x)
{
  return 0.5 + 0.2 * std::sin(2.0 * pi * x);
}

/** 1e-4 across a sine, growing to 0.1 away from it; 0.1 along it. */
Eigen::Matrix3d sine(const Point3& p)
{
  const Point3 across(-0.4 * pi * std::cos(2.0 * pi * p[0]), 1.0, 0.0);
  const double distance = std::abs(p[1] - sineAt(p[0])) / across.norm();
  return tensorOf(across, std::min(0.1, 1e-4 + 0.3 * distance), 0.1);
}

/** 1e-5 across a circle of radius 0.6, 0.025 along it; away from it both grow to 0.1. */
Eigen::Matrix3d circle(const Point3& p)
{
  const double distance = std::abs(p.norm() - 0.6);
  const double along = std::min(0.1, 0.025 + 0.75 * distance);
  return tensorOf(p, 1e-5 + 0.2 * distance, along);
}

/** From -1 to 1: as far apart as a layer's sizes, that grow with the distance, want. */
double graded(double u, double least)
{
  const double top = std::log(1.0 + 1.0 / least);
  return std::copysign(least * std::expm1(std::abs(u) * top), u);
}

/** The unit square, with rows along the sine. */
vtkSmartPointer<vtkPolyData> squareAlong(int columns, int rows)
{
  TriangleSoup soup = gridPatch(columns, rows);
  for (Point3& p : soup.points)
  {
    const double row = graded(2.0 * p[1] - 1.0, 4e-4);
    const double fade = (1.0 - row * row) * (1.0 - row * row);
    p[1] = 0.5 + 0.5 * row + fade * (sineAt(p[0]) - 0.5);
  }
  return polyDataOf(soup);
}

/** A quarter of a ring, 0.5 to 0.7. */
vtkSmartPointer<vtkPolyData> ring(int angles, int radii)
{
  TriangleSoup soup = gridPatch(angles, radii);
  for (Point3& p : soup.points)
  {
    const double radius = 0.6 + 0.1 * graded(2.0 * p[1] - 1.0, 5e-4);
    const double angle = 0.5 * pi * p[0];
    p = { radius * std::cos(angle), radius * std::sin(angle), 0.0 };
  }
  return polyDataOf(soup);
}

Eigen::Matrix3d withEigenvalues(const Eigen::Matrix3d& matrix, double (*f)(double))
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
  const Eigen::Vector3d values = solver.eigenvalues().unaryExpr(f);
  return solver.eigenvectors() * values.asDiagonal() * solver.eigenvectors().transpose();
}

/** `LimitedMetric` between the points: logarithms are linear. */
class Limited
{
public:
  explicit Limited(vtkPolyData* surface)
    : m_surface(surface)
  {
    m_locator->SetDataSet(surface);
    m_locator->BuildLocator();
    vtkDataArray* tensors = surface->GetPointData()->GetArray("LimitedMetric");
    for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
    {
      std::array<double, 6> t{};
      tensors->GetTuple(p, t.data());
      Eigen::Matrix3d matrix;
      matrix << t[0], t[3], t[5], t[3], t[1], t[4], t[5], t[4], t[2];
      m_logarithms.push_back(withEigenvalues(matrix, std::log));
    }
  }

  Eigen::Matrix3d at(const Point3& place) const
  {
    Point3 closest;
    vtkIdType cell = 0;
    int part = 0;
    double distance2 = 0.0;
    m_locator->FindClosestPoint(place.data(), closest.data(), m_cell, cell, part, distance2);
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    const Point3 corners[3] = { pointOf(m_surface, m_cell->GetPointId(0)),
      pointOf(m_surface, m_cell->GetPointId(1)), pointOf(m_surface, m_cell->GetPointId(2)) };
    const double area = (corners[1] - corners[0]).cross(corners[2] - corners[0])[2];
    for (int k = 0; k < 3; ++k)
    {
      const Point3 first = corners[(k + 1) % 3] - closest;
      const Point3 second = corners[(k + 2) % 3] - closest;
      sum += first.cross(second)[2] / area * m_logarithms[m_cell->GetPointId(k)];
    }
    return withEigenvalues(sum, std::exp);
  }

private:
  vtkPolyData* m_surface;
  vtkNew<vtkStaticCellLocator> m_locator;
  vtkNew<vtkGenericCell> m_cell;
  std::vector<Eigen::Matrix3d> m_logarithms;
};

double fact(vtkPolyData* data, const char* name)
{
  return vtkDataArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name))
    ->GetComponent(0, 0);
}

/** Edges of a mesh with so many points have the lengths of the metric as limited. */
void checkEdges(vtkPolyData* input, vtkPolyData* embedded, vtkIdType points)
{
  vtkNew<vtkAnisotropicRemesher> remesher;
  remesher->SetInputData(input);
  remesher->SetMetricArray("Metric");
  remesher->SetNumberOfPoints(points);
  remesher->Update();
  vtkPolyData* mesh = remesher->GetOutput();
  CHECK_EQUAL(mesh->GetNumberOfPoints(), points);
  CHECK(fact(mesh, "NumberOfFlippedTriangles") == 0);
  CHECK(fact(mesh, "TopologyPreserved") == 1);
  const Limited limited(embedded);
  const double share = unitShare(mesh, [&](const Point3& p) { return limited.at(p); });
  check(share >= 0.97, __FILE__, __LINE__, "share " + std::to_string(share));
}

void testBentLayer(vtkPolyData* input, const Tensor& tensor, vtkIdType points)
{
  addMetric(input, tensor);
  const auto embedding = embeddingOf(input, points);
  Messages messages(embedding);
  embedding->Update();
  CHECK(messages.errors().empty());
  CHECK(messages.warnings().empty());
  CHECK(fact(embedding->GetOutput(), "MetricShare") > 0.95);
  CHECK(fact(embedding->GetOutput(), "MetricLimit") > 3.0);
  checkEdges(input, embedding->GetOutput(), points);
}

/** Between points of a grid, nothing tells where the layer is: what is between them is met. */
void testFarPoints()
{
  const auto input = polyDataOf(gridPatch(160, 160));
  constexpr vtkIdType points = 2000;
  addMetric(input, sine);
  const auto embedding = embeddingOf(input, points);
  Messages messages(embedding);
  embedding->Update();
  CHECK(messages.errors().empty());
  CHECK_EQUAL(messages.warnings().size(), 1);
  CHECK(messages.warnings()[0].find("Smaller triangles of the surface") != std::string::npos);
  CHECK(fact(embedding->GetOutput(), "MetricShare") < 0.8);
  checkEdges(input, embedding->GetOutput(), points); // 0.95 with points within needles
}
}

int TestBentLayers(int, char*[])
{
  testBentLayer(squareAlong(110, 140), sine, 2000);
  testBentLayer(ring(140, 120), circle, 2800);
  testFarPoints();
  return result();
}
