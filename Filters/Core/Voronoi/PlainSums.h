/**
 * @file PlainSums.h
 * @brief Masses and energies of the cells where a density weighted the optimisation, without it.
 */
#ifndef remesh_PlainSums_h
#define remesh_PlainSums_h

#include "Support/RunControl.h"
#include "Support/Status.h"
#include "Voronoi/CellSums.h"
#include "Voronoi/Diagram.h"

namespace remesh
{
/** In scaled units. */
struct PlainSums
{
  std::vector<double> mass;   ///< area in R^d
  std::vector<double> energy; ///< integral of |x - x_i|^2
  std::vector<double> moment; ///< x d, integral of x - x_i; of sites only
};

/**
 * Sums over the pieces of each site's cell.
 *
 * @return Cancelled, or success. Cost: O(P d), in one thread.
 */
Status sumSitesPlainly(const EmbeddedSurface& surface, const Sites& sites, const Diagram& diagram,
  const RunControl& control, PlainSums& sums);

/** Mass and energy of groups of pieces. @param groups P, the group of each piece. */
Status sumGroupsPlainly(const EmbeddedSurface& surface, const Diagram& diagram,
  const std::vector<Index>& groups, Index count, const RunControl& control, PlainSums& sums);
}

#endif
