/**
 * @file Eigenfunctions.h
 * @brief The first eigenfunctions of a surface's Laplacian, from a few to thousands.
 *
 * 1. Small problems: by a dense matrix.
 * 2. Others band by band [Vallet08]: a shift in the middle of the next band, and all eigenpairs
 *    around it by block Lanczos (BlockLanczos.h). Bands overlap, and are joined in a gap.
 * 3. A factor at the band's end tells how many eigenvalues are below. Those that are missing, as of
 *    many equal ones, are sought again without what was found; so all are there.
 *
 * Source: B. Vallet, B. Levy, "Spectral geometry processing with manifold harmonics", 2008.
 * [Vallet08]
 * Cost: for d functions of n points O(d) solutions with factors, O(n) dense work for each, and two
 * factors for some 140 functions; memory n d doubles, and some 600 n beside. (measured, a torus of
 * 100 000 triangles: d = 1000 in 50 s of processor time, d = 5000 in 255 s and 2.2 GB.)
 */
#ifndef remesh_Eigenfunctions_h
#define remesh_Eigenfunctions_h

#include "Spectrum/BlockLanczos.h"

namespace remesh
{
/**
 * The first eigenpairs but for the constants, deterministic: of each function the largest entry,
 * the first of equal ones, is positive. Functions of equal eigenvalues are some basis of theirs.
 *
 * @param count at most n less the number of constants.
 * @return Cancelled, or InvalidInput where the surface's triangles are too thin for numbers.
 */
Status findEigenfunctions(
  const SurfaceLaplacian& laplacian, Index count, const RunControl& control, Eigenpairs& pairs);
}

#endif
