#include "Optimization/LocalRelaxation.h"

#include "Optimization/Lloyd.h"
#include "Voronoi/NeighborSearch.h"

#include <algorithm>

namespace remesh
{
namespace
{
constexpr Index moving = 24;   // sites nearest to a place that move, about two rings
constexpr Index covering = 60; // that see their part of the surface, about four rings

/** What sites around the places are there for; of the earlier ones. */
struct Neighborhood
{
  std::vector<char> moves;  ///< n
  std::vector<char> covers; ///< n
};

Neighborhood findNeighborhood(
  const EmbeddedSurface& surface, const Sites& sites, const std::vector<double>& places)
{
  const NeighborSearch search(sites);
  const auto count = static_cast<std::size_t>(sites.count());
  Neighborhood result{ std::vector<char>(count, 0), std::vector<char>(count, 0) };
  std::vector<char> isDone(count, 0);
  std::vector<Neighbor> found;
  for (std::size_t k = 0; k < places.size(); k += static_cast<std::size_t>(sites.dimension))
  {
    const Index nearest = search.nearest(&places[k]);
    if (isDone[nearest])
    {
      continue;
    }
    isDone[nearest] = 1;
    search.neighbors(nearest, covering, surface.patches.minDistance(), found);
    found.insert(found.begin(), { nearest, 0.0 });
    for (std::size_t n = 0; n < found.size(); ++n)
    {
      result.covers[found[n].site] = 1;
      result.moves[found[n].site] |= n <= moving;
    }
  }
  return result;
}

/** Lends the surface's own corners, which are centred and scaled. */
void lendScaled(
  const EmbeddedSurface& surface, const std::vector<Index>& corners, EmbeddedSurface& part)
{
  part.source.dimension = surface.dimension;
  part.source.lent = { { surface.corners.data(), nullptr, surface.dimension, 1.0 } };
  part.source.rows.assign(corners.begin(), corners.end());
  part.center.assign(static_cast<std::size_t>(surface.dimension), 0.0);
  part.unit = 1.0;
}

/** Lends some corners, or copies them where they have few coordinates. */
void giveCorners(
  const EmbeddedSurface& surface, const std::vector<Index>& corners, EmbeddedSurface& part)
{
  if (surface.source.isLent())
  {
    part.source = surface.source.of(corners);
    return;
  }
  if (surface.dimension >= manyDimensions)
  {
    lendScaled(surface, corners, part);
    return;
  }
  part.corners.reserve(corners.size() * static_cast<std::size_t>(surface.dimension));
  for (const Index corner : corners)
  {
    const double* row = surface.corner(corner);
    part.corners.insert(part.corners.end(), row, row + surface.dimension);
  }
}

/** Some facets as a surface of their own, in the same scaled units; it reads the surface's rows. */
EmbeddedSurface extractFacets(const EmbeddedSurface& surface, const std::vector<Index>& facets)
{
  EmbeddedSurface part;
  part.dimension = surface.dimension;
  part.patches = surface.patches;
  part.center = surface.center;
  part.unit = surface.unit;
  part.densityUnit = surface.densityUnit;
  std::vector<Index> ids(static_cast<std::size_t>(surface.numberOfCorners()), noIndex);
  std::vector<Index> corners;
  std::vector<Triple> facetCorners;
  for (const Index facet : facets)
  {
    Triple ends = surface.facetCorners[facet];
    for (Index& corner : ends)
    {
      if (ids[corner] == noIndex)
      {
        ids[corner] = static_cast<Index>(corners.size());
        corners.push_back(corner);
      }
      corner = ids[corner];
    }
    facetCorners.push_back(ends);
    part.constants.push_back(surface.constants[facet]);
    if (surface.hasDensity())
    {
      part.densities.push_back(surface.densities[facet]);
    }
    part.mass += part.constants.back().mass;
    part.siteMeasure += surface.siteMeasureOf(facet);
  }
  part.facetCorners = std::move(facetCorners);
  giveCorners(surface, corners, part);
  return part;
}

/** Those with a piece of one of these sites, ascending. */
std::vector<Index> facetsOf(const Diagram& diagram, const std::vector<char>& isOne)
{
  std::vector<Index> facets;
  for (Offset piece = 0; piece < diagram.numberOfPieces(); ++piece)
  {
    const Index facet = diagram.facets[piece];
    if (isOne[diagram.sites[piece]] && (facets.empty() || facets.back() != facet))
    {
      facets.push_back(facet);
    }
  }
  return facets;
}

/** The later sites that are seen on these facets: those that stay, and then those that move. */
struct SitesInPart
{
  std::vector<Index> ids; ///< later sites
  Index fixed = 0;
};

SitesInPart sitesOn(const std::vector<Index>& facets, const Diagram& diagram,
  const Neighborhood& around, const SiteChanges& changes, const Sites& later)
{
  SitesInPart result;
  std::vector<Index> movers;
  std::vector<char> seen(changes.later.size(), 0);
  for (const Index facet : facets)
  {
    for (Offset piece = diagram.facetBegin[facet]; piece < diagram.facetBegin[facet + 1]; ++piece)
    {
      const Index site = diagram.sites[piece];
      const Index id = changes.later[site];
      if (id != noIndex && !seen[site])
      {
        const bool moves = around.moves[site] && id >= later.fixed;
        (moves ? movers : result.ids).push_back(id);
      }
      seen[site] = 1;
    }
  }
  for (std::size_t site = 0; site < seen.size(); ++site) // those without a cell get one
  {
    const Index id = changes.later[site];
    if (around.covers[site] && !seen[site] && id != noIndex && id >= later.fixed)
    {
      movers.push_back(id);
    }
  }
  for (const Index id : changes.added)
  {
    (id >= later.fixed ? movers : result.ids).push_back(id);
  }
  result.fixed = static_cast<Index>(result.ids.size());
  result.ids.insert(result.ids.end(), movers.begin(), movers.end());
  return result;
}
}

Status relaxAround(const VertexPlaces& earlier, const SiteChanges& changes, const LloydSteps& steps,
  const RunControl& control, Sites& later)
{
  const Neighborhood around = findNeighborhood(earlier.surface, earlier.sites, changes.places);
  const std::vector<Index> facets = facetsOf(earlier.diagram, around.covers);
  const SitesInPart part = sitesOn(facets, earlier.diagram, around, changes, later);
  const EmbeddedSurface partOfSurface = extractFacets(earlier.surface, facets);
  Sites sites;
  sites.dimension = later.dimension;
  sites.fixed = part.fixed;
  for (const Index id : part.ids)
  {
    sites.coordinates.insert(
      sites.coordinates.end(), later.site(id), later.site(id) + later.dimension);
  }
  if (sites.fixed == sites.count())
  {
    return Status::success();
  }
  RestrictedVoronoi voronoi(partOfSurface);
  CellSums sums;
  Convergence apart; // not the optimisation's
  Index emptyCells = 0;
  Status status = relaxLloyd(
    { voronoi, partOfSurface, steps.seed, sites, sums, apart, emptyCells }, steps.number, control);
  for (Index k = sites.fixed; status.ok() && k < sites.count(); ++k)
  {
    std::copy_n(sites.site(k), sites.dimension, later.site(part.ids[k]));
  }
  return status;
}
}
