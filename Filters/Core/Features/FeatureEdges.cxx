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
constexpr int maxThinFacets = 8;      // over thin facets, to one with a normal
constexpr double needleHeight = 0.02; // of the spacing, below
/**
 * Flaps. Between their sides points would be as close to each other as these are, eight to a side
 * or more. Strips of facets are none, as rims of thin plates: their diagonals are no creases.
 */
constexpr double flapHeight = 0.2;           // of the spacing, below
constexpr double flapSlenderness = 0.125;    // height, of the longest side, below
constexpr double minAgreement = 0.1;         // of cosines; ridges with two like sides have none
constexpr double cosineOfTurningBack = -0.7; // a surface that folds up, to and fro

double cosineOf(double degrees)
{
  return std::cos(degrees * std::acos(-1.0) / 180.0);
}

struct FacetShape
{
  Point3 normal;
  std::array<double, 3> lengths;
  double height; ///< above the longest edge
  bool thin;     ///< too thin for its normal to mean anything
  bool needle = false;

  bool isSlender() const
  {
    return this->height < flapSlenderness * this->lengths[this->longestBut(-1)];
  }
  bool hasNormal() const { return !this->thin && !this->needle; }

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
  FacetShape shape{ facetNormal(*p[0], *p[1], *p[2]), {}, 0.0, true };
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

/** Of two facets that alone share an edge: the cosine between these normals of theirs. */
double cosineBetween(const SurfaceMesh& mesh, const EdgeTable& edges, Index edge,
  const Point3& first, const Point3& second)
{
  const Index* around = edges.edgeFacets.data() + edges.edgeFacetsBegin[edge];
  const double cosine = first.dot(second);
  return opposed(mesh, edges, edge, around[0], around[1]) ? -cosine : cosine;
}

/** The normals beyond the long sides of a facet, turned as its own; none where one has none. */
struct NormalsBeside
{
  std::array<Point3, 3> normals;
  int count = 0;
};

NormalsBeside normalsBeside(const SurfaceMesh& mesh, const EdgeTable& edges,
  const std::vector<FacetShape>& shapes, Index facet)
{
  const FacetShape& shape = shapes[facet];
  const double second = shape.lengths[shape.longestBut(shape.longestBut(-1))];
  NormalsBeside beside;
  for (int side = 0; side < 3; ++side)
  {
    if (shape.lengths[side] < second)
    {
      continue;
    }
    const Index edge = edges.facetEdges[facet][side];
    const Index other = beyond(edges, edge, facet);
    if (other == noIndex || shapes[other].thin)
    {
      return {};
    }
    const double sign = opposed(mesh, edges, edge, facet, other) ? -1.0 : 1.0;
    beside.normals[beside.count++] = sign * shapes[other].normal;
  }
  return beside;
}

/**
 * Whether a slender facet that makes creases of its long sides stands out of facets that agree with
 * each other. Where a surface rolls or folds up, each stands out of the next.
 *
 * @param nearest the largest of the cosines to them.
 */
bool isFlap(const NormalsBeside& beside, double nearest)
{
  double agreement = 1.0;
  for (int k = 1; k < beside.count; ++k)
  {
    for (int l = 0; l < k; ++l)
    {
      agreement = std::min(agreement, beside.normals[k].dot(beside.normals[l]));
    }
  }
  return agreement > nearest + minAgreement && nearest > cosineOfTurningBack;
}

std::vector<FacetShape> findShapes(const SurfaceMesh& mesh, const EdgeTable& edges,
  const FeatureOptions& options, const RunControl& control)
{
  const double least = minHeight(mesh);
  const double lowest = needleHeight * options.spacing;
  const double highest = flapHeight * options.spacing;
  const double minCosine = cosineOf(options.angleDegrees);
  std::vector<FacetShape> shapes(mesh.facetPoints.size());
  const auto count = static_cast<Offset>(shapes.size());
  const auto findShape = [&](Offset f) { shapes[f] = shapeOf(mesh, static_cast<Index>(f), least); };
  const auto findNeedle = [&](Offset f)
  {
    FacetShape& shape = shapes[f];
    const bool isLow = shape.height < lowest;
    if (shape.thin || !(isLow || (shape.height < highest && shape.isSlender())))
    {
      return;
    }
    const NormalsBeside beside = normalsBeside(mesh, edges, shapes, static_cast<Index>(f));
    double nearest = -1.0;
    for (int k = 0; k < beside.count; ++k)
    {
      nearest = std::max(nearest, shape.normal.dot(beside.normals[k]));
    }
    shape.needle = beside.count > 0 && nearest < minCosine && (isLow || isFlap(beside, nearest));
  };
  static_cast<void>(
    forEachItem(count, control, findShape) && forEachItem(count, control, findNeedle));
  return shapes;
}

/**
 * Where a facet's way to a normal begins: at the facet itself, but for two without a normal whose
 * longest edge is the same one. Both ways begin at the lower id; each from its own, they would
 * cross, and the two facets take the normals from each other's sides.
 */
Index firstOfPair(const EdgeTable& edges, const std::vector<FacetShape>& shapes, Index facet)
{
  const Index edge = edges.facetEdges[facet][shapes[facet].longestBut(-1)];
  const Index other = beyond(edges, edge, facet);
  const bool isPair = !shapes[facet].hasNormal() && other != noIndex && other < facet &&
    !shapes[other].hasNormal() && edges.facetEdges[other][shapes[other].longestBut(-1)] == edge;
  return isPair ? other : facet;
}

/** Those of facets that have one; others take that of a facet beyond their long sides. */
std::vector<Point3> reliableNormals(const SurfaceMesh& mesh, const EdgeTable& edges,
  const std::vector<FacetShape>& shapes, const RunControl& control)
{
  std::vector<Point3> normals(shapes.size());
  const auto findNormal = [&](Offset f)
  {
    const auto facet = static_cast<Index>(f);
    Index at = firstOfPair(edges, shapes, facet);
    const int longest = shapes[facet].longestBut(-1);
    double sign =
      at != facet && opposed(mesh, edges, edges.facetEdges[facet][longest], facet, at) ? -1.0 : 1.0;
    int side = -1; // that it is come in by
    for (int step = 0; step < maxThinFacets && !shapes[at].hasNormal(); ++step)
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
    normals[f] = shapes[at].hasNormal() ? Point3(sign * shapes[at].normal) : shapes[f].normal;
  };
  static_cast<void>(forEachItem(static_cast<Offset>(shapes.size()), control, findNormal));
  return normals;
}

std::vector<FacetNormal> borrowedNormals(
  const std::vector<FacetShape>& shapes, const std::vector<Point3>& normals)
{
  std::vector<FacetNormal> borrowed;
  for (std::size_t f = 0; f < shapes.size(); ++f)
  {
    if (!shapes[f].hasNormal())
    {
      borrowed.push_back({ static_cast<Index>(f), normals[f] });
    }
  }
  return borrowed;
}

/** Tells features from other edges. */
class EdgeJudge
{
public:
  /** @param normals F, reliable ones. All must outlive it. */
  EdgeJudge(const SurfaceMesh& mesh, const EdgeTable& edges, const std::vector<FacetShape>& shapes,
    const std::vector<Point3>& normals, const FeatureOptions& options)
    : m_mesh(mesh)
    , m_edges(edges)
    , m_shapes(shapes)
    , m_normals(normals)
    , m_options(options)
    , m_flat(cosineOf(weakShare * options.angleDegrees))
    , m_leastCosine(cosineOf(options.angleDegrees))
  {
  }

