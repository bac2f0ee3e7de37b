// What a default run holds at its peak, which is in the fit, by facets and by sites: what it does
// not read makes room for it. Peaks of other steps, and of the preparation, are lower and not seen
// here.
#include "Remesh.h"
#include "TestPlacements.h"

#include <atomic>
#include <cstdlib>
#include <iostream>
#include <new>

// Sanitizers have allocations of their own, which an operator of this file must not free.
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define COUNTS_BYTES
#include <malloc.h>

namespace
{
std::atomic<Eigen::Index> held{ 0 }; // bytes
std::atomic<Eigen::Index> most{ 0 };

void hold(void* memory)
{
  const Eigen::Index now = held += static_cast<Eigen::Index>(malloc_usable_size(memory));
  Eigen::Index before = most.load();
  while (before < now && !most.compare_exchange_weak(before, now))
  {
  }
}
}

void* operator new(std::size_t size)
{
  void* const memory = std::malloc(size > 0 ? size : 1);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  hold(memory);
  return memory;
}

void operator delete(void* memory) noexcept
{
  held -= static_cast<Eigen::Index>(malloc_usable_size(memory));
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  operator delete(memory);
}

namespace
{
using namespace remesh;

/** The most that a run holds beside the surface, in bytes. */
double peakOf(const SurfaceMesh& mesh, Offset sites)
{
  const EmbeddedSurface surface = test::gaussMapOf(mesh, 0.02);
  RemeshOptions options;
  options.numberOfSites = sites;
  options.lloydIterations = 1;
  options.quasiNewton.iterations = 8; // that the history is full
  options.keepDiagram = false;
  RunControl control;
  control.schedule = Schedule::ShuffledBlocks; // each thread more would have scratch of its own
  RemeshResult result;
  const Eigen::Index before = held.load();
  most.store(before);
  CHECK(remesh::remesh({ mesh, surface, nullptr, options }, control, result).ok());
  CHECK_EQUAL(result.components.count(), sites);
  return static_cast<double>(most.load() - before);
}

/** Of which nothing is kept twice: pieces, and for a while the tree over the facets. */
void testFacets()
{
  const SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.4, 400, 200));
  const double bytes = peakOf(mesh, 2000) / mesh.numberOfFacets();
  std::cout << bytes << " bytes a facet\n";
  CHECK(bytes < 155.0);
}

/** The system of the fit, and two cells a facet. */
void testSites()
{
  const SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.4, 160, 80));
  const double bytes = peakOf(mesh, 25000) / 25000.0;
  std::cout << bytes << " bytes a site\n";
  CHECK(bytes < 3120.0);
}
}
#endif

int TestPeakMemory(int, char*[])
{
#ifdef COUNTS_BYTES
  testFacets();
  testSites();
  return remesh::test::result();
#else
  std::cout << "Skipped: with this library, or with sanitizers, allocations cannot be counted.\n";
  return 125;
#endif
}
