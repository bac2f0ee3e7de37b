/**
 * @file TestCarriedArrays.h
 * @brief Runs of the remesher for the tests of what becomes of the input's arrays.
 */
#ifndef TestCarriedArrays_h
#define TestCarriedArrays_h

#include "TestBytes.h"
#include "TestMeasures.h"

#include "vtkAnisotropicRemesher.h"

namespace remesh::test
{
using Filter = vtkSmartPointer<vtkAnisotropicRemesher>;

inline Filter makeFilter(vtkPolyData* input, vtkIdType points)
{
  auto filter = Filter::New();
  filter->SetInputData(input);
  filter->SetNumberOfPoints(points);
  filter->SetNumberOfNewtonIterations(5);
  return filter;
}

/** Runs it; returns its warnings. */
inline std::vector<std::string> run(vtkAnisotropicRemesher* filter)
{
  Messages messages(filter);
  filter->Update();
  CHECK(messages.errors().empty());
  return messages.warnings();
}
}

#endif
