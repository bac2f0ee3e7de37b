#include "Features/FeatureGraph.h"

#include "Features/CreaseGraph.h"
#include "Features/DroppedCreases.h"
#include "Support/DisjointSets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace remesh
{
namespace
{
constexpr double minCosineOfTurn = 0.5; // sharper turns are corners
/** Radians, around a point: of a cone whose sides are 45 degrees from its axis. */
constexpr double maxAngleAtApex = 4.4429;

/** From a point along an edge and on, as far as features go there without a fork, or so far. */
Point3 placeAlong(const CreaseGraph& graph, Index point, Index edge, double distance)
{
  Index at = graph.other(edge, point);
  double length = graph.length(edge);
  while (length < distance && graph.degree(at) == 2 && at != point)
  {
    edge = graph.at(at, graph.at(at, 0) == edge ? 1 : 0);
    at = graph.other(edge, at);
    length += graph.length(edge);
  }
  return graph.mesh.points[at];
}

bool turnsSharply(const Point3& from, const Point3& at, const Point3& to)
{
  return (at - from).stableNormalized().dot((to - at).stableNormalized()) < minCosineOfTurn;
}

/** Sharp turns are no corners where they are those of a curve that zigzags. */
bool isCorner(const Features& features, const CreaseGraph& graph, Index point)
{
  if (graph.degree(point) != 2)
  {
    return graph.degree(point) > 0;
  }
  const Index a = graph.at(point, 0);
  const Index b = graph.at(point, 1);
  if (features.kinds[a] != features.kinds[b])
  {
    return true;
  }
  const std::vector<Point3>& points = graph.mesh.points;
  const Point3& at = points[point];
  return turnsSharply(points[graph.other(a, point)], at, points[graph.other(b, point)]) &&
    turnsSharply(placeAlong(graph, point, a, features.spacing), at,
      placeAlong(graph, point, b, features.spacing));
}

/** Follows a curve from a point along an edge, to the next corner or round to where it began. */
FeatureCurve follow(const CreaseGraph& graph, const std::vector<char>& corners, Index start,
  Index edge, std::vector<char>& used)
{
  FeatureCurve curve;
  curve.points.push_back(start);
  Index at = start;
  while (true)
  {
    used[edge] = 1;
    curve.edges.push_back(edge);
    at = graph.other(edge, at);
    curve.points.push_back(at);
    if (corners[at] || at == start)
    {
      break;
    }
    edge = graph.at(at, 0) == edge ? graph.at(at, 1) : graph.at(at, 0);
  }
  return curve;
}

/**
 * Lets a closed curve begin where it is farthest in some direction, none that parts have: so curves
 * that are like each other, as both rims of a plate, begin opposite each other.
 */
void beginAtExtreme(const std::vector<Point3>& points, FeatureCurve& curve)
{
  const Point3 direction(0.6180, 0.7320, 0.2360);
  const auto nearer = [&](Index a, Index b)
  { return points[a].dot(direction) < points[b].dot(direction); };
  curve.points.pop_back();
  const auto first =
    std::max_element(curve.points.begin(), curve.points.end(), nearer) - curve.points.begin();
  std::rotate(curve.points.begin(), curve.points.begin() + first, curve.points.end());
  std::rotate(curve.edges.begin(), curve.edges.begin() + first, curve.edges.end());
  curve.points.push_back(curve.points.front());
}

/** Lists the corners, and marks them among all points. */
std::vector<char> findCorners(const CreaseGraph& graph, Features& features)
{
  std::vector<char> corners(graph.mesh.points.size(), 0);
  for (const Index point : features.pinches)
  {
    corners[point] = 1;
  }
  for (Index p = 0; p < graph.mesh.numberOfPoints(); ++p)
  {
    corners[p] = corners[p] || isCorner(features, graph, p);
    if (corners[p])
    {
      features.corners.push_back(p);
    }
  }
  return corners;
}
}

void traceCurves(const SurfaceMesh& mesh, Features& features)
{
  const CreaseGraph graph = makeCreaseGraph(mesh, features.edges, features.kinds);
  const std::vector<char> corners = findCorners(graph, features);
  std::vector<char> used(features.kinds.size(), 0);
  for (const Index point : features.corners)
  {
    for (Index k = 0; k < graph.degree(point); ++k)
    {
      if (!used[graph.at(point, k)])
      {
        features.curves.push_back(follow(graph, corners, point, graph.at(point, k), used));
      }
    }
  }
  for (std::size_t e = 0; e < features.kinds.size(); ++e)
  {
    if (features.kinds[e] != FeatureKind::None && !used[e])
    {
      features.curves.push_back(
        follow(graph, corners, graph.ends[e][0], static_cast<Index>(e), used));
      beginAtExtreme(mesh.points, features.curves.back());
      features.curves.back().hasCorners = false;
    }
  }
  for (FeatureCurve& curve : features.curves)
  {
    curve.kind = features.kinds[curve.edges.front()];
  }
}

namespace
{
/** A facet's corner. */
struct Corner
{
  Index facet;
  int k;
};

/** The corners of two facets at the same ends of their common edge. */
std::array<std::pair<Corner, Corner>, 2> cornersAtEnds(
  const SurfaceMesh& mesh, const EdgeTable& edges, Index edge, Index first, Index second)
{
  std::array<std::pair<Corner, Corner>, 2> found;
  const Triple& others = mesh.facetPoints[second];
  for (int end = 0; end < 2; ++end)
  {
    const int k = (edges.sideOf(first, edge) + end) % 3;
    const auto across = std::find(others.begin(), others.end(), mesh.facetPoints[first][k]);
    found[end] = { { first, k }, { second, static_cast<int>(across - others.begin()) } };
  }
  return found;
}

/** Facets joined by edges that are no features. */
void findPatches(Features& features)
{
  DisjointSets patches(features.edges.facetEdges.size());
  for (Index e = 0; e < features.edges.numberOfEdges(); ++e)
  {
    if (features.kinds[e] == FeatureKind::None)
    {
      const Offset begin = features.edges.edgeFacetsBegin[e];
      patches.unite(features.edges.edgeFacets[begin], features.edges.edgeFacets[begin + 1]);
    }
  }
  features.facetPatches.resize(features.edges.facetEdges.size());
  features.numberOfPatches = 0;
  for (std::size_t f = 0; f < features.facetPatches.size(); ++f)
  {
    const Index root = patches.find(static_cast<Index>(f));
    features.facetPatches[f] =
      root == static_cast<Index>(f) ? features.numberOfPatches++ : features.facetPatches[root];
  }
}

/** Features between different patches, and those that are no creases. */
void findCuts(Features& features)
{
  features.cuts.assign(features.kinds.size(), 0);
  for (std::size_t e = 0; e < features.kinds.size(); ++e)
  {
    const Index* around = features.edges.edgeFacets.data() + features.edges.edgeFacetsBegin[e];
    features.cuts[e] = features.kinds[e] != FeatureKind::None &&
      (features.kinds[e] != FeatureKind::Crease ||
        features.facetPatches[around[0]] != features.facetPatches[around[1]]);
  }
}

/** Numbers the corners as the facets meet them. */
void numberCorners(SurfaceMesh& mesh, DisjointSets& fans)
{
  std::vector<Index> cornerOfFan(3 * mesh.facetPoints.size(), noIndex);
  std::vector<Triple> corners = mesh.facetPoints;
  mesh.cornerPoints.clear();
  for (Index f = 0; f < mesh.numberOfFacets(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      Index& corner = cornerOfFan[fans.find(3 * f + k)];
      if (corner == noIndex)
      {
        corner = mesh.numberOfCorners();
        mesh.cornerPoints.push_back(mesh.facetPoints[f][k]);
      }
      corners[f][k] = corner;
    }
  }
  mesh.facetCorners = std::move(corners);
  if (mesh.facetCorners == mesh.facetPoints)
  {
    mesh.facetCorners = mesh.facetPoints; // held once
  }
}

/** The points whose corners do not all hang together across edges. */
std::vector<Index> findPinches(const SurfaceMesh& mesh, const Features& features)
{
  DisjointSets joined(mesh.cornerPoints.size());
  const EdgeTable& edges = features.edges;
  for (Index e = 0; e < edges.numberOfEdges(); ++e)
  {
    if (!features.cuts[e])
    {
      continue; // has the same corners on both sides
    }
    const Index first = edges.edgeFacets[edges.edgeFacetsBegin[e]];
    for (Index i = edges.edgeFacetsBegin[e] + 1; i < edges.edgeFacetsBegin[e + 1]; ++i)
    {
      for (const auto& [a, b] : cornersAtEnds(mesh, edges, e, first, edges.edgeFacets[i]))
      {
        joined.unite(mesh.facetCorners[a.facet][a.k], mesh.facetCorners[b.facet][b.k]);
      }
    }
  }
  std::vector<Index> parts(mesh.points.size(), 0);
  for (Index c = 0; c < mesh.numberOfCorners(); ++c)
  {
    parts[mesh.cornerPoints[c]] += joined.isLowest(c);
  }
  std::vector<Index> pinches;
  for (Index p = 0; p < mesh.numberOfPoints(); ++p)
  {
    if (parts[p] > 1)
    {
      pinches.push_back(p);
    }
  }
  return pinches;
}
}

void cutAlongFeatures(SurfaceMesh& mesh, Features& features)
{
  findPatches(features);
  findCuts(features);
  DisjointSets fans(3 * mesh.facetPoints.size()); // of the facets' corners
  for (Index e = 0; e < features.edges.numberOfEdges(); ++e)
  {
    if (!features.cuts[e])
    {
      const Index* around = features.edges.edgeFacets.data() + features.edges.edgeFacetsBegin[e];
      for (const auto& [a, b] : cornersAtEnds(mesh, features.edges, e, around[0], around[1]))
      {
        fans.unite(3 * a.facet + a.k, 3 * b.facet + b.k);
      }
    }
  }
  numberCorners(mesh, fans);
  features.pinches = findPinches(mesh, features);
}

std::vector<Index> findApexes(const SurfaceMesh& mesh, const Features& features, double spacing)
{
  std::vector<double> angles(mesh.points.size(), 0.0);
  for (const Triple& facet : mesh.facetPoints)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Point3& at = mesh.points[facet[k]];
      const Point3 u = mesh.points[facet[(k + 1) % 3]] - at;
      const Point3 v = mesh.points[facet[(k + 2) % 3]] - at;
      angles[facet[k]] += std::atan2(u.cross(v).norm(), u.dot(v));
      if (!(std::min(u.norm(), v.norm()) > spacing))
      {
        angles[facet[k]] = std::numeric_limits<double>::infinity();
      }
    }
  }
  for (std::size_t f = 0; f < mesh.facetPoints.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (features.kind(static_cast<Index>(f), k) != FeatureKind::None)
      {
        angles[mesh.facetPoints[f][k]] = std::numeric_limits<double>::infinity();
        angles[mesh.facetPoints[f][(k + 1) % 3]] = std::numeric_limits<double>::infinity();
      }
    }
  }
  std::vector<Index> apexes;
  for (Index p = 0; p < mesh.numberOfPoints(); ++p)
  {
    if (angles[p] <= maxAngleAtApex)
    {
      apexes.push_back(p);
    }
  }
  return apexes;
}

