/**
 * @file CavityFilling.h
 * @brief The best triangles for the polygon that some triangles of a mesh fill.
 */
#ifndef remesh_CavityFilling_h
#define remesh_CavityFilling_h

#include "Repair/RepairedMesh.h"

#include <algorithm>
#include <map>
#include <vector>

namespace remesh
{
/** Triangles that hang together, with neither a vertex nor a feature between them. */
struct Cavity
{
  std::vector<Index> triangles; ///< t, ascending
  std::vector<Index> loop;      ///< t + 2, the polygon's corners as the triangles turn, each once

  bool has(Index triangle) const
  {
    return std::binary_search(this->triangles.begin(), this->triangles.end(), triangle);
  }
};

/** Triangles to put in the place of as many others, where those of a polygon change at all. */
struct Filling
{
  int turnedBack = 0; ///< so many fewer are inverted
  double gain = 0.0;  ///< of the cost
  std::vector<Index> old;
  std::vector<Triple> fresh;
  Offset newEdges = 0;
};

/** Finds fillings, and remembers what the triangles in them cost, while no vertex moves. */
class CavityFiller
{
public:
  /** The mesh must outlive it. */
  explicit CavityFiller(const RepairedMesh& mesh)
    : m_mesh(mesh)
  {
  }

  /**
   * The triangles of the least cost (RepairedMesh.h; of those that cost the same, the ones of the
   * best shapes) with no edge that the mesh has elsewhere, by dynamic programming: G. T. Klincsek,
   * "Minimal triangulations of polygonal domains", 1980. Cost: `stepsFor` the cavity, and a look
   * for the closest facet for each three corners that were not together before.
   */
  Filling fill(const Cavity& cavity);

  static std::size_t stepsFor(const Cavity& cavity)
  {
    const std::size_t corners = cavity.loop.size();
    return corners * corners * corners / 6;
  }

private:
  /** The best triangles between two corners of the loop and those that come between them. */
  struct Section
  {
    double cost;
    std::size_t apex;
  };

  Section& between(std::size_t from, std::size_t to) { return m_sections[from * m_corners + to]; }
  void markEdges(const Cavity& cavity);
  void findApex(const std::vector<Index>& loop, std::size_t from, std::size_t to);
  double costOf(Triple triangle);
  void list(const std::vector<Index>& loop, std::size_t from, std::size_t to,
    std::vector<Triple>& triangles);

  const RepairedMesh& m_mesh;
  std::size_t m_corners = 0;
  std::vector<Section> m_sections; ///< from, to
  std::vector<char> m_isEdge;      ///< from, to; 1: of the mesh around the cavity
  std::map<Triple, double> m_costs;
};
}

#endif
