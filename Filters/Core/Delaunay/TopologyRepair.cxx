#include "Delaunay/TopologyRepair.h"

#include "Delaunay/ThinTips.h"
#include "Embedding/CornerReader.h"
#include "Embedding/Distance.h"
#include "Support/SortUnique.h"

#include <algorithm>
#include <initializer_list>
#include <numeric>
#include <utility>

namespace remesh
{
namespace
{
/** Keeps the farthest of the vertices it is shown from their sites, in R^d. */
class FarthestVertex
{
public:
  explicit FarthestVertex(const VertexPlaces& places)
    : m_places(places)
    , m_reader(places.surface)
    , m_point(static_cast<std::size_t>(places.surface.dimension))
    , m_farthest(m_point.size())
  {
  }

  void begin() { m_largest = -1.0; }
  bool found() const { return m_largest >= 0.0; }
  const std::vector<double>& place() const { return m_farthest; }
  /** The piece that was shown with it, and its place there. */
  std::pair<Offset, Offset> vertex() const { return m_vertex; }

  void show(Offset piece, Offset vertex)
  {
    const int d = m_places.surface.dimension;
    const auto corners = m_reader.facet(m_places.diagram.facets[piece]);
    const std::array<double, 3> b = m_places.at(piece, vertex);
    for (int k = 0; k < d; ++k)
    {
      m_point[k] = b[0] * corners[0][k] + b[1] * corners[1][k] + b[2] * corners[2][k];
    }
    const double* site = m_places.sites.site(m_places.diagram.sites[piece]);
    const double squared = squaredDistance<Eigen::Dynamic>(m_point.data(), site, d);
    if (squared > m_largest)
    {
      m_largest = squared;
      m_farthest = m_point;
      m_vertex = { piece, vertex };
    }
  }

private:
  const VertexPlaces& m_places;
  CornerReader<Eigen::Dynamic> m_reader;
  std::vector<double> m_point;
  std::vector<double> m_farthest;
  std::pair<Offset, Offset> m_vertex;
  double m_largest = -1.0;
};

/** The component beyond a side of a piece, or noIndex on an edge of its facet. */
Index componentBeyond(
  const Diagram& diagram, const Components& components, Offset piece, Index across)
{
  return across < 0 ? noIndex : components.ofPiece[diagram.pieceOf(diagram.facets[piece], across)];
}

/** The vertices of a component's pieces whose sides are towards `wanted(before, after)`. */
template <class Wanted>
void showVertices(const Diagram& diagram, const Components& components, Index component,
  FarthestVertex& farthest, const Wanted& wanted)
{
  const auto beyond = [&](Offset piece, Index across)
  { return componentBeyond(diagram, components, piece, across); };
  farthest.begin();
  for (Offset p = components.pieceBegin[component]; p < components.pieceBegin[component + 1]; ++p)
  {
    const Offset piece = components.pieces[p];
    for (Offset v = diagram.vertexBegin[piece]; v < diagram.vertexBegin[piece + 1]; ++v)
    {
      if (wanted(beyond(piece, diagram.acrossIncoming(piece, v)), beyond(piece, diagram.across[v])))
      {
        farthest.show(piece, v);
      }
    }
  }
}

/** Adds a site at the farthest vertex shown, unless there is one. */
bool addSite(const Diagram& diagram, const Components& components, const FarthestVertex& farthest,
  Refinement& refinement)
{
  if (!farthest.found())
  {
    return false;
  }
  const auto [piece, vertex] = farthest.vertex();
  Triple meeting{ components.ofPiece[piece],
    componentBeyond(diagram, components, piece, diagram.across[vertex]),
    componentBeyond(diagram, components, piece, diagram.acrossIncoming(piece, vertex)) };
  std::sort(meeting.begin(), meeting.end());
  const bool isNew = refinement.meetings.insert(meeting).second;
  if (isNew)
  {
    refinement.added.insert(
      refinement.added.end(), farthest.place().begin(), farthest.place().end());
  }
  return isNew;
}

std::vector<Index> countUses(const Dual& dual, Index numberOfVertices)
{
  std::vector<Index> uses(static_cast<std::size_t>(numberOfVertices), 0);
  for (const Triple& triangle : dual.triangles)
  {
    for (const Index vertex : triangle)
    {
      ++uses[vertex];
    }
  }
  return uses;
}

/** Finds sites for failures, one for each of the cells around at most. */
class TopologyRefiner
{
public:
  /** @param cutTips whether cells at tips go instead. All must outlive it. */
  TopologyRefiner(const DiagramDual& diagram, bool cutTips)
    : m_places(diagram.places)
    , m_components(diagram.components)
    , m_cutTips(cutTips)
    , m_uses(countUses(diagram.dual, m_components.count()))
    , m_taken(static_cast<std::size_t>(m_components.count()), 0)
    , m_farthest(m_places)
    , m_thinTips(m_places, m_components)
  {
  }

