#include "Placement/PartableCrossings.h"

#include "Placement/TriangleShape.h"
#include "Support/Parallel.h"
#include "Support/SortUnique.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace remesh
{
namespace
{
constexpr Offset pairsAtOnce = 128; // so many are tried in parallel before they are counted

/** The facets that the cells of a triangle's corners meet, ascending. */
std::vector<Index> facetsOf(const PlacementProblem& problem, const Triple& triangle)
{
  const Components& components = problem.components;
  std::vector<Index> facets;
  for (const Index vertex : triangle)
  {
    for (Offset p = components.pieceBegin[vertex]; p < components.pieceBegin[vertex + 1]; ++p)
    {
      facets.push_back(problem.diagram.facets[components.pieces[p]]);
    }
  }
  sortUnique(facets);
  return facets;
}

Eigen::AlignedBox3d boxOf(const PlacementProblem& problem, Index facet)
{
  return boxAround(cornersOf(problem.mesh.facetPoints[facet], problem.mesh.points));
}

/** Leaves those whose boxes meet that of all the others. */
void leaveThoseNear(
  const PlacementProblem& problem, const std::vector<Index>& others, std::vector<Index>& facets)
{
  Eigen::AlignedBox3d box;
  for (const Index facet : others)
  {
    box.extend(boxOf(problem, facet));
  }
  const auto isAway = [&](Index facet) { return !boxOf(problem, facet).intersects(box); };
  facets.erase(std::remove_if(facets.begin(), facets.end(), isAway), facets.end());
}

/** Whether a facet of the one triangle's cells goes through one of the other's. */
bool surfaceCrosses(const PlacementProblem& problem, const Triple& first, const Triple& second)
{
  std::vector<Index> own = facetsOf(problem, first);
  std::vector<Index> others = facetsOf(problem, second);
  leaveThoseNear(problem, others, own);
  leaveThoseNear(problem, own, others);
  const SharedArray<Triple>& facets = problem.mesh.facetPoints;
  return std::any_of(own.begin(), own.end(),
    [&](Index a)
    {
      return std::any_of(others.begin(), others.end(),
        [&](Index b) { return areCrossing(facets[a], facets[b], problem.mesh.points); });
    });
}

/** Appends those of some pairs that can be parted; false when cancelled. */
bool appendPartable(const PlacementProblem& problem,
  const std::vector<std::pair<Index, Index>>& some, const std::vector<Triple>& triangles,
  const RunControl& control, std::vector<std::pair<Index, Index>>& pairs)
{
  std::vector<char> stays(some.size(), 0);
  const bool done = forEachBlock(static_cast<Offset>(some.size()), control.silent(),
    [&](Offset k)
    {
      const auto& [a, b] = some[k];
      stays[k] = surfaceCrosses(problem, triangles[a], triangles[b]);
    });
  for (std::size_t k = 0; k < some.size(); ++k)
  {
    if (!stays[k])
    {
      pairs.push_back(some[k]);
    }
  }
  return done;
}
}

Status findPartable(const PlacementProblem& problem, const CrossingSearch& search,
  const std::vector<Triple>& triangles, Offset most, const RunControl& control,
  std::vector<std::pair<Index, Index>>& pairs)
{
  pairs.clear();
  std::vector<std::pair<Index, Index>> found;
  if (Status status = search.find(control, found); !status.ok())
  {
    return status;
  }
  const Blocks groups{ static_cast<Offset>(found.size()), pairsAtOnce };
  for (Offset group = 0; group < groups.count(); ++group)
  {
    const std::vector<std::pair<Index, Index>> some(
      found.begin() + groups.begin(group), found.begin() + groups.end(group));
    if (!appendPartable(problem, some, triangles, control, pairs))
    {
      return Status::cancelled();
    }
    if (static_cast<Offset>(pairs.size()) > most)
    {
      pairs.resize(static_cast<std::size_t>(most) + 1);
      break;
    }
  }
  return Status::success();
}
}
