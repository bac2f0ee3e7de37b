#include "Mesh/EdgeValences.h"

#include "Support/Parallel.h"

#include <algorithm>
#include <numeric>

namespace remesh
{
namespace
{
constexpr Offset smallestWindow = Offset(1) << 14; // vertices
constexpr Offset maxWindows = 32;                  // each looks at all triangles twice

/** Calls `visit(lower, upper)` for the edges of the triangles whose lower vertex is in a range. */
template <class Visit>
void forEachEdge(const std::vector<Triple>& triangles, Offset begin, Offset end, const Visit& visit)
{
  for (const Triple& triangle : triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto [lower, upper] = std::minmax(triangle[k], triangle[(k + 1) % 3]);
      if (lower >= begin && lower < end)
      {
        visit(lower, upper);
      }
    }
  }
}

/** The edges whose lower vertex is in [begin, end): listed by that vertex, each list in order. */
EdgeValences countWindow(const std::vector<Triple>& triangles, Offset begin, Offset end)
{
  std::vector<Offset> ends(static_cast<std::size_t>(end - begin) + 1, 0); // of the lists
  forEachEdge(triangles, begin, end, [&](Index lower, Index) { ++ends[lower - begin + 1]; });
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<Index> uppers(static_cast<std::size_t>(ends.back()));
  std::vector<Offset> next(ends.begin(), ends.end() - 1);
  forEachEdge(triangles, begin, end,
    [&](Index lower, Index upper) { uppers[next[lower - begin]++] = upper; });
  EdgeValences valences;
  for (std::size_t list = 0; list + 1 < ends.size(); ++list)
  {
    const auto last = uppers.begin() + ends[list + 1];
    std::sort(uppers.begin() + ends[list], last);
    for (auto upper = uppers.begin() + ends[list]; upper != last;)
    {
      const auto other = std::find_if(upper, last, [=](Index next) { return next != *upper; });
      ++valences.edges;
      if (other - upper != 2)
      {
        const auto lower = static_cast<Index>(begin + static_cast<Offset>(list));
        valences.irregular.push_back({ { lower, *upper }, static_cast<Index>(other - upper) });
      }
      upper = other;
    }
  }
  return valences;
}
}

Index EdgeValences::of(Index a, Index b) const
{
  const std::pair<Index, Index> edge = std::minmax(a, b);
  const auto found = std::lower_bound(this->irregular.begin(), this->irregular.end(), edge,
    [](const EdgeValence& other, const std::pair<Index, Index>& ends)
    { return other.first < ends; });
  return found != this->irregular.end() && found->first == edge ? found->second : 2;
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
    std::clamp<Offset>(numberOfVertices / smallestWindow, 1, maxWindows),
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
