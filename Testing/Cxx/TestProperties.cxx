// Defaults, ranges and PrintSelf of the filters' properties.

#include "TestHelpers.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkGaussMapEmbedding.h"
#include "vtkMetricEmbedding.h"
#include "vtkRestrictedVoronoiDiagram.h"
#include "vtkSolutionMetric.h"
#include "vtkSpectralEmbedding.h"
#include "vtkSurfaceMeshComparison.h"

#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <type_traits>

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

const std::vector<const char*> ofSurfaces = { "EmbeddingMode", "Anisotropy", "EstimateNormals",
  "NormalSmoothingPasses", "NormalSmoothingRadius", "MergeTolerance", "CoordinateArrays",
  "MetricOrder", "MetricDimension", "LimitMetric", "MetricGrowth", "NumberOfThreads", "SMPBackend",
  "NumberOfInputComponents", "NumberOfDroppedTriangles", "NumberOfMergedPoints", "UsedBackend",
  "NumberOfUsedThreads" };
const std::vector<const char*> ofDiagrams = { "VertexPlacement", "GenerateVoronoiCells",
  "GenerateEdges", "MeasureDistance", "MaximumCellEmbeddingDimension", "Dimension",
  "NumberOfIterations", "NumberOfEvaluations", "Energy", "TopologyReport" };
const std::vector<const char*> ofRemesher = { "NumberOfPoints", "SamplingMethod", "CoarseStart",
  "Seed", "NumberOfLloydIterations", "NumberOfNewtonIterations", "HistoryLength",
  "GradientTolerance", "EnergyTolerance", "MaximumNumberOfExtraPoints", "DistanceTolerance",
  "DistanceToleranceIsAbsolute", "MaximumNumberOfPoints", "PreserveFeatures", "FeatureAngle",
  "UnitEdges", "MetricComplexity" };

/**
 * A value out of the range is kept, and is an error that names the property, the value and what is
 * allowed; one at an end of the range is none. What is set twice is modified once.
 *
 * The input has no polygons, so that no value makes the filter work.
 */
template <class Value, class Set, class Get>
void checkRange(vtkAlgorithm* filter, const std::string& name, const std::array<Value, 2>& ends,
  const Set& set, const Get& get)
{
  const Value before = get();
  const auto errorOf = [&](Value given)
  {
    set(given);
    check(get() == given || std::isnan(static_cast<double>(given)), __FILE__, __LINE__,
      described(name.c_str(), "kept", get(), given));
    Messages messages(filter);
    filter->Update();
    return messages.errors().size() == 1 ? messages.errors()[0] : std::string("not one error");
  };
  const auto expect = [&](Value given, bool allowed)
  {
    std::ostringstream must;
    must << name << " must be ";
    const std::string error = errorOf(given);
    check((error.find(must.str()) == std::string::npos) == allowed, __FILE__, __LINE__,
      described(name.c_str(), "error", error, must.str()));
  };
  const auto [lowest, highest] = ends;
  expect(lowest, true);
  expect(highest, true);
  expect(static_cast<Value>(lowest - 1), false);
  if (static_cast<double>(highest) < 1e9)
  {
    expect(static_cast<Value>(highest + 1), false);
  }
  if constexpr (std::is_floating_point_v<Value>)
  {
    expect(std::numeric_limits<Value>::quiet_NaN(), false);
    expect(std::numeric_limits<Value>::infinity(), false);
  }
  set(before);
  const vtkMTimeType time = filter->GetMTime();
  set(before);
  check(filter->GetMTime() == time, __FILE__, __LINE__, name + " modified twice");
}

