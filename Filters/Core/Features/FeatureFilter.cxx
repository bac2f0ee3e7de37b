/**
 * @file FeatureFilter.cxx
 *
 * What tells a crease from noise, as far as a mesh of some spacing is concerned: it is longer than
 * a few spacings, or closes smoothly, and it neither zigzags from edge to edge nor branches every
 * few edges. Where it does both at almost every point, it is noise however far it reaches, and
 * whatever borders it meets. What goes around a facet or two that are turned back is none.
 */
#include "Features/CreaseGraph.h"
#include "Features/FeatureEdges.h"

#include "Support/DisjointSets.h"
#include "Support/SortUnique.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <iterator>

namespace remesh
{
namespace
{
// Extents in spacings.
constexpr double minLoop = 1.0;
constexpr double minCrease = 2.5;
constexpr double minStrongCrease = 1.5;
constexpr double minFine = 5.0; // of edges much shorter than the spacing
constexpr double minWiggle = 12.0;
constexpr double minBranch = 1.5;

constexpr double fineEdge = 0.7;        // mean length, in spacings
constexpr double strongAngle = 1.05;    // radians, mean along the crease
constexpr double turnedBack = 2.35;     // radians
constexpr double minCover = 2.0;        // times its area, of what a facet turned back lies on
constexpr double largestMeanTurn = 0.5; // radians
constexpr double largestSmoothTurn = 0.35;
constexpr double largestStraightTurn = 0.2;
constexpr double maxPerEdge = 0.15; // branches and ends beyond two
constexpr double maxPerSpacing = 0.3;
// Of noise so strong that its edges hang together everywhere: real creases turn by half as much.
constexpr double noisyTurn = 0.7;
constexpr double noisyPerEdge = 0.2; // points where not just two features meet
constexpr Index minNoisyPoints = 20;

/** What is known of one connected set of droppable edges. */
struct Cluster
{
  Eigen::AlignedBox3d box;
  Index edges = 0;
  Index irregular = 0; ///< points where not just two features meet
  Index turns = 0;
  double turning = 0.0; ///< sum of the angles between consecutive edges
  double length = 0.0;
  double strength = 0.0; ///< sum of length times the angle between the facets
  bool attached = false; ///< meets an edge that must stay
};

bool isNoise(const Cluster& cluster, double spacing)
{
  const double meanTurn = cluster.turns > 0 ? cluster.turning / cluster.turns : 0.0;
  if (cluster.turns + cluster.irregular >= minNoisyPoints && meanTurn > noisyTurn &&
    cluster.irregular > noisyPerEdge * cluster.edges)
  {
    return true;
  }
  const double extent = cluster.box.diagonal().norm() / spacing;
  const bool loop = cluster.irregular == 0;
  const bool fine = cluster.length < fineEdge * spacing * cluster.edges;
  const double branches = std::max(0, cluster.irregular - 2);
  const bool branching =
    branches > maxPerEdge * cluster.edges && branches > maxPerSpacing * cluster.length / spacing;
  const bool rough = fine && (branching || meanTurn > largestSmoothTurn);
  const bool wiggles = meanTurn > largestMeanTurn || branching;
  const bool strong = cluster.strength > strongAngle * cluster.length;
  if (rough && (strong || !wiggles))
  {
    return extent < minFine;
  }
  if (wiggles && !strong && (fine || !cluster.attached))
  {
    return extent < minWiggle;
  }
  if (cluster.attached) // short where the surface is narrow
  {
    return false;
  }
  const bool straight = cluster.irregular <= 2 && meanTurn < largestStraightTurn;
  const double least = loop ? minLoop
    : strong                ? minStrongCrease
    : fine && !straight     ? minFine
                            : minCrease;
  return extent < least;
}

/** Adds the edges that start at a point, and whether others that must stay meet there. */
void addEdges(
  const CreaseGraph& graph, const std::vector<float>& angles, Index point, Cluster& cluster)
{
  for (Offset i = graph.begin[point]; i < graph.begin[point + 1]; ++i)
  {
    const Index edge = graph.around[i];
    if (!graph.droppable[edge])
    {
      cluster.attached = true;
    }
    else if (graph.ends[edge][0] == point)
    {
      const double length = graph.length(edge);
      ++cluster.edges;
      cluster.length += length;
      cluster.strength += length * angles[edge];
    }
  }
}

std::vector<Cluster> measureClusters(
  const CreaseGraph& graph, const std::vector<float>& angles, DisjointSets& sets)
{
  for (const Index edge : graph.around)
  {
    if (graph.droppable[edge])
    {
      sets.unite(graph.ends[edge][0], graph.ends[edge][1]);
    }
  }
  std::vector<Cluster> clusters(graph.mesh.points.size());
  for (Index p = 0; p < graph.mesh.numberOfPoints(); ++p)
  {
    if (graph.degree(p) == 0)
    {
      continue;
    }
    Cluster& cluster = clusters[sets.find(p)];
    cluster.box.extend(graph.mesh.points[p]);
    cluster.irregular += graph.degree(p) != 2;
    if (graph.degree(p) == 2)
    {
      ++cluster.turns;
      cluster.turning += graph.turn(p);
    }
    addEdges(graph, angles, p, cluster);
  }
  return clusters;
}

/** Finds single facets, and pairs of them, that lie on their neighbours the wrong way round. */
class TurnedBackFacets
{
public:
  TurnedBackFacets(
    const CreaseGraph& graph, const EdgeTable& edges, const std::vector<float>& angles)
    : m_graph(graph)
    , m_edges(edges)
    , m_angles(angles)
  {
  }

