/**
 * @file Dual.h
 * @brief The restricted Delaunay triangulation: the dual of the components of the cells.
 */
#ifndef remesh_Dual_h
#define remesh_Dual_h

#include "Delaunay/Collar.h"
#include "Mesh/EdgeValences.h"

namespace remesh
{
struct Dual
{
  std::vector<Triple> triangles; ///< components, oriented like the facet they come from
  /** Further points of three cells whose triangle was there already; sorted, and each ascending. */
  std::vector<Triple> repeated;
  EdgeValences edges;             ///< of these triangles
  Offset eulerCharacteristic = 0; ///< used vertices - edges + triangles
};

/**
 * A triangle for each point where three cells meet, by facet, each set of three components once.
 *
 * @param seams adds its triangles; or nullptr.
 * @return Cancelled; then `dual` is of no use.
 * Cost: O(P) but for the triangles around a component, which are sorted; in parallel.
 */
Status buildDual(const Diagram& diagram, const Components& components, const RunControl& control,
  Dual& dual, const Seams* seams = nullptr);

/**
 * Takes away the triangles that hang on an edge (see HangingTriangles.h), and tells the rest anew.
 * O(T).
 *
 * @return Cancelled; then `dual` is of no use.
 */
Status dropHangingTriangles(
  Components& components, Seams& seams, const RunControl& control, Dual& dual);

/**
 * For each of n sites, the number of sites whose cells share a segment with its cell.
 *
 * @return Cancelled; then `counts` are of no use.
 * Cost: O(P) but for the neighbours of a site, which are sorted; in parallel.
 */
Status countNeighbors(const Diagram& diagram, Index numberOfSites, const RunControl& control,
  std::vector<Index>& counts);
}

#endif