  /** @param angle stays as it is where the edge is flat, or of no two facets. */
  FeatureKind kindOf(Index edge, float& angle) const
  {
    const Index* around = this->facetsAt(edge);
    if (m_edges.valence(edge) != 2)
    {
      return m_edges.valence(edge) == 1 ? FeatureKind::Boundary : FeatureKind::NonManifold;
    }
    const double cosine =
      cosineBetween(m_mesh, m_edges, edge, m_normals[around[0]], m_normals[around[1]]);
    if (!(cosine > m_flat))
    {
      angle = static_cast<float>(std::acos(std::clamp(cosine, -1.0, 1.0)));
    }
    const bool isFeature =
      cosine < m_leastCosine || isGivenFeature(m_mesh, m_edges, m_options, edge);
    return isFeature ? FeatureKind::Crease : FeatureKind::None;
  }

  /** Whether an edge of two facets, one of them a needle, is a crease by their own normals. */
  bool isSharpByNeedle(Index edge) const
  {
    const FacetShape& a = m_shapes[this->facetsAt(edge)[0]];
    const FacetShape& b = m_shapes[this->facetsAt(edge)[1]];
    return (a.needle || b.needle) &&
      cosineBetween(m_mesh, m_edges, edge, a.normal, b.normal) < m_leastCosine;
  }

private:
  const Index* facetsAt(Index edge) const
  {
    return m_edges.edgeFacets.data() + m_edges.edgeFacetsBegin[edge];
  }

