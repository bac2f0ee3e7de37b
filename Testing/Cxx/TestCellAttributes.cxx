// What becomes of the input's cell arrays on the mesh, and of ghost cells.

#include "TestCarriedArrays.h"

#include "vtkBitArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkStaticCellLocator.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariantArray.h"

#include <cmath>
#include <functional>
#include <limits>

using namespace remesh;
using namespace remesh::test;

namespace
{
Point3 centerOf(vtkPolyData* data, vtkIdType cell)
{
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  data->GetCellPoints(cell, size, ids);
  return (pointOf(data, ids[0]) + pointOf(data, ids[1]) + pointOf(data, ids[2])) / 3.0;
}

template <class Array, class Value>
void addCellArray(vtkPolyData* data, const char* name, int components, const Value& value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    for (int c = 0; c < components; ++c)
    {
      array->InsertNextValue(value(cell, c));
    }
  }
  data->GetCellData()->AddArray(array);
}

/** Narrow winding bands. */
int bandAt(const Point3& p)
{
  return static_cast<int>(std::floor(9.0 * p[0] + 0.8 * std::sin(7.0 * p[1]))) - 3;
}

/** A plane with the bands in arrays of all kinds. */
vtkSmartPointer<vtkPolyData> bandedPlane(int cells)
{
  auto data = polyDataOf(gridPatch(cells, cells));
  data->BuildCells();
  const auto band = [&](vtkIdType cell) { return bandAt(centerOf(data, cell)); };
  addCellArray<vtkIntArray>(data, "Int", 1, [&](vtkIdType cell, int) { return band(cell); });
  addCellArray<vtkIdTypeArray>(data, "Origin", 1, [](vtkIdType cell, int) { return cell; });
  addCellArray<vtkFloatArray>(
    data, "Floats", 2, [&](vtkIdType cell, int c) { return c == 0 ? 1.5f : 0.25f * band(cell); });
  addCellArray<vtkStringArray>(
    data, "Name", 1, [&](vtkIdType cell, int) { return "band " + std::to_string(band(cell)); });
  addCellArray<vtkBitArray>(data, "Odd", 1, [&](vtkIdType cell, int) { return band(cell) & 1; });
  addCellArray<vtkVariantArray>(
    data, "Variant", 1, [](vtkIdType cell, int) { return vtkVariant(cell); });
  addCellArray<vtkDoubleArray>(data, "Holes", 1,
    [&](vtkIdType cell, int)
    { return band(cell) < 2 ? std::numeric_limits<double>::quiet_NaN() : 2.0; });
  return data;
}

/** Cells of the plane under a triangle, by number of samples; none if the samples leave it. */
std::map<vtkIdType, int> sampleCells(vtkStaticCellLocator* locator, vtkPolyData* mesh, vtkIdType t)
{
  constexpr int steps = 40;
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  mesh->GetCellPoints(t, size, ids);
  const Point3 a = pointOf(mesh, ids[0]), b = pointOf(mesh, ids[1]), c = pointOf(mesh, ids[2]);
  std::map<vtkIdType, int> counts;
  for (int i = 0; i < steps; ++i)
  {
    for (int j = 0; i + j < steps; ++j)
    {
      const double u = (i + 1.0 / 3.0) / steps, v = (j + 1.0 / 3.0) / steps;
      Point3 place = a + u * (b - a) + v * (c - a);
      ++counts[locator->FindCell(place.data())];
    }
  }
  return counts;
}

