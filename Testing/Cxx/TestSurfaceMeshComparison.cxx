// The comparison of a mesh with a reference: outputs, and their values by formula.

#include "TestComparisons.h"
#include "TestMeasures.h"

#include <limits>

using namespace remesh;
using namespace remesh::test;

namespace
{
const double nan = std::numeric_limits<double>::quiet_NaN();

Comparison compareNow(const TriangleSoup& mesh, const TriangleSoup& reference)
{
  const Comparison filter = compare(polyDataOf(mesh), polyDataOf(reference));
  Messages messages(filter);
  filter->Update();
  CHECK(messages.errors().empty() && messages.warnings().empty());
  return filter;
}

/** A sphere inside another: signs, relative distances, both ways. */
void testSpheres()
{
  const TriangleSoup large = icosphere(2);
  const Comparison filter = compareNow(scaled(large, 0.9), large);
  vtkPolyData* mesh = filter->GetOutput();
  CHECK_EQUAL(mesh->GetNumberOfCells(), 320);
  const auto distance = arrayOf(mesh->GetPointData(), "Distance");
  const auto side = arrayOf(mesh->GetPointData(), "SignedDistance");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    CHECK(distance->GetTuple1(i) > 0.08 && distance->GetTuple1(i) < 0.1);
    CHECK_EQUAL(side->GetTuple1(i), -distance->GetTuple1(i));
  }
  const auto outside = arrayOf(filter->GetReferenceOutput()->GetPointData(), "SignedDistance");
  for (vtkIdType i = 0; i < outside->GetNumberOfTuples(); ++i)
  {
    CHECK_NEAR(outside->GetTuple1(i), 0.1, 1e-14);
  }
  const double diagonal = summaryOf(filter, "ReferenceDiagonal");
  double bounds[6];
  polyDataOf(large)->GetBounds(bounds);
  CHECK_NEAR(diagonal,
    std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]), 1e-14);
  CHECK_NEAR(summaryOf(filter, "MaximumDistance"), 0.1, 1e-14);
  CHECK_NEAR(summaryOf(filter, "MaximumDistanceFromReference"), 0.1, 1e-14);
  CHECK(summaryOf(filter, "MaximumDistanceToReference") < 0.1);
  CHECK(summaryOf(filter, "MaximumDistanceBound") >= 0.1 - 1e-14);
  CHECK(summaryOf(filter, "MaximumDistanceBound") <= 0.101 + 1e-14);
  CHECK_NEAR(summaryOf(filter, "RelativeMaximumDistance"), 0.1 / diagonal, 1e-14);
  CHECK_NEAR(
    summaryOf(filter, "RelativeRMSDistance") * diagonal, summaryOf(filter, "RMSDistance"), 1e-15);
  CHECK_NEAR(summaryOf(filter, "Area"), 0.81 * summaryOf(filter, "ReferenceArea"), 1e-12);
  CHECK_EQUAL(summaryOf(filter, "NumberOfFlippedTriangles"), 0.0);
  CHECK_NEAR(summaryOf(filter, "MaximumNormalDeviation"), 0.0, 1e-6);
  CHECK_EQUAL(summaryOf(filter, "EulerCharacteristic"), 2.0);
  CHECK_EQUAL(summaryOf(filter, "ReferenceEulerCharacteristic"), 2.0);

  filter->BoundMaximumDistanceOff();
  filter->Update();
  CHECK(filter->GetSummaryOutput()->GetColumnByName("MaximumDistanceBound") == nullptr);
}

