/**
 * @file EdgeSplit.cxx
 *
 * A facet and the middles of its sides are six nodes: 0 to 2 the corners, 3 + k the middle of side
 * k, which joins the corners k and k + 1. The facets it is split into are triples of nodes.
 */
#include "Refinement/EdgeSplit.h"

#include "Features/FeatureGraph.h"

#include <algorithm>
#include <numeric>

namespace remesh
{
namespace
{
using Nodes = std::array<int, 3>;

/** The facets that a facet is split into. */
struct Parts
{
  std::array<Nodes, 4> nodes;
  int count = 0;

  void add(int a, int b, int c) { this->nodes[this->count++] = { a, b, c }; }
};

/** @param longest of the sides that are split, if one is. */
Parts partsOf(const std::array<bool, 3>& split, int longest)
{
  const int a = longest;
  const int b = (longest + 1) % 3;
  const int c = (longest + 2) % 3;
  const int ab = 3 + a;
  const int bc = 3 + b;
  const int ca = 3 + c;
  Parts parts;
  if (!split[a])
  {
    parts.add(0, 1, 2);
  }
  else if (split[b] && split[c])
  {
    parts.add(a, ab, ca);
    parts.add(ab, bc, ca);
    parts.add(ab, b, bc);
    parts.add(ca, bc, c);
  }
  else
  {
    split[c] ? parts.add(a, ab, ca) : parts.add(a, ab, c);
    if (split[c])
    {
      parts.add(ca, ab, c);
    }
    if (split[b])
    {
      parts.add(ab, bc, c);
    }
    split[b] ? parts.add(ab, b, bc) : parts.add(ab, b, c);
  }
  return parts;
}

/** The side of the facet on which both nodes lie; 3 if none. */
int sideThrough(int node, int other)
{
  for (int side = 0; side < 3; ++side)
  {
    const auto isOn = [side](int n) { return n == side || n == (side + 1) % 3 || n == 3 + side; };
    if (isOn(node) && isOn(other))
    {
      return side;
    }
  }
  return 3;
}

/** The longest of the sides that are split; any where none is. */
int longestSplit(
  const Triple& facetEdges, const std::array<bool, 3>& split, const EdgesToSplit& wanted)
{
  int longest = 0;
  for (const int k : { 1, 2 })
  {
    const bool isBetter =
      split[k] != split[longest] ? split[k] : wanted.isLonger(facetEdges[k], facetEdges[longest]);
    longest = isBetter ? k : longest;
  }
  return longest;
}

/** One round of splits. */
class Splitter
{
public:
  Splitter(const EdgeTable& edges, const EdgesToSplit& wanted, RefinedSurface& surface)
    : m_edges(edges)
    , m_wanted(wanted)
    , m_surface(surface)
    , m_pointNumbers(surface.mesh.points.size(), noIndex)
    , m_middleNumbers(wanted.marked.size(), noIndex)
  {
  }

  /** The features get the kinds of the edges alone. */
  void run(const PieceShapes* shapes, const RunControl& control)
  {
    const SurfaceMesh& before = m_surface.mesh;
    for (Index f = 0; f < before.numberOfFacets(); ++f)
    {
      this->split(f);
    }
    if (shapes && !flipPieces(*shapes, control, { m_facets, m_origins, m_kinds }))
    {
      return;
    }
    SurfaceMesh mesh;
    mesh.points = std::move(m_points);
    mesh.facetPoints = std::move(m_facets);
    mesh.facetCorners = mesh.facetPoints;
    mesh.cornerPoints.resize(mesh.points.size());
    std::iota(mesh.cornerPoints.begin(), mesh.cornerPoints.end(), 0);
    mesh.facetInputCells = std::move(m_cells);
    m_surface.mesh = std::move(mesh);
    m_surface.origins = std::move(m_origins);
    if (m_surface.features)
    {
      this->inheritKinds(control);
    }
  }

private:
  void split(Index facet)
  {
    const Triple& sides = m_edges.facetEdges[facet];
    const std::array<bool, 3> split{ m_wanted.marked[sides[0]] != 0, m_wanted.marked[sides[1]] != 0,
      m_wanted.marked[sides[2]] != 0 };
    const Parts parts = partsOf(split, longestSplit(sides, split, m_wanted));
    for (int p = 0; p < parts.count; ++p)
    {
      this->addFacet(facet, parts.nodes[p]);
    }
  }

