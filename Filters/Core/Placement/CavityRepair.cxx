#include "Placement/CavityRepair.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace remesh
{
namespace
{
constexpr std::size_t mostTriangles = 40;
constexpr std::size_t mostCavities = 300;

/** Triangles that hang together, and the polygon that they fill. */
struct Cavity
{
  std::vector<Index> triangles; ///< ascending
  std::vector<Index> loop;      ///< corners, as the triangles turn, each once

  bool has(Index triangle) const
  {
    return std::binary_search(this->triangles.begin(), this->triangles.end(), triangle);
  }
};

/** Other triangles for a cavity. */
struct Filling
{
  double gain = 0.0; ///< of the cost
  std::vector<Index> old;
  std::vector<Triple> fresh;
};

/** Looks for fillings, and remembers what the triangles in them cost. */
class CavityFiller
{
public:
  explicit CavityFiller(const RepairedMesh& mesh)
    : m_mesh(mesh)
  {
  }

  /** The best filling of a cavity; without triangles where that is the one it has. */
  Filling fill(const Cavity& cavity)
  {
    const std::size_t size = cavity.loop.size();
    m_cavity = &cavity;
    m_best.assign(size * size, { 0.0, 0 });
    for (std::size_t span = 2; span < size; ++span)
    {
      for (std::size_t from = 0; from + span < size; ++from)
      {
        this->findApex(from, from + span);
      }
    }
    double before = 0.0;
    for (const Index t : cavity.triangles)
    {
      before += this->costOf(m_mesh.triangles()[t]);
    }
    Filling filling;
    filling.gain = before - this->best(0, size - 1).cost;
    if (filling.gain > 0.0)
    {
      filling.old = cavity.triangles;
      this->listTriangles(0, size - 1, filling.fresh);
    }
    return filling;
  }

private:
  /** The best triangles between two corners of the loop and those that come between them. */
  struct Section
  {
    double cost;
    std::size_t apex;
  };

  Section& best(std::size_t from, std::size_t to)
  {
    return m_best[from * m_cavity->loop.size() + to];
  }

  void findApex(std::size_t from, std::size_t to)
  {
    const std::vector<Index>& loop = m_cavity->loop;
    Section section{ std::numeric_limits<double>::infinity(), from + 1 };
    const bool closes = from == 0 && to + 1 == loop.size(); // the polygon with a side of its own
    if (closes || this->mayJoin(loop[from], loop[to]))
    {
      for (std::size_t apex = from + 1; apex < to; ++apex)
      {
        const double others = this->best(from, apex).cost + this->best(apex, to).cost;
        if (others < section.cost)
        {
          const double cost = others + this->costOf({ loop[from], loop[apex], loop[to] });
          section = cost < section.cost ? Section{ cost, apex } : section;
        }
      }
    }
    this->best(from, to) = section;
  }

  /** Whether the mesh has no such edge, but inside of the cavity. */
  bool mayJoin(Index a, Index b) const
  {
    for (const Index t : m_mesh.star(a))
    {
      const Triple& corners = m_mesh.triangles()[t];
      if (!m_cavity->has(t) && std::find(corners.begin(), corners.end(), b) != corners.end())
      {
        return false;
      }
    }
    return true;
  }

  double costOf(Triple triangle)
  {
    std::rotate(
      triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    const auto [found, isNew] = m_costs.emplace(triangle, 0.0);
    if (isNew)
    {
      found->second = m_mesh.cost(triangle);
    }
    return found->second;
  }

  void listTriangles(std::size_t from, std::size_t to, std::vector<Triple>& triangles)
  {
    if (to - from < 2)
    {
      return;
    }
    const std::vector<Index>& loop = m_cavity->loop;
    const std::size_t apex = this->best(from, to).apex;
    triangles.push_back({ loop[from], loop[apex], loop[to] });
    this->listTriangles(from, apex, triangles);
    this->listTriangles(apex, to, triangles);
  }

  const RepairedMesh& m_mesh;
  const Cavity* m_cavity = nullptr;
  std::vector<Section> m_best; ///< from, to
  std::map<Triple, double> m_costs;
};

/** Adds the triangle beyond edge k of one that it has; false where that would close it around a
 * vertex. */
bool extend(Cavity& cavity, Index triangle, int k, Index other, const RepairedMesh& mesh)
{
  const Triple& across = mesh.triangles()[other];
  const Index end = mesh.triangles()[triangle][(k + 2) % 3];
  const auto at = std::find(across.begin(), across.end(), end) - across.begin();
  const Index apex = across[(at + 2) % 3];
  if (std::find(cavity.loop.begin(), cavity.loop.end(), apex) != cavity.loop.end())
  {
    return false;
  }
  cavity.loop.insert(std::find(cavity.loop.begin(), cavity.loop.end(), end), apex);
  cavity.triangles.insert(
    std::upper_bound(cavity.triangles.begin(), cavity.triangles.end(), other), other);
  return true;
}

/** The cavities with one triangle more. */
void listLarger(const Cavity& cavity, const RepairedMesh& mesh, std::set<std::vector<Index>>& seen,
  std::vector<Cavity>& larger)
{
  for (const Index t : cavity.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index other = mesh.beyond(t, k);
      Cavity next = cavity;
      if (other != noIndex && !cavity.has(other) && extend(next, t, k, other, mesh) &&
        seen.insert(next.triangles).second)
      {
        larger.push_back(std::move(next));
      }
    }
  }
}

/** The flipped triangles that hang together with one. */
Cavity flippedAround(const RepairedMesh& mesh, Index triangle)
{
  const Triple& corners = mesh.triangles()[triangle];
  Cavity cavity{ { triangle }, { corners.begin(), corners.end() } };
  std::vector<Index> open{ triangle };
  while (!open.empty() && cavity.triangles.size() < mostTriangles)
  {
    const Index t = open.back();
    open.pop_back();
    for (int k = 0; k < 3; ++k)
    {
      const Index other = mesh.beyond(t, k);
      if (other != noIndex && !cavity.has(other) && mesh.isFlipped(mesh.triangles()[other]) &&
        extend(cavity, t, k, other, mesh))
      {
        open.push_back(other);
      }
    }
  }
  return cavity;
}

/** Fills a cavity and as few triangles more as help anew. */
bool refill(const RepairContext& context, const Cavity& seed, CavityFiller& filler,
  RepairedMesh& mesh, FlipRepair& repair)
{
  std::set<std::vector<Index>> seen;
  std::vector<Cavity> cavities{ seed };
  while (!cavities.empty() && cavities.front().triangles.size() < mostTriangles &&
    seen.size() < mostCavities && !context.control.cancelled())
  {
    std::vector<Cavity> larger;
    for (const Cavity& cavity : cavities)
    {
      listLarger(cavity, mesh, seen, larger);
    }
    Filling best;
    for (const Cavity& cavity : larger)
    {
      Filling filling = filler.fill(cavity);
      best = filling.gain > best.gain ? std::move(filling) : best;
    }
    if (best.gain > 0.5 * context.gain)
    {
      mesh.replace(best.old, best.fresh);
      repair.flippedEdges += static_cast<Offset>(best.old.size()) - 1;
      return true;
    }
    cavities = std::move(larger);
  }
  return false;
}
}

bool refillAround(
  const RepairContext& context, Index triangle, RepairedMesh& mesh, FlipRepair& repair)
{
  const Triple& corners = mesh.triangles()[triangle];
  CavityFiller filler(mesh);
  if (refill(context, { { triangle }, { corners.begin(), corners.end() } }, filler, mesh, repair))
  {
    return true;
  }
  const Cavity flipped = flippedAround(mesh, triangle);
  return flipped.triangles.size() > 1 && refill(context, flipped, filler, mesh, repair);
}
}
