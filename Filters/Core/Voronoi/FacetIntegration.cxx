#include "Voronoi/FacetIntegration.h"

#include "Embedding/Distance.h"
#include "Support/Lanes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace remesh
{
namespace
{
constexpr int maxRounds = 8;
/** Among more, borders far from the reference would be rounded too much, and few would win. */
constexpr std::size_t maxNearby = 256;
}

template <int D>
FacetIntegration<D>::FacetIntegration(const EmbeddedSurface& surface, const Sites& sites,
  const NeighborLists& lists, const std::vector<Index>& owners, std::vector<Index>& centers,
  InstructionSet instructions)
  : m_surface(surface)
  , m_sites(sites)
  , m_lists(lists)
  , m_owners(owners)
  , m_centers(centers)
  , m_evaluate(bisectorEvaluation(instructions))
  , m_trace(envelopeTracing(instructions))
  , m_packs(sites, lists, instructions)
  , m_stride(m_packs.stride())
  , m_values(3 * static_cast<std::size_t>(m_stride))
  , m_chosen(static_cast<std::size_t>(m_stride / lanes))
  , m_facetOfSite(static_cast<std::size_t>(sites.count()), noIndex)
{
  for (View& view : m_views)
  {
    view.points.resize(3 * static_cast<std::size_t>(surface.dimension));
  }
  m_cellView.points.resize(3 * static_cast<std::size_t>(surface.dimension));
}

template <int D>
typename FacetIntegration<D>::Owners FacetIntegration<D>::distinctOwners(
  const Triple& corners) const
{
  const Index all[3] = { m_owners[corners[0]], m_owners[corners[1]], m_owners[corners[2]] };
  for (int k = 0; k < 3; ++k)
  {
    const Index shared = all[(k + 1) % 3];
    if (shared == all[(k + 2) % 3])
    {
      return { shared == all[k] ? 1 : 2, { shared, all[k], noIndex } };
    }
  }
  return { 3, { all[0], all[1], all[2] } };
}

/** Of the owners, the one likely to see the facet best. */
template <int D>
Index FacetIntegration<D>::bestOwner(const Triple& corners, const Owners& owners) const
{
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < owners.count && owners.count == 3; ++k)
  {
    const double squared = squaredDistance<D>(
      m_sites.site(owners.sites[k]), m_surface.corner(corners[k]), m_surface.dimension);
    if (squared < least)
    {
      best = k;
      least = squared;
    }
  }
  return owners.sites[best];
}

template <int D>
void FacetIntegration<D>::look(Index site, const Triple& corners, View& view) const
{
  using Coordinates = Eigen::Array<double, D, 1>;
  using Row = Eigen::Map<const Coordinates>;
  view.site = site;
  const int d = D == Eigen::Dynamic ? m_surface.dimension : D;
  const Row x(m_sites.site(site), d);
  for (int k = 0; k < 3; ++k)
  {
    Eigen::Map<Coordinates> seen(view.points.data() + k * d, d);
    seen = Row(m_surface.corner(corners[k]), d) - x;
    view.squared[k] = seen.matrix().squaredNorm();
    view.values[k] = view.squared[k] - m_views[0].squared[k];
  }
}

template <int D>
void FacetIntegration<D>::addSite(Index site, const double values[3])
{
  m_ids[m_envelope.count] = site;
  m_envelope.add(values);
}

/**
 * Adds the neighbours of a site, as far as `farthest`, that are below each of the owners looked at
 * somewhere, and accepted by `accept(site, values)`. False if there are too many.
 */
template <int D>
template <class Accept>
bool FacetIntegration<D>::addNeighbors(const View& view, double farthest, const Accept& accept)
{
  const NeighborList list = m_lists.list(view.site);
  // In whole lanes: those that are farther away are below at no corner.
  Index count = 0;
  while (count < list.count && list.distances[count] <= farthest)
  {
    count += lanes;
  }
  double limits[maxViews][3];
  for (int w = 0; w < m_numberOfViews; ++w)
  {
    for (int k = 0; k < 3; ++k)
    {
      limits[w][k] = m_views[w].values[k] - view.values[k];
    }
  }
  m_evaluate({ m_packs.of(view.site, count), m_stride, count, view.points.data(),
    m_surface.dimension, limits, m_numberOfViews, m_values.data(), m_chosen.data() });
  for (int first = 0; first < count; first += lanes)
  {
    for (unsigned bits = m_chosen[first / lanes]; bits != 0; bits &= bits - 1)
    {
      const int lane = first + __builtin_ctz(bits);
      const double values[3] = { m_values[lane] + view.values[0],
        m_values[m_stride + lane] + view.values[1],
        m_values[2 * m_stride + lane] + view.values[2] };
      if (accept(list.sites[lane], values))
      {
        if (m_envelope.count == Envelope::maxSites)
        {
          return false;
        }
        this->addSite(list.sites[lane], values);
      }
    }
  }
  return true;
}

/** Whether the site's list holds all sites that may win on the facet: those up to `farthest`. */
template <int D>
bool FacetIntegration<D>::seesAll(const View& view, double& farthest) const
{
  const double radius = std::sqrt(std::max({ view.squared[0], view.squared[1], view.squared[2] }));
  return m_lists.holds(view.site, 2.0 * radius * aboveRounding, farthest);
}

