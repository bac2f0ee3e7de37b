#include "Delaunay/Components.h"

#include "Mesh/FacetGeometry.h"
#include "Support/DisjointSets.h"
#include "Support/Grouping.h"
#include "Voronoi/VertexPlaces.h"

#include <algorithm>

namespace remesh
{
namespace
{
/** Joins a piece to the others of its cell beyond the facet's edges, where they share a segment. */
void joinAcrossEdges(
  const EdgeTable& edges, const Diagram& diagram, Index piece, DisjointSets& sets)
{
  const Index facet = diagram.facets[piece];
  for (Offset v = diagram.vertexBegin[piece]; v < diagram.vertexBegin[piece + 1]; ++v)
  {
    const Index across = diagram.across[v];
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
        sets.unite(piece, static_cast<Index>(other));
      }
    }
  }
}

/**
 * Joins the pieces around each corner: all belong to the cell that owns it. Each is joined to the
 * first that was met there, whichever that is.
 */
bool joinAroundCorners(const EmbeddedSurface& surface, const Diagram& diagram,
  const std::vector<Index>& owners, const RunControl& control, DisjointSets& sets)
{
  std::vector<std::atomic<Index>> metPieces(owners.size());
  return forEachItem(static_cast<Offset>(owners.size()), control,
           [&](Offset corner) { metPieces[corner].store(noIndex, std::memory_order_relaxed); }) &&
    forEachItem(surface.numberOfFacets(), control,
      [&](Offset f)
      {
        const auto facet = static_cast<Index>(f);
        for (const Index corner : surface.facetCorners[facet])
        {
          const auto piece = static_cast<Index>(diagram.pieceOf(facet, owners[corner]));
          Index met = noIndex;
          if (piece >= 0 && !metPieces[corner].compare_exchange_strong(met, piece))
          {
            sets.unite(met, piece);
          }
        }
      });
}

/** Joins the pieces of all copies of a feature's site at its place. */
void joinCopies(const Diagram& diagram, const FeatureSites& features, DisjointSets& sets)
{
  for (std::size_t p = 0; p < features.points.size(); ++p)
  {
    Offset first = -1;
    for (Offset s = features.seatBegin[p]; s < features.seatBegin[p + 1]; ++s)
    {
      const Offset piece = diagram.pieceOf(features.seats[s].facet, features.seats[s].site);
      if (first >= 0 && piece >= 0)
      {
        sets.unite(static_cast<Index>(first), static_cast<Index>(piece));
      }
      first = first < 0 ? piece : first;
    }
  }
}

/** Feature points stay where they are. */
void placeFeaturePoints(
  const Diagram& diagram, const FeatureSites& features, Components& components)
{
  for (std::size_t p = 0; p < features.points.size(); ++p)
  {
    for (Offset s = features.seatBegin[p]; s < features.seatBegin[p + 1]; ++s)
    {
      const Offset piece = diagram.pieceOf(features.seats[s].facet, features.seats[s].site);
      if (piece >= 0)
      {
        components.centroids[components.ofPiece[piece]] = features.points[p].place;
      }
    }
  }
}

/** Numbers the sets by site and first piece: sites, ranks, and the component of each first piece.
 */
bool numberComponents(const Diagram& diagram, const FeatureSites* features,
  const DisjointSets& sets, const RunControl& control, Components& components)
{
  const auto siteOf = [&](Offset piece)
  { return features ? features->mergedSite(diagram.sites[piece]) : diagram.sites[piece]; };
  std::vector<Index> roots;
  Groups ofSites; // by site, into `roots`
  const Index sites =
    diagram.sites.empty() ? 0 : 1 + *std::max_element(diagram.sites.begin(), diagram.sites.end());
  if (!packItems(
        diagram.numberOfPieces(), control,
        [&](Offset piece) { return sets.isLowest(static_cast<Index>(piece)); },
        [&](Offset count) { roots.resize(static_cast<std::size_t>(count)); },
        [&](Offset piece, Offset number) { roots[number] = static_cast<Index>(piece); }) ||
    !groupByKey(
      static_cast<Offset>(roots.size()), sites, control,
      [&](Offset root) { return siteOf(roots[root]); }, ofSites))
  {
    return false;
  }
  components.ofPiece.resize(diagram.sites.size());
  components.sites.resize(roots.size());
  components.ranks.resize(roots.size());
  return forEachItem(sites, control,
    [&](Offset site)
    {
      for (Offset k = ofSites.begins[site]; k < ofSites.begins[site + 1]; ++k)
      {
        components.sites[k] = static_cast<Index>(site);
        components.ranks[k] = static_cast<Index>(k - ofSites.begins[site]);
        components.ofPiece[roots[ofSites.items[k]]] = static_cast<Index>(k);
      }
    });
}

