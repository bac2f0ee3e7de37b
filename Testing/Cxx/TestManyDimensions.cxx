/**
 * Embeddings of many dimensions: rows that are read in the caller's array give the same bytes as
 * rows that are copied.
 */
#include "TestWaves.h"

namespace
{
using namespace remesh;
using namespace remesh::test;

/** The same values, component after component, cannot be read in place. */
void testSameBytes()
{
  const auto lent = test::polyDataOf(test::ellipsoid(3));
  const auto copied = test::polyDataOf(test::ellipsoid(3));
  addWaves<vtkDoubleArray>(lent, 70);
  addWaves<vtkSOADataArrayTemplate<double>>(copied, 70);
  for (const Role role : { Role::Embedding, Role::Coordinates })
  {
    test::checkSame(test::contentsOf(runOnWaves(lent, role, true)),
      test::contentsOf(runOnWaves(copied, role, true)),
      role == Role::Embedding ? "embedding" : "coordinates");
  }
}
}

int TestManyDimensions(int, char*[])
{
  testSameBytes();
  return test::result();
}
