// Defaults, clamping and PrintSelf of the filters' properties.

#include "TestHelpers.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkGaussMapEmbedding.h"
#include "vtkRestrictedVoronoiDiagram.h"

#include <sstream>

using namespace remesh;
using namespace remesh::test;

namespace
{
std::string printed(vtkObject* object)
{
  std::ostringstream text;
  object->Print(text);
  return text.str();
}

void checkPrints(vtkObject* object, const std::vector<const char*>& names)
{
  const std::string text = printed(object);
  for (const char* name : names)
  {
    check(text.find(std::string(" ") + name + ": ") != std::string::npos, __FILE__, __LINE__,
      std::string(object->GetClassName()) + " does not print " + name);
  }
}

const std::vector<const char*> ofSurfaces = { "EmbeddingMode", "Anisotropy",
  "NormalSmoothingPasses", "NormalSmoothingRadius", "MergeTolerance", "CoordinateArrays",
  "NumberOfThreads", "SMPBackend", "NumberOfInputComponents", "NumberOfDroppedTriangles",
  "NumberOfMergedPoints", "UsedBackend", "NumberOfUsedThreads" };
const std::vector<const char*> ofDiagrams = { "VertexPlacement", "GenerateVoronoiCells",
  "GenerateEdges", "MeasureDistance", "MaximumCellEmbeddingDimension", "Dimension",
  "NumberOfIterations", "NumberOfEvaluations", "Energy", "TopologyReport" };
const std::vector<const char*> ofRemesher = { "NumberOfPoints", "SamplingMethod", "CoarseStart",
  "Seed", "NumberOfLloydIterations", "NumberOfNewtonIterations", "HistoryLength",
  "GradientTolerance", "EnergyTolerance", "MaximumNumberOfExtraPoints", "DistanceTolerance",
  "DistanceToleranceIsAbsolute", "MaximumNumberOfPoints", "PreserveFeatures", "FeatureAngle" };

/** Values below and above the range become its ends; what is set twice is modified once. */
template <class Value, class Set, class Get>
void checkClamped(
  vtkObject* object, const char* name, Value lowest, Value highest, const Set& set, const Get& get)
{
  const auto expect = [&](Value given, Value expected)
  {
    set(given);
    check(get() == expected, __FILE__, __LINE__, described(name, "clamped", get(), expected));
    const vtkMTimeType time = object->GetMTime();
    set(given);
    check(object->GetMTime() == time, __FILE__, __LINE__, std::string(name) + " modified twice");
  };
  expect(lowest, lowest);
  expect(highest, highest);
  expect(static_cast<Value>(lowest - 1), lowest);
  if (static_cast<double>(highest) < 1e9)
  {
    expect(static_cast<Value>(highest + 1), highest);
  }
}

#define CHECK_CLAMPED(filter, Property, lowest, highest)                                           \
  checkClamped<decltype(filter->Get##Property())>(                                                 \
    filter, #Property, lowest, highest, [&](auto value) { filter->Set##Property(value); },         \
    [&]() { return filter->Get##Property(); })

void testSurfaceProperties(vtkEmbeddedSurfaceAlgorithm* filter)
{
  using Algorithm = vtkEmbeddedSurfaceAlgorithm;
  CHECK_EQUAL(filter->GetEmbeddingMode(), static_cast<int>(Algorithm::GAUSS_MAP));
  CHECK_EQUAL(filter->GetAnisotropy(), 0.04);
  CHECK_EQUAL(filter->GetNormalSmoothingPasses(), -1);
  CHECK_EQUAL(filter->GetNormalSmoothingRadius(), -1.0);
  CHECK_EQUAL(filter->GetMergeTolerance(), 0.0);
  CHECK_EQUAL(filter->GetNumberOfCoordinateArrays(), 0);
  CHECK_EQUAL(filter->GetNumberOfThreads(), 0);
  CHECK_EQUAL(filter->GetSMPBackend(), static_cast<int>(Algorithm::SMP_AUTOMATIC));
  // Facts, before the first execution.
  CHECK_EQUAL(filter->GetNumberOfInputComponents(), 0);
  CHECK_EQUAL(filter->GetNumberOfDroppedTriangles(), 0);
  CHECK_EQUAL(filter->GetNumberOfMergedPoints(), 0);
  CHECK_EQUAL(std::string(filter->GetUsedBackend()), "");
  CHECK_EQUAL(filter->GetNumberOfUsedThreads(), 0);
  checkPrints(filter, ofSurfaces);

  CHECK_CLAMPED(filter, EmbeddingMode, 0, 1);
  CHECK_CLAMPED(filter, Anisotropy, 0.0, 1.0);
  CHECK_CLAMPED(filter, NormalSmoothingPasses, -1, 10000);
  CHECK_CLAMPED(filter, NormalSmoothingRadius, -1.0, VTK_DOUBLE_MAX);
  CHECK_CLAMPED(filter, MergeTolerance, 0.0, 0.1);
  CHECK_CLAMPED(filter, NumberOfThreads, 0, 1024);
  CHECK_CLAMPED(filter, SMPBackend, 0, 3);

  // Coordinate arrays: in the order given, and each change is one.
  vtkMTimeType time = filter->GetMTime();
  filter->AddCoordinateArray("A", 0.5);
  filter->AddCoordinateArray("B", -2.0);
  CHECK(filter->GetMTime() > time);
  CHECK_EQUAL(filter->GetNumberOfCoordinateArrays(), 2);
  CHECK_EQUAL(std::string(filter->GetCoordinateArrayName(0)), "A");
  CHECK_EQUAL(std::string(filter->GetCoordinateArrayName(1)), "B");
  CHECK_EQUAL(filter->GetCoordinateArrayScale(0), 0.5);
  CHECK_EQUAL(filter->GetCoordinateArrayScale(1), -2.0);
  const std::string text = printed(filter);
  CHECK(text.find("A * 0.5") != std::string::npos);
  CHECK(text.find("B * -2") != std::string::npos);
  for (const int outside : { -1, 2, 1000 })
  {
    CHECK(filter->GetCoordinateArrayName(outside) == nullptr);
    CHECK_EQUAL(filter->GetCoordinateArrayScale(outside), 0.0);
  }
  time = filter->GetMTime();
  filter->ClearCoordinateArrays();
  CHECK(filter->GetMTime() > time);
  CHECK_EQUAL(filter->GetNumberOfCoordinateArrays(), 0);
}

void testDiagramProperties(vtkRestrictedVoronoiAlgorithm* filter)
{
  CHECK_EQUAL(filter->GetNumberOfInputPorts(), 2);
  CHECK_EQUAL(filter->GetNumberOfOutputPorts(), 5);
  CHECK_EQUAL(filter->GetGenerateVoronoiCells(), true);
  CHECK_EQUAL(filter->GetGenerateEdges(), true);
  CHECK_EQUAL(filter->GetMeasureDistance(), true);
  CHECK_EQUAL(filter->GetMaximumCellEmbeddingDimension(), 16);
  CHECK_EQUAL(filter->GetDimension(), 0);
  CHECK_EQUAL(filter->GetNumberOfIterations(), 0);
  CHECK_EQUAL(filter->GetNumberOfEvaluations(), 0);
  CHECK_EQUAL(filter->GetEnergy(), 0.0);
  CHECK_EQUAL(filter->GetPhaseSeconds("lloyd"), 0.0);
  checkPrints(filter, ofDiagrams);
  CHECK_EQUAL(filter->GetVertexPlacement(), static_cast<int>(vtkAnisotropicRemesher::FIT));
  CHECK_CLAMPED(filter, VertexPlacement, 0, 3);
  CHECK_CLAMPED(filter, MaximumCellEmbeddingDimension, 0, 100000);
  filter->GenerateVoronoiCellsOff();
  filter->GenerateEdgesOff();
  CHECK(!filter->GetGenerateVoronoiCells() && !filter->GetGenerateEdges());
  filter->GenerateVoronoiCellsOn();
  filter->GenerateEdgesOn();
  CHECK(filter->GetGenerateVoronoiCells() && filter->GetGenerateEdges());
}

void testRemesher()
{
  vtkNew<vtkAnisotropicRemesher> filter;
  CHECK_EQUAL(filter->GetNumberOfPoints(), 10000);
  CHECK_EQUAL(filter->GetSamplingMethod(), static_cast<int>(vtkAnisotropicRemesher::STRATIFIED));
  CHECK_EQUAL(filter->GetCoarseStart(), true);
  CHECK_EQUAL(filter->GetSeed(), 0);
  CHECK_EQUAL(filter->GetHistoryLength(), 7);
  CHECK_EQUAL(filter->GetGradientTolerance(), 0.0);
  CHECK_EQUAL(filter->GetEnergyTolerance(), 0.0);
  CHECK_EQUAL(filter->GetNumberOfLloydIterations(), 5);
  CHECK_EQUAL(filter->GetNumberOfNewtonIterations(), 30);
  CHECK_EQUAL(filter->GetDistanceTolerance(), 0.0);
  CHECK_EQUAL(filter->GetDistanceToleranceIsAbsolute(), false);
  CHECK_EQUAL(filter->GetMaximumNumberOfPoints(), 1000000);
  CHECK_EQUAL(filter->GetPreserveFeatures(), true);
  CHECK_EQUAL(filter->GetFeatureAngle(), 35.0);
  testSurfaceProperties(filter);
  testDiagramProperties(filter);
  checkPrints(filter, ofRemesher);
  CHECK_CLAMPED(filter, NumberOfPoints, vtkIdType(0), vtkIdType(VTK_ID_MAX));
  CHECK_CLAMPED(filter, SamplingMethod, 0, 1);
  CHECK_EQUAL(filter->GetMaximumNumberOfExtraPoints(),
    static_cast<vtkIdType>(vtkAnisotropicRemesher::ONE_PERCENT));
  CHECK_CLAMPED(filter, MaximumNumberOfExtraPoints, vtkIdType(-2), vtkIdType(VTK_ID_MAX));
  CHECK_CLAMPED(filter, NumberOfLloydIterations, 0, 100000);
  CHECK_CLAMPED(filter, NumberOfNewtonIterations, 0, 100000);
  CHECK_CLAMPED(filter, DistanceTolerance, 0.0, VTK_DOUBLE_MAX);
  CHECK_CLAMPED(filter, MaximumNumberOfPoints, vtkIdType(4), vtkIdType(VTK_ID_MAX));
  CHECK_CLAMPED(filter, FeatureAngle, 0.0, 180.0);
  CHECK_CLAMPED(filter, HistoryLength, 1, 100);
  CHECK_CLAMPED(filter, GradientTolerance, 0.0, 1.0);
  CHECK_CLAMPED(filter, EnergyTolerance, 0.0, 1.0);
  filter->SetSeed(-5);
  CHECK_EQUAL(filter->GetSeed(), -5);
}

/** A property runs the filter again; a getter does not. */
void testModification()
{
  vtkNew<vtkAnisotropicRemesher> filter;
  filter->SetInputData(polyDataOf(icosphere(2)));
  filter->SetNumberOfPoints(20);
  int runs = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&runs);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  filter->AddObserver(vtkCommand::EndEvent, count);
  filter->Update();
  filter->Update();
  printed(filter);
  filter->GetPhaseSeconds("lloyd");
  filter->Update();
  CHECK_EQUAL(runs, 1);
  filter->SetSeed(9);
  filter->Update();
  CHECK_EQUAL(runs, 2);
  filter->SetEmbeddingArray("");
  filter->Update();
  CHECK(runs <= 3);
}
}

int TestProperties(int, char*[])
{
  testRemesher();
  vtkNew<vtkRestrictedVoronoiDiagram> diagram;
  testSurfaceProperties(diagram);
  testDiagramProperties(diagram);
  vtkNew<vtkGaussMapEmbedding> embedding;
  testSurfaceProperties(embedding);
  checkPrints(embedding, { "NumberOfPoints" });
  CHECK_EQUAL(embedding->GetNumberOfPoints(), 10000);
  CHECK_CLAMPED(embedding, NumberOfPoints, vtkIdType(1), vtkIdType(VTK_ID_MAX));
  CHECK_EQUAL(embedding->GetNumberOfInputPorts(), 1);
  CHECK_EQUAL(embedding->GetNumberOfOutputPorts(), 1);
  testModification();
  return result();
}
