// SetDensityArray: spacing by its 4th root, on faces and borders; what it leaves as it is; errors.

#include "TestBytes.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkRestrictedVoronoiDiagram.h"

#include <limits>

using namespace remesh;
using namespace remesh::test;

namespace
{
/** The unit square with a density of 16 beyond x = 1/2, of 1 before. */
vtkSmartPointer<vtkPolyData> square()
{
  auto input = polyDataOf(gridPatch(60, 60));
  addPointArray<vtkDoubleArray>(
    input, "Density", 1, [](const Point3& p, int) { return p[0] > 0.5 ? 16.0 : 1.0; });
  return input;
}

template <class Filter = vtkAnisotropicRemesher>
vtkSmartPointer<Filter> filterOf(vtkPolyData* input, const char* density = "Density")
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputData(input);
  filter->SetAnisotropy(0.0);
  filter->SetDensityArray(density);
  if (auto* remesher = vtkAnisotropicRemesher::SafeDownCast(filter))
  {
    remesher->SetNumberOfPoints(1500);
  }
  return filter;
}

double sumOf(vtkFieldData* data, const char* name)
{
  double sum = 0.0;
  const auto array = arrayOf(data, name);
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    sum += array->GetComponent(i, 0);
  }
  return sum;
}

/** Mean length of the mesh's edges with both ends in a strip of the square, or on its border. */
double meanEdge(vtkPolyData* mesh, double low, double high, bool onBorder)
{
  double sum = 0.0;
  int count = 0;
  forEachSide(mesh,
    [&](vtkIdType p, vtkIdType q)
    {
      const Point3 a = pointOf(mesh, p);
      const Point3 b = pointOf(mesh, q);
      const bool within = std::min(a[0], b[0]) > low && std::max(a[0], b[0]) < high;
      const bool border = std::max(a[1], b[1]) < 1e-9;
      if (within && border == onBorder)
      {
        sum += (b - a).norm();
        ++count;
      }
    });
  CHECK(count > 5);
  return sum / count;
}

void testSpacing()
{
  const auto filter = filterOf(square());
  filter->Update();
  vtkPolyData* mesh = filter->GetOutput();
  CHECK_EQUAL(mesh->GetNumberOfPoints(), 1500);
  for (const bool border : { false, true })
  {
    const double sparse = meanEdge(mesh, 0.02, 0.42, border);
    const double dense = meanEdge(mesh, 0.58, 0.98, border);
    CHECK_NEAR(sparse / dense, 2.0, 0.1);
  }
}

