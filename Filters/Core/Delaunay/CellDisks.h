/**
 * @file CellDisks.h
 * @brief Which components of the restricted cells are disks.
 */
#ifndef remesh_CellDisks_h
#define remesh_CellDisks_h

#include "Delaunay/Collar.h"
#include "Delaunay/FacetJoins.h"

namespace remesh
{
/** The cells of a diagram, as a complex of pieces. */
struct CellComplex
{
  const FacetJoins& joins;
  const Diagram& diagram;
  const Components& components;
  const Seams* seams = nullptr; ///< if there are features
};

/**
 * For each component, whether it is connected and has Euler characteristic 1, its stretches of the
 * collar included (see Certificate.h); at a pinch, whether all parts of it together have 1 for
 * each. That it borders on another one is left to the caller.
 *
 * @param cells on a surface with edges of two facets at most, and no point in two fans of facets.
 * @return Cancelled; then `isDisk` is of no use.
 * Cost: O(P) but for the look-up of pieces in their facets; in parallel.
 */
Status findDisks(const CellComplex& cells, const RunControl& control, std::vector<char>& isDisk);
}

#endif