/** Whether a facet's centre has leapt away from it: no site that wins there is in its list. */
template <int D>
bool FacetIntegration<D>::isAway(const View& view) const
{
  const double nearest = std::min({ view.squared[0], view.squared[1], view.squared[2] });
  return std::sqrt(nearest) > std::max(0.0, m_lists.reach(view.site));
}

/** Makes this site the reference, and the only one so far. */
template <int D>
void FacetIntegration<D>::lookFrom(Index site, const Triple& corners)
{
  View& reference = m_views[0];
  this->look(site, corners, reference);
  std::fill_n(reference.values, 3, 0.0);
  m_numberOfViews = 1;
  m_envelope.clear();
  this->addSite(site, reference.values);
}

template <int D>
bool FacetIntegration<D>::integrate(Index facet)
{
  if (D == Eigen::Dynamic && m_surface.dimension > BisectorPacks::maxDimensions)
  {
    return false;
  }
  const Triple& corners = m_surface.facetCorners[facet];
  const Owners owners = this->distinctOwners(corners);
  Index& center = m_centers[facet];
  if (center != noIndex)
  {
    this->lookFrom(center, corners);
    if (!this->isAway(m_views[0]))
    {
      return this->integrateLarge(facet, owners);
    }
    center = noIndex;
  }
  this->lookFrom(this->bestOwner(corners, owners), corners);
  double farthest = 0.0;
  if (this->seesAll(m_views[0], farthest))
  {
    return this->addNeighbors(m_views[0], farthest, [](Index, const double*) { return true; }) &&
      m_trace(m_envelope);
  }
  return this->integrateLarge(facet, owners);
}

/** Adds the owners beside the reference; returns what the best one (see bestOwner) sees. */
template <int D>
const typename FacetIntegration<D>::View& FacetIntegration<D>::addOwners(
  Index facet, const Owners& owners)
{
  const View* best = nullptr;
  int bestCorner = 0;
  for (int w = 0; w < owners.count; ++w)
  {
    const View* owner = &m_views[0];
    if (owners.sites[w] != owner->site)
    {
      View& view = m_views[m_numberOfViews++];
      this->look(owners.sites[w], m_surface.facetCorners[facet], view);
      this->addSite(view.site, view.values);
      m_facetOfSite[view.site] = facet;
      owner = &view;
    }
    if (!best || (owners.count == 3 && owner->squared[w] < best->squared[bestCorner]))
    {
      best = owner;
      bestCorner = w;
    }
  }
  return *best;
}

template <int D>
bool FacetIntegration<D>::integrateLarge(Index facet, const Owners& owners)
{
  const View& reference = m_views[0];
  m_facetOfSite[reference.site] = facet;
  const View& best = this->addOwners(facet, owners);
  const auto isNew = [this, facet](Index site, const double*) { return this->meets(site, facet); };
  double farthest = 0.0;
  const bool complete = this->seesAll(reference, farthest);
  if (!this->addNeighbors(
        reference, complete ? farthest : std::numeric_limits<double>::infinity(), isNew))
  {
    return false;
  }
  m_expanded.clear();
  for (int round = 0; round < maxRounds; ++round)
  {
    bool grown = false;
    if (!m_trace(m_envelope) || (!complete && !this->checkCells(facet, grown)))
    {
      return false;
    }
    if (!grown)
    {
      m_centers[facet] = this->seesAll(best, farthest) ? noIndex : this->nearestToCenter();
      return true;
    }
  }
  return false;
}

/** The site nearest to the facet's centre, from where the next look at it will be. */
template <int D>
Index FacetIntegration<D>::nearestToCenter() const
{
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int slot = 0; slot < m_envelope.count; ++slot)
  {
    const double sum =
      m_envelope.values[0][slot] + m_envelope.values[1][slot] + m_envelope.values[2][slot];
    if (sum < least)
    {
      least = sum;
      best = slot;
    }
  }
  return m_ids[best];
}

/**
 * For each part the largest distance r from its site to a point, and the largest sum of r and the
 * distance of the point from the reference. Who wins a point is within r of it, and so within these
 * of the site and the reference (convex: the vertices are enough).
 */
template <int D>
void FacetIntegration<D>::findReach(const FacetConstants& facet, PartReach reach[]) const
{
  std::fill_n(reach, m_envelope.count, PartReach{});
  const double* e = facet.edge2;
  const double* seen = m_views[0].squared;
  for (int v = 0; v < m_envelope.numberOfVertices; ++v)
  {
    const Envelope::Vertex& vertex = m_envelope.vertices[v];
    const double* b = vertex.b;
    const int first = vertex.sites[0];
    const double fromReference = b[0] * seen[0] + b[1] * seen[1] + b[2] * seen[2] -
      (b[0] * b[1] * e[0] + b[1] * b[2] * e[1] + b[2] * b[0] * e[2]);
    const auto& values = m_envelope.values;
    const double fromSite =
      fromReference + (b[0] * values[0][first] + b[1] * values[1][first] + b[2] * values[2][first]);
    const double radius = std::sqrt(std::max(0.0, fromSite));
    const double sum = radius + std::sqrt(std::max(0.0, fromReference));
    for (const int slot : vertex.sites)
    {
      reach[slot].radius = std::max(reach[slot].radius, radius);
      reach[slot].sum = std::max(reach[slot].sum, sum);
    }
  }
}

