// Mesh/EdgeTable against the definition, a map from pairs of points to facets.

#include "Mesh/EdgeTable.h"
#include "Support/Random.h"
#include "TestSupport.h"

#include <algorithm>
#include <map>

using namespace remesh;

namespace
{
void checkAgainstDefinition(const std::vector<Triple>& facets)
{
  std::map<std::pair<Index, Index>, std::vector<Index>> facetsOf;
  std::map<std::pair<Index, Index>, Index> numbers;
  const EdgeTable table = buildEdgeTable(facets);
  CHECK_EQUAL(table.facetEdges.size(), facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const std::pair<Index, Index> ends = std::minmax({ facets[f][k], facets[f][(k + 1) % 3] });
      facetsOf[ends].push_back(static_cast<Index>(f));
      // Numbered in the order in which facets meet them.
      const Index number =
        numbers.try_emplace(ends, static_cast<Index>(numbers.size())).first->second;
      CHECK_EQUAL(table.facetEdges[f][k], number);
    }
  }
  CHECK_EQUAL(table.numberOfEdges(), static_cast<Index>(numbers.size()));
  for (const auto& [ends, expected] : facetsOf)
  {
    const Index edge = numbers[ends];
    CHECK_EQUAL(table.valence(edge), static_cast<Index>(expected.size()));
    CHECK(std::equal(expected.begin(), expected.end(),
      table.edgeFacets.begin() + table.edgeFacetsBegin[edge],
      table.edgeFacets.begin() + table.edgeFacetsBegin[edge + 1]));
  }
}

void testSurfaces()
{
  for (const TriangleSoup& soup :
    { test::tetrahedron(), test::cube(), test::gridPatch(6, 4), test::icosphere(2),
      test::torus(2.0, 1.0, 12, 9), test::moebiusStrip(7), test::threeSheets() })
  {
    checkAgainstDefinition(test::meshOf(soup).facetPoints);
  }
}

/** Random triples of few points: many facets to an edge, many edges to a point. */
void testRandomTriples()
{
  std::vector<Triple> facets;
  for (std::uint64_t i = 0; i < 2000; ++i)
  {
    Triple facet{};
    for (int k = 0; k < 3; ++k)
    {
      facet[k] = static_cast<Index>(25.0 * uniform01(3, i, k));
    }
    if (facet[0] != facet[1] && facet[1] != facet[2] && facet[2] != facet[0])
    {
      facets.push_back(facet);
    }
  }
  checkAgainstDefinition(facets);
}

void testEuler()
{
  const auto count = [](const TriangleSoup& soup)
  { return buildEdgeTable(test::meshOf(soup).facetPoints).numberOfEdges(); };
  CHECK_EQUAL(count(test::tetrahedron()), 6);
  CHECK_EQUAL(count(test::cube()), 18);
  CHECK_EQUAL(count(test::icosphere(1)), 120);
  CHECK_EQUAL(count(test::torus(3.0, 1.0, 10, 10)), 300);
  CHECK_EQUAL(buildEdgeTable({}).numberOfEdges(), 0);
}
}

int TestEdgeTable(int, char*[])
{
  testSurfaces();
  testRandomTriples();
  testEuler();
  return test::result();
}
