#include "Voronoi/FacetDecomposition.h"

#include "Embedding/Distance.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
/** More candidates than this, and clipping all against all costs more than walking the lists. */
constexpr int maxCandidates = 32;
}

template <int D>
FacetDecomposition<D>::FacetDecomposition(const EmbeddedSurface& surface, const Sites& sites,
  const NeighborLists& lists, const std::vector<Index>& owners, Decisions decisions)
  : m_surface(surface)
  , m_sites(sites)
  , m_lists(lists)
  , m_owners(owners)
  , m_corners(surface)
  , m_security(surface.dimension)
  , m_tiling(decisions)
  , m_slotOfSite(static_cast<std::size_t>(sites.count()))
  , m_cutOfSlot(static_cast<std::size_t>(sites.count()), 0)
  , m_center(static_cast<std::size_t>(surface.dimension))
  , m_vertex(static_cast<std::size_t>(surface.dimension))
{
}

template <int D>
FacetSite FacetDecomposition<D>::see(Index site) const
{
  FacetSite seen;
  seen.id = site;
  const double* x = m_sites.site(site);
  for (int k = 0; k < 3; ++k)
  {
    seen.h[k] = squaredDistance<D>(x, m_points[k], m_surface.dimension);
  }
  return seen;
}

template <int D>
int FacetDecomposition<D>::slotOf(Index site)
{
  return m_cutOfSlot[site] == m_cut ? m_slotOfSite[site] : this->addSlot(this->see(site));
}

template <int D>
int FacetDecomposition<D>::addSlot(const FacetSite& seen)
{
  m_cutOfSlot[seen.id] = m_cut;
  m_slotOfSite[seen.id] = m_tiling.addSite(seen);
  m_queued.push_back(0);
  return m_slotOfSite[seen.id];
}

template <int D>
bool FacetDecomposition<D>::addCandidate(Index site)
{
  if (m_cutOfSlot[site] == m_cut)
  {
    return true; // an owner
  }
  const FacetSite seen = this->see(site);
  for (std::size_t owner = 0; owner < m_used; ++owner)
  {
    if (!beatsSomewhere(seen, m_tiling.site(static_cast<int>(owner))))
    {
      return true; // wins nothing here
    }
  }
  this->addSlot(seen);
  return m_tiling.numberOfSites() <= maxCandidates;
}

template <int D>
void FacetDecomposition<D>::enqueue(int slot)
{
  if (m_queued[slot])
  {
    return;
  }
  m_queued[slot] = 1;
  if (m_used == m_pieces.size())
  {
    m_pieces.emplace_back();
  }
  m_pieces[m_used++].slot = slot;
}

template <int D>
bool FacetDecomposition<D>::gatherCandidates(Index facet)
{
  const int d = m_surface.dimension;
  findCenter(m_points, m_center);
  Index owner = noIndex;
  double nearest = 0.0;
  for (const Index corner : m_surface.facetCorners[facet])
  {
    const Index site = m_owners[corner];
    const double distance = std::sqrt(squaredDistance<D>(m_sites.site(site), m_center.data(), d));
    if (owner == noIndex || distance < nearest)
    {
      owner = site;
      nearest = distance;
    }
  }
  const double bound = (nearest + 2.0 * m_surface.constants[facet].radius()) * aboveRounding;
  double farthest = 0.0;
  const bool complete = m_lists.holds(owner, (nearest + bound) * aboveRounding, farthest);
  const NeighborList list = m_lists.list(owner);
  const double bound2 = bound * bound;
  for (Index k = 0; k < list.count && list.distances[k] <= farthest; ++k)
  {
    const Index site = list.sites[k];
    if (squaredDistance<D>(m_sites.site(site), m_center.data(), d) <= bound2 &&
      !this->addCandidate(site))
    {
      return false;
    }
  }
  return complete;
}

template <int D>
void FacetDecomposition<D>::clipWithCandidates(FacetPiece& piece)
{
  for (int q = 0; q < m_tiling.numberOfSites() && !piece.polygon.empty(); ++q)
  {
    if (q != piece.slot)
    {
      m_tiling.clip(piece.polygon, piece.slot, q);
    }
  }
}