  /** Where three cells meet in several vertices: in the one with the fewest triangles. */
  void refineVertex(const Triple& cells)
  {
    const auto& [a, b, c] = cells;
    if (!this->takes({ a, b, c }))
    {
      return;
    }
    const Index least = this->lessUsed(this->lessUsed(a, b), c);
    if (this->isTip(least, 1))
    {
      m_refinement.removed.push_back(m_components.sites[least]);
      return;
    }
    const std::vector<double> place = m_uses[least] <= 1
      ? m_thinTips.placeBetween(least, a == least ? b : a, c == least ? b : c)
      : std::vector<double>();
    m_refinement.added.insert(m_refinement.added.end(), place.begin(), place.end());
    if (place.empty())
    {
      this->refine(least, noIndex);
    }
    else
    {
      m_refinement.meetings.insert({ a, b, c }); // left without a site of its own
    }
  }

  /**
   * Takes away a cell without triangles, and those around the cone below it, but for the last: it
   * has triangles, and comes to cover the apex.
   */
  void bareApex(Index cell)
  {
    for (Index above = noIndex; cell != noIndex && this->isFree(cell) && m_uses[cell] == 0;)
    {
      const Index below = this->onlyNeighbor(cell, above);
      if (below == noIndex || !this->takes({ cell }))
      {
        break;
      }
      m_refinement.removed.push_back(m_components.sites[cell]);
      above = std::exchange(cell, below);
      if (m_uses[cell] != 0)
      {
        m_taken[cell] = 1;
        m_refinement.closed.push_back(cell);
      }
    }
  }

  void refineCell(Index cell)
  {
    if (!this->takes({ cell }))
    {
      return;
    }
    if (this->isTip(cell, 0))
    {
      m_refinement.removed.push_back(m_components.sites[cell]);
    }
    else
    {
      this->refine(cell, noIndex);
    }
  }

  void refineEdge(Index cell, Index neighbor)
  {
    if (this->takes({ cell, neighbor }))
    {
      this->refine(cell, neighbor);
    }
  }

  Refinement take()
  {
    sortUnique(m_refinement.removed);
    return std::move(m_refinement);
  }

private:
  /** Whether none of the cells has been taken; they are then. */
  bool takes(std::initializer_list<Index> cells)
  {
    const bool areFree =
      std::none_of(cells.begin(), cells.end(), [&](Index cell) { return m_taken[cell] != 0; });
    if (areFree)
    {
      std::for_each(cells.begin(), cells.end(), [&](Index cell) { m_taken[cell] = 1; });
    }
    return areFree;
  }

  Index lessUsed(Index a, Index b) const { return m_uses[b] < m_uses[a] ? b : a; }

  /** A cell of a repeated triangle and no other has two neighbours, one of none has one. */
  bool isTip(Index cell, Index maxUses) const
  {
    return m_cutTips && m_uses[cell] <= maxUses && this->isFree(cell);
  }

  bool isFree(Index cell) const { return m_components.sites[cell] >= m_places.sites.fixed; }

