/**
 * @file SpareSites.h
 * @brief Which sites a patch can do without.
 *
 * A cell is of its site's own patch alone: a patch whose last site went would be covered by cells
 * of others, which would be no Voronoi cells, and be no part of the mesh. Patches with a border
 * have fixed sites there; those without get four sites at least (PatchSampling.h) and keep them.
 */
#ifndef remesh_SpareSites_h
#define remesh_SpareSites_h

#include "Embedding/EmbeddedSurface.h"

#include <map>

namespace remesh
{
class SpareSites
{
public:
  static constexpr Index minOfClosed = 4;

  /** O(n). The surface must outlive this. */
  SpareSites(const EmbeddedSurface& surface, const Sites& sites);

  /** Whether one more site of the patch of a place (of d coordinates) can go. */
  bool has(const double* site) const;
  /** If so, notes that it goes. */
  bool take(const double* site);

private:
  const PatchLattice& m_patches;
  std::map<Index, Index> m_spare; ///< of patches without fixed sites
};
}

#endif