template <int D>
void FacetDecomposition<D>::clipWithNeighbors(FacetPiece& piece)
{
  const FacetSite site = m_tiling.site(piece.slot);
  const double reach2 = std::max({ site.h[0], site.h[1], site.h[2] });
  const double reach = std::sqrt(reach2);
  const auto radiusNow = [&]()
  { return m_security.roundUp(m_tiling.squaredRadius(piece.polygon, piece.slot), reach2); };
  double radius = radiusNow();
  NeighborWalk walk(m_lists, m_longer, site.id);
  const auto excludes = [&](double least)
  { return m_security.excludes(least, radius, reach) || piece.polygon.empty(); };
  int steps = 0;
  while (walk.next(excludes))
  {
    if (++steps > longestWalk)
    {
      this->clipAroundVertices(piece);
      return;
    }
    if (m_tiling.clip(piece.polygon, piece.slot, this->slotOf(walk.site())))
    {
      radius = radiusNow();
    }
  }
}

/** Clips until no site can win a vertex of what is left. */
template <int D>
void FacetDecomposition<D>::clipAroundVertices(FacetPiece& piece)
{
  for (std::size_t v = 0; v < piece.polygon.size();)
  {
    v = this->clipAround(piece.polygon[v], piece) ? 0 : v + 1;
  }
}

/** Whether the sites that may win this vertex of the piece have taken a part of it. */
template <int D>
bool FacetDecomposition<D>::clipAround(PieceVertex vertex, FacetPiece& piece)
{
  for (std::size_t k = 0; k < m_vertex.size(); ++k)
  {
    m_vertex[k] =
      vertex.b[0] * m_points[0][k] + vertex.b[1] * m_points[1][k] + vertex.b[2] * m_points[2][k];
  }
  const Index own = m_tiling.site(piece.slot).id;
  const auto clip = [&](Index site)
  { return site != own && m_tiling.clip(piece.polygon, piece.slot, this->slotOf(site)); };
  if (clip(m_lists.search().nearest(m_vertex.data()))) // else there may be many that are nearer
  {
    return true;
  }
  const double distance =
    std::sqrt(squaredDistance<D>(m_sites.site(own), m_vertex.data(), m_surface.dimension));
  m_lists.sitesNear(m_vertex.data(), aboveRounding * distance, m_near);
  bool taken = false;
  for (const Neighbor& neighbor : m_near)
  {
    taken = clip(neighbor.site) || taken;
  }
  return taken;
}

template <int D>
void FacetDecomposition<D>::gather(Index facet)
{
  m_tiling.begin(m_surface.facetCorners[facet], m_surface.constants[facet]);
  m_points = m_corners.facet(facet);
  ++m_cut;
  m_queued.clear();
  m_used = 0;
  for (const Index corner : m_surface.facetCorners[facet])
  {
    this->enqueue(this->slotOf(m_owners[corner]));
  }
  m_complete = m_used == 1 || this->gatherCandidates(facet);
}

template <int D>
void FacetDecomposition<D>::tile()
{
  for (std::size_t next = 0; next < m_used; ++next)
  {
    FacetPiece& piece = m_pieces[next];
    m_tiling.wholeFacet(piece.polygon);
    if (m_complete)
    {
      if (m_used > 1)
      {
        this->clipWithCandidates(piece);
      }
    }
    else
    {
      this->clipWithNeighbors(piece);
    }
    // `piece` may move when the queue grows.
    for (std::size_t v = 0; v < m_pieces[next].polygon.size(); ++v)
    {
      const int across = m_pieces[next].polygon[v].edge;
      if (across >= 0)
      {
        this->enqueue(across);
      }
    }
  }
  std::sort(m_pieces.begin(), m_pieces.begin() + static_cast<std::ptrdiff_t>(m_used),
    [this](const FacetPiece& a, const FacetPiece& b)
    { return m_tiling.site(a.slot).id < m_tiling.site(b.slot).id; });
}

template <int D>
void FacetDecomposition<D>::fixFirstVertices()
{
  const auto beyond = [this](const PieceVertex& vertex)
  { return vertex.edge < 0 ? vertex.edge : m_tiling.site(vertex.edge).id; };
  for (std::size_t k = 0; k < m_used; ++k)
  {
    Polygon& polygon = m_pieces[k].polygon;
    const auto first = std::max_element(polygon.begin(), polygon.end(),
      [&](const PieceVertex& a, const PieceVertex& b) { return beyond(a) < beyond(b); });
    std::rotate(polygon.begin(), first, polygon.end());
  }
}

template class FacetDecomposition<3>;
template class FacetDecomposition<6>;
template class FacetDecomposition<Eigen::Dynamic>;
}
