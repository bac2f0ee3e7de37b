// vtkAnisotropicRemesher: what its properties and its second input change.

#include "TestBytes.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkSurfaceMeshComparison.h"

#include <functional>

using namespace remesh;
using namespace remesh::test;

namespace
{
constexpr vtkIdType numberOfSites = 300;

/** A second filter with one thing changed. */
vtkSmartPointer<vtkAnisotropicRemesher> run(
  vtkPolyData* input, const std::function<void(vtkAnisotropicRemesher*)>& change)
{
  auto filter = vtkSmartPointer<vtkAnisotropicRemesher>::New();
  filter->SetInputData(input);
  filter->SetNumberOfPoints(numberOfSites);
  filter->SetNumberOfLloydIterations(6);
  filter->SetNumberOfNewtonIterations(4);
  filter->SetSeed(5);
  filter->SetAnisotropy(0.1);
  change(filter);
  filter->Update();
  return filter;
}

void testOptions(vtkPolyData* input)
{
  const auto plain = run(input, [](vtkAnisotropicRemesher*) {});
  const auto embedding = [](vtkAnisotropicRemesher* filter)
  { return contentOf(filter->GetSitesOutput()).at("point Embedding"); };

  const auto lean = run(input,
    [](vtkAnisotropicRemesher* filter)
    {
      filter->GenerateVoronoiCellsOff();
      filter->GenerateEdgesOff();
    });
  CHECK_EQUAL(lean->GetVoronoiCellsOutput()->GetNumberOfPoints(), 0);
  CHECK_EQUAL(lean->GetEdgesOutput()->GetNumberOfPoints(), 0);
  checkSame(contentOf(lean->GetOutput()), contentOf(plain->GetOutput()), "without cells");
  checkSame(contentOf(lean->GetSitesOutput()), contentOf(plain->GetSitesOutput()), "without cells");

  // The distances are those that the comparison finds.
  vtkNew<vtkSurfaceMeshComparison> comparison;
  comparison->SetInputData(0, plain->GetOutput());
  comparison->SetInputData(1, input);
  comparison->Update();
  const auto fact = [](vtkPolyData* data, const char* name)
  { return arrayOf(data->GetFieldData(), name)->GetComponent(0, 0); };
  const double rms = fact(comparison->GetOutput(), "RMSDistance");
  const double maximum = fact(comparison->GetOutput(), "MaximumDistance");
  CHECK_NEAR(fact(plain->GetOutput(), "RMSDistance"), rms, 0.1 * rms);
  CHECK_NEAR(fact(plain->GetOutput(), "MaximumDistance"), maximum, 0.1 * maximum);
  const auto unmeasured =
    run(input, [](vtkAnisotropicRemesher* filter) { filter->MeasureDistanceOff(); });
  CHECK(!unmeasured->GetOutput()->GetFieldData()->HasArray("RMSDistance"));

  const auto bare =
    run(input, [](vtkAnisotropicRemesher* filter) { filter->SetMaximumCellEmbeddingDimension(5); });
  CHECK(!bare->GetVoronoiCellsOutput()->GetPointData()->HasArray("Embedding"));

  const auto otherSeed = run(input, [](vtkAnisotropicRemesher* filter) { filter->SetSeed(6); });
  CHECK(embedding(otherSeed) != embedding(plain));
  const auto random = run(input,
    [](vtkAnisotropicRemesher* filter)
    { filter->SetSamplingMethod(vtkAnisotropicRemesher::RANDOM); });
  CHECK(embedding(random) != embedding(plain));
  CHECK_EQUAL(random->GetSitesOutput()->GetNumberOfPoints(), numberOfSites);

  const auto more = [](bool coarseStart)
  {
    return [=](vtkAnisotropicRemesher* filter)
    {
      filter->SetNumberOfPoints(500);
      filter->SetCoarseStart(coarseStart);
    };
  };
  const auto grown = run(input, more(true));
  CHECK(grown->GetEnergy() < run(input, more(false))->GetEnergy());
  CHECK_EQUAL(grown->GetOutput()->GetNumberOfPoints(), 500);

  // Anisotropy 0 is plain R^3, and so is the mode POSITION.
  const auto zero = run(input, [](vtkAnisotropicRemesher* filter) { filter->SetAnisotropy(0.0); });
  CHECK_EQUAL(zero->GetDimension(), 3);
  const auto position = run(input,
    [](vtkAnisotropicRemesher* filter)
    { filter->SetEmbeddingMode(vtkAnisotropicRemesher::POSITION); });
  checkSame(contentsOf(position), contentsOf(zero), "POSITION and Anisotropy 0");
  const auto mass = arrayOf(zero->GetSitesOutput()->GetPointData(), "CellMass");
  const auto area = arrayOf(zero->GetSitesOutput()->GetPointData(), "CellArea");
  for (vtkIdType i = 0; i < numberOfSites; ++i)
  {
    CHECK_NEAR(mass->GetComponent(i, 0), area->GetComponent(i, 0), 1e-13);
  }
}

/** Initial sites: their number counts, and without iterations they stay. */
void testInitialSites(vtkPolyData* input)
{
  const auto first = run(input,
    [](vtkAnisotropicRemesher* filter)
    {
      filter->SetNumberOfPoints(57);
      filter->SetNumberOfLloydIterations(0);
      filter->SetNumberOfNewtonIterations(0);
    });
  CHECK_EQUAL(first->GetConvergenceOutput()->GetNumberOfRows(), 1);
  const auto again = run(input,
    [&](vtkAnisotropicRemesher* filter)
    {
      filter->SetInitialSitesData(first->GetSitesOutput());
      filter->SetNumberOfLloydIterations(0);
      filter->SetNumberOfNewtonIterations(0);
    });
  CHECK_EQUAL(again->GetSitesOutput()->GetNumberOfPoints(), 57);
  for (vtkIdType i = 0; i < 57; ++i)
  {
    const Eigen::VectorXd shift =
      tupleOf(arrayOf(again->GetSitesOutput()->GetPointData(), "Embedding"), i) -
      tupleOf(arrayOf(first->GetSitesOutput()->GetPointData(), "Embedding"), i);
    CHECK_EQUAL(shift.norm(), 0.0);
  }
  // Through a connection, with iterations: goes on where the first one stopped.
  const auto further = run(input,
    [&](vtkAnisotropicRemesher* filter)
    { filter->SetInitialSitesConnection(first->GetOutputPort(vtkAnisotropicRemesher::SITES)); });
  const auto energy = arrayOf(further->GetConvergenceOutput()->GetRowData(), "Energy");
  CHECK_NEAR(energy->GetComponent(0, 0), first->GetEnergy(), 1e-12 * first->GetEnergy());
  CHECK(further->GetEnergy() < first->GetEnergy());
}
}

int TestRemesherOptions(int, char*[])
{
  const auto input = polyDataOf(ellipsoid(4));
  testOptions(input);
  testInitialSites(input);
  return result();
}
