#include "Mesh/EdgeValences.h"

#include "Support/Parallel.h"

#include <algorithm>

namespace remesh
{
namespace
{
constexpr Offset smallestWindow = Offset(1) << 14; // vertices
constexpr Offset mostWindows = 32;                 // each looks at all triangles

/** The edges whose lower vertex is in [begin, end). */
EdgeValences countWindow(const std::vector<Triple>& triangles, Offset begin, Offset end)
{
  std::vector<std::pair<Index, Index>> edges;
  for (const Triple& triangle : triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const std::pair<Index, Index> edge = std::minmax(triangle[k], triangle[(k + 1) % 3]);
      if (edge.first >= begin && edge.first < end)
      {
        edges.push_back(edge);
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  EdgeValences valences;
  for (auto edge = edges.begin(); edge != edges.end();)
  {
    const auto next = std::find_if(
      edge, edges.end(), [edge](const std::pair<Index, Index>& other) { return other != *edge; });
    ++valences.edges;
    if (next - edge != 2)
    {
      valences.irregular.emplace_back(*edge, static_cast<Index>(next - edge));
    }
    edge = next;
  }
  return valences;
}
}

Offset EdgeValences::numberOfNonManifold() const
{
  return std::count_if(this->irregular.begin(), this->irregular.end(),
    [](const EdgeValence& edge) { return edge.second > 2; });
}

EdgeValences countEdgeValences(
  const std::vector<Triple>& triangles, Index numberOfVertices, const RunControl& control)
{
  const Blocks windows = Blocks::cut(numberOfVertices,
    std::clamp<Offset>(numberOfVertices / smallestWindow, 1, mostWindows),
    std::max<Offset>(numberOfVertices, 1));
  std::vector<EdgeValences> parts(static_cast<std::size_t>(windows.count()));
  const bool done = forEachBlock(windows.count(), control.silent(),
    [&](Offset window)
    { parts[window] = countWindow(triangles, windows.begin(window), windows.end(window)); });
  EdgeValences all;
  if (!done)
  {
    return all;
  }
  for (const EdgeValences& part : parts)
  {
    all.edges += part.edges;
    all.irregular.insert(all.irregular.end(), part.irregular.begin(), part.irregular.end());
  }
  return all;
}
}
