/**
 * @file TestTriangles.h
 * @brief Surfaces as they stand, for tests of what measures them.
 */
#ifndef remesh_TestTriangles_h
#define remesh_TestTriangles_h

#include "Mesh/TriangleTree.h"
#include "TestSupport.h"

namespace remesh::test
{
struct Surface
{
  std::vector<Point3> points;
  std::vector<Triple> triangles;

  explicit Surface(const TriangleSoup& soup)
    : points(soup.points)
  {
    for (const auto& [a, b, c] : soup.triangles)
    {
      this->triangles.push_back(
        { static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(c) });
    }
  }
  Triangles view() const { return { this->points, this->triangles }; }
};

/** Three points in a line. */
inline Surface surfaceWithoutArea()
{
  return Surface(makeSoup({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }, { { 0, 1, 2 } }));
}
}

#endif