#define CHECK_RANGE(filter, Property, lowest, highest)                                             \
  checkRange<decltype(filter->Get##Property())>(                                                   \
    filter, #Property, { lowest, highest }, [&](auto value) { filter->Set##Property(value); },     \
    [&]() { return filter->Get##Property(); })

/** Points alone: an error of its own, after the parameters are looked at. */
vtkSmartPointer<vtkPolyData> pointsAlone()
{
  const auto input = polyDataOf(icosphere(1));
  input->SetPolys(nullptr);
  return input;
}

void testSurfaceProperties(vtkEmbeddedSurfaceAlgorithm* filter)
{
  using Algorithm = vtkEmbeddedSurfaceAlgorithm;
  CHECK_EQUAL(filter->GetEmbeddingMode(), static_cast<int>(Algorithm::GAUSS_MAP));
  CHECK_EQUAL(filter->GetAnisotropy(), 0.04);
  CHECK_EQUAL(filter->GetEstimateNormals(), false);
  CHECK_EQUAL(filter->GetNormalSmoothingPasses(), -1);
  CHECK_EQUAL(filter->GetNormalSmoothingRadius(), -1.0);
  CHECK_EQUAL(filter->GetMergeTolerance(), 0.0);
  CHECK_EQUAL(filter->GetLimitMetric(), true);
  CHECK_EQUAL(filter->GetMetricGrowth(), 5.0);
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

  filter->SetInputData(pointsAlone());
  if (filter->GetNumberOfInputPorts() > 1)
  {
    filter->SetInputData(1, polyDataOf(icosphere(1)));
  }
  CHECK_RANGE(filter, EmbeddingMode, 0, 1);
  CHECK_RANGE(filter, Anisotropy, 0.0, 1.0);
  CHECK_RANGE(filter, NormalSmoothingPasses, -1, 10000);
  CHECK_RANGE(filter, NormalSmoothingRadius, -1.0, VTK_DOUBLE_MAX);
  CHECK_RANGE(filter, MergeTolerance, 0.0, 0.1);
  CHECK_RANGE(filter, MetricGrowth, 1.01, 1000.0);
  CHECK_RANGE(filter, NumberOfThreads, 0, 1024);
  CHECK_RANGE(filter, SMPBackend, 0, 3);

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
  CHECK_RANGE(filter, VertexPlacement, 0, 3);
  CHECK_RANGE(filter, MaximumCellEmbeddingDimension, 0, 100000);
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
  CHECK_EQUAL(filter->GetEnergyTolerance(), 5e-6);
  CHECK_EQUAL(filter->GetNumberOfLloydIterations(), 5);
  CHECK_EQUAL(filter->GetNumberOfNewtonIterations(), 30);
  CHECK_EQUAL(filter->GetDistanceTolerance(), 0.0);
  CHECK_EQUAL(filter->GetDistanceToleranceIsAbsolute(), false);
  CHECK_EQUAL(filter->GetMaximumNumberOfPoints(), 1000000);
  CHECK_EQUAL(filter->GetPreserveFeatures(), true);
  CHECK_EQUAL(filter->GetUnitEdges(), false);
  CHECK_EQUAL(filter->GetMetricComplexity(), 0.0);
  CHECK_EQUAL(filter->GetFeatureAngle(), 35.0);
  testSurfaceProperties(filter);
  testDiagramProperties(filter);
  checkPrints(filter, ofRemesher);
  CHECK_RANGE(filter, SamplingMethod, 0, 1);
  CHECK_EQUAL(filter->GetMaximumNumberOfExtraPoints(),
    static_cast<vtkIdType>(vtkAnisotropicRemesher::ONE_PERCENT));
  CHECK_RANGE(filter, MaximumNumberOfExtraPoints, vtkIdType(-2), vtkIdType(VTK_ID_MAX));
  CHECK_RANGE(filter, NumberOfLloydIterations, 0, 100000);
  CHECK_RANGE(filter, NumberOfNewtonIterations, 0, 100000);
  CHECK_RANGE(filter, DistanceTolerance, 0.0, VTK_DOUBLE_MAX);
  CHECK_RANGE(filter, MaximumNumberOfPoints, vtkIdType(4), vtkIdType(VTK_ID_MAX));
  CHECK_RANGE(filter, MetricComplexity, 0.0, VTK_DOUBLE_MAX);
  CHECK_RANGE(filter, FeatureAngle, 0.0, 180.0);
  CHECK_RANGE(filter, HistoryLength, 1, 100);
  CHECK_RANGE(filter, GradientTolerance, 0.0, 1.0);
  CHECK_RANGE(filter, EnergyTolerance, 0.0, 1.0);
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

void testSolutionMetric()
{
  vtkNew<vtkSolutionMetric> filter;
  checkPrints(filter,
    { "SolutionArrays", "HessianArrays", "MetricArrays", "MetricOrder", "ErrorNorm",
      "NumberOfPoints", "MinimumSize", "MaximumSize", "MaximumRatio", "ChordTolerance",
      "DistanceArray", "DistanceSize", "DistanceGrowth", "NumberOfThreads", "SMPBackend" });
  CHECK_EQUAL(filter->GetMetricOrder(), static_cast<int>(vtkSolutionMetric::METRIC_VTK));
  CHECK_EQUAL(filter->GetErrorNorm(), static_cast<int>(vtkSolutionMetric::L2));
  CHECK_EQUAL(filter->GetNumberOfPoints(), 10000);
  CHECK_EQUAL(filter->GetMinimumSize(), 0.0);
  CHECK_EQUAL(filter->GetMaximumSize(), 0.0);
  CHECK_EQUAL(filter->GetMaximumRatio(), 1000.0);
  CHECK_EQUAL(filter->GetChordTolerance(), 0.0);
  CHECK(filter->GetDistanceArray() == nullptr);
  CHECK_EQUAL(filter->GetDistanceSize(), 0.0);
  CHECK_EQUAL(filter->GetDistanceGrowth(), 0.2);
  filter->SetInputData(pointsAlone());
  constexpr double any = VTK_DOUBLE_MAX;
  CHECK_RANGE(filter, MetricOrder, 0, 2);
  CHECK_RANGE(filter, ErrorNorm, 0, 3);
  CHECK_RANGE(filter, NumberOfPoints, vtkIdType(1), vtkIdType(VTK_ID_MAX));
  CHECK_RANGE(filter, MinimumSize, 0.0, any);
  CHECK_RANGE(filter, MaximumSize, 0.0, any);
  CHECK_RANGE(filter, MaximumRatio, 1.0, 1e6);
  CHECK_RANGE(filter, ChordTolerance, 0.0, any);
  CHECK_RANGE(filter, DistanceSize, 0.0, any);
  CHECK_RANGE(filter, DistanceGrowth, 0.0, any);
  CHECK_RANGE(filter, NumberOfThreads, 0, 1024);
  CHECK_RANGE(filter, SMPBackend, 0, 3);
  filter->SetMaximumSize(2.0);
  CHECK_RANGE(filter, MinimumSize, 0.0, 2.0);
}

void testMetricEmbedding()
{
  vtkNew<vtkMetricEmbedding> filter;
  checkPrints(filter,
    { "MetricArray", "MetricOrder", "NumberOfPoints", "UnitEdges", "MetricComplexity", "Dimension",
      "Refine", "LimitMetric", "MetricGrowth", "NumberOfIterations", "EnergyTolerance" });
  CHECK(filter->GetMetricArray() == nullptr);
  CHECK_EQUAL(filter->GetMetricOrder(), static_cast<int>(vtkMetricEmbedding::METRIC_VTK));
  CHECK_EQUAL(filter->GetNumberOfPoints(), 10000);
  CHECK_EQUAL(filter->GetUnitEdges(), false);
  CHECK_EQUAL(filter->GetMetricComplexity(), 0.0);
  CHECK_EQUAL(filter->GetDimension(), 6);
  CHECK_EQUAL(filter->GetRefine(), true);
  CHECK_EQUAL(filter->GetLimitMetric(), true);
  CHECK_EQUAL(filter->GetMetricGrowth(), 5.0);
  CHECK_EQUAL(filter->GetNumberOfIterations(), 200);
  CHECK_EQUAL(filter->GetEnergyTolerance(), 0.15);
  filter->SetInputData(pointsAlone());
  CHECK_RANGE(filter, MetricOrder, 0, 2);
  CHECK_RANGE(filter, NumberOfPoints, vtkIdType(1), vtkIdType(VTK_ID_MAX));
  CHECK_RANGE(filter, MetricComplexity, 0.0, VTK_DOUBLE_MAX);
  CHECK_RANGE(filter, Dimension, 3, 16);
  CHECK_RANGE(filter, MetricGrowth, 1.01, 1000.0);
  CHECK_RANGE(filter, NumberOfIterations, 0, 100000);
  CHECK_RANGE(filter, EnergyTolerance, 0.0, 1.0);
}

void testSpectralEmbedding()
{
  vtkNew<vtkSpectralEmbedding> filter;
  checkPrints(filter, { "Dimension", "Scaling", "DiffusionTime", "MassMatrix", "BorderCondition" });
  CHECK_EQUAL(filter->GetDimension(), 6);
  CHECK_EQUAL(filter->GetScaling(), static_cast<int>(vtkSpectralEmbedding::COMMUTE_TIME));
  CHECK_EQUAL(filter->GetDiffusionTime(), 0.0);
  CHECK_EQUAL(filter->GetMassMatrix(), static_cast<int>(vtkSpectralEmbedding::LUMPED));
  CHECK_EQUAL(filter->GetBorderCondition(), static_cast<int>(vtkSpectralEmbedding::NATURAL));
  filter->SetInputData(pointsAlone());
  CHECK_RANGE(filter, Dimension, 2, 100000);
  CHECK_RANGE(filter, Scaling, 0, 3);
  CHECK_RANGE(filter, DiffusionTime, 0.0, VTK_DOUBLE_MAX);
  CHECK_RANGE(filter, MassMatrix, 0, 1);
  CHECK_RANGE(filter, BorderCondition, 0, 1);
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
  CHECK_RANGE(embedding, NumberOfPoints, vtkIdType(1), vtkIdType(VTK_ID_MAX));
  CHECK_EQUAL(embedding->GetNumberOfInputPorts(), 1);
  CHECK_EQUAL(embedding->GetNumberOfOutputPorts(), 1);
  vtkNew<vtkSurfaceMeshComparison> comparison;
  comparison->SetInputData(pointsAlone());
  CHECK_RANGE(comparison, NumberOfSamples, vtkIdType(1), vtkIdType(1000000000));
  CHECK_RANGE(comparison, NumberOfBins, 1, 10000);
  CHECK_RANGE(comparison, NumberOfThreads, 0, 1024);
  CHECK_RANGE(comparison, SMPBackend, 0, 3);
  testSolutionMetric();
  testMetricEmbedding();
  testSpectralEmbedding();
  testModification();
  return result();
}
