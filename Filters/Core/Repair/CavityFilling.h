/**
 * @file CavityFilling.h
 * @brief Fills a polygon of a mesh with the best triangles.
 */
#ifndef remesh_CavityFilling_h
#define remesh_CavityFilling_h

#include "Repair/RepairedMesh.h"

#include <algorithm>
#include <map>
#include <vector>

namespace remesh
{
/**
 * A set of connected triangles that may be replaced. They have no vertex inside, and no two of them
 * share a feature's edge. So they fill a polygon.
 */
struct Cavity
{
  std::vector<Index> triangles; ///< t, ascending
  std::vector<Index> loop;      ///< t + 2, corners of the polygon, in the triangles' orientation

  bool has(Index triangle) const
  {
    return std::binary_search(this->triangles.begin(), this->triangles.end(), triangle);
  }
};

/** Triangles that replace as many others. Triangles of the cavity that stay are in neither list. */
struct Filling
{
  int turnedBack = 0;        ///< how many triangles fewer are inverted or strays
  double gain = 0.0;         ///< by how much the cost falls
  std::vector<Index> old;    ///< numbers of the triangles that go
  std::vector<Triple> fresh; ///< corners of those that come, as many
  Offset newEdges = 0;       ///< edges that were not there before
};

/** Finds fillings. Remembers what triangles cost, so no vertex may move while it is in use. */
class CavityFiller
{
public:
  /** The mesh must outlive it. */
  explicit CavityFiller(const RepairedMesh& mesh)
    : m_mesh(mesh)
  {
  }

  /**
   * Finds the triangles of the least cost (RepairedMesh.h), by dynamic programming (G. T. Klincsek,
   * "Minimal triangulations of polygonal domains", 1980). Of triangles that cost the same, those of
   * the best shapes are taken. None gets an edge that the mesh has already outside of the cavity.
   *
   * @return empty if no filling costs less than the present triangles.
   * Cost: `stepsFor` the cavity, and one search for the closest facet for each new triple of
   * corners.
   */
  Filling fill(const Cavity& cavity);

  /** Steps of the dynamic programming: the cube of the number of corners, over 6. */
  static std::size_t stepsFor(const Cavity& cavity)
  {
    const std::size_t corners = cavity.loop.size();
    return corners * corners * corners / 6;
  }

private:
  /** The best triangles for a part of the loop: two of its corners, and all between them. */
  struct Section
  {
    double cost;
    std::size_t apex; ///< third corner of the triangle that has the other two
  };

  Section& between(std::size_t from, std::size_t to) { return m_sections[from * m_corners + to]; }
  void markEdges(const Cavity& cavity);
  void findApex(const std::vector<Index>& loop, std::size_t from, std::size_t to);
  double costOf(Triple triangle);
  void list(const std::vector<Index>& loop, std::size_t from, std::size_t to,
    std::vector<Triple>& triangles);

  const RepairedMesh& m_mesh;
  std::size_t m_corners = 0;
  std::vector<Section> m_sections; ///< corners x corners: from, to
  std::vector<char> m_isEdge;      ///< likewise; 1: the mesh has this edge outside of the cavity
  std::map<Triple, double> m_costs;
};
}

#endif
