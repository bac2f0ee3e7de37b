/**
 * Embeddings of many dimensions: no copy of the embedding is held.
 */
#include "TestWaves.h"

#include "vtkTesting.h"

#include <sys/resource.h>

#include <iostream>

namespace
{
using namespace remesh;
using namespace remesh::test;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool keepsFreedMemory = true;
#else
constexpr bool keepsFreedMemory = false;
#endif

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

void testMemory()
{
  constexpr int dimension = 2000;
  const auto surface = test::polyDataOf(test::ellipsoid(4));
  const double values =
    static_cast<double>(surface->GetNumberOfPoints()) * static_cast<double>(dimension);
  const auto checkGrowth = [&](Role role, double copies, const char* what)
  {
    const double before = peakMemory();
    runOnWaves(surface, role, false);
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
}

int TestManyDimensionsMemory(int, char*[])
{
  if (keepsFreedMemory)
  {
    std::cout << "Skipped: the sanitizer keeps freed memory.\n";
    return VTK_SKIP_RETURN_CODE;
  }
  // First, so that what the library itself needs is there.
  const auto small = test::polyDataOf(test::ellipsoid(2));
  addWaves<vtkDoubleArray>(small, 70);
  runOnWaves(small, Role::Embedding, false);
  testMemory();
  return test::result();
}
