/**
 * @file TestWaves.h
 * @brief Embeddings of many dimensions, and runs on them.
 */
#ifndef TestWaves_h
#define TestWaves_h

#include "TestBytes.h"

#include "vtkAnisotropicRemesher.h"

#include "vtkFloatArray.h"
#include "vtkSOADataArrayTemplate.h"

#include <cmath>

namespace remesh::test
{
/** A function of a point for each k, smooth enough for the cells of few points to be disks. */
inline double wave(const double x[3], int k)
{
  const double frequency = 1.0 + 0.01 * (k % 70);
  return 0.1 * std::sin(frequency * x[k % 3] + 0.3 * x[(k + 1) % 3] + k);
}

template <class Array>
void addWaves(vtkPolyData* surface, int dimension)
{
  vtkNew<Array> array;
  array->SetName("Waves");
  array->SetNumberOfComponents(dimension);
  array->SetNumberOfTuples(surface->GetNumberOfPoints());
  for (vtkIdType point = 0; point < surface->GetNumberOfPoints(); ++point)
  {
    double x[3];
    surface->GetPoint(point, x);
    for (int k = 0; k < dimension; ++k)
    {
      array->SetTypedComponent(point, k, static_cast<typename Array::ValueType>(wave(x, k)));
    }
  }
  surface->GetPointData()->AddArray(array);
}

/** The waves are the embedding, or come after the positions. */
enum class Role
{
  Embedding,
  Coordinates
};

inline vtkSmartPointer<vtkAnisotropicRemesher> runOnWaves(
  vtkPolyData* surface, Role role, bool cells)
{
  auto filter = vtkSmartPointer<vtkAnisotropicRemesher>::New();
  filter->SetInputData(surface);
  filter->SetNumberOfPoints(60);
  filter->SetNumberOfLloydIterations(1);
  filter->SetNumberOfNewtonIterations(3);
  filter->SetGenerateVoronoiCells(cells);
  filter->SetEmbeddingMode(vtkAnisotropicRemesher::POSITION);
  if (role == Role::Embedding)
  {
    filter->SetEmbeddingArray("Waves");
  }
  else
  {
    filter->AddCoordinateArray("Waves", 0.5);
  }
  filter->Update();
  CHECK(filter->GetOutput()->GetNumberOfPolys() > 0);
  return filter;
}

}

#endif