/** Areas, masses and energies are the surface's; the weighted mass has an array of its own. */
void testArrays()
{
  const auto filter = filterOf(square());
  filter->Update();
  const double weighted = 0.5 + 0.5 * 16.0; // but for the facets between
  for (const int port : { vtkAnisotropicRemesher::SURFACE, vtkAnisotropicRemesher::SITES })
  {
    vtkPointData* data =
      vtkPolyData::SafeDownCast(filter->GetOutputDataObject(port))->GetPointData();
    CHECK_NEAR(sumOf(data, "CellArea"), 1.0, 1e-12);
    CHECK_NEAR(sumOf(data, "CellMass"), 1.0, 1e-12);
    CHECK_NEAR(sumOf(data, "CellWeightedMass"), weighted, 15.0 / 60.0);
  }
  CHECK_NEAR(sumOf(filter->GetOutput()->GetPointData(), "CellWeightedMass"),
    sumOf(filter->GetSitesOutput()->GetPointData(), "CellWeightedMass"), 1e-12);
  // Chosen as the points' active scalars, the same array does the same.
  const auto byAttribute = filterOf(square(), nullptr);
  vtkPolyData::SafeDownCast(byAttribute->GetInput())->GetPointData()->SetActiveScalars("Density");
  byAttribute->SetInputArrayToProcess(
    3, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  byAttribute->Update();
  checkSame(contentOf(byAttribute->GetOutput()), contentOf(filter->GetOutput()), "by attribute");
  // The same sites without density.
  const auto plain = filterOf<vtkRestrictedVoronoiDiagram>(square(), nullptr);
  plain->SetSitesData(filter->GetSitesOutput());
  plain->Update();
  const auto again = filterOf<vtkRestrictedVoronoiDiagram>(square());
  again->SetSitesData(filter->GetSitesOutput());
  again->Update();
  for (const char* name : { "CellMass", "CellEnergy", "Centroid", "CellArea" })
  {
    const auto array = arrayOf(again->GetSitesOutput()->GetPointData(), name);
    const auto expected = arrayOf(plain->GetSitesOutput()->GetPointData(), name);
    for (vtkIdType i = 0; i < expected->GetNumberOfTuples(); ++i)
    {
      CHECK_NEAR((tupleOf(array, i) - tupleOf(expected, i)).norm(), 0.0, 1e-12);
    }
  }
  CHECK(again->GetEnergy() > plain->GetEnergy());
  CHECK(!plain->GetOutput()->GetPointData()->HasArray("CellWeightedMass"));
  CHECK(again->GetVoronoiCellsOutput()->GetCellData()->HasArray("CellWeightedMass"));
  const auto energy = arrayOf(filter->GetConvergenceOutput()->GetRowData(), "Energy");
  CHECK_NEAR(energy->GetComponent(energy->GetNumberOfTuples() - 1, 0), filter->GetEnergy(),
    1e-12 * filter->GetEnergy());
}

void testThreads()
{
  const auto one = filterOf(square());
  one->SetNumberOfThreads(1);
  one->SetSMPBackend(vtkAnisotropicRemesher::SMP_SEQUENTIAL);
  one->Update();
  const auto many = filterOf(square());
  many->SetNumberOfThreads(8);
  many->SetSMPBackend(vtkAnisotropicRemesher::SMP_STDTHREAD);
  many->Update();
  checkSame(contentsOf(many), contentsOf(one), "8 threads");
}

/** The same everywhere, "None" and "" are no density. */
void testNone()
{
  const auto plain = filterOf(square(), nullptr);
  plain->Update();
  for (const char* name : { "", "None" })
  {
    const auto filter = filterOf(square(), name);
    filter->Update();
    checkSame(contentsOf(filter), contentsOf(plain), std::string("density \"") + name + "\"");
  }
  // One value everywhere is a factor of the energy.
  const auto input = square();
  addPointArray<vtkDoubleArray>(input, "Density", 1, [](const Point3&, int) { return 4.0; });
  const auto one = filterOf<vtkRestrictedVoronoiDiagram>(square(), nullptr);
  const auto four = filterOf<vtkRestrictedVoronoiDiagram>(input);
  for (const auto& filter : { one, four })
  {
    filter->SetSitesData(plain->GetSitesOutput());
    filter->Update();
  }
  CHECK_NEAR(four->GetEnergy(), 4.0 * one->GetEnergy(), 1e-12 * four->GetEnergy());
}

void checkFails(vtkPolyData* input, const char* density, const std::string& words)
{
  const auto filter = filterOf(input, density);
  Messages messages(filter);
  filter->Update();
  const bool told =
    messages.errors().size() == 1 && messages.errors()[0].find(words) != std::string::npos;
  check(told, __FILE__, __LINE__,
    words + " is not told, but " + (messages.errors().empty() ? "nothing" : messages.errors()[0]));
  CHECK(outputsAreEmpty(filter));
}

void testErrors()
{
  checkFails(square(), "Missing", "no numeric point array \"Missing\"");
  for (const double odd : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity() })
  {
    const auto input = square();
    input->GetPointData()->GetArray("Density")->SetComponent(77, 0, odd);
    checkFails(input, "Density", "at point 77 that is not a finite number above 0");
  }
  const auto input = square();
  input->GetPointData()->GetArray("Density")->SetComponent(77, 0, 1e-50);
  checkFails(input, "Density", "1e40 times another");
  addPointArray<vtkDoubleArray>(input, "Two", 2, [](const Point3&, int) { return 1.0; });
  checkFails(input, "Two", "2 components; a density has 1");
  vtkNew<vtkDoubleArray> shortArray;
  shortArray->SetName("Short");
  shortArray->InsertNextValue(1.0);
  input->GetPointData()->AddArray(shortArray);
  checkFails(input, "Short", "has 1 tuples");
}
}

int TestDensity(int, char*[])
{
  testSpacing();
  testArrays();
  testThreads();
  testNone();
  testErrors();
  return result();
}
