#include "Delaunay/ThinTips.h"

#include "Embedding/Distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace remesh
{
namespace
{
/** Between two ends, where the distance from a centre is the radius, or nearest to it. */
Eigen::VectorXd placeAtRadius(const Eigen::VectorXd& center, double radius,
  const Eigen::VectorXd& begin, const Eigen::VectorXd& end)
{
  const Eigen::VectorXd way = end - begin;
  const Eigen::VectorXd from = begin - center;
  const double a = way.squaredNorm();
  const double b = from.dot(way);
  const double root = std::sqrt(std::max(0.0, b * b - a * (from.squaredNorm() - radius * radius)));
  double best = 0.0;
  double minGap = std::numeric_limits<double>::infinity();
  for (const double t : { (root - b) / a, (-root - b) / a })
  {
    const double inside = std::isfinite(t) ? std::clamp(t, 0.0, 1.0) : 0.0;
    const double gap = std::abs((from + inside * way).norm() - radius);
    if (gap < minGap)
    {
      minGap = gap;
      best = inside;
    }
  }
  return begin + best * way;
}
}

ThinTips::ThinTips(const VertexPlaces& places, const Components& components)
  : m_places(places)
  , m_components(components)
  , m_reader(places.surface)
{
}

/** Whether it is of a site that stays, and the only one: that at the site's own place. */
bool ThinTips::isFixed(Index component) const
{
  const std::vector<Index>& sites = m_components.sites;
  const auto k = static_cast<std::size_t>(component);
  return sites[k] < m_places.sites.fixed && (k == 0 || sites[k - 1] != sites[k]) &&
    (k + 1 == sites.size() || sites[k + 1] != sites[k]);
}

ThinTips::Vector ThinTips::rowOf(const double* row) const
{
  return Eigen::Map<const Vector>(row, m_places.surface.dimension);
}

/** Of the copies of a component's site, the nearest on the patch of another site; or noIndex. */
Index ThinTips::copyBeside(Index component, Index other) const
{
  const auto patchOf = [this](Index site)
  { return m_places.surface.patches.patchOf(m_places.sites.site(site)); };
  const Index patch = patchOf(other);
  Index nearest = noIndex;
  double least = std::numeric_limits<double>::infinity();
  for (Offset p = m_components.pieceBegin[component]; p < m_components.pieceBegin[component + 1];
       ++p)
  {
    const Index site = m_places.diagram.sites[m_components.pieces[p]];
    if (site != nearest && patchOf(site) == patch)
    {
      const double squared = squaredDistance<Eigen::Dynamic>(
        m_places.sites.site(site), m_places.sites.site(other), m_places.surface.dimension);
      nearest = squared < least ? site : nearest;
      least = std::min(least, squared);
    }
  }
  return nearest;
}

ThinTips::Vector ThinTips::placeOf(Offset piece, Offset vertex)
{
  const auto corners = m_reader.facet(m_places.diagram.facets[piece]);
  const std::array<double, 3> b = m_places.at(piece, vertex);
  return b[0] * this->rowOf(corners[0]) + b[1] * this->rowOf(corners[1]) +
    b[2] * this->rowOf(corners[2]);
}

/**
 * The place on a side of a piece, towards another site, that is as far from a corner's site as the
 * two are on average, or nearest to it; and how far it is off.
 */
std::pair<ThinTips::Vector, double> ThinTips::placeOnSide(Index center, Offset piece, Offset vertex)
{
  const Diagram& diagram = m_places.diagram;
  const Vector from = this->rowOf(m_places.sites.site(center));
  const auto distance = [&](Index site)
  { return (this->rowOf(m_places.sites.site(site)) - from).norm(); };
  const double radius = 0.5 * (distance(diagram.sites[piece]) + distance(diagram.across[vertex]));
  const Offset next =
    vertex + 1 < diagram.vertexBegin[piece + 1] ? vertex + 1 : diagram.vertexBegin[piece];
  const Vector place =
    placeAtRadius(from, radius, this->placeOf(piece, vertex), this->placeOf(piece, next));
  return { place, std::abs((place - from).norm() - radius) };
}

std::vector<double> ThinTips::placeBetween(Index corner, Index first, Index second)
{
  std::vector<double> best;
  if (!this->isFixed(corner) || !this->isFixed(first) || !this->isFixed(second))
  {
    return best;
  }
  const Diagram& diagram = m_places.diagram;
  double minGap = std::numeric_limits<double>::infinity();
  for (Offset p = m_components.pieceBegin[first]; p < m_components.pieceBegin[first + 1]; ++p)
  {
    const Index piece = m_components.pieces[p];
    const Index site = diagram.sites[piece];
    for (Offset v = diagram.vertexBegin[piece]; v < diagram.vertexBegin[piece + 1]; ++v)
    {
      const Index across = diagram.across[v];
      if (across < 0 ||
        m_components.ofPiece[diagram.pieceOf(diagram.facets[piece], across)] != second)
      {
        continue;
      }
      const Index copy = this->copyBeside(corner, site);
      if (copy == noIndex)
      {
        continue;
      }
      const auto [place, gap] = this->placeOnSide(copy, piece, v);
      if (gap < minGap)
      {
        minGap = gap;
        best.assign(place.data(), place.data() + place.size());
      }
    }
  }
  return best;
}
}
