/**
 * @file FeatureSteps.cxx
 *
 * A surface made of voxels has creases at each of its steps, straight and strong ones, that hang
 * together everywhere: neither their size nor their shape tells them from those of a machine part.
 * What does is that up and down cancel: smoothed over the spacing of the points, the surface hardly
 * moves there, and goes on across them. Pins, fins and thin plates would shrink.
 */
#include "Features/CreaseGraph.h"
#include "Features/FeatureEdges.h"

#include "Mesh/NormalFlow.h"
#include "Mesh/Normals.h"
#include "Support/DisjointSets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
// Of the points that the spacing gives:
constexpr double tooManyBends = 1.0; // for creases to be dropped at all
constexpr double maxBends = 0.5;     // in the end, if wider smoothing helps

constexpr double minBend = 0.5; // radians, of a curve at a point of it

// In spacings:
constexpr double narrowestSmoothing = 0.25;
constexpr double widestSmoothing = 1.0;
constexpr double highestStep = 0.3; // by which the surface moves

// Of the length of creases that hang together:
constexpr double maxHighShare = 0.02;
constexpr double minGoneShare = 0.5;

/** Points at which features meet, end, or bend. */
Offset countBends(const CreaseGraph& graph)
{
  Offset bends = 0;
  for (Index p = 0; p < graph.mesh.numberOfPoints(); ++p)
  {
    const Index degree = graph.degree(p);
    bends += degree == 2 ? graph.turn(p) > minBend : degree > 0;
  }
  return bends;
}

/** A surface smoothed over some distance. */
struct Smoothed
{
  double radius;
  std::vector<Point3> normals; ///< C
  std::vector<Point3> places;  ///< C

  Smoothed(const SurfaceMesh& mesh, double over, const RunControl& control)
    : radius(over)
    , normals(estimateCornerNormals(mesh, 0, control))
    , places(smoothNormalsAndPlacesOver(mesh, over, control, this->normals))
  {
  }

  double moved(const SurfaceMesh& mesh, Index corner) const
  {
    return (this->places[corner] - mesh.points[mesh.cornerPoints[corner]]).norm();
  }
};

/** The corner of a facet opposite to its edge k. */
Index opposite(const SurfaceMesh& mesh, Index facet, int k)
{
  return mesh.facetCorners[facet][(k + 2) % 3];
}

/**
 * By how much smoothed normals turn from one side of an edge to the other, over the distance they
 * were smoothed over to both sides; radians.
 */
double turnAcross(
  const SurfaceMesh& mesh, const EdgeTable& edges, const Smoothed& smoothed, Index edge)
{
  const Index* facets = edges.edgeFacets.data() + edges.edgeFacetsBegin[edge];
  const Index a = opposite(mesh, facets[0], edges.sideOf(facets[0], edge));
  const Index b = opposite(mesh, facets[1], edges.sideOf(facets[1], edge));
  const Point3& from = smoothed.normals[a];
  const Point3& to = smoothed.normals[b];
  const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
  const double distance =
    (mesh.points[mesh.cornerPoints[a]] - mesh.points[mesh.cornerPoints[b]]).norm();
  return angle * std::max(1.0, 2.0 * smoothed.radius / distance);
}

/** What smoothing does to a crease. */
struct Smoothing
{
  Index edge;
  bool isGone;
  bool isHigh; ///< the surface moves far there
};

/** Of all that may be dropped. */
std::vector<Smoothing> smoothCreases(const CreaseGraph& graph, const EdgeTable& edges,
  const FeatureOptions& options, const Smoothed& smoothed, const std::vector<FeatureKind>& kinds)
{
  const SurfaceMesh& mesh = graph.mesh;
  const double least = options.angleDegrees * EIGEN_PI / 180.0;
  std::vector<Smoothing> creases;
  for (std::size_t e = 0; e < kinds.size(); ++e)
  {
    const auto edge = static_cast<Index>(e);
    if (kinds[e] == FeatureKind::None || !graph.droppable[e])
    {
      continue;
    }
    const Index facet = edges.edgeFacets[edges.edgeFacetsBegin[e]];
    const int k = edges.sideOf(facet, edge);
    const double moved = std::max(smoothed.moved(mesh, mesh.facetCorners[facet][k]),
      smoothed.moved(mesh, mesh.facetCorners[facet][(k + 1) % 3]));
    creases.push_back({ edge, turnAcross(mesh, edges, smoothed, edge) < least,
      moved > highestStep * options.spacing });
  }
  return creases;
}

/** Drops what the smoothing does away with, of creases that hang together and hardly move. */
Index dropGone(const CreaseGraph& graph, const EdgeTable& edges, const FeatureOptions& options,
  const Smoothed& smoothed, FeatureEdges& features)
{
  std::vector<FeatureKind>& kinds = features.kinds;
  const std::vector<Smoothing> creases = smoothCreases(graph, edges, options, smoothed, kinds);
  DisjointSets sets(graph.mesh.points.size()); // of those that hang together
  for (const Smoothing& crease : creases)
  {
    sets.unite(graph.ends[crease.edge][0], graph.ends[crease.edge][1]);
  }
  std::vector<double> lengths(graph.mesh.points.size(), 0.0);
  std::vector<double> gone(graph.mesh.points.size(), 0.0);
  std::vector<double> high(graph.mesh.points.size(), 0.0);
  for (const Smoothing& crease : creases)
  {
    const Index root = sets.find(graph.ends[crease.edge][0]);
    const double length = graph.length(crease.edge);
    lengths[root] += length;
    gone[root] += crease.isGone ? length : 0.0;
    high[root] += crease.isHigh ? length : 0.0;
  }
  Index dropped = 0;
  for (const Smoothing& crease : creases)
  {
    const Index root = sets.find(graph.ends[crease.edge][0]);
    if (crease.isGone && gone[root] >= minGoneShare * lengths[root] &&
      high[root] <= maxHighShare * lengths[root])
    {
      kinds[crease.edge] = FeatureKind::None;
      features.angles[crease.edge] = 0.0F; // no gap is bridged along it
      ++dropped;
    }
  }
  return dropped;
}
}

Index dropSteps(const SurfaceMesh& mesh, const EdgeTable& edges, const FeatureOptions& options,
  const RunControl& control, FeatureEdges& features)
{
  if (!(options.spacing > 0.0))
  {
    return 0;
  }
  const double points = std::pow(meanSpacing(mesh, 1) / options.spacing, 2.0);
  CreaseGraph graph = makeCreaseGraph(mesh, edges, options, features.kinds);
  Index dropped = 0;
  double most = tooManyBends * points;
  for (double width = narrowestSmoothing;
       width <= widestSmoothing && static_cast<double>(countBends(graph)) > most; width *= 2.0)
  {
    most = maxBends * points;
    const Smoothed smoothed(mesh, width * options.spacing, control);
    if (control.cancelled())
    {
      break;
    }
    dropped += dropGone(graph, edges, options, smoothed, features);
    graph.listAround(features.kinds);
  }
  return dropped;
}
}