/** A patch with a hole and one triangle turned over, above a plane. */
void testFaults()
{
  TriangleSoup patch = gridPatch(6, 6, { 0, 0, 0.25 });
  flip(patch, 30);
  patch.triangles.erase(patch.triangles.begin() + 56, patch.triangles.begin() + 58);
  const Comparison filter = compareNow(patch, gridPatch(9, 7));
  const auto flipped = arrayOf(filter->GetOutput()->GetCellData(), "Flipped");
  const auto degrees = arrayOf(filter->GetOutput()->GetCellData(), "NormalDeviation");
  for (vtkIdType t = 0; t < flipped->GetNumberOfTuples(); ++t)
  {
    CHECK_EQUAL(flipped->GetTuple1(t), t == 30 ? 1.0 : 0.0);
    CHECK_NEAR(degrees->GetTuple1(t), t == 30 ? 180.0 : 0.0, 1e-12);
  }
  CHECK_EQUAL(summaryOf(filter, "NumberOfFlippedTriangles"), 1.0);
  CHECK_NEAR(summaryOf(filter, "MeanNormalDeviation"), 180.0 / 70.0, 1e-12);
  CHECK_EQUAL(summaryOf(filter, "IsConsistentlyOriented"), 0.0);
  CHECK_EQUAL(summaryOf(filter, "NumberOfBoundaryLoops"), 2.0);
  CHECK_EQUAL(summaryOf(filter, "NumberOfBoundaryEdges"), 28.0);
  CHECK_EQUAL(summaryOf(filter, "EulerCharacteristic"), 0.0);
  CHECK_EQUAL(summaryOf(filter, "ReferenceNumberOfBoundaryLoops"), 1.0);
  CHECK_NEAR(summaryOf(filter, "MeanDistanceToReference"), 0.25, 1e-13);
  CHECK_NEAR(summaryOf(filter, "RMSDistanceToReference"), 0.25, 1e-13);
  // The middle of the hole is half a square's side away sideways.
  const double farthest = std::hypot(0.25, 1.0 / 12.0);
  CHECK(summaryOf(filter, "MaximumDistanceFromReference") <= farthest + 1e-14);
  CHECK(summaryOf(filter, "MaximumDistanceFromReference") >= farthest / 1.01);
  CHECK(summaryOf(filter, "MaximumDistanceBound") >= farthest - 1e-14);
  // The mesh has no sides to speak of, the reference has.
  CHECK(filter->GetReferenceOutput()->GetPointData()->GetArray("SignedDistance") == nullptr);
  CHECK_NEAR(
    arrayOf(filter->GetOutput()->GetPointData(), "SignedDistance")->GetTuple1(0), 0.25, 1e-15);

  // Right-angled triangles all: one bin of each histogram but the normals'.
  CHECK_NEAR(summaryOf(filter, "MeanMinimumAngle"), 45.0, 1e-12);
  CHECK_NEAR(summaryOf(filter, "MaximumEdgeRatio"), std::sqrt(2.0), 1e-12);
  vtkTable* histograms = filter->GetHistogramsOutput();
  CHECK_EQUAL(histograms->GetNumberOfRows(), 30);
  CHECK_NEAR(histograms->GetValueByName(22, "MinimumAngle").ToDouble(), 45.0, 1e-12);
  CHECK_EQUAL(histograms->GetValueByName(0, "NormalDeviationTriangles").ToInt(), 69);
  CHECK_EQUAL(histograms->GetValueByName(29, "NormalDeviationTriangles").ToInt(), 1);
  for (const char* name :
    { "QualityTriangles", "MinimumAngleTriangles", "NormalDeviationTriangles" })
  {
    int sum = 0;
    for (vtkIdType bin = 0; bin < 30; ++bin)
    {
      sum += histograms->GetValueByName(bin, name).ToInt();
    }
    CHECK_EQUAL(sum, 70);
  }
}

/** Points that coincide in the reference are merged there, and counted in the mesh. */
void testSeams()
{
  TriangleSoup split;
  const TriangleSoup box = cube();
  for (const auto& [a, b, c] : box.triangles)
  {
    append(split, makeSoup({ box.points[a], box.points[b], box.points[c] }, { { 0, 1, 2 } }),
      { 0, 0, 0 });
  }
  const Comparison filter = compareNow(split, split);
  CHECK_EQUAL(summaryOf(filter, "NumberOfPoints"), 36.0);
  CHECK_EQUAL(summaryOf(filter, "NumberOfDuplicatePoints"), 28.0);
  CHECK_EQUAL(summaryOf(filter, "NumberOfComponents"), 12.0);
  CHECK_EQUAL(summaryOf(filter, "ReferenceNumberOfPoints"), 8.0);
  CHECK_EQUAL(summaryOf(filter, "ReferenceEulerCharacteristic"), 2.0);
  CHECK_NEAR(summaryOf(filter, "MaximumDistance"), 0.0, 1e-15);
  CHECK(summaryOf(filter, "RelativeMaximumDistanceBound") < 1e-6);
  CHECK_EQUAL(summaryOf(filter, "MaximumNormalDeviation"), 0.0);
  CHECK(filter->GetOutput()->GetPointData()->GetArray("SignedDistance") != nullptr);
}

