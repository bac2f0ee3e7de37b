/**
 * @file CoarseCells.h
 * @brief What the cells of a coarse tessellation tell about where more sites belong.
 */
#ifndef remesh_CoarseCells_h
#define remesh_CoarseCells_h

#include "Embedding/EmbeddedSurface.h"
#include "Support/RunControl.h"
#include "Support/Status.h"
#include "Voronoi/CellSums.h"
#include "Voronoi/Diagram.h"

#include <vector>

namespace remesh
{
/** A tessellation of the same surface with fewer sites. */
struct CoarseTessellation
{
  const Sites& sites;
  const CellSums& sums;
  const Diagram& diagram;
};

struct CoarseCells
{
  const Sites& sites;
  std::vector<Index> patches;                ///< n
  std::vector<std::vector<Index>> neighbors; ///< n, those of the same patch
  std::vector<double> due;                   ///< n, new sites for the cell's measure
  /** n, what squared lengths are multiplied with to compare spacings: 1 without a density. */
  std::vector<double> scales;
  /**
   * n, whether new sites can be put at the cell's site and in the middles between it and its
   * neighbours: it is about as flat as a hexagon and due to about as many, and none is fixed.
   */
  std::vector<char> grows;

  double distance2(Index a, Index b) const;
};

/** The patch that each site is in. */
std::vector<Index> patchesOf(const EmbeddedSurface& surface, const Sites& sites);

/**
 * @param wanted new free sites of each patch.
 * @return Cancelled.
 * Cost: O(P + n d) for P pieces.
 */
Status findCoarseCells(const EmbeddedSurface& surface, const CoarseTessellation& coarse,
  const std::vector<Offset>& wanted, const RunControl& control, CoarseCells& cells);
}

#endif
