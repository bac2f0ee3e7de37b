// Creases by the angle of their facets and by their shape: a ridge that is none, and one that
// zigzags.

#include "TestMeasures.h"

#include "vtkAnisotropicRemesher.h"

#include <cmath>
#include <functional>

using namespace remesh;
using namespace remesh::test;

namespace
{
vtkSmartPointer<vtkPolyData> meshOf(
  vtkAnisotropicRemesher* filter, vtkPolyData* input, vtkIdType points)
{
  filter->SetInputData(input);
  filter->SetNumberOfPoints(points);
  Messages messages(filter);
  filter->Update();
  CHECK(messages.errors().empty() && messages.warnings().empty());
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), points);
  return filter->GetOutput();
}

/** The ridge of a roof of this slope, bent from point to point. */
vtkSmartPointer<vtkPolyData> roof(const std::function<double(int)>& bend, double slope = 1.0)
{
  constexpr int n = 60;
  TriangleSoup soup = gridPatch(n, n);
  for (std::size_t k = 0; k < soup.points.size(); ++k)
  {
    Point3& p = soup.points[k];
    p[2] = -slope * std::abs(p[0] - 0.5);
    p[0] += p[2] == 0.0 ? bend(static_cast<int>(k) / (n + 1)) : 0.0;
  }
  return polyDataOf(soup);
}

/** A ridge of 45 degrees is a crease below that angle, and none above. */
void testAngle()
{
  const auto straight = [](int) { return 0.0; };
  const auto input = roof(straight, std::tan(pi / 8.0));
  const auto onRidge = [](const Point3& p) { return std::abs(p[2]) < 1e-9; };
  for (const double angle : { 44.0, 46.0 })
  {
    vtkNew<vtkAnisotropicRemesher> filter;
    filter->SetFeatureAngle(angle);
    int edges = 0;
    const double expected = angle < 45.0 ? 1.0 : 0.0;
    CHECK_NEAR(lengthAlong(meshOf(filter, input, 200), 2, onRidge, edges), expected, 1e-12);
    CHECK_NEAR(lengthsOfEdges(filter->GetEdgesOutput())[1], expected, 1e-12);
  }
}

/**
 * A ridge that zigzags, or winds slowly, is followed as finely as the mesh is, and no finer: points
 * as dense as its own would be at the tips of thin triangles. One that winds faster than edges of
 * the mesh can follow has more points.
 */
void testZigzag()
{
  const auto pointsOnRidge = [](const std::function<double(int)>& bend)
  {
    vtkNew<vtkAnisotropicRemesher> filter;
    const auto mesh = meshOf(filter, roof(bend), 300);
    int count = 0;
    for (vtkIdType k = 0; k < mesh->GetNumberOfPoints(); ++k)
    {
      count += pointOf(mesh, k)[2] > -1e-9;
    }
    return count;
  };
  const int zigzag = pointsOnRidge([](int j) { return j % 2 ? 3e-3 : -3e-3; });
  CHECK(zigzag > 10);
  CHECK(zigzag < 32);
  const int winding = pointsOnRidge([](int j) { return 6e-3 * std::sin(0.3 * j); });
  CHECK(winding > 10);
  CHECK(winding < 32);
  const int bent = pointsOnRidge([](int j) { return 1e-2 * std::sin(0.9 * j); });
  CHECK(bent > 40);
}
}

int TestRidges(int, char*[])
{
  testAngle();
  testZigzag();
  return result();
}