/** The band with the most samples covers a triangle, unless it is a matter of the sampling. */
void testCellsUnderTriangles(int cells, vtkIdType points)
{
  const auto input = bandedPlane(cells);
  const Filter filter = makeFilter(input, points);
  CHECK(run(filter).empty());
  vtkPolyData* mesh = filter->GetOutput();
  vtkCellData* data = mesh->GetCellData();
  CHECK_EQUAL(data->GetNumberOfArrays(), input->GetCellData()->GetNumberOfArrays());
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(input);
  locator->BuildLocator();
  const auto bands = arrayOf(data, "Int");
  auto* names = vtkStringArray::SafeDownCast(data->GetAbstractArray("Name"));
  auto* variants = vtkVariantArray::SafeDownCast(data->GetAbstractArray("Variant"));
  int mixed = 0;
  for (vtkIdType t = 0; t < mesh->GetNumberOfCells(); ++t)
  {
    const std::map<vtkIdType, int> counts = sampleCells(locator, mesh, t);
    std::map<int, int> ofBands;
    std::map<int, int> ofParity;
    std::map<bool, int> ofHoles;
    int most = 0, samples = 0;
    for (const auto& [cell, count] : counts)
    {
      CHECK(cell >= 0);
      const int band = bandAt(centerOf(input, std::max<vtkIdType>(cell, 0)));
      ofBands[band] += count;
      ofParity[band & 1] += count;
      ofHoles[band < 2] += count;
      most = std::max(most, count);
      samples += count;
    }
    mixed += ofBands.size() > 1 ? 1 : 0;
    const double slack = 0.05 * samples;
    const auto isMost = [&](const auto& groups, auto key)
    {
      const auto found = groups.find(key);
      const int count = found == groups.end() ? 0 : found->second;
      return std::all_of(groups.begin(), groups.end(),
        [&](const auto& group) { return count >= group.second - slack; });
    };
    const int band = static_cast<int>(bands->GetComponent(t, 0));
    CHECK(isMost(ofBands, band));
    CHECK_EQUAL(names->GetValue(t), "band " + std::to_string(band));
    CHECK_EQUAL(arrayOf(data, "Floats")->GetComponent(t, 0), 1.5);
    CHECK_EQUAL(arrayOf(data, "Floats")->GetComponent(t, 1), 0.25 * band);
    CHECK(isMost(ofParity, static_cast<int>(arrayOf(data, "Odd")->GetComponent(t, 0))));
    const double hole = arrayOf(data, "Holes")->GetComponent(t, 0);
    CHECK(std::isnan(hole) || hole == 2.0);
    CHECK(isMost(ofHoles, std::isnan(hole)));
    const auto origin = static_cast<vtkIdType>(arrayOf(data, "Origin")->GetComponent(t, 0));
    CHECK(counts.count(origin) == 1);
    CHECK((counts.count(origin) ? counts.at(origin) : 0) >= most - slack);
    CHECK_EQUAL(variants->GetValue(t).ToTypeInt64(), origin);
  }
  CHECK(mixed > mesh->GetNumberOfCells() / 10);
}

/** On a sphere every triangle away from the border has the label of its side. */
void testClosedSurface()
{
  auto input = polyDataOf(icosphere(4));
  input->BuildCells();
  addCellArray<vtkIntArray>(
    input, "Half", 1, [&](vtkIdType cell, int) { return centerOf(input, cell)[0] > 0.1 ? 1 : 0; });
  const Filter filter = makeFilter(input, 400);
  CHECK(run(filter).empty());
  vtkPolyData* mesh = filter->GetOutput();
  const auto halves = arrayOf(mesh->GetCellData(), "Half");
  for (vtkIdType t = 0; t < mesh->GetNumberOfCells(); ++t)
  {
    const double beyond = centerOf(mesh, t).normalized()[0] - 0.1;
    CHECK(std::abs(beyond) < 0.05 || (halves->GetComponent(t, 0) == 1.0) == (beyond > 0.0));
  }
}

