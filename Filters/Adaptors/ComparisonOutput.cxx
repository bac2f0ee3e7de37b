#include "Adaptors/ComparisonData.h"

#include "Adaptors/ArrayHelpers.h"
#include "Adaptors/ReservedNames.h"

#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
void addDistances(const PointDistances& points, vtkPolyData* output)
{
  const Columns columns{ output->GetPointData(), static_cast<Offset>(points.distances.size()), {} };
  columns.add<vtkDoubleArray>("Distance", [&](Offset k) { return points.distances[k]; });
  if (!points.behind.empty())
  {
    columns.add<vtkDoubleArray>("SignedDistance",
      [&](Offset k) { return points.behind[k] ? -points.distances[k] : points.distances[k]; });
  }
}

/**
 * The cell arrays that triangles can take: one tuple for each cell, and global ids only where no
 * cell becomes several triangles.
 */
vtkSmartPointer<vtkCellData> cellArraysToCopy(vtkPolyData* input, const ComparedSurface& mesh)
{
  auto arrays = vtkSmartPointer<vtkCellData>::New();
  arrays->ShallowCopy(input->GetCellData());
  const std::vector<Offset>& cells = mesh.inputCells; // triangles of one cell are in a row
  const bool isCut = std::adjacent_find(cells.begin(), cells.end()) != cells.end();
  vtkAbstractArray* ids = arrays->GetGlobalIds();
  for (int k = arrays->GetNumberOfArrays() - 1; k >= 0; --k)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(k);
    if (array->GetNumberOfTuples() != input->GetNumberOfCells() || (isCut && array == ids))
    {
      arrays->RemoveArray(k);
    }
  }
  return arrays;
}

/** The input's points and field data, its polygons and strips as triangles, with their cell data.
 */
void copyAsTriangles(vtkPolyData* input, const ComparedSurface& mesh, vtkPolyData* output)
{
  const auto count = static_cast<Offset>(mesh.triangles.size());
  output->SetPoints(input->GetPoints());
  output->GetPointData()->ShallowCopy(input->GetPointData());
  output->GetFieldData()->ShallowCopy(input->GetFieldData());
  output->SetPolys(makeCells(count, 3, {},
    [&](Offset t, vtkIdType* ids)
    { std::copy(mesh.triangles[t].begin(), mesh.triangles[t].end(), ids); }));
  const vtkSmartPointer<vtkCellData> from = cellArraysToCopy(input, mesh);
  vtkCellData* cells = output->GetCellData();
  cells->CopyAllOn();
  cells->CopyAllocate(from, count);
  for (Offset t = 0; t < count; ++t)
  {
    cells->CopyData(from, mesh.inputCells[t], t);
  }
}

/** Adds columns of one value to a table of one row. */
struct Row
{
  vtkTable* table;

  template <class Array, class Value>
  void add(const std::string& name, Value value) const
  {
    vtkNew<Array> column;
    column->SetName(name.c_str());
    column->InsertNextValue(value);
    this->table->AddColumn(column);
  }
  void count(const std::string& name, Offset value) const
  {
    this->add<vtkIdTypeArray>(name, static_cast<vtkIdType>(value));
  }
  void number(const std::string& name, double value) const
  {
    this->add<vtkDoubleArray>(name, value);
  }
};

void addTopology(const MeshTopology& topology, const std::string& prefix, const Row& row)
{
  const auto add = [&](const char* name, Index value) { row.count(prefix + name, value); };
  add("NumberOfPoints", topology.points);
  add("NumberOfTriangles", topology.triangles);
  add("NumberOfEdges", topology.edges);
  add("EulerCharacteristic", topology.eulerCharacteristic);
  add("NumberOfComponents", topology.components);
  add("NumberOfBoundaryLoops", topology.boundaryLoops);
  add("NumberOfBoundaryEdges", topology.boundaryEdges);
  add("NumberOfNonManifoldEdges", topology.nonManifoldEdges);
  add("NumberOfNonManifoldPoints", topology.nonManifoldPoints);
  add("NumberOfDuplicatePoints", topology.duplicatePoints);
  add("NumberOfDuplicateTriangles", topology.duplicateTriangles);
  add("NumberOfDegenerateTriangles", topology.degenerateTriangles);
  add("IsConsistentlyOriented", topology.oriented ? 1 : 0);
}

void addQualities(const std::vector<TriangleQuality>& qualities, const Row& row)
{
  double least = 1.0, sum = 0.0, minAngle = 60.0, angleSum = 0.0, largestEdgeRatio = 1.0;
  for (const TriangleQuality& each : qualities)
  {
    least = std::min(least, each.quality());
    sum += each.quality();
    minAngle = std::min(minAngle, each.minimumAngle);
    angleSum += each.minimumAngle;
    largestEdgeRatio = std::max(largestEdgeRatio, each.edgeRatio);
  }
  const auto count = static_cast<double>(qualities.size());
  row.number("MinimumQuality", least);
  row.number("MeanQuality", sum / count);
  row.number("LeastMinimumAngle", minAngle);
  row.number("MeanMinimumAngle", angleSum / count);
  row.number("MaximumEdgeRatio", largestEdgeRatio);
}

