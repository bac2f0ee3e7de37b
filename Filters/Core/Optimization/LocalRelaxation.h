/**
 * @file LocalRelaxation.h
 * @brief Lloyd's steps for the sites around a few places, on the part of the surface there.
 */
#ifndef remesh_LocalRelaxation_h
#define remesh_LocalRelaxation_h

#include "Support/RunControl.h"
#include "Support/Status.h"
#include "Voronoi/Diagram.h"
#include "Voronoi/SiteChanges.h"

#include <cstdint>

namespace remesh
{
/**
 * Lloyd's steps ([Levy12], Algorithm 3) of the free sites within about two rings of cells around
 * some places; all others stay. They see the part of the surface that the cells within four rings
 * cover.
 *
 * @param diagram of `earlier`.
 * @param changes from `earlier` to `later`.
 * @param places m x d.
 * @param later its sites move.
 * Cost: that of the steps on that part, and O(n log n + pieces).
 */
Status relaxAround(const EmbeddedSurface& surface, const Diagram& diagram, const Sites& earlier,
  const SiteChanges& changes, const std::vector<double>& places, int iterations,
  std::uint64_t seed, const RunControl& control, Sites& later);
}

#endif
