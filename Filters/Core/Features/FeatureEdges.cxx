#include "Features/FeatureEdges.h"

#include "Mesh/Extent.h"
#include "Mesh/FacetGeometry.h"
#include "Support/Grouping.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
constexpr int mostSteps = 8;          // over thin facets, to one with a normal
constexpr double needleHeight = 0.02; // of the spacing, at most

double cosineOf(double degrees)
{
  return std::cos(degrees * std::acos(-1.0) / 180.0);
}

struct FacetShape
{
  Point3 normal;
  double height;
  bool thin; ///< too thin for its normal to mean anything
  std::array<double, 3> lengths;

  /** The longest edge, but for one. */
  int longestBut(int other) const
  {
    int longest = other == 0 ? 1 : 0;
    for (int k = longest + 1; k < 3; ++k)
    {
      longest = k != other && this->lengths[k] > this->lengths[longest] ? k : longest;
    }
    return longest;
  }
};

FacetShape shapeOf(const SurfaceMesh& mesh, Index facet, double least)
{
  const Triple& points = mesh.facetPoints[facet];
  const Point3* p[3];
  for (int k = 0; k < 3; ++k)
  {
    p[k] = &mesh.points[points[k]];
  }
  FacetShape shape{ facetNormal(*p[0], *p[1], *p[2]), 0.0, true, {} };
  double longest = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    shape.lengths[k] = (*p[(k + 1) % 3] - *p[k]).norm();
    longest = std::max(longest, shape.lengths[k]);
  }
  shape.height = longest > 0.0 ? 2.0 * facetArea(*p[0], *p[1], *p[2]) / longest : 0.0;
  shape.thin = shape.height < least;
  return shape;
}

/** Whether both facets run along their common edge in the same direction: one is turned over. */
bool opposed(const SurfaceMesh& mesh, const EdgeTable& edges, Index edge, Index first, Index second)
{
  const auto start = [&](Index facet)
  { return mesh.facetPoints[facet][edges.sideOf(facet, edge)]; };
  return start(first) == start(second);
}

/** The facet beyond an edge of two facets, or noIndex. */
Index beyond(const EdgeTable& edges, Index edge, Index facet)
{
  if (edges.valence(edge) != 2)
  {
    return noIndex;
  }
  const Index* around = edges.edgeFacets.data() + edges.edgeFacetsBegin[edge];
  return around[0] == facet ? around[1] : around[0];
}

/** Whether a facet's normal makes a crease of each of its long sides. */
bool isNeedle(const SurfaceMesh& mesh, const EdgeTable& edges,
  const std::vector<FacetShape>& shapes, double leastCosine, Index facet)
{
  const int longest = shapes[facet].longestBut(-1);
  for (const int side : { longest, shapes[facet].longestBut(longest) })
  {
    const Index edge = edges.facetEdges[facet][side];
    const Index other = beyond(edges, edge, facet);
    if (other == noIndex)
    {
      return false;
    }
    const double sign = opposed(mesh, edges, edge, facet, other) ? -1.0 : 1.0;
    if (sign * shapes[facet].normal.dot(shapes[other].normal) >= leastCosine)
    {
      return false;
    }
  }
  return true;
}

std::vector<FacetShape> findShapes(const SurfaceMesh& mesh, const EdgeTable& edges,
  const FeatureOptions& options, const RunControl& control)
{
  const double least = leastHeight(mesh);
  const double highest = needleHeight * options.spacing;
  const double leastCosine = cosineOf(options.angleDegrees);
  std::vector<FacetShape> shapes(mesh.facetPoints.size());
  std::vector<char> needles(shapes.size(), 0);
  const auto count = static_cast<Offset>(shapes.size());
  const auto findShape = [&](Offset f) { shapes[f] = shapeOf(mesh, static_cast<Index>(f), least); };
  const auto findNeedle = [&](Offset f)
  {
    needles[f] = shapes[f].height < highest &&
      isNeedle(mesh, edges, shapes, leastCosine, static_cast<Index>(f));
  };
  static_cast<void>(
    forEachItem(count, control, findShape) && forEachItem(count, control, findNeedle));
  for (std::size_t f = 0; f < shapes.size(); ++f)
  {
    shapes[f].thin = shapes[f].thin || needles[f] != 0;
  }
  return shapes;
}

/** Those of facets that have one; others take that of a facet beyond their long sides. */
std::vector<Point3> reliableNormals(const SurfaceMesh& mesh, const EdgeTable& edges,
  const FeatureOptions& options, const RunControl& control)
{
  const std::vector<FacetShape> shapes = findShapes(mesh, edges, options, control);
  std::vector<Point3> normals(shapes.size());
  const auto findNormal = [&](Offset f)
  {
    auto at = static_cast<Index>(f);
    double sign = 1.0;
    int side = -1; // that it is come in by
    for (int step = 0; step < mostSteps && shapes[at].thin; ++step)
    {
      const Index edge = edges.facetEdges[at][shapes[at].longestBut(side)];
      const Index next = beyond(edges, edge, at);
      if (next == noIndex)
      {
        break;
      }
      sign = opposed(mesh, edges, edge, at, next) ? -sign : sign;
      at = next;
      side = edges.sideOf(at, edge);
    }
    normals[f] = shapes[at].thin ? shapes[f].normal : Point3(sign * shapes[at].normal);
  };
  static_cast<void>(forEachItem(static_cast<Offset>(shapes.size()), control, findNormal));
  return normals;
}
}

FeatureEdges findFeatureEdges(const SurfaceMesh& mesh, const EdgeTable& edges,
  const FeatureOptions& options, const RunControl& control)
{
  const std::vector<Point3> normals = reliableNormals(mesh, edges, options, control);
  const double flat = cosineOf(weakShare * options.angleDegrees);
  const double leastCosine = cosineOf(options.angleDegrees);
  FeatureEdges features;
  features.kinds.resize(static_cast<std::size_t>(edges.numberOfEdges()));
  features.angles.resize(features.kinds.size(), 0.0F);
  const auto findKind = [&](Offset item)
  {
    const auto edge = static_cast<Index>(item);
    const Index* around = edges.edgeFacets.data() + edges.edgeFacetsBegin[edge];
    if (edges.valence(edge) != 2)
    {
      features.kinds[edge] =
        edges.valence(edge) == 1 ? FeatureKind::Boundary : FeatureKind::NonManifold;
      return;
    }
    const bool bordersLabels = !options.facetLabels.empty() &&
      options.facetLabels[around[0]] != options.facetLabels[around[1]];
    const double sign = opposed(mesh, edges, edge, around[0], around[1]) ? -1.0 : 1.0;
    const double cosine = sign * normals[around[0]].dot(normals[around[1]]);
    features.angles[edge] =
      cosine > flat ? 0.0F : static_cast<float>(std::acos(std::clamp(cosine, -1.0, 1.0)));
    features.kinds[edge] =
      bordersLabels || cosine < leastCosine ? FeatureKind::Crease : FeatureKind::None;
  };
  static_cast<void>(forEachItem(edges.numberOfEdges(), control, findKind));
  return features;
}
}
