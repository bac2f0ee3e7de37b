// Runs without a result leave nothing behind: on no port, and no facts of an earlier run.

#include "TestHelpers.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkGaussMapEmbedding.h"
#include "vtkMetricEmbedding.h"
#include "vtkSolutionMetric.h"
#include "vtkSpectralEmbedding.h"
#include "vtkSurfaceMeshComparison.h"

#include "vtkIntArray.h"
#include "vtkObjectFactory.h"

#include <functional>
#include <limits>
#include <new>
#include <utility>

using namespace remesh;
using namespace remesh::test;

namespace
{
/** Labels that take all memory when their values are asked for. */
class Unreadable : public vtkIntArray
{
public:
  static Unreadable* New();
  vtkTypeMacro(Unreadable, vtkIntArray);
  using vtkIntArray::GetTuples;
  void GetTuples(vtkIdList*, vtkAbstractArray*) override { throw std::bad_alloc(); }
};
vtkStandardNewMacro(Unreadable);

vtkSmartPointer<vtkPolyData> sphere()
{
  return polyDataOf(icosphere(2));
}

/** The executive passes field data to all ports. */
vtkSmartPointer<vtkPolyData> sphereWithFieldData()
{
  const auto input = sphere();
  vtkNew<vtkIntArray> year;
  year->SetName("Year");
  year->InsertNextValue(2012);
  input->GetFieldData()->AddArray(year);
  return input;
}

void checkSilent(vtkAlgorithm* filter, const std::string& where)
{
  Messages messages(filter);
  filter->Update();
  check(
    messages.errors().empty() && messages.warnings().empty() && messages.executiveErrors().empty(),
    __FILE__, __LINE__, where + ": not silent");
  check(outputsAreEmpty(filter), __FILE__, __LINE__, where + ": not empty");
}

void checkFails(vtkAlgorithm* filter, const std::string& words)
{
  Messages messages(filter);
  filter->Update();
  CHECK_EQUAL(messages.errors().size(), std::size_t(1));
  CHECK_EQUAL(messages.executiveErrors().size(), std::size_t(1));
  check(!messages.errors().empty() && messages.errors()[0].find(words) != std::string::npos,
    __FILE__, __LINE__, "no word of: " + words);
  check(outputsAreEmpty(filter), __FILE__, __LINE__, words + ": the outputs are not empty");
}

/** Where nothing comes in, arrays are not looked for, nor sites and points counted. */
void testEmptyInput()
{
  using Change = std::function<void(vtkAnisotropicRemesher*)>;
  const std::pair<const char*, Change> changes[] = {
    { "density", [](vtkAnisotropicRemesher* filter) { filter->SetDensityArray("D"); } },
    { "embedding", [](vtkAnisotropicRemesher* filter) { filter->SetEmbeddingArray("E"); } },
    { "labels", [](vtkAnisotropicRemesher* filter) { filter->SetFeatureLabelArray("L"); } },
    { "coordinates", [](vtkAnisotropicRemesher* filter) { filter->AddCoordinateArray("C", 1.0); } },
    { "normals",
      [](vtkAnisotropicRemesher* filter)
      { filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "N"); } },
    { "sites",
      [](vtkAnisotropicRemesher* filter) { filter->SetInitialSitesData(pointsOnly({})); } },
    { "points", [](vtkAnisotropicRemesher* filter) { filter->SetNumberOfPoints(0); } },
    { "tolerance", [](vtkAnisotropicRemesher* filter) { filter->SetDistanceTolerance(0.01); } },
  };
  vtkNew<vtkPolyData> empty;
  empty->GetFieldData()->ShallowCopy(sphereWithFieldData()->GetFieldData());
  for (const auto& [name, change] : changes)
  {
    vtkNew<vtkAnisotropicRemesher> filter;
    filter->SetInputData(empty);
    change(filter);
    checkSilent(filter, std::string("empty input, ") + name);
  }
  vtkNew<vtkGaussMapEmbedding> embedding;
  embedding->SetInputData(empty);
  embedding->SetEmbeddingArray("E");
  checkSilent(embedding, "empty input of the embedding");
  vtkNew<vtkSolutionMetric> metric;
  metric->SetInputData(empty);
  metric->AddSolutionArray("E");
  checkSilent(metric, "empty input of the metric");
  vtkNew<vtkMetricEmbedding> embedded;
  embedded->SetInputData(empty);
  embedded->SetMetricArray("Metric");
  checkSilent(embedded, "empty input of the metric's embedding");
  vtkNew<vtkSpectralEmbedding> spectrum;
  spectrum->SetInputData(empty);
  checkSilent(spectrum, "empty input of the eigenfunctions");
  vtkNew<vtkSurfaceMeshComparison> comparison;
  comparison->SetInputData(empty);
  comparison->SetReferenceData(sphere());
  checkSilent(comparison, "empty mesh of the comparison");
}

/** Memory ends when the first port has its points and triangles already. */
void testFailureWhileWriting()
{
  const auto input = sphereWithFieldData();
  addPointArray<Unreadable>(input, "Labels", 1, [](const Point3&, int) { return 1; });
  vtkNew<vtkAnisotropicRemesher> filter;
  filter->SetNumberOfPoints(50);
  filter->SetInputData(input);
  checkFails(filter, "not enough memory");
}

void testFieldDataAfterError()
{
  const auto input = sphereWithFieldData();
  vtkNew<vtkAnisotropicRemesher> filter;
  filter->SetInputData(input);
  filter->SetNumberOfPoints(3);
  checkFails(filter, "at least 4 points");
  filter->SetNumberOfPoints(50);
  input->GetPoints()->SetPoint(3, 0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  input->Modified();
  checkFails(filter, "not finite");
  vtkNew<vtkGaussMapEmbedding> embedding;
  embedding->SetInputData(input);
  checkFails(embedding, "not finite");
  vtkNew<vtkSurfaceMeshComparison> comparison;
  comparison->SetInputData(input);
  checkFails(comparison, "not finite");
}

void testFactsAfterError()
{
  vtkNew<vtkAnisotropicRemesher> filter;
  filter->SetInputData(sphere());
  filter->SetNumberOfPoints(50);
  filter->Update();
  CHECK(filter->GetDimension() == 6 && filter->GetEnergy() > 0.0);
  CHECK(filter->GetNumberOfInputComponents() == 1 && filter->GetNumberOfUsedThreads() > 0);
  filter->SetNumberOfPoints(3);
  checkFails(filter, "at least 4 points");
  CHECK_EQUAL(filter->GetDimension(), 0);
  CHECK_EQUAL(filter->GetEnergy(), 0.0);
  CHECK_EQUAL(filter->GetNumberOfInputComponents(), 0);
  CHECK_EQUAL(filter->GetNumberOfUsedThreads(), 0);
}
}

int TestEmptyOutputs(int, char*[])
{
  testEmptyInput();
  testFailureWhileWriting();
  testFieldDataAfterError();
  testFactsAfterError();
  return result();
}