Features findFeatures(SurfaceMesh& mesh, const FeatureOptions& options, const RunControl& control,
  std::vector<FacetNormal>* borrowed)
{
  const RunControl silent = control.silent();
  Features features;
  features.spacing = options.spacing;
  features.edges = buildEdgeTable(mesh.facetPoints, silent);
  if (control.cancelled())
  {
    return features;
  }
  FeatureEdges found = findFeatureEdges(mesh, features.edges, options, silent);
  if (control.cancelled())
  {
    return features;
  }
  const std::vector<FeatureKind> all = found.kinds;
  dropSmallFeatures(mesh, features.edges, options, found);
  if (dropSteps(mesh, features.edges, options, silent, found) > 0)
  {
    dropSmallFeatures(mesh, features.edges, options, found);
  }
  bridgeGaps(mesh, features.edges, options, found);
  features.dropped = tellDropped(mesh, features.edges, all, found);
  features.kinds = std::move(found.kinds);
  if (borrowed)
  {
    *borrowed = std::move(found.borrowed);
  }
  if (control.cancelled())
  {
    return features;
  }
  cutAlongFeatures(mesh, features);
  if (!control.cancelled())
  {
    features.apexes = findApexes(mesh, features, options.spacing);
    traceCurves(mesh, features);
  }
  return features;
}

