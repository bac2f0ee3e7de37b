// Topology of small meshes that one can count by hand, and shapes of triangles by formula.

#include "Comparison/MeshTopology.h"
#include "Comparison/TriangleQuality.h"
#include "TestTriangles.h"

using namespace remesh;
using namespace remesh::test;

namespace
{
MeshTopology topologyOf(const TriangleSoup& soup)
{
  const Surface surface(soup);
  MeshTopology topology;
  CHECK(measureTopology(surface.view(), RunControl(), topology).ok());
  return topology;
}

void testClosed()
{
  const MeshTopology box = topologyOf(cube());
  CHECK_EQUAL(box.points, 8);
  CHECK_EQUAL(box.triangles, 12);
  CHECK_EQUAL(box.edges, 18);
  CHECK_EQUAL(box.eulerCharacteristic, 2);
  CHECK_EQUAL(box.boundaryEdges + box.boundaryLoops + box.nonManifoldEdges, 0);
  CHECK_EQUAL(box.nonManifoldPoints + box.duplicatePoints + box.degenerateTriangles, 0);
  CHECK_EQUAL(box.components, 1);
  CHECK(box.oriented);

  const MeshTopology ring = topologyOf(torus(1.0, 0.3, 9, 7));
  CHECK_EQUAL(ring.eulerCharacteristic, 0);
  CHECK_EQUAL(ring.boundaryLoops, 0);

  TriangleSoup turned = cube();
  flip(turned, 3);
  CHECK(!topologyOf(turned).oriented);
  CHECK_EQUAL(topologyOf(turned).eulerCharacteristic, 2);
}

void testBorders()
{
  const MeshTopology holes = topologyOf(patchWithHoles(6, { { 1, 1 }, { 4, 3 } }));
  CHECK_EQUAL(holes.boundaryLoops, 3);
  CHECK_EQUAL(holes.boundaryEdges, 24 + 4 + 4);
  CHECK_EQUAL(holes.eulerCharacteristic, -1);
  CHECK_EQUAL(holes.nonManifoldPoints, 0);

  // Two holes that touch in a point become one where the surface is cut apart there.
  const MeshTopology touching = topologyOf(patchWithHoles(6, { { 1, 1 }, { 2, 2 } }));
  CHECK_EQUAL(touching.boundaryLoops, 2);
  CHECK_EQUAL(touching.nonManifoldPoints, 1);
  CHECK_EQUAL(touching.eulerCharacteristic, -1);

  const MeshTopology strip = topologyOf(moebiusStrip(12));
  CHECK_EQUAL(strip.boundaryLoops, 1);
  CHECK_EQUAL(strip.eulerCharacteristic, 0);
  CHECK(!strip.oriented);
}

void testNonManifold()
{
  const MeshTopology sheets = topologyOf(threeSheets());
  CHECK_EQUAL(sheets.nonManifoldEdges, 1);
  CHECK_EQUAL(sheets.nonManifoldPoints, 2);
  CHECK_EQUAL(sheets.boundaryEdges, 9);
  CHECK_EQUAL(sheets.components, 1);
  CHECK_EQUAL(sheets.eulerCharacteristic, 1);

  // Two tetrahedra that share a point are one component, but no surface there.
  TriangleSoup two = tetrahedron();
  append(two, tetrahedron(), { -1, 0, 0 });
  CHECK_EQUAL(topologyOf(two).components, 2);
  CHECK_EQUAL(topologyOf(two).duplicatePoints, 1);
  for (auto& triangle : two.triangles)
  {
    std::replace(triangle.begin(), triangle.end(), Offset(5), Offset(0));
  }
  const MeshTopology joined = topologyOf(two);
  CHECK_EQUAL(joined.points, 7);
  CHECK_EQUAL(joined.components, 1);
  CHECK_EQUAL(joined.nonManifoldPoints, 1);
  CHECK_EQUAL(joined.nonManifoldEdges, 0);
  CHECK_EQUAL(joined.eulerCharacteristic, 3);
  CHECK_EQUAL(joined.duplicatePoints, 0);
}

void testFaults()
{
  // Two patches side by side, not joined; a triangle with two points, one with three in a line,
  // one that repeats the first the other way round; an unused point.
  TriangleSoup soup = gridPatch(3, 4);
  append(soup, gridPatch(2, 4), { 1, 0, 0 });
  CHECK_EQUAL(topologyOf(soup).duplicatePoints, 5);
  CHECK_EQUAL(topologyOf(soup).components, 2);
  CHECK_EQUAL(topologyOf(soup).boundaryLoops, 2);
  soup.points.emplace_back(9, 9, 9);
  const auto [a, b, c] = soup.triangles[0];
  soup.triangles.push_back({ a, a, b });
  soup.triangles.push_back({ 0, 1, 2 });
  soup.triangles.push_back({ c, b, a });
  const MeshTopology topology = topologyOf(soup);
  CHECK_EQUAL(topology.points, 20 + 15);
  CHECK_EQUAL(topology.triangles, 24 + 16 + 3);
  CHECK_EQUAL(topology.degenerateTriangles, 2);
  CHECK_EQUAL(topology.duplicateTriangles, 1);

  // Nothing but triangles without points of their own: no surface.
  const MeshTopology none = topologyOf(makeSoup({ { 0, 0, 0 } }, { { 0, 0, 0 } }));
  CHECK_EQUAL(none.triangles, 1);
  CHECK_EQUAL(none.points + none.edges + none.components + none.boundaryLoops, 0);
}

void testQuality()
{
  for (const double scale : { 1.0, 1e-40, 1e40 })
  {
    const TriangleQuality best = triangleQuality(
      { scale * Point3(0, 0, 0), scale * Point3(2, 0, 0), scale * Point3(1, 0, std::sqrt(3.0)) });
    CHECK_NEAR(best.minimumAngle, 60.0, 1e-12);
    CHECK_NEAR(best.radiusRatio, 1.0, 1e-14);
    CHECK_NEAR(best.quality(), 1.0, 1e-14);
    CHECK_NEAR(best.edgeRatio, 1.0, 1e-14);
    const TriangleQuality right = triangleQuality(
      { scale * Point3(0, 0, 0), scale * Point3(0, 1, 0), scale * Point3(1, 0, 0) });
    CHECK_NEAR(right.minimumAngle, 45.0, 1e-12);
    CHECK_NEAR(right.radiusRatio, 0.5 * std::sqrt(2.0) / (2.0 - std::sqrt(2.0)), 1e-14);
    CHECK_NEAR(right.edgeRatio, std::sqrt(2.0), 1e-14);
  }
  const TriangleQuality needle = triangleQuality({ Point3(0, 0, 0), { 1, 0, 0 }, { 1, 1e-9, 0 } });
  CHECK_NEAR(needle.minimumAngle, 1e-9 * 180.0 / pi, 1e-22);
  CHECK_NEAR(needle.edgeRatio, 1e9, 1.0);
  CHECK_NEAR(needle.quality(), 2e-9, 1e-15);
  const TriangleQuality line = triangleQuality({ Point3(0, 0, 0), { 1, 0, 0 }, { 3, 0, 0 } });
  CHECK_EQUAL(line.minimumAngle, 0.0);
  CHECK_EQUAL(line.radiusRatio, largestRatio);
  CHECK_EQUAL(line.quality(), 0.0);
  CHECK_EQUAL(line.edgeRatio, 3.0);
  const TriangleQuality point = triangleQuality({ Point3(1, 1, 1), { 1, 1, 1 }, { 1, 1, 1 } });
  CHECK_EQUAL(point.edgeRatio, largestRatio);
  CHECK_EQUAL(point.quality(), 0.0);
}
}

int TestMeshTopology(int, char*[])
{
  testClosed();
  testBorders();
  testNonManifold();
  testFaults();
  testQuality();
  return result();
}
