/**
 * @file Dual.h
 * @brief The restricted Delaunay triangulation: the dual of the components of the cells.
 */
#ifndef remesh_Dual_h
#define remesh_Dual_h

#include "Delaunay/Components.h"

namespace remesh
{
struct Dual
{
  std::vector<Triple> triangles; ///< components, oriented like the facet they come from
  Offset repeated = 0;           ///< points of three cells whose triangle was there already

  /**
   * Components where the dual is no manifold, ascending: of each repeated triangle, and of each
   * other edge of more than two triangles, the vertex in the fewest triangles.
   */
  std::vector<Index> defects;

  Offset numberOfNonManifoldEdges = 0; ///< edges of more than two triangles
  Offset eulerCharacteristic = 0;      ///< used vertices - edges + triangles
};

/**
 * A triangle for each point where three cells meet, by facet, each set of three components once.
 * O(P log P).
 */
Dual buildDual(const Diagram& diagram, const Components& components);

/** For each site, the number of sites whose cells share a segment with its cell. */
std::vector<Index> countNeighbors(const Diagram& diagram, Index numberOfSites);
}

#endif
