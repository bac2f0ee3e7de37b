#include "Repair/CavityFilling.h"

#include "Placement/TriangleShape.h"

#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace remesh
{
namespace
{
constexpr double shapeWeight = 1e-3; // decides where normals do not

/** The same triangle, from its lowest corner on. */
Triple turned(Triple triangle)
{
  std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  return triangle;
}

/** 1: all sides are of one length; 0: no area. */
double shapeOf(const Corners& p)
{
  const double sides =
    (p[1] - p[0]).squaredNorm() + (p[2] - p[1]).squaredNorm() + (p[0] - p[2]).squaredNorm();
  return sides > 0.0 ? 4.0 * std::sqrt(3.0) * facetArea(p[0], p[1], p[2]) / sides : 0.0;
}

std::set<std::pair<Index, Index>> edgesOf(const std::vector<Triple>& triangles)
{
  std::set<std::pair<Index, Index>> edges;
  for (const Triple& triangle : triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      edges.insert(std::minmax(triangle[k], triangle[(k + 1) % 3]));
    }
  }
  return edges;
}

/** The triangles that change; others stay where they are. */
void listChanges(const Cavity& cavity, const std::vector<Triple>& triangles,
  const std::vector<Triple>& filling, Filling& changes)
{
  std::vector<Triple> before;
  for (const Index t : cavity.triangles)
  {
    before.push_back(turned(triangles[t]));
  }
  for (const Triple& triangle : filling)
  {
    if (std::find(before.begin(), before.end(), turned(triangle)) == before.end())
    {
      changes.fresh.push_back(triangle);
    }
  }
  for (std::size_t k = 0; k < before.size(); ++k)
  {
    const auto isIt = [&](const Triple& triangle) { return turned(triangle) == before[k]; };
    if (std::none_of(filling.begin(), filling.end(), isIt))
    {
      changes.old.push_back(cavity.triangles[k]);
    }
  }
  const std::set<std::pair<Index, Index>> edges = edgesOf(before);
  for (const std::pair<Index, Index>& edge : edgesOf(changes.fresh))
  {
    changes.newEdges += edges.count(edge) == 0 ? 1 : 0;
  }
}
}

Filling CavityFiller::fill(const Cavity& cavity)
{
  const std::vector<Index>& loop = cavity.loop;
  m_corners = loop.size();
  m_sections.assign(m_corners * m_corners, { 0.0, 0 });
  this->markEdges(cavity);
  for (std::size_t span = 2; span < m_corners; ++span)
  {
    for (std::size_t from = 0; from + span < m_corners; ++from)
    {
      this->findApex(loop, from, from + span);
    }
  }
  Filling filling;
  for (const Index t : cavity.triangles)
  {
    const double cost = this->costOf(m_mesh.triangles()[t]);
    filling.gain += cost;
    filling.turnedBack += cost >= strayCost ? 1 : 0;
  }
  filling.gain -= this->between(0, m_corners - 1).cost;
  if (!(filling.gain > 0.0))
  {
    return {};
  }
  std::vector<Triple> triangles;
  this->list(loop, 0, m_corners - 1, triangles);
  for (const Triple& triangle : triangles)
  {
    filling.turnedBack -= this->costOf(triangle) >= strayCost ? 1 : 0;
  }
  listChanges(cavity, m_mesh.triangles(), triangles, filling);
  return filling;
}

/** Finds out between which corners the mesh around the cavity has edges. */
void CavityFiller::markEdges(const Cavity& cavity)
{
  m_isEdge.assign(m_corners * m_corners, 0);
  for (std::size_t from = 0; from < m_corners; ++from)
  {
    for (const Index t : m_mesh.star(cavity.loop[from]))
    {
      const Triple& corners = m_mesh.triangles()[t];
      for (std::size_t to = 0; to < m_corners && !cavity.has(t); ++to)
      {
        const bool isCorner =
          std::find(corners.begin(), corners.end(), cavity.loop[to]) != corners.end();
        m_isEdge[from * m_corners + to] |= isCorner ? 1 : 0;
      }
    }
  }
}

void CavityFiller::findApex(const std::vector<Index>& loop, std::size_t from, std::size_t to)
{
  Section section{ std::numeric_limits<double>::infinity(), from + 1 };
  const bool isSide = from == 0 && to + 1 == m_corners;
  if (isSide || m_isEdge[from * m_corners + to] == 0)
  {
    for (std::size_t apex = from + 1; apex < to; ++apex)
    {
      const double others = this->between(from, apex).cost + this->between(apex, to).cost;
      if (others < section.cost)
      {
        const double cost = others + this->costOf({ loop[from], loop[apex], loop[to] });
        section = cost < section.cost ? Section{ cost, apex } : section;
      }
    }
  }
  this->between(from, to) = section;
}

double CavityFiller::costOf(Triple triangle)
{
  const auto [found, isNew] = m_costs.try_emplace(turned(triangle), 0.0);
  if (isNew)
  {
    const Corners corners = cornersOf(found->first, m_mesh.positions());
    found->second = m_mesh.cost(found->first) + shapeWeight * (1.0 - shapeOf(corners));
  }
  return found->second;
}

void CavityFiller::list(
  const std::vector<Index>& loop, std::size_t from, std::size_t to, std::vector<Triple>& triangles)
{
  if (to - from > 1)
  {
    const std::size_t apex = this->between(from, to).apex;
    triangles.push_back({ loop[from], loop[apex], loop[to] });
    this->list(loop, from, apex, triangles);
    this->list(loop, apex, to, triangles);
  }
}
}
