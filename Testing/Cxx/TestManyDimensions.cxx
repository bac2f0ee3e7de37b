/**
 * Embeddings of many dimensions: no copy of the embedding is held, and rows that are read in the
 * caller's array give the same bytes as rows that are copied.
 */
#include "TestBytes.h"

#include "vtkAnisotropicRemesher.h"

#include "vtkFloatArray.h"
#include "vtkSOADataArrayTemplate.h"

#include <sys/resource.h>

#include <cmath>

namespace
{
using namespace remesh;

/** A smooth function of a point for each k. */
double wave(const double x[3], int k)
{
  return 0.1 * std::sin((1.0 + 0.01 * k) * x[k % 3] + 0.3 * x[(k + 1) % 3] + k);
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

/** The largest memory that this process had so far, in bytes. */
double peakMemory()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  return static_cast<double>(usage.ru_maxrss);
#else
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
#endif
}

/** The waves are the embedding, or come after the positions. */
enum class Role
{
  Embedding,
  Coordinates
};

vtkSmartPointer<vtkAnisotropicRemesher> run(vtkPolyData* surface, Role role, bool cells)
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

void testMemory()
{
  constexpr int dimension = 2000;
  const auto surface = test::polyDataOf(test::ellipsoid(4));
  const double values =
    static_cast<double>(surface->GetNumberOfPoints()) * static_cast<double>(dimension);
  const auto checkGrowth = [&](Role role, double copies, const char* what)
  {
    const double before = peakMemory();
    run(surface, role, false);
    const double grown = (peakMemory() - before) / (values * sizeof(double));
    // A copy would be 1 more; all that belongs to the sites is far less.
    test::check(grown < copies + 0.6, __FILE__, __LINE__,
      std::string(what) + " takes " + std::to_string(grown) + " times the embedding more");
  };
  addWaves<vtkFloatArray>(surface, dimension);
  checkGrowth(Role::Embedding, 0.0, "an embedding of floats");
  surface->GetPointData()->RemoveArray("Waves");
  addWaves<vtkDoubleArray>(surface, dimension);
  checkGrowth(Role::Embedding, 0.0, "an embedding of doubles");
  checkGrowth(Role::Coordinates, 0.0, "positions and coordinates");
  surface->GetPointData()->RemoveArray("Waves");
  addWaves<vtkSOADataArrayTemplate<double>>(surface, dimension);
  checkGrowth(Role::Embedding, 1.0, "an embedding that has to be copied");
}

/** The same values, component after component, cannot be read in place. */
void testSameBytes()
{
  const auto lent = test::polyDataOf(test::ellipsoid(3));
  const auto copied = test::polyDataOf(test::ellipsoid(3));
  addWaves<vtkDoubleArray>(lent, 70);
  addWaves<vtkSOADataArrayTemplate<double>>(copied, 70);
  for (const Role role : { Role::Embedding, Role::Coordinates })
  {
    test::checkSame(test::contentsOf(run(lent, role, true)),
      test::contentsOf(run(copied, role, true)),
      role == Role::Embedding ? "embedding" : "coordinates");
  }
}
}

int TestManyDimensions(int, char*[])
{
  testSameBytes(); // first, so that what the library itself needs is there
  testMemory();
  return test::result();
}
