/**
 * @file SiteRevision.h
 * @brief Adds sites and takes others away, so that the mesh has the number of vertices wanted.
 */
#ifndef remesh_SiteRevision_h
#define remesh_SiteRevision_h

#include "Delaunay/TopologyRepair.h"

namespace remesh
{
/** For each of these sites, those with cells next to its cell; some repeatedly. O(K). */
std::vector<std::vector<Index>> neighborsOf(const std::vector<Index>& candidates,
  const Components& components, const Dual& dual, Index numberOfSites);

struct Revision
{
  Index added = 0; ///< the last sites there are
  Index removed = 0;
  Index removedLast = 0; ///< of them, of the last `addedBefore`
};

/** What a revision is to come to. */
struct RevisionGoal
{
  const Certificate& failures; ///< from which no sites are taken
  Offset wanted;               ///< vertices, sites on features (counted once) included
  Index addedBefore = 0;       ///< the last so many sites were added before
  /** Whether these stay, and those around them, but for such in the refinement. */
  bool keepAdded = true;
};

/**
 * Adds and takes away these sites, and brings the number of the mesh's vertices to what is wanted:
 * takes away the free sites with the least energy, as far as can be from failures, from where sites
 * were added before and from each other, or adds sites where cells have the most. No patch loses
 * sites that it cannot do without (SpareSites.h), though there be more vertices than wanted.
 *
 * @param diagram, sums of the sites as they are still.
 * @param refinement the last places are left out where there are not enough sites to take away.
 */
Revision reviseSites(const DiagramDual& diagram, const CellSums& sums, Refinement refinement,
  const RevisionGoal& goal, Sites& sites);
}

#endif