  /** Of two neighbours, each is one; both have a small part of the area that they lie on. */
  bool has(Index facet) const
  {
    const int side = this->openSide(facet);
    if (side < 0)
    {
      return false;
    }
    std::vector<Index> island = { facet };
    if (side < 3)
    {
      const Index edge = m_edges.facetEdges[facet][side];
      const Index other = m_edges.valence(edge) == 2 ? this->beyond(facet, edge) : noIndex;
      const int otherSide = other != noIndex ? this->openSide(other) : -1;
      if (otherSide < 0 || otherSide > 2 || m_edges.facetEdges[other][otherSide] != edge)
      {
        return false;
      }
      island.push_back(other);
    }
    std::vector<Index> around; // each counts once, also beyond two sides
    for (const Index f : island)
    {
      for (const Index edge : m_edges.facetEdges[f])
      {
        if (this->isBack(edge))
        {
          around.push_back(this->beyond(f, edge));
        }
      }
    }
    sortUnique(around);
    const Point3 own = this->areaOf(island);
    return this->areaOf(around).dot(own) < -minCover * own.squaredNorm();
  }

  bool isBack(Index edge) const
  {
    const auto& [a, b] = m_graph.ends[edge];
    return m_graph.droppable[edge] && m_angles[edge] > turnedBack && m_graph.degree(a) == 2 &&
      m_graph.degree(b) == 2;
  }

private:
  /** The side of a facet that does not turn back, where the two others do; 3 where all do. */
  int openSide(Index facet) const
  {
    int open = 3;
    int back = 0;
    for (int k = 0; k < 3; ++k)
    {
      const bool turns = this->isBack(m_edges.facetEdges[facet][k]);
      back += turns;
      open = turns ? open : k;
    }
    return back >= 2 ? open : -1;
  }

  Index beyond(Index facet, Index edge) const
  {
    const Index* facets = m_edges.edgeFacets.data() + m_edges.edgeFacetsBegin[edge];
    return facets[facets[0] == facet ? 1 : 0];
  }

  /** Twice that of these facets together, as a vector along their normals. */
  Point3 areaOf(const std::vector<Index>& facets) const
  {
    const std::vector<Point3>& points = m_graph.mesh.points;
    Point3 sum = Point3::Zero();
    for (const Index facet : facets)
    {
      const auto& [a, b, c] = m_graph.mesh.facetPoints[facet];
      sum += (points[b] - points[a]).cross(points[c] - points[a]);
    }
    return sum;
  }

