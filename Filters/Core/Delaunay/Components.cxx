#include "Delaunay/Components.h"

#include "Support/DisjointSets.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <numeric>

namespace remesh
{
namespace
{
/** Joins the pieces of each cell that share a segment of a facet's edge. */
void joinAcrossEdges(const EdgeTable& edges, const Diagram& diagram, DisjointSets& sets)
{
  for (Offset piece = 0; piece < diagram.numberOfPieces(); ++piece)
  {
    const Index facet = diagram.facets[piece];
    for (Offset v = diagram.vertexBegin[piece]; v < diagram.vertexBegin[piece + 1]; ++v)
    {
      const Index across = diagram.vertices[v].across;
      if (across >= 0)
      {
        continue;
      }
      const Index edge = edges.facetEdges[facet][-1 - across];
      const Index first = edges.edgeFacets[edges.edgeFacetsBegin[edge]];
      if (first != facet)
      {
        if (const Offset other = diagram.pieceOf(first, diagram.sites[piece]); other >= 0)
        {
          sets.unite(static_cast<Index>(piece), static_cast<Index>(other));
        }
      }
    }
  }
}

/** Joins the pieces around each corner: all belong to the cell that owns it. */
void joinAroundCorners(const EmbeddedSurface& surface, const Diagram& diagram,
  const std::vector<Index>& owners, DisjointSets& sets)
{
  std::vector<Offset> firstPiece(owners.size(), -1);
  for (Index facet = 0; facet < surface.numberOfFacets(); ++facet)
  {
    for (const Index corner : surface.facetCorners[facet])
    {
      const Offset piece = diagram.pieceOf(facet, owners[corner]);
      if (firstPiece[corner] < 0)
      {
        firstPiece[corner] = piece;
      }
      else if (piece >= 0)
      {
        sets.unite(static_cast<Index>(firstPiece[corner]), static_cast<Index>(piece));
      }
    }
  }
}

/** Numbers the sets by site and first piece, and lists the pieces of each. */
void numberComponents(const Diagram& diagram, DisjointSets& sets, Components& components)
{
  const Offset count = diagram.numberOfPieces();
  std::vector<Offset> roots;
  for (Offset piece = 0; piece < count; ++piece)
  {
    if (sets.find(static_cast<Index>(piece)) == piece)
    {
      roots.push_back(piece);
    }
  }
  std::stable_sort(roots.begin(), roots.end(),
    [&](Offset a, Offset b) { return diagram.sites[a] < diagram.sites[b]; });
  components.ofPiece.resize(static_cast<std::size_t>(count));
  for (std::size_t k = 0; k < roots.size(); ++k)
  {
    const Index site = diagram.sites[roots[k]];
    const bool sameSite = k > 0 && components.sites.back() == site;
    components.ranks.push_back(sameSite ? components.ranks.back() + 1 : 0);
    components.sites.push_back(site);
    components.ofPiece[roots[k]] = static_cast<Index>(k);
  }
  components.pieceBegin.assign(roots.size() + 1, 0);
  for (Offset piece = 0; piece < count; ++piece)
  {
    components.ofPiece[piece] = components.ofPiece[sets.find(static_cast<Index>(piece))];
    ++components.pieceBegin[static_cast<std::size_t>(components.ofPiece[piece]) + 1];
  }
  std::partial_sum(
    components.pieceBegin.begin(), components.pieceBegin.end(), components.pieceBegin.begin());
  std::vector<Offset> next(components.pieceBegin.begin(), components.pieceBegin.end() - 1);
  components.pieces.resize(static_cast<std::size_t>(count));
  for (Offset piece = 0; piece < count; ++piece)
  {
    components.pieces[next[components.ofPiece[piece]]++] = piece;
  }
}

void sumComponent(const SurfaceMesh& mesh, const EmbeddedSurface& surface, const Diagram& diagram,
  Index component, Components& components)
{
  double mass = 0.0, area = 0.0, energy = 0.0;
  Point3 moment = Point3::Zero();
  Point3 middle = Point3::Zero(); // for components without mass
  for (Offset p = components.pieceBegin[component]; p < components.pieceBegin[component + 1]; ++p)
  {
    const Offset piece = components.pieces[p];
    const Index facet = diagram.facets[piece];
    const PieceIntegral& integral = diagram.integrals[piece];
    const FacetConstants& constants = surface.constants[facet];
    mass += integral.fraction * constants.mass;
    area += integral.fraction * constants.area;
    energy += integral.energy;
    for (int k = 0; k < 3; ++k)
    {
      const Point3& point = mesh.points[mesh.facetPoints[facet][k]];
      moment += (integral.weights[k] * constants.mass) * point;
      const double* b = diagram.vertices[diagram.vertexBegin[piece]].b;
      middle += b[k] * point;
    }
  }
  components.mass[component] = mass;
  components.area[component] = area;
  components.energy[component] = energy;
  const auto pieces =
    static_cast<double>(components.pieceBegin[component + 1] - components.pieceBegin[component]);
  components.centroids[component] = mass > 0.0 ? Point3(moment / mass) : Point3(middle / pieces);
}
}

Status findComponents(const SurfaceMesh& mesh, const EmbeddedSurface& surface,
  const EdgeTable& edges, const Diagram& diagram, const std::vector<Index>& owners,
  const RunControl& control, Components& components)
{
  components = Components{};
  DisjointSets sets(diagram.sites.size());
  joinAcrossEdges(edges, diagram, sets);
  joinAroundCorners(surface, diagram, owners, sets);
  numberComponents(diagram, sets, components);
  const auto count = static_cast<std::size_t>(components.count());
  components.mass.resize(count);
  components.area.resize(count);
  components.energy.resize(count);
  components.centroids.resize(count);
  const bool done = forEachRange(Blocks::cut(components.count(), 256, 4096), control,
    [&](Offset begin, Offset end)
    {
      for (Offset k = begin; k < end; ++k)
      {
        sumComponent(mesh, surface, diagram, static_cast<Index>(k), components);
      }
    });
  return done ? Status::success() : Status::cancelled();
}
}
