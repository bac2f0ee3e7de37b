// Edges counted window by window: as a table of all edges has them.

#include "Mesh/EdgeTable.h"
#include "Mesh/EdgeValences.h"
#include "Support/Random.h"
#include "TestSupport.h"
#include "TestSurfaces.h"

#include <algorithm>

using namespace remesh;

namespace
{
void checkTriangles(const std::vector<Triple>& triangles, Index numberOfVertices)
{
  const EdgeValences valences = countEdgeValences(triangles, numberOfVertices, RunControl());
  const EdgeTable edges = buildEdgeTable(triangles);
  std::vector<EdgeValence> odd;
  Offset nonManifold = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index edge = edges.facetEdges[t][k];
      CHECK_EQUAL(valences.of(triangles[t][k], triangles[t][(k + 1) % 3]), edges.valence(edge));
      if (edges.edgeFacets[edges.edgeFacetsBegin[edge]] == static_cast<Index>(t) &&
        edges.valence(edge) != 2)
      {
        odd.emplace_back(
          std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]), edges.valence(edge));
        nonManifold += edges.valence(edge) > 2;
      }
    }
  }
  std::sort(odd.begin(), odd.end());
  CHECK_EQUAL(valences.edges, edges.numberOfEdges());
  CHECK(valences.irregular == odd);
  CHECK_EQUAL(valences.numberOfNonManifold(), nonManifold);
}
}

int TestEdgeValences(int, char*[])
{
  checkTriangles({}, 0);
  checkTriangles({}, 5);
  for (const TriangleSoup& soup :
    { test::cube(), test::gridPatch(150, 170), test::threeSheets(), test::icosphere(5) })
  {
    checkTriangles(test::meshOf(soup).facetPoints, test::meshOf(soup).numberOfPoints());
  }
  // At random, over many windows.
  constexpr Index vertices = 100000;
  std::vector<Triple> triangles;
  for (std::uint64_t t = 0; t < 200000; ++t)
  {
    const auto first = static_cast<Index>((vertices - 9) * uniform01(1, t, 0));
    const auto second = first + 1 + static_cast<Index>(4 * uniform01(1, t, 1));
    triangles.push_back({ second, first, second + 1 + static_cast<Index>(3 * uniform01(1, t, 2)) });
  }
  checkTriangles(triangles, vertices);
  return test::result();
}