  const CreaseGraph& m_graph;
  const EdgeTable& m_edges;
  const std::vector<float>& m_angles;
};

/**
 * Drops the creases around facets that lie on their neighbours the wrong way round: defects,
 * however large, but not the bases of low pyramids, which lie on what is no larger.
 */
void dropTurnedBack(const CreaseGraph& graph, const EdgeTable& edges, FeatureEdges& features)
{
  const TurnedBackFacets turned(graph, edges, features.angles);
  std::vector<Index> dropped;
  for (Index facet = 0; facet < graph.mesh.numberOfFacets(); ++facet)
  {
    if (turned.has(facet))
    {
      const Triple& sides = edges.facetEdges[facet];
      std::copy_if(sides.begin(), sides.end(), std::back_inserter(dropped),
        [&](Index edge) { return turned.isBack(edge); });
    }
  }
  sortUnique(dropped);
  for (const Index edge : dropped)
  {
    features.kinds[edge] = FeatureKind::None;
    features.angles[edge] = 0.0F; // no gap is bridged along it
  }
}

/** Features from one point where not just two of them meet to the next. */
struct Chain
{
  std::pair<Index, Index> ends; ///< ascending
  std::vector<Index> edges;
  double length = 0.0;
  double strength = 0.0; ///< sum of length times the angle between the facets
  bool droppable = true;
};

/** Follows a chain from its end, as far as it is shorter than `longest`. */
Chain followChain(
  const CreaseGraph& graph, const std::vector<float>& angles, Index end, Index edge, double longest)
{
  Chain chain;
  Index at = end;
  while (true)
  {
    const double length = graph.length(edge);
    chain.edges.push_back(edge);
    chain.length += length;
    chain.strength += length * angles[edge];
    chain.droppable = chain.droppable && graph.droppable[edge];
    at = graph.other(edge, at);
    if (graph.degree(at) != 2 || chain.length >= longest)
    {
      break;
    }
    edge = graph.at(at, graph.at(at, 0) == edge ? 1 : 0);
  }
  chain.ends = std::minmax(end, at);
  return chain;
}

/** Those that are shorter, by their ends, those of the same ends the weakest first. */
std::vector<Chain> shortChains(
  const CreaseGraph& graph, const std::vector<float>& angles, double longest)
{
  std::vector<Chain> chains;
  for (Index p = 0; p < graph.mesh.numberOfPoints(); ++p)
  {
    const Index degree = graph.degree(p);
    for (Index k = 0; k < degree && degree != 2; ++k)
    {
      Chain chain = followChain(graph, angles, p, graph.at(p, k), longest);
      const bool isFirst = chain.ends.first < chain.ends.second
        ? p == chain.ends.first
        : chain.edges.front() <= chain.edges.back(); // a ring, found from both of its ends
      if (chain.length < longest && isFirst)
      {
        chains.push_back(std::move(chain));
      }
    }
  }
  std::stable_sort(chains.begin(), chains.end(),
    [](const Chain& a, const Chain& b)
    { return a.ends != b.ends ? a.ends < b.ends : a.strength * b.length < b.strength * a.length; });
  return chains;
}

/**
 * Removes what branches off another feature within less than `longest`: dead ends, and of chains
 * that go the same way all but the strongest, and those that come back to where they begin.
 *
 * @return whether there were any.
 */
bool dropBranches(const CreaseGraph& graph, const std::vector<float>& angles, double longest,
  std::vector<FeatureKind>& kinds)
{
  const std::vector<Chain> chains = shortChains(graph, angles, longest);
  bool dropped = false;
  for (std::size_t k = 0; k < chains.size(); ++k)
  {
    const Chain& chain = chains[k];
    const auto [a, b] = chain.ends;
    const bool branches = std::max(graph.degree(a), graph.degree(b)) > 2;
    const bool isLoose = std::min(graph.degree(a), graph.degree(b)) == 1;
    const bool isDouble = k + 1 < chains.size() && chains[k + 1].ends == chain.ends;
    if (chain.droppable && branches && (isLoose || isDouble || a == b))
    {
      for (const Index edge : chain.edges)
      {
        kinds[edge] = FeatureKind::None;
      }
      dropped = true;
    }
  }
  return dropped;
}
}

void dropSmallFeatures(const SurfaceMesh& mesh, const EdgeTable& edges,
  const FeatureOptions& options, FeatureEdges& features)
{
  std::vector<FeatureKind>& kinds = features.kinds;
  if (!(options.spacing > 0.0))
  {
    return;
  }
  CreaseGraph graph = makeCreaseGraph(mesh, edges, options, kinds);
  dropTurnedBack(graph, edges, features);
  graph.listAround(kinds);
  while (dropBranches(graph, features.angles, minBranch * options.spacing, kinds))
  {
    graph.listAround(kinds); // others may come to light
  }
  DisjointSets sets(mesh.points.size());
  const std::vector<Cluster> clusters = measureClusters(graph, features.angles, sets);
  for (std::size_t e = 0; e < kinds.size(); ++e)
  {
    if (kinds[e] != FeatureKind::None && graph.droppable[e] &&
      isNoise(clusters[sets.find(graph.ends[e][0])], options.spacing))
    {
      kinds[e] = FeatureKind::None;
    }
  }
}
}