  const SurfaceMesh& m_mesh;
  const EdgeTable& m_edges;
  const std::vector<FacetShape>& m_shapes;
  const std::vector<Point3>& m_normals;
  const FeatureOptions& m_options;
  double m_flat;
  double m_leastCosine;
};
}

bool isSeam(const SurfaceMesh& mesh, const EdgeTable& edges,
  const std::vector<Triple>& cornerCharts, Index edge)
{
  const Index* around = edges.edgeFacets.data() + edges.edgeFacetsBegin[edge];
  const Triple& points = mesh.facetPoints[around[0]];
  const Triple& others = mesh.facetPoints[around[1]];
  const int side = edges.sideOf(around[0], edge);
  for (const int k : { side, (side + 1) % 3 })
  {
    const auto l = std::find(others.begin(), others.end(), points[k]) - others.begin();
    if (cornerCharts[around[0]][k] != cornerCharts[around[1]][l])
    {
      return true;
    }
  }
  return false;
}

bool isGivenFeature(
  const SurfaceMesh& mesh, const EdgeTable& edges, const FeatureOptions& options, Index edge)
{
  const Index* around = edges.edgeFacets.data() + edges.edgeFacetsBegin[edge];
  const std::vector<Index>& labels = options.facetLabels;
  return (!labels.empty() && labels[around[0]] != labels[around[1]]) ||
    (!options.cornerCharts.empty() && isSeam(mesh, edges, options.cornerCharts, edge));
}

FeatureEdges findFeatureEdges(const SurfaceMesh& mesh, const EdgeTable& edges,
  const FeatureOptions& options, const RunControl& control)
{
  const std::vector<FacetShape> shapes = findShapes(mesh, edges, options, control);
  const std::vector<Point3> normals = reliableNormals(mesh, edges, shapes, control);
  const EdgeJudge judge(mesh, edges, shapes, normals, options);
  FeatureEdges features;
  features.borrowed = borrowedNormals(shapes, normals);
  features.kinds.resize(static_cast<std::size_t>(edges.numberOfEdges()));
  features.angles.resize(features.kinds.size(), 0.0F);
  std::vector<char> leftOut(features.kinds.size(), 0);
  const auto findKind = [&](Offset item)
  {
    const auto edge = static_cast<Index>(item);
    features.kinds[edge] = judge.kindOf(edge, features.angles[edge]);
    leftOut[edge] = features.kinds[edge] == FeatureKind::None && judge.isSharpByNeedle(edge);
  };
  if (forEachItem(edges.numberOfEdges(), control, findKind))
  {
    for (Index edge = 0; edge < edges.numberOfEdges(); ++edge)
    {
      if (leftOut[edge])
      {
        features.sidesOfNeedles.push_back(edge);
      }
    }
  }
  return features;
}
}
