/**
 * @file TestComparisons.h
 * @brief Comparisons of a mesh with a reference, and what their summary says.
 */
#ifndef TestComparisons_h
#define TestComparisons_h

#include "TestHelpers.h"

#include "vtkSurfaceMeshComparison.h"

#include "vtkTable.h"
#include "vtkVariant.h"

#include <limits>

namespace remesh::test
{
using Comparison = vtkSmartPointer<vtkSurfaceMeshComparison>;

inline Comparison compare(vtkPolyData* mesh, vtkPolyData* reference)
{
  auto filter = Comparison::New();
  filter->SetInputData(mesh);
  filter->SetReferenceData(reference);
  filter->SetNumberOfSamples(5000);
  return filter;
}

inline double summaryOf(vtkSurfaceMeshComparison* filter, const char* column)
{
  vtkAbstractArray* values = filter->GetSummaryOutput()->GetColumnByName(column);
  check(values && values->GetNumberOfTuples() == 1, __FILE__, __LINE__,
    std::string("there is no column ") + column);
  return values ? values->GetVariantValue(0).ToDouble() : std::numeric_limits<double>::quiet_NaN();
}
}

#endif
