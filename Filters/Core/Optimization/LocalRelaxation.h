/**
 * @file LocalRelaxation.h
 * @brief Lloyd's steps for the sites around a few places, on the part of the surface there.
 */
#ifndef remesh_LocalRelaxation_h
#define remesh_LocalRelaxation_h

#include "Support/RunControl.h"
#include "Support/Status.h"
#include "Voronoi/SiteChanges.h"
#include "Voronoi/VertexPlaces.h"

#include <cstdint>

namespace remesh
{
struct LloydSteps
{
  int number;
  std::uint64_t seed; ///< of the places where sites come that lose their cells
};

/**
 * Lloyd's steps ([Levy12], Algorithm 3) of the free sites within about two rings of cells around
 * the places of the changes; all others stay. They see the part of the surface that the cells
 * within four rings cover.
 *
 * @param earlier sites with their diagram.
 * @param changes from `earlier` to `later`.
 * @param later its sites move.
 * Cost: that of the steps on that part, and O(n log n + pieces).
 */
Status relaxAround(const VertexPlaces& earlier, const SiteChanges& changes, const LloydSteps& steps,
  const RunControl& control, Sites& later);
}

#endif
