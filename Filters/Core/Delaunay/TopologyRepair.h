/**
 * @file TopologyRepair.h
 * @brief Sites for the few places where the dual is no manifold.
 *
 * Where a thin part of the surface has too few cells around it (a cell with two neighbours only at
 * the tip of a spike, two cells that meet along two segments), the dual has hanging triangles and
 * non-manifold edges. One more site in such a cell mends it; so that the number of sites stays as
 * it was asked for, it is taken from where it matters least.
 */
#ifndef remesh_TopologyRepair_h
#define remesh_TopologyRepair_h

#include "Delaunay/Dual.h"
#include "Voronoi/CellSums.h"

namespace remesh
{
/**
 * For each defect of the dual, moves the site with the least energy, away from all defects, to the
 * point of the defect's cell that is farthest from its site.
 *
 * @return the number of sites moved; 0 where there are no defects, or so many (more than 1 % of the
 *         sites) that the points are too few for the shape.
 */
Index moveSitesToDefects(const EmbeddedSurface& surface, const Diagram& diagram,
  const Components& components, const Dual& dual, const CellSums& sums, Sites& sites);

/**
 * Brings the number of the mesh's vertices to what was asked for: takes away the free sites with
 * the least energy, away from defects, or adds sites where cells have the most.
 *
 * @param wanted vertices, sites on features (counted once) included.
 * @return the number of sites taken away or added; 0 where there is none to take.
 */
Index adjustNumber(const EmbeddedSurface& surface, const Diagram& diagram,
  const Components& components, const Dual& dual, const CellSums& sums, Offset wanted,
  Sites& sites);
}

#endif