/** Whether a site with these values at the corners would take a vertex from its cells. */
template <int D>
bool FacetIntegration<D>::winsSomewhere(const double values[3]) const
{
  for (int v = 0; v < m_envelope.numberOfVertices; ++v)
  {
    const double* b = m_envelope.vertices[v].b;
    const int slot = m_envelope.vertices[v].sites[0];
    double lead = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      lead += b[k] * (values[k] - m_envelope.values[k][slot]);
    }
    if (lead < 0.0)
    {
      return true;
    }
  }
  return false;
}

/** Whether this is the first time that a large facet meets a site. */
template <int D>
bool FacetIntegration<D>::meets(Index site, Index facet)
{
  const bool met = m_facetOfSite[site] == facet;
  m_facetOfSite[site] = facet;
  return !met;
}

/** Adds those in the list of a part's own site that win something; false: they are too many. */
template <int D>
bool FacetIntegration<D>::addListed(Index site, Index facet, double farthest)
{
  this->look(site, m_surface.facetCorners[facet], m_cellView);
  return this->addNeighbors(m_cellView, farthest,
    [this, facet](Index neighbor, const double values[3])
    { return this->meets(neighbor, facet) && this->winsSomewhere(values); });
}

/** The same for all sites within a distance: beside many close together, lists end early. */
template <int D>
bool FacetIntegration<D>::addNearby(Index site, Index facet, double distance)
{
  const int d = D == Eigen::Dynamic ? m_surface.dimension : D;
  const double* x = m_sites.site(site);
  this->look(site, m_surface.facetCorners[facet], m_cellView);
  m_lists.sitesNear(x, distance, m_near);
  if (m_near.size() > maxNearby)
  {
    return false;
  }
  for (const Neighbor& neighbor : m_near)
  {
    if (!this->meets(neighbor.site, facet))
    {
      continue;
    }
    // As from packed bisectors: far from both sites, their squared distances would cancel.
    const double* other = m_sites.site(neighbor.site);
    double values[3] = { m_cellView.values[0], m_cellView.values[1], m_cellView.values[2] };
    for (int m = 0; m < d; ++m)
    {
      const double offset = other[m] - x[m];
      for (int k = 0; k < 3; ++k)
      {
        values[k] += offset * (offset - 2.0 * m_cellView.points[k * d + m]);
      }
    }
    if (this->winsSomewhere(values))
    {
      if (m_envelope.count == Envelope::maxSites)
      {
        return false;
      }
      this->addSite(neighbor.site, values);
    }
  }
  return true;
}

/**
 * Lets sites join in that win something: for each part those that may, from the list of the part's
 * own site, unless the reference's list holds them. False if there are too many.
 */
template <int D>
bool FacetIntegration<D>::checkCells(Index facet, bool& grown)
{
  PartReach reach[Envelope::maxSites];
  this->findReach(m_surface.constants[facet], reach);
  const Index reference = m_views[0].site;
  const int count = m_envelope.count;
  for (int slot = 0; slot < count; ++slot)
  {
    double farthest = 0.0;
    if (m_lists.holds(reference, reach[slot].sum * aboveRounding, farthest))
    {
      continue;
    }
    const Index site = m_ids[slot];
    const double diameter = 2.0 * reach[slot].radius * aboveRounding;
    const bool isListed = m_lists.holds(site, diameter, farthest);
    if ((isListed && site == reference) ||
      std::find(m_expanded.begin(), m_expanded.end(), site) != m_expanded.end())
    {
      continue; // parts only shrink: all are in
    }
    m_expanded.push_back(site);
    const bool fits =
      isListed ? this->addListed(site, facet, farthest) : this->addNearby(site, facet, diameter);
    if (!fits)
    {
      return false;
    }
  }
  grown = m_envelope.count > count;
  return true;
}

template <int D>
PieceIntegral FacetIntegration<D>::integralOf(int slot, const FacetConstants& facet) const
{
  const double* moments = m_envelope.moments[slot];
  const double* e = facet.edge2;
  PieceIntegral integral;
  integral.weights[0] = moments[0] - moments[1] - moments[2];
  integral.weights[1] = moments[1];
  integral.weights[2] = moments[2];
  double squared = -(e[0] * (moments[1] - moments[3] - moments[4]) + e[1] * moments[4] +
    e[2] * (moments[2] - moments[4] - moments[5]));
  for (int k = 0; k < 3; ++k)
  {
    squared += integral.weights[k] * (m_views[0].squared[k] + m_envelope.values[k][slot]);
  }
  integral.energy = facet.mass * std::max(0.0, squared);
  return integral;
}

template class FacetIntegration<3>;
template class FacetIntegration<6>;
template class FacetIntegration<Eigen::Dynamic>;
}
