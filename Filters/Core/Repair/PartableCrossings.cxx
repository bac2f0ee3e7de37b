#include "Repair/PartableCrossings.h"

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

struct BoxedFacet
{
  Index facet;
  Eigen::AlignedBox3d box;
};

/** The facets that the cells of a triangle's corners meet, ascending. */
std::vector<BoxedFacet> facetsOf(const PlacementProblem& problem, const Triple& triangle)
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
  std::vector<BoxedFacet> boxed;
  boxed.reserve(facets.size());
  for (const Index facet : facets)
  {
    boxed.push_back(
      { facet, boxAround(cornersOf(problem.mesh.facetPoints[facet], problem.mesh.points)) });
  }
  return boxed;
}

Eigen::AlignedBox3d boxAroundAll(const std::vector<BoxedFacet>& facets)
{
  Eigen::AlignedBox3d box;
  for (const BoxedFacet& each : facets)
  {
    box.extend(each.box);
  }
  return box;
}

/** Leaves those whose boxes meet that of all the others. */
void leaveThoseNear(const std::vector<BoxedFacet>& others, std::vector<BoxedFacet>& facets)
{
  const Eigen::AlignedBox3d box = boxAroundAll(others);
  const auto isAway = [&](const BoxedFacet& facet) { return !facet.box.intersects(box); };
  facets.erase(std::remove_if(facets.begin(), facets.end(), isAway), facets.end());
}

/** Whether any facet goes through one of the others, which are ordered along an axis. */
bool anyCrosses(const PlacementProblem& problem, const std::vector<BoxedFacet>& facets,
  std::vector<BoxedFacet> others)
{
  int axis = 0;
  boxAroundAll(others).diagonal().maxCoeff(&axis);
  const auto lowerEnd = [axis](const BoxedFacet& each) { return each.box.min()[axis]; };
  std::sort(others.begin(), others.end(),
    [&](const BoxedFacet& a, const BoxedFacet& b) { return lowerEnd(a) < lowerEnd(b); });
  double widest = 0.0;
  for (const BoxedFacet& each : others)
  {
    widest = std::max(widest, each.box.sizes()[axis]);
  }
  const SharedArray<Triple>& corners = problem.mesh.facetPoints;
  return std::any_of(facets.begin(), facets.end(),
    [&](const BoxedFacet& a)
    {
      auto b = std::lower_bound(others.begin(), others.end(), lowerEnd(a) - widest,
        [&](const BoxedFacet& each, double place) { return lowerEnd(each) < place; });
      for (; b != others.end() && lowerEnd(*b) <= a.box.max()[axis]; ++b)
      {
        if (a.box.intersects(b->box) &&
          areCrossing(corners[a.facet], corners[b->facet], problem.mesh.points))
        {
          return true;
        }
      }
      return false;
    });
}

/** Whether a facet of the one triangle's cells goes through one of the other's. */
bool surfaceCrosses(const PlacementProblem& problem, const Triple& first, const Triple& second)
{
  std::vector<BoxedFacet> own = facetsOf(problem, first);
  std::vector<BoxedFacet> others = facetsOf(problem, second);
  leaveThoseNear(others, own);
  leaveThoseNear(own, others);
  return !others.empty() && anyCrosses(problem, own, std::move(others));
}

/** Appends those of some pairs that can be parted; false when cancelled. */
bool appendPartable(const PlacementProblem& problem, const CrossingSearch::Pairs& some,
  const std::vector<Triple>& triangles, const RunControl& control, CrossingSearch::Pairs& pairs)
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

Status findPartable(const PlacementProblem& problem, const CrossingSearch& search, Offset most,
  const RunControl& control, CrossingSearch::Pairs& pairs)
{
  pairs.clear();
  CrossingSearch::Pairs found;
  if (Status status = search.find(control, found); !status.ok())
  {
    return status;
  }
  const Blocks groups{ static_cast<Offset>(found.size()), pairsAtOnce };
  for (Offset group = 0; group < groups.count(); ++group)
  {
    const CrossingSearch::Pairs some(
      found.begin() + groups.begin(group), found.begin() + groups.end(group));
    if (!appendPartable(problem, some, search.triangles(), control, pairs))
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
