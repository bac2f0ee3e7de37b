// Curves and cells of several parts leave enough points for the rest of the surface.

#include "TestTrials.h"

#include "vtkCleanPolyData.h"
#include "vtkParametricFunctionSource.h"
#include "vtkParametricSuperToroid.h"

using namespace remesh;
using namespace remesh::test;

namespace
{
/**
 * A star with sharp edges, each cut off: two creases close to each other. It is closed but for a
 * slit of a hundred-thousandth of its size.
 */
vtkSmartPointer<vtkPolyData> star()
{
  vtkNew<vtkParametricSuperToroid> shape;
  shape->SetN1(0.3);
  shape->SetN2(2.5);
  vtkNew<vtkParametricFunctionSource> source;
  source->SetParametricFunction(shape);
  source->SetUResolution(120);
  source->SetVResolution(90);
  vtkNew<vtkCleanPolyData> closed;
  closed->SetInputConnection(source->GetOutputPort());
  closed->ToleranceIsAbsoluteOn();
  closed->SetAbsoluteTolerance(1e-7);
  closed->ConvertPolysToLinesOff();
  closed->Update();
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(closed->GetOutput()->GetPoints());
  surface->SetPolys(closed->GetOutput()->GetPolys());
  return surface;
}

/**
 * Curves that take any number of points to be kept apart, and cells that reach both sides of a
 * sheet, leave enough points for the rest of the surface, and for the number asked for.
 */
void testNothingStarves()
{
  const Trial ofStar = keepingMesh(star(), 1000, 0.0, "nearly coincide with others there: 89.");
  CHECK(ofStar.value("RelativeRMSDistance") < 1e-3);
  const Trial ofLeaf = keepingMesh(polyDataOf(leaf(6, 0.02)), 1000, 0.0);
  CHECK(ofLeaf.value("RelativeRMSDistance") < 1e-3);
}
}

int TestStarvation(int, char*[])
{
  testNothingStarves();
  return result();
}
