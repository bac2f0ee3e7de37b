#include "Voronoi/VertexPlaces.h"

#include "Embedding/CornerReader.h"
#include "Embedding/Distance.h"
#include "Voronoi/Expansion.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace remesh
{
namespace
{
/** Cross products that cancel by more than this are computed exactly. */
constexpr double maxCancelled = 0x1.0p-4;

/** The cross product of H_j - H_i and H_m - H_i, exactly but for the last rounding. */
double exactCrossProduct(const FacetSite* const sites[3], double b[3])
{
  Expansion sum;
  for (int k = 0; k < 3; ++k)
  {
    const int l = (k + 1) % 3;
    const int n = (k + 2) % 3;
    Expansion component;
    for (int r = 0; r < 3; ++r)
    {
      const double* x = sites[r]->h;
      const double* y = sites[(r + 1) % 3]->h;
      for (Expansion* to : { &component, &sum })
      {
        to->addProduct(x[l], y[n]);
        to->addProduct(-x[n], y[l]);
      }
    }
    b[k] = component.estimate();
  }
  return sum.estimate();
}
}

void placeOnEdge(
  const Triple& corners, const FacetSite& i, const FacetSite& j, int edge, double b[3])
{
  int k = edge;
  int l = (edge + 1) % 3;
  if (corners[k] > corners[l])
  {
    std::swap(k, l);
  }
  const FacetSite* lower = &i;
  const FacetSite* upper = &j;
  if (lower->id > upper->id)
  {
    std::swap(lower, upper);
  }
  const double atK = upper->h[k] - lower->h[k];
  const double atL = upper->h[l] - lower->h[l];
  const double t = atK == atL ? 0.5 : std::clamp(atK / (atK - atL), 0.0, 1.0);
  b[3 - k - l] = 0.0;
  b[k] = 1.0 - t;
  b[l] = t;
}

void placeInside(const FacetSite& i, const FacetSite& j, const FacetSite& m, double b[3])
{
  const FacetSite* sites[3] = { &i, &j, &m };
  std::sort(sites, sites + 3, [](const FacetSite* x, const FacetSite* y) { return x->id < y->id; });
  double u[3], v[3];
  for (int k = 0; k < 3; ++k)
  {
    u[k] = sites[1]->h[k] - sites[0]->h[k];
    v[k] = sites[2]->h[k] - sites[0]->h[k];
  }
  double sum = 0.0;
  double size = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const double left = u[(k + 1) % 3] * v[(k + 2) % 3];
    const double right = u[(k + 2) % 3] * v[(k + 1) % 3];
    b[k] = left - right;
    sum += b[k];
    size += std::abs(left) + std::abs(right);
  }
  // Where the bisectors nearly coincide, rounding would put the point anywhere in the facet, and
  // the piece that ends there would seem smaller than it is (FacetTiling::squaredRadius).
  if (std::abs(sum) <= maxCancelled * size)
  {
    sum = exactCrossProduct(sites, b);
  }
  // The point lies in the facet; the last rounding may put it outside.
  double inside = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    b[k] = sum == 0.0 ? 1.0 : std::max(0.0, b[k] / sum);
    inside += b[k];
  }
  for (int k = 0; k < 3; ++k)
  {
    b[k] /= inside;
  }
}

PiecePlaces::PiecePlaces(const VertexPlaces& places, Offset piece)
  : m_places(places)
  , m_piece(piece)
  , m_facet(places.diagram.facets[piece])
{
}

const FacetSite& PiecePlaces::see(Index site, int slot)
{
  FacetSite& seen = m_seen[slot];
  if (seen.id == site)
  {
    return seen;
  }
  seen.id = site;
  const EmbeddedSurface& surface = m_places.surface;
  CornerReader<Eigen::Dynamic> reader(surface);
  dispatchDimension(surface.dimension,
    [&](auto dimension)
    {
      for (int k = 0; k < 3; ++k)
      {
        seen.h[k] = squaredDistance<decltype(dimension)::value>(m_places.sites.site(site),
          reader.corner(surface.facetCorners[m_facet][k]), surface.dimension);
      }
    });
  return seen;
}

std::array<double, 3> PiecePlaces::at(Offset vertex)
{
  const Index incoming = m_places.diagram.acrossIncoming(m_piece, vertex);
  const Index outgoing = m_places.diagram.across[vertex];
  std::array<double, 3> b = { 0.0, 0.0, 0.0 };
  if (incoming < 0 && outgoing < 0) // the corner where the facet's edge starts
  {
    b[-1 - outgoing] = 1.0;
    return b;
  }
  const FacetSite& own = this->see(m_places.diagram.sites[m_piece], ownSlot);
  // On the way around, the site across the next edge takes the place of that before the last.
  const int before = m_seen[0].id == incoming ? 0 : 1;
  if (incoming < 0 || outgoing < 0)
  {
    const FacetSite& other =
      incoming < 0 ? this->see(outgoing, 1 - before) : this->see(incoming, before);
    placeOnEdge(m_places.surface.facetCorners[m_facet], own, other,
      -1 - std::min(incoming, outgoing), b.data());
  }
  else
  {
    const FacetSite& other = this->see(incoming, before);
    placeInside(own, other, this->see(outgoing, 1 - before), b.data());
  }
  return b;
}

std::array<double, 3> VertexPlaces::at(Offset piece, Offset vertex) const
{
  return PiecePlaces(*this, piece).at(vertex);
}
}
