#include "Voronoi/FacetTiling.h"

#include "Voronoi/VertexPlaces.h"

#include <algorithm>
#include <utility>

namespace remesh
{
void FacetTiling::begin(const Triple& corners, const FacetConstants& constants)
{
  m_corners = corners;
  m_constants = constants;
  m_sites.clear();
}

int FacetTiling::addSite(const FacetSite& site)
{
  m_sites.push_back(site);
  return this->numberOfSites() - 1;
}

void FacetTiling::wholeFacet(Polygon& polygon) const
{
  polygon.resize(3);
  for (int k = 0; k < 3; ++k)
  {
    polygon[k] = { { 0.0, 0.0, 0.0 }, -1 - k };
    polygon[k].b[k] = 1.0;
  }
}

bool FacetTiling::beats(const Polygon& polygon, int vertex, int i, int q) const
{
  const int size = static_cast<int>(polygon.size());
  const int incoming = polygon[(vertex + size - 1) % size].edge;
  const int outgoing = polygon[vertex].edge;
  const FacetSite& si = m_sites[i];
  const FacetSite& sq = m_sites[q];
  if (incoming < 0 && outgoing < 0)
  {
    return beatsAtCorner(sq, si, -1 - outgoing);
  }
  if (incoming < 0)
  {
    return beatsOnEdge(sq, si, m_sites[outgoing], -1 - incoming, true, m_decisions);
  }
  if (outgoing < 0)
  {
    return beatsOnEdge(sq, si, m_sites[incoming], -1 - outgoing, false, m_decisions);
  }
  return beatsInside(sq, si, m_sites[incoming], m_sites[outgoing], m_decisions);
}

// The beaten vertices of a convex polygon are consecutive: they give way to two new ones, at the
// ends of an edge along the bisector with q.
bool FacetTiling::clip(Polygon& polygon, int i, int q)
{
  if (!beatsSomewhere(m_sites[q], m_sites[i]))
  {
    return false;
  }
  const int size = static_cast<int>(polygon.size());
  m_beaten.resize(size);
  int beaten = 0;
  for (int v = 0; v < size; ++v)
  {
    m_beaten[v] = this->beats(polygon, v, i, q);
    beaten += m_beaten[v];
  }
  if (beaten == 0)
  {
    return false;
  }
  if (beaten == size)
  {
    polygon.clear();
    return true;
  }
  int first = 0;
  while (!m_beaten[first] || m_beaten[(first + size - 1) % size])
  {
    ++first;
  }
  const int last = (first + beaten - 1) % size;
  m_clipped.clear();
  for (int v = (last + 1) % size; v != first; v = (v + 1) % size)
  {
    m_clipped.push_back(polygon[v]);
  }
  PieceVertex start{ {}, q };
  this->construct(i, polygon[(first + size - 1) % size].edge, q, start.b);
  PieceVertex end{ {}, polygon[last].edge };
  this->construct(i, q, polygon[last].edge, end.b);
  m_clipped.push_back(start);
  m_clipped.push_back(end);
  std::swap(polygon, m_clipped);
  return true;
}

void FacetTiling::construct(int i, int incoming, int outgoing, double b[3]) const
{
  if (incoming < 0)
  {
    placeOnEdge(m_corners, m_sites[i], m_sites[outgoing], -1 - incoming, b);
  }
  else if (outgoing < 0)
  {
    placeOnEdge(m_corners, m_sites[i], m_sites[incoming], -1 - outgoing, b);
  }
  else
  {
    placeInside(m_sites[i], m_sites[incoming], m_sites[outgoing], b);
  }
}

double FacetTiling::squaredDistance(int slot, const double b[3]) const
{
  const double* h = m_sites[slot].h;
  const double* e = m_constants.edge2;
  const double affine = b[0] * h[0] + b[1] * h[1] + b[2] * h[2];
  const double quadratic = b[0] * b[1] * e[0] + b[1] * b[2] * e[1] + b[2] * b[0] * e[2];
  return std::max(0.0, affine - quadratic);
}

double FacetTiling::squaredRadius(const Polygon& polygon, int slot) const
{
  double radius2 = 0.0;
  for (const PieceVertex& vertex : polygon)
  {
    radius2 = std::max(radius2, this->squaredDistance(slot, vertex.b));
  }
  return radius2;
}
}