namespace
{
/** Lists the facets of the edges, whose numbers are known in the facets. */
void listFacets(const std::vector<Index>& valences, EdgeTable& table)
{
  table.edgeFacetsBegin.assign(valences.size() + 1, 0);
  for (std::size_t e = 0; e < valences.size(); ++e)
  {
    table.edgeFacetsBegin[e + 1] = table.edgeFacetsBegin[e] + valences[e];
  }
  table.edgeFacets.resize(3 * table.facetEdges.size());
  std::vector<Index> next(table.edgeFacetsBegin.begin(), table.edgeFacetsBegin.end() - 1);
  for (std::size_t f = 0; f < table.facetEdges.size(); ++f)
  {
    for (const Index edge : table.facetEdges[f])
    {
      table.edgeFacets[next[edge]++] = static_cast<Index>(f);
    }
  }
}
}

EdgeTable buildCutEdgeTable(
  const SurfaceMesh& mesh, const Features* features, const RunControl& control)
{
  if (!features)
  {
    return buildEdgeTable(mesh.facetPoints, control);
  }
  EdgeTable table;
  const std::size_t count = mesh.facetPoints.size();
  table.facetEdges.resize(count);
  std::vector<Index> number(features->kinds.size(), noIndex);
  std::vector<Index> valences;
  for (std::size_t f = 0; f < count; ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index edge = features->edges.facetEdges[f][k];
      const bool cut = features->cuts[edge] != 0;
      if (cut || number[edge] == noIndex)
      {
        number[edge] = static_cast<Index>(valences.size());
        valences.push_back(0);
      }
      table.facetEdges[f][k] = number[edge];
      ++valences[number[edge]];
    }
  }
  listFacets(valences, table);
  return table;
}
}