/** Tells each piece its component, and lists the pieces of each. */
bool listPieces(
  const Diagram& diagram, DisjointSets& sets, const RunControl& control, Components& components)
{
  Groups pieces;
  const bool done = forEachItem(diagram.numberOfPieces(), control,
                      [&](Offset piece)
                      {
                        const Index root = sets.find(static_cast<Index>(piece));
                        if (root != piece) // whose component is known
                        {
                          components.ofPiece[piece] = components.ofPiece[root];
                        }
                      }) &&
    groupByKey(
      diagram.numberOfPieces(), components.count(), control,
      [&](Offset piece) { return components.ofPiece[piece]; }, pieces);
  components.pieceBegin = std::move(pieces.begins);
  components.pieces = std::move(pieces.items);
  return done;
}

/** The mean of one vertex of each piece, for a component without mass. */
Point3 middleOf(const SurfaceMesh& mesh, const VertexPlaces& places, Index component,
  const Components& components)
{
  const Offset begin = components.pieceBegin[component];
  const Offset end = components.pieceBegin[component + 1];
  Point3 middle = Point3::Zero();
  for (Offset p = begin; p < end; ++p)
  {
    const Index piece = components.pieces[p];
    const Triple& points = mesh.facetPoints[places.diagram.facets[piece]];
    const auto b = places.at(piece, places.diagram.vertexBegin[piece]);
    for (int k = 0; k < 3; ++k)
    {
      middle += b[k] * mesh.points[points[k]];
    }
  }
  return middle / static_cast<double>(end - begin);
}

void sumComponent(
  const SurfaceMesh& mesh, const VertexPlaces& places, Index component, Components& components)
{
  const Diagram& diagram = places.diagram;
  double mass = 0.0, area = 0.0, energy = 0.0;
  Point3 moment = Point3::Zero();
  for (Offset p = components.pieceBegin[component]; p < components.pieceBegin[component + 1]; ++p)
  {
    const Offset piece = components.pieces[p];
    const Index facet = diagram.facets[piece];
    const PieceWeights& part = diagram.weights[piece];
    const FacetConstants& constants = places.surface.constants[facet];
    mass += part.fraction() * constants.mass;
    area += part.fraction() * facetArea(mesh, facet);
    energy += diagram.energies[piece];
    for (int k = 0; k < 3; ++k)
    {
      const Point3& point = mesh.points[mesh.facetPoints[facet][k]];
      moment += (part.weights[k] * constants.mass) * point;
    }
  }
  components.mass[component] = mass;
  components.area[component] = area;
  components.energy[component] = energy;
  components.centroids[component] =
    mass > 0.0 ? Point3(moment / mass) : middleOf(mesh, places, component, components);
}
}

Status findComponents(
  const JoinedDiagram& joined, const RunControl& control, Components& components)
{
  components = Components{};
  const Diagram& diagram = joined.places.diagram;
  const FeatureSites* features = joined.features;
  const RunControl silent = control.silent();
  DisjointSets sets(diagram.sites.size());
  if (!forEachItem(diagram.numberOfPieces(), silent,
        [&](Offset piece)
        { joinAcrossEdges(joined.edges, diagram, static_cast<Index>(piece), sets); }) ||
    !joinAroundCorners(joined.places.surface, diagram, joined.owners, silent, sets))
  {
    return Status::cancelled();
  }
  if (features)
  {
    joinCopies(diagram, *features, sets);
  }
  if (!numberComponents(diagram, features, sets, silent, components) ||
    !listPieces(diagram, sets, silent, components))
  {
    return Status::cancelled();
  }
  const auto count = static_cast<std::size_t>(components.count());
  components.mass.resize(count);
  components.area.resize(count);
  components.energy.resize(count);
  components.centroids.resize(count);
  const bool done = forEachItem(Blocks::cut(components.count(), 256, 4096), control,
    [&](Offset k) { sumComponent(joined.mesh, joined.places, static_cast<Index>(k), components); });
  if (features)
  {
    placeFeaturePoints(diagram, *features, components);
  }
  return done ? Status::success() : Status::cancelled();
}

std::vector<Index> componentsAt(
  const JoinedDiagram& joined, const std::vector<Index>& points, const Components& components)
{
  const SurfaceMesh& mesh = joined.mesh;
  std::vector<Index> found(points.size(), noIndex);
  for (Index f = 0; f < mesh.numberOfFacets() && !points.empty(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index point = mesh.facetPoints[f][k];
      const auto at = std::lower_bound(points.begin(), points.end(), point) - points.begin();
      if (at < static_cast<std::ptrdiff_t>(points.size()) && points[at] == point &&
        found[at] == noIndex)
      {
        const Offset piece =
          joined.places.diagram.pieceOf(f, joined.owners[mesh.facetCorners[f][k]]);
        found[at] = piece >= 0 ? components.ofPiece[piece] : noIndex;
      }
    }
  }
  return found;
}

std::vector<double> measureCellAreas(
  const SurfaceMesh& mesh, const Diagram& diagram, Index numberOfSites)
{
  std::vector<double> areas(static_cast<std::size_t>(numberOfSites), 0.0);
  for (Index facet = 0; facet < mesh.numberOfFacets(); ++facet)
  {
    const double area = facetArea(mesh, facet);
    for (Offset p = diagram.facetBegin[facet]; p < diagram.facetBegin[facet + 1]; ++p)
    {
      areas[diagram.sites[p]] += diagram.weights[p].fraction() * area;
    }
  }
  return areas;
}
}