  void addFacet(Index facet, const Nodes& nodes)
  {
    Triple points;
    FacetOrigin origin = m_surface.origins[facet];
    for (int k = 0; k < 3; ++k)
    {
      points[k] = this->numberOf(facet, nodes[k]);
      origin.corners[k] = this->placeOf(facet, nodes[k]);
    }
    m_facets.push_back(points);
    m_origins.push_back(origin);
    m_cells.push_back(m_surface.mesh.facetInputCells[facet]);
    if (m_surface.features)
    {
      std::array<FeatureKind, 3>& kinds = m_kinds.emplace_back();
      for (int k = 0; k < 3; ++k)
      {
        const int side = sideThrough(nodes[k], nodes[(k + 1) % 3]);
        kinds[k] = side < 3 ? m_surface.features->kind(facet, side) : FeatureKind::None;
      }
    }
  }

  Index numberOf(Index facet, int node)
  {
    const SurfaceMesh& mesh = m_surface.mesh;
    const Triple& points = mesh.facetPoints[facet];
    const bool isCorner = node < 3;
    Index& number = isCorner ? m_pointNumbers[points[node]]
                             : m_middleNumbers[m_edges.facetEdges[facet][node - 3]];
    if (number == noIndex)
    {
      number = static_cast<Index>(m_points.size());
      const Point3& a = mesh.points[points[node % 3]];
      const Point3& b = mesh.points[points[(node + 1) % 3]];
      m_points.push_back(isCorner ? a : Point3(0.5 * (a + b)));
    }
    return number;
  }

  /** Barycentric coordinates on the surface before all splits. */
  std::array<float, 3> placeOf(Index facet, int node) const
  {
    const auto& corners = m_surface.origins[facet].corners;
    if (node < 3)
    {
      return corners[node];
    }
    std::array<float, 3> middle;
    for (int j = 0; j < 3; ++j)
    {
      middle[j] = 0.5F * (corners[node - 3][j] + corners[(node - 2) % 3][j]);
    }
    return middle;
  }

  void inheritKinds(const RunControl& control)
  {
    Features& features = *m_surface.features;
    for (Index& apex : features.apexes)
    {
      apex = m_pointNumbers[apex];
    }
    std::sort(features.apexes.begin(), features.apexes.end());
    features.edges = buildEdgeTable(m_surface.mesh.facetPoints, control);
    features.kinds.assign(
      static_cast<std::size_t>(features.edges.numberOfEdges()), FeatureKind::None);
    for (std::size_t f = 0; f < features.edges.facetEdges.size(); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        features.kinds[features.edges.facetEdges[f][k]] = m_kinds[f][k];
      }
    }
  }

  const EdgeTable& m_edges;
  const EdgesToSplit& m_wanted;
  RefinedSurface& m_surface;
  std::vector<Index> m_pointNumbers;  ///< new ones of the points before
  std::vector<Index> m_middleNumbers; ///< of the middles of edges
  std::vector<Point3> m_points;
  std::vector<Triple> m_facets;
  std::vector<FacetOrigin> m_origins;
  std::vector<Offset> m_cells;
  std::vector<std::array<FeatureKind, 3>> m_kinds; ///< of the facets' sides
};
}

int longestSide(const Triple& facetEdges, const EdgesToSplit& wanted)
{
  return longestSplit(facetEdges, { true, true, true }, wanted);
}

void closeMarks(const EdgeTable& edges, EdgesToSplit& wanted)
{
  std::vector<Index> fresh;
  for (Index e = 0; e < edges.numberOfEdges(); ++e)
  {
    if (wanted.marked[e])
    {
      fresh.push_back(e);
    }
  }
  while (!fresh.empty())
  {
    const Index edge = fresh.back();
    fresh.pop_back();
    for (Index k = edges.edgeFacetsBegin[edge]; k < edges.edgeFacetsBegin[edge + 1]; ++k)
    {
      const Index facet = edges.edgeFacets[k];
      const Triple& sides = edges.facetEdges[facet];
      const Index longest = sides[longestSide(sides, wanted)];
      if (!wanted.isOpen(facet) && !wanted.marked[longest])
      {
        wanted.marked[longest] = 1;
        fresh.push_back(longest);
      }
    }
  }
}

void splitEdges(const EdgeTable& edges, const EdgesToSplit& wanted, const PieceShapes* shapes,
  const RunControl& control, RefinedSurface& surface)
{
  Splitter(edges, wanted, surface).run(shapes, control);
  if (surface.features && !control.cancelled())
  {
    cutAlongFeatures(surface.mesh, *surface.features);
  }
}
}
