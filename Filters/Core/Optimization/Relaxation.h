/**
 * @file Relaxation.h
 * @brief A tessellation on its way to a centroidal one.
 */
#ifndef remesh_Relaxation_h
#define remesh_Relaxation_h

#include "Optimization/Convergence.h"
#include "Voronoi/RestrictedVoronoi.h"

#include <cstdint>

namespace remesh
{
/** What all steps read and change. */
struct Relaxation
{
  RestrictedVoronoi& voronoi; ///< of `surface`
  const EmbeddedSurface& surface;
  std::uint64_t seed; ///< of the places where sites come that lose their cells
  Sites& sites;
  CellSums& sums; ///< of the cells of `sites`
  Convergence& convergence;
  Index& emptyCells; ///< free sites without mass
};
}

#endif
