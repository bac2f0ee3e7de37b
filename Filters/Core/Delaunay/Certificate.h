/**
 * @file Certificate.h
 * @brief Proves from the diagram that the dual is homeomorphic to the surface, or says where not.
 *
 * Let M be the surface, a manifold with or without border; along cut features and borders each side
 * goes on in a collar that belongs to the curve's vertices alone (Collar.h), which changes nothing
 * about its topology. Pieces and collar fall into *cells*, one for each component (Components.h).
 * The diagram is that of perturbed, exact values, so at each point of M at most three cells meet,
 * and at its border at most two. The *closed ball property* [H. Edelsbrunner, N. R. Shah,
 * "Triangulating topological spaces", 1997], for components in place of whole cells:
 *
 * 1. each cell is a disk;
 * 2. each cell has a triangle of the dual, and its part of the border of M is nothing or one
 *    segment;
 * 3. two cells meet in nothing, or in one segment that has at most one end on the border of M;
 * 4. three cells meet in at most one point.
 *
 * Where it holds, the dual is homeomorphic to M. Proof: the borders between cells are curves whose
 * ends are triangles of the dual or lie on the border of M. A closed curve without ends would be
 * the whole circle around a disk (1), which then had no triangle (2). So each curve is a segment
 * between its ends, two cells have at most one (3), and by (4) the triangles, with their edges and
 * vertices, are the nerve of the cells. Each cell is a disk, each segment an arc, each point a
 * point, and each meets the border of M in nothing or a ball of one dimension less (2, 3): cells,
 * segments, points and their parts of the border make M a regular complex. Its barycentric
 * subdivision is that of the nerve, whose stars are the cells; simplex by simplex, they are
 * homeomorphic.
 *
 * How it is counted:
 * - a cell is a manifold with border, so it is a disk where it is connected, borders on others, and
 *   has Euler characteristic 1: faces - edges + vertices, those on its border left out, as there
 *   are as many of these edges as vertices. A whole cell of one site is connected by the way
 *   components are found; those of several, and those on curves, are walked through;
 * - the collar of a curve's vertex is one face: a disk, unless the curve meets itself in it;
 * - two cells meet in as many segments as half of the ends that their common edge has: triangles
 *   of the dual, repeated ones included, and points on the border of M.
 *
 * Along curves of more than two sheets the same is checked sheet by sheet, and where such a curve
 * ends on the border of M, as many borders may leave the cell as end there. At pinches, where parts
 * of M meet in just a point, a cell may be several disks, and its part of the border of M as many
 * segments as the point has borders. As M is no manifold, nothing is proven then.
 */
#ifndef remesh_Certificate_h
#define remesh_Certificate_h

#include "Delaunay/CellDisks.h"
#include "Delaunay/Dual.h"

namespace remesh
{
/** Where the closed ball property fails; all empty where it holds. Each list ascending. */
struct Certificate
{
  std::vector<Index> cells;                   ///< components that break 1 or 2
  std::vector<std::pair<Index, Index>> edges; ///< that break 3, the lower component first
  std::vector<Triple> vertices;               ///< that break 4, sorted
  /** Vertices on features without a cell; one more if the cells do not cover all features. */
  Index lostPoints = 0;

  bool holds() const { return this->violations() == 0; }
  Offset violations() const
  {
    return static_cast<Offset>(this->cells.size() + this->edges.size() + this->vertices.size()) +
      this->lostPoints;
  }
};

/**
 * @param dual of these cells.
 * @return Cancelled; then `certificate` is of no use.
 * Cost: O(P) but for the look-up of pieces in their facets; in parallel.
 */
Status certify(
  const CellComplex& cells, const Dual& dual, const RunControl& control, Certificate& certificate);
}

#endif