/** Three sheets on a line and a triangle that is there twice; two triangles that touch in a tip. */
void testNoManifold()
{
  TriangleSoup soup = threeSheets();
  const TriangleSoup tip =
    makeSoup({ { 0, 0, 5 }, { 1, 0, 5 }, { 0, 1, 5 }, { -1, 0, 5 }, { 0, -1, 5 } },
      { { 0, 1, 2 }, { 0, 3, 4 } });
  const auto touching = compare(polyDataOf(tip), nullptr);
  touching->Update();
  CHECK_EQUAL(summaryOf(touching, "NumberOfNonManifoldPoints"), 1.0);
  CHECK_EQUAL(summaryOf(touching, "NumberOfNonManifoldEdges"), 0.0);
  CHECK_EQUAL(summaryOf(touching, "IsConsistentlyOriented"), 1.0);

  append(soup, tip, Point3::Zero());
  const auto last = soup.triangles.back();
  soup.triangles.push_back(last);
  soup.inputCells.push_back(static_cast<Offset>(soup.inputCells.size()));
  const auto mesh = polyDataOf(soup);
  const auto filter = compare(mesh, nullptr);
  filter->Update();
  const auto valences = valencesOf(mesh);
  const auto nonManifold = std::count_if(
    valences.begin(), valences.end(), [](const auto& edge) { return edge.second > 2; });
  CHECK(nonManifold > 0);
  CHECK_EQUAL(summaryOf(filter, "NumberOfEdges"), static_cast<double>(valences.size()));
  CHECK_EQUAL(summaryOf(filter, "NumberOfNonManifoldEdges"), static_cast<double>(nonManifold));
  CHECK_EQUAL(summaryOf(filter, "NumberOfDuplicateTriangles"), 1.0);
  CHECK_EQUAL(summaryOf(filter, "IsConsistentlyOriented"), 0.0);

  const auto sphere = compare(polyDataOf(icosphere(2)), nullptr);
  sphere->Update();
  CHECK_EQUAL(summaryOf(sphere, "NumberOfNonManifoldEdges"), 0.0);
  CHECK_EQUAL(summaryOf(sphere, "IsConsistentlyOriented"), 1.0);
  CHECK(summaryOf(sphere, "LeastMinimumAngle") > 50.0);
  CHECK(summaryOf(sphere, "LeastMinimumAngle") < summaryOf(sphere, "MeanMinimumAngle"));
}

void testWithoutReference()
{
  const Comparison filter = compare(polyDataOf(torus(1.0, 0.3, 12, 9)), nullptr);
  filter->SetInputConnection(1, nullptr);
  Messages messages(filter);
  filter->Update();
  CHECK(messages.errors().empty() && messages.warnings().empty());
  CHECK_EQUAL(summaryOf(filter, "EulerCharacteristic"), 0.0);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfCells(), 216);
  CHECK(filter->GetOutput()->GetCellData()->GetArray("Quality") != nullptr);
  CHECK(filter->GetOutput()->GetCellData()->GetArray("Flipped") == nullptr);
  CHECK(filter->GetOutput()->GetPointData()->GetArray("Distance") == nullptr);
  CHECK(filter->GetSummaryOutput()->GetColumnByName("RMSDistance") == nullptr);
  CHECK(filter->GetHistogramsOutput()->GetColumnByName("NormalDeviation") == nullptr);
  CHECK_EQUAL(filter->GetReferenceOutput()->GetNumberOfPoints(), 0);

  // An empty one is none, with a warning.
  filter->SetReferenceData(vtkSmartPointer<vtkPolyData>::New());
  filter->Update();
  CHECK(messages.errors().empty());
  CHECK_EQUAL(messages.warnings().size(), std::size_t(1));
  CHECK_EQUAL(summaryOf(filter, "NumberOfTriangles"), 216.0);

  // A mesh without area has its counts.
  TriangleSoup line;
  line.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } };
  line.triangles = { { 0, 1, 2 } };
  filter->SetReferenceData(nullptr);
  filter->SetInputData(polyDataOf(line));
  messages.clear();
  filter->Update();
  CHECK(messages.errors().empty());
  CHECK_EQUAL(summaryOf(filter, "NumberOfDegenerateTriangles"), 1.0);
  CHECK_EQUAL(summaryOf(filter, "MeanQuality"), 0.0);
}