void addDistanceColumns(const Comparison& comparison, const Row& row)
{
  const TwoSidedDistance& distance = comparison.distance;
  const auto add = [&](const char* name, double value)
  {
    row.number(name, value);
    row.number(std::string("Relative") + name, value / comparison.diagonal);
  };
  row.number("ReferenceDiagonal", comparison.diagonal);
  row.number("Area", distance.forward.area);
  row.number("ReferenceArea", distance.backward.area);
  add("RMSDistance", distance.rms());
  add("MaximumDistance", distance.maximum());
  if (std::isfinite(distance.maximumBound()))
  {
    add("MaximumDistanceBound", distance.maximumBound());
  }
  add("MeanDistanceToReference", distance.forward.mean);
  add("RMSDistanceToReference", distance.forward.rms);
  add("MaximumDistanceToReference", distance.forward.maximum);
  add("MeanDistanceFromReference", distance.backward.mean);
  add("RMSDistanceFromReference", distance.backward.rms);
  add("MaximumDistanceFromReference", distance.backward.maximum);
}

void addNormalColumns(const ComparedSurface& mesh, const Comparison& comparison, const Row& row)
{
  Offset flipped = 0;
  double area = 0.0, sum = 0.0, largest = 0.0;
  for (std::size_t t = 0; t < comparison.normalDeviations.size(); ++t)
  {
    const double degrees = comparison.normalDeviations[t];
    if (std::isnan(degrees))
    {
      continue;
    }
    const auto [a, b, c] = mesh.view().corners(static_cast<Offset>(t));
    const double weight = facetArea(a, b, c);
    area += weight;
    sum += weight * degrees;
    largest = std::max(largest, degrees);
    flipped += degrees > flippedDegrees;
  }
  row.count("NumberOfFlippedTriangles", flipped);
  row.number("MeanNormalDeviation", sum / area);
  row.number("MaximumNormalDeviation", largest);
}

/** Two columns: the middles of equal bins from 0 to `end`, and the triangles in each. */
template <class Value>
void addHistogram(
  const Columns& columns, const char* name, double end, Offset count, const Value& value)
{
  const auto bins = static_cast<int>(columns.tuples);
  columns.add<vtkDoubleArray>(
    name, [&](Offset bin) { return (static_cast<double>(bin) + 0.5) * end / bins; });
  const auto counts =
    columns.addEmpty<vtkIdTypeArray>((std::string(name) + "Triangles").c_str(), 1);
  counts->Fill(0.0);
  for (Offset t = 0; t < count; ++t)
  {
    const double place = value(t) / end * bins;
    if (!std::isnan(place))
    {
      ++*counts->GetPointer(std::clamp(static_cast<int>(place), 0, bins - 1));
    }
  }
}
}

void writeComparedMesh(vtkPolyData* input, const ComparedSurface& mesh,
  const Comparison& comparison, vtkPolyData* output)
{
  const auto count = static_cast<Offset>(mesh.triangles.size());
  // With a vertex and a strip of two triangles there are as many cells as triangles, too.
  if (input->GetNumberOfCells() == count && input->GetNumberOfPolys() == count &&
    input->GetPolys()->IsHomogeneous() == 3)
  {
    output->ShallowCopy(input);
  }
  else
  {
    copyAsTriangles(input, mesh, output);
  }
  removeReserved(comparedCellNames, output->GetCellData());
  removeReserved(comparedPointNames, output->GetPointData());
  const Columns columns{ output->GetCellData(), count, {} };
  const std::vector<TriangleQuality>& qualities = comparison.qualities;
  columns.add<vtkDoubleArray>("Quality", [&](Offset t) { return qualities[t].quality(); });
  columns.add<vtkDoubleArray>("MinimumAngle", [&](Offset t) { return qualities[t].minimumAngle; });
  columns.add<vtkDoubleArray>("RadiusRatio", [&](Offset t) { return qualities[t].radiusRatio; });
  columns.add<vtkDoubleArray>("EdgeRatio", [&](Offset t) { return qualities[t].edgeRatio; });
  if (comparison.hasReference)
  {
    const std::vector<double>& degrees = comparison.normalDeviations;
    columns.add<vtkDoubleArray>("NormalDeviation", [&](Offset t) { return degrees[t]; });
    columns.add<vtkUnsignedCharArray>(
      "Flipped", [&](Offset t) { return static_cast<unsigned char>(degrees[t] > flippedDegrees); });
    addDistances(comparison.meshPoints, output);
    output->GetPointData()->SetActiveScalars("Distance"); // what viewers then colour by
  }
}

void writeComparedReference(vtkPolyData* input, const Comparison& comparison, vtkPolyData* output)
{
  output->ShallowCopy(input);
  removeReserved(comparedPointNames, output->GetPointData());
  addDistances(comparison.referencePoints, output);
}

void writeComparisonSummary(
  const ComparedSurface& mesh, const Comparison& comparison, vtkTable* output)
{
  const Row row{ output };
  if (comparison.hasReference)
  {
    addDistanceColumns(comparison, row);
    addNormalColumns(mesh, comparison, row);
  }
  addQualities(comparison.qualities, row);
  addTopology(comparison.topology, "", row);
  if (comparison.hasReference)
  {
    addTopology(comparison.referenceTopology, "Reference", row);
  }
}

void writeComparisonHistograms(const Comparison& comparison, int bins, vtkTable* output)
{
  const std::vector<TriangleQuality>& qualities = comparison.qualities;
  const auto count = static_cast<Offset>(qualities.size());
  const Columns columns{ output->GetRowData(), bins, {} };
  addHistogram(columns, "Quality", 1.0, count, [&](Offset t) { return qualities[t].quality(); });
  addHistogram(
    columns, "MinimumAngle", 60.0, count, [&](Offset t) { return qualities[t].minimumAngle; });
  if (comparison.hasReference)
  {
    addHistogram(columns, "NormalDeviation", 180.0, count,
      [&](Offset t) { return comparison.normalDeviations[t]; });
  }
}
}
