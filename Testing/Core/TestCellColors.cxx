// Delaunay/CellColors on graphs whose number of colours is known.

#include "Delaunay/CellColors.h"
#include "Support/SortUnique.h"
#include "TestChecks.h"

#include <algorithm>
#include <functional>
#include <set>
#include <vector>

using namespace remesh;
using namespace remesh::test;

namespace
{
Groups graphOf(Index vertices, const std::function<bool(Index, Index)>& areNeighbors)
{
  Groups graph;
  graph.begins.push_back(0);
  for (Index a = 0; a < vertices; ++a)
  {
    for (Index b = 0; b < vertices; ++b)
    {
      if (a != b && areNeighbors(a, b))
      {
        graph.items.push_back(b);
      }
    }
    graph.begins.push_back(static_cast<Offset>(graph.items.size()));
  }
  return graph;
}

/** Neighbours differ, and there are just so many colours. */
void checkGraph(const char* where, const Groups& graph, std::size_t expected)
{
  const std::vector<int> colors = colorGraph(graph);
  CHECK_EQUAL(colors.size() + 1, graph.begins.size());
  Offset equal = 0;
  for (std::size_t v = 0; v < colors.size(); ++v)
  {
    for (Offset k = graph.begins[v]; k < graph.begins[v + 1]; ++k)
    {
      equal += colors[v] == colors[graph.items[k]] ? 1 : 0;
    }
  }
  CHECK_EQUAL(equal, 0);
  const std::size_t used = std::set<int>(colors.begin(), colors.end()).size();
  check(used == expected, __FILE__, __LINE__, described(where, "colours", used, expected));
  CHECK(colorGraph(graph) == colors);
}

/** No colour of a large triangulation is rare: what one sees is even. */
void testBalance()
{
  constexpr Index width = 60;
  const Groups lattice = graphOf(width * width,
    [](Index a, Index b)
    {
      const Index dx = b % width - a % width;
      const Index dy = b / width - a / width;
      return std::abs(dx) <= 1 && std::abs(dy) <= 1 && dx != -dy;
    });
  const std::vector<int> colors = colorGraph(lattice);
  const int largest = *std::max_element(colors.begin(), colors.end());
  CHECK(largest >= 2 && largest <= 5);
  for (int color = 0; color <= largest; ++color)
  {
    const auto uses = std::count(colors.begin(), colors.end(), color);
    CHECK(uses > width * width / (2 * (largest + 1)));
  }
}
}

int TestCellColors(int, char*[])
{
  checkGraph("nothing", graphOf(0, [](Index, Index) { return true; }), 0);
  checkGraph("loose points", graphOf(5, [](Index, Index) { return false; }), 1);
  checkGraph("a path", graphOf(9, [](Index a, Index b) { return std::abs(a - b) == 1; }), 2);
  checkGraph("all with all", graphOf(7, [](Index, Index) { return true; }), 7);
  checkGraph("a wheel",
    graphOf(
      8, [](Index a, Index b) { return a == 7 || b == 7 || (a + 1) % 7 == b || (b + 1) % 7 == a; }),
    4);
  testBalance();
  return result();
}