/** Quadrilaterals, strips, vertices, lines: triangles come out, with the cell data of their cells.
 */
void testOtherCells()
{
  const auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(polyDataOf(gridPatch(3, 1))->GetPoints());
  mesh->GetPoints()->InsertNextPoint(nan, 0.0, 0.0); // of a vertex: no part of the surface
  vtkNew<vtkCellArray> vertices, lines, polygons, strips;
  vertices->InsertNextCell({ 8 });
  lines->InsertNextCell({ 0, 1, 2 });
  polygons->InsertNextCell({ 0, 1, 5, 4 });
  strips->InsertNextCell({ 5, 1, 6, 2, 7, 3 });
  mesh->SetVerts(vertices);
  mesh->SetLines(lines);
  mesh->SetPolys(polygons);
  mesh->SetStrips(strips);
  vtkNew<vtkDoubleArray> label;
  label->SetName("Label");
  for (const double value : { 1.0, 2.0, 3.0, 4.0 })
  {
    label->InsertNextValue(value);
  }
  mesh->GetCellData()->AddArray(label);
  addPointArray<vtkDoubleArray>(mesh, "X", 1, [](const Point3& p, int) { return p.x(); });

  const Comparison filter = compare(mesh, polyDataOf(gridPatch(2, 2, { 0, 0, -1.0 })));
  Messages messages(filter);
  filter->Update();
  CHECK(messages.errors().empty() && messages.warnings().empty());
  vtkPolyData* output = filter->GetOutput();
  CHECK_EQUAL(output->GetNumberOfCells(), 6);
  CHECK_EQUAL(output->GetNumberOfPolys(), 6);
  CHECK_EQUAL(output->GetNumberOfPoints(), 9);
  const auto labels = arrayOf(output->GetCellData(), "Label");
  const double expected[] = { 3.0, 3.0, 4.0, 4.0, 4.0, 4.0 };
  for (vtkIdType t = 0; t < 6; ++t)
  {
    CHECK_EQUAL(labels->GetTuple1(t), expected[t]);
    CHECK_EQUAL(arrayOf(output->GetCellData(), "Flipped")->GetTuple1(t), 0.0);
  }
  CHECK(output->GetPointData()->GetArray("X") != nullptr);
  const auto distance = arrayOf(output->GetPointData(), "Distance");
  CHECK(std::isnan(distance->GetTuple1(8)));
  CHECK_EQUAL(distance->GetTuple1(0), 1.0);
  CHECK_EQUAL(summaryOf(filter, "NumberOfPoints"), 8.0);
  CHECK_NEAR(summaryOf(filter, "MaximumDistanceToReference"), 1.0, 1e-15);
  // The inputs keep what they had.
  CHECK_EQUAL(mesh->GetPointData()->GetNumberOfArrays(), 1);
  CHECK_EQUAL(mesh->GetCellData()->GetNumberOfArrays(), 1);
}
}

int TestSurfaceMeshComparison(int, char*[])
{
  testSpheres();
  testFaults();
  testSeams();
  testWithoutReference();
  testNoManifold();
  testOtherCells();
  return result();
}