/** Equal shares: the lowest cell's value, wherever it stands. */
void testTies()
{
  // A square of two triangles, remeshed to a smaller one of two: one of the two diagonals crosses
  // the mesh's, and then each triangle of the mesh lies half on either.
  int ties = 0;
  for (const bool other : { false, true })
  {
    for (const int first : { 4, 9 })
    {
      TriangleSoup soup = gridPatch(1, 1);
      if (other)
      {
        soup.triangles = { { 0, 1, 2 }, { 1, 3, 2 } };
      }
      auto input = polyDataOf(soup);
      addCellArray<vtkIntArray>(
        input, "Label", 1, [&](vtkIdType cell, int) { return cell == 0 ? first : 13 - first; });
      const Filter filter = makeFilter(input, 4);
      filter->SetInitialSitesData(
        pointsOnly({ { 0.25, 0.25, 0 }, { 0.75, 0.25, 0 }, { 0.75, 0.75, 0 }, { 0.25, 0.75, 0 } }));
      filter->SetNumberOfLloydIterations(0);
      filter->SetNumberOfNewtonIterations(0);
      CHECK(run(filter).empty());
      const auto labels = arrayOf(filter->GetOutput()->GetCellData(), "Label");
      CHECK_EQUAL(labels->GetNumberOfTuples(), 2);
      const double low = labels->GetRange()[0];
      const double high = labels->GetRange()[1];
      CHECK((low == 4.0 && high == 9.0) || (low == first && high == first));
      ties += low == high ? 1 : 0;
    }
  }
  CHECK_EQUAL(ties, 2);
}

vtkSmartPointer<vtkPolyData> plane()
{
  return polyDataOf(gridPatch(12, 12));
}

vtkSmartPointer<vtkUnsignedCharArray> ghostArray(
  vtkPolyData* data, const std::function<bool(vtkIdType)>& isGhost, unsigned char mark)
{
  auto ghosts = vtkSmartPointer<vtkUnsignedCharArray>::New();
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    ghosts->InsertNextValue(isGhost(cell) ? mark : 0);
  }
  return ghosts;
}

/** Cells of other processes and hidden ones are no part of the surface. */
void testGhostCells()
{
  for (const unsigned char mark :
    { vtkDataSetAttributes::DUPLICATECELL, vtkDataSetAttributes::HIDDENCELL })
  {
    auto input = plane();
    input->BuildCells();
    const auto isGhost = [&](vtkIdType cell) { return centerOf(input, cell)[0] > 0.5; };
    addCellArray<vtkIntArray>(
      input, "Label", 1, [&](vtkIdType cell, int) { return isGhost(cell) ? 1 : 0; });
    input->GetCellData()->AddArray(ghostArray(input, isGhost, mark));
    const Filter filter = makeFilter(input, 60);
    CHECK(run(filter).empty());
    vtkPolyData* mesh = filter->GetOutput();
    CHECK_NEAR(areaOf(filter->GetVoronoiCellsOutput()), 0.5, 1e-13);
    CHECK(!mesh->GetCellData()->HasArray(vtkDataSetAttributes::GhostArrayName()));
    CHECK_EQUAL(arrayOf(mesh->GetCellData(), "Label")->GetRange()[1], 0.0);
  }
  auto input = plane();
  input->GetCellData()->AddArray(ghostArray(
    input, [](vtkIdType) { return true; }, vtkDataSetAttributes::DUPLICATECELL));
  const Filter filter = makeFilter(input, 60);
  CHECK(run(filter).empty());
  CHECK(outputsAreEmpty(filter));
}

/** With or without the other ports, in any number of threads. */
void testSameBytes()
{
  const auto input = bandedPlane(60);
  input->GetCellData()->RemoveArray("Variant"); // has no bytes to compare
  addPointArray<vtkFloatArray>(
    input, "Wave", 2, [](const Point3& p, int c) { return std::sin((c + 5) * p[c]); });
  Content expected;
  for (const int threads : { 1, 2, 4 })
  {
    const Filter filter = makeFilter(input, 300);
    filter->SetNumberOfThreads(threads);
    filter->SetGenerateVoronoiCells(threads < 4);
    filter->SetGenerateEdges(threads < 4);
    CHECK(run(filter).empty());
    const Content content = contentOf(filter->GetOutput());
    expected = expected.empty() ? content : expected;
    checkSame(content, expected, std::to_string(threads) + " threads");
  }
}
}

int TestCellAttributes(int, char*[])
{
  testCellsUnderTriangles(60, 80);
  testCellsUnderTriangles(20, 2000);
  testClosedSurface();
  testTies();
  testGhostCells();
  testSameBytes();
  return result();
}