  /** The one cell next to another but for that above it; noIndex if there is none or several. */
  Index onlyNeighbor(Index cell, Index above) const
  {
    const Diagram& diagram = m_places.diagram;
    Index found = noIndex;
    for (Offset p = m_components.pieceBegin[cell]; p < m_components.pieceBegin[cell + 1]; ++p)
    {
      const Offset piece = m_components.pieces[p];
      for (Offset v = diagram.vertexBegin[piece]; v < diagram.vertexBegin[piece + 1]; ++v)
      {
        const Index beyond = componentBeyond(diagram, m_components, piece, diagram.across[v]);
        if (beyond == noIndex || beyond == above || beyond == found)
        {
          continue;
        }
        if (found != noIndex)
        {
          return noIndex;
        }
        found = beyond;
      }
    }
    return found;
  }

  void refine(Index cell, Index neighbor)
  {
    showVertices(m_places.diagram, m_components, cell, m_farthest,
      [&](Index before, Index after)
      { return neighbor == noIndex || before == neighbor || after == neighbor; });
    addSite(m_places.diagram, m_components, m_farthest, m_refinement);
  }

  const VertexPlaces& m_places;
  const Components& m_components;
  bool m_cutTips;
  std::vector<Index> m_uses; ///< triangles of each component
  std::vector<char> m_taken;
  FarthestVertex m_farthest;
  ThinTips m_thinTips;
  Refinement m_refinement;
};
}

Refinement refineTopology(const DiagramDual& diagram, const Certificate& certificate, bool cutTips)
{
  TopologyRefiner refiner(diagram, cutTips);
  for (const Index cell : diagram.components.apexes)
  {
    refiner.bareApex(cell);
  }
  for (const Triple& vertex : certificate.vertices)
  {
    refiner.refineVertex(vertex);
  }
  for (const Index cell : certificate.cells)
  {
    refiner.refineCell(cell);
  }
  for (const auto& [a, b] : certificate.edges)
  {
    refiner.refineEdge(a, b);
  }
  return refiner.take();
}

Refinement refineTriangles(const DiagramDual& diagram, const std::vector<Index>& triangles)
{
  const auto& [places, components, dual] = diagram;
  Refinement refinement;
  std::vector<char> taken(static_cast<std::size_t>(components.count()), 0);
  FarthestVertex farthest(places);
  for (const Index t : triangles)
  {
    const auto& [a, b, c] = dual.triangles[t];
    if (taken[a] || taken[b] || taken[c])
    {
      continue;
    }
    showVertices(places.diagram, components, a, farthest,
      [b = b, c = c](Index before, Index after)
      { return (after == b && before == c) || (after == c && before == b); });
    if (addSite(places.diagram, components, farthest, refinement))
    {
      taken[a] = taken[b] = taken[c] = 1;
    }
  }
  return refinement;
}

void addWhereEnergyIs(
  const VertexPlaces& places, const Components& components, Offset count, Refinement& refinement)
{
  std::vector<Index> byEnergy(static_cast<std::size_t>(components.count()));
  std::iota(byEnergy.begin(), byEnergy.end(), Index(0));
  std::stable_sort(byEnergy.begin(), byEnergy.end(),
    [&](Index a, Index b) { return components.energy[a] > components.energy[b]; });
  std::vector<char> isClosed(byEnergy.size(), 0);
  const auto close = [&](Index cell)
  {
    if (cell != noIndex)
    {
      isClosed[cell] = 1;
    }
  };
  std::for_each(components.apexes.begin(), components.apexes.end(), close);
  std::for_each(refinement.closed.begin(), refinement.closed.end(), close);
  FarthestVertex farthest(places);
  for (std::size_t k = 0; k < byEnergy.size() && count > 0; ++k)
  {
    if (isClosed[byEnergy[k]])
    {
      continue;
    }
    showVertices(
      places.diagram, components, byEnergy[k], farthest, [](Index, Index) { return true; });
    count -= addSite(places.diagram, components, farthest, refinement) ? 1 : 0;
  }
}
}
