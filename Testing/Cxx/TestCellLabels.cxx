// Labels of the cells: equal where their values are, exactly in the array's own type.

#include "TestHelpers.h"

#include "Adaptors/CellLabels.h"

#include "vtkAnisotropicRemesher.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkStringArray.h"
#include "vtkUnsignedLongLongArray.h"
#include "vtkVariantArray.h"

#include <limits>

using namespace remesh;
using namespace remesh::test;

namespace
{
std::vector<Index> labelsOf(vtkAbstractArray* array)
{
  std::vector<Index> labels;
  const Status status = readCellLabels(array, array->GetNumberOfTuples(), labels);
  CHECK(status.ok());
  return labels;
}

template <class Array, class Value>
std::vector<Index> labelsOfValues(std::initializer_list<Value> values, int components = 1)
{
  vtkNew<Array> array;
  array->SetName("Labels");
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  vtkIdType k = 0;
  for (const Value& value : values)
  {
    array->SetValue(k++, value);
  }
  return labelsOf(array);
}

using Labels = std::vector<Index>;

/** Numbered as they come; neighbours beyond what doubles can tell apart are two. */
void testNumbers()
{
  const vtkIdType large = vtkIdType(1) << 60;
  const Labels expected = { 0, 1, 0, 2, 1 };
  CHECK(labelsOfValues<vtkIdTypeArray>({ large, large + 1, large, -large, large + 1 }) == expected);
  const unsigned long long huge = std::numeric_limits<unsigned long long>::max();
  CHECK(
    labelsOfValues<vtkUnsignedLongLongArray>({ huge, huge - 1, huge, 0ULL, huge - 1 }) == expected);
  // A layout that is not dispatched to.
  CHECK(labelsOfValues<vtkSOADataArrayTemplate<long long>>(
          { 1LL << 60, (1LL << 60) + 1, 1LL << 60, 0LL, (1LL << 60) + 1 }) == expected);
  CHECK(labelsOfValues<vtkIdTypeArray>({ large, large, large + 1, large, large, large }, 2) ==
    Labels({ 0, 1, 0 }));
}

/** Such neighbours are two regions, and the border between them is kept. */
void testRegions()
{
  const auto input = polyDataOf(gridPatch(8, 8));
  vtkNew<vtkIdTypeArray> labels;
  labels->SetName("Region");
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    labels->InsertNextValue((vtkIdType(1) << 60) + (cell < 64 ? 0 : 1));
  }
  input->GetCellData()->AddArray(labels);
  vtkNew<vtkAnisotropicRemesher> filter;
  filter->SetInputData(input);
  filter->SetNumberOfPoints(100);
  filter->SetFeatureLabelArray("Region");
  filter->Update();
  const auto patches = arrayOf(filter->GetSitesOutput()->GetPointData(), "PatchId");
  CHECK_EQUAL(patches->GetRange()[1], 1.0);

  // Likewise as the active array of a type.
  input->GetCellData()->SetActiveScalars("Region");
  vtkNew<vtkAnisotropicRemesher> byAttribute;
  byAttribute->SetInputData(input);
  byAttribute->SetNumberOfPoints(100);
  byAttribute->SetInputArrayToProcess(
    2, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkDataSetAttributes::SCALARS);
  byAttribute->Update();
  const auto others = arrayOf(byAttribute->GetSitesOutput()->GetPointData(), "PatchId");
  CHECK_EQUAL(others->GetRange()[1], 1.0);
}

/** What is no number equals itself, and nothing else. */
void testNotANumber()
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(
    labelsOfValues<vtkFloatArray>({ nan, 0.0f, nan, -0.0f, 1.0f }) == Labels({ 0, 1, 0, 1, 2 }));
  CHECK(labelsOfValues<vtkFloatArray>({ 0.0f, nan, 1.0f, 1.0f, 0.0f, nan, nan, nan }, 2) ==
    Labels({ 0, 1, 0, 2 }));
}

void testOthers()
{
  const std::string zero("a\0b", 3);
  CHECK(labelsOfValues<vtkStringArray>({ vtkStdString("b"), vtkStdString("a"), vtkStdString("b"),
          vtkStdString(zero), vtkStdString("a") }) == Labels({ 0, 1, 0, 2, 1 }));
  vtkNew<vtkVariantArray> variants;
  variants->SetName("Variants");
  variants->InsertNextValue(vtkVariant(1));
  Labels labels;
  const Status unknown = readCellLabels(variants, 1, labels);
  CHECK(unknown.code == StatusCode::InvalidInput);
  CHECK(unknown.message.find("neither numbers nor strings") != std::string::npos);
  const Status wrong = readCellLabels(variants, 2, labels);
  CHECK(wrong.message.find("1 tuples for 2 cells") != std::string::npos);
}
}

int TestCellLabels(int, char*[])
{
  testNumbers();
  testRegions();
  testNotANumber();
  testOthers();
  return result();
}
