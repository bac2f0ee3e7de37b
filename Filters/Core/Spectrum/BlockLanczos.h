/**
 * @file BlockLanczos.h
 * @brief Eigenpairs of K x = lambda M x that are nearest to a shift.
 *
 * 1. Factor K - shift M = L D L'. The number of negative entries of D is the number of eigenvalues
 *    below the shift (Sylvester).
 * 2. Block Krylov basis of (K - shift M)^-1 M, orthonormal in M: each block is made orthogonal to
 * the last two, and then to all of the basis, by products of matrices. Eigenvalues that are equal
 * are found together.
 * 3. Rayleigh-Ritz: values theta give lambda = shift + 1 / theta, the largest |theta| first.
 *
 * Source: R. Grimes, J. Lewis, H. Simon, "A shifted block Lanczos algorithm for solving sparse
 * symmetric generalized eigenproblems", SIAM J. Matrix Anal. Appl., 1994.
 */
#ifndef remesh_BlockLanczos_h
#define remesh_BlockLanczos_h

#include "Spectrum/SurfaceLaplacian.h"
#include "Support/SparseFactor.h"

namespace remesh
{
/** Eigenvalues, ascending, and their functions: n x count, orthonormal in M. */
struct Eigenpairs
{
  std::vector<double> values;
  Eigen::MatrixXd functions;
};

/** All those from `low` to `high`, and only those. */
struct FoundBand
{
  Eigenpairs pairs;
  double low = 0.0;
  double high = 0.0;
};

class ShiftedLaplacian
{
public:
  /** The Laplacian must outlive it. Orders the unknowns, once for all shifts. */
  explicit ShiftedLaplacian(const SurfaceLaplacian& laplacian);

  /**
   * Factors for a shift, or one next to it where that is an eigenvalue.
   * @return Cancelled, or InvalidInput where no shift nearby can be factored.
   */
  Status factor(double shift, const RunControl& control);

  double shift() const { return m_shift; }
  /** Exactly, but for rounding; constants count as eigenvalues 0. */
  Index eigenvaluesBelow() const { return m_below; }
  const SurfaceLaplacian& laplacian() const { return m_laplacian; }

  /** Columns of (K - shift M)^-1 right, in parallel. False when cancelled. */
  bool solve(
    const Eigen::MatrixXd& right, const RunControl& control, Eigen::MatrixXd& solution) const;

private:
  using Lower = SparseFactor::Matrix;

  const SurfaceLaplacian& m_laplacian;
  Lower m_stiffness; ///< lower triangles of equal patterns
  Lower m_mass;
  SparseFactor m_factor;
  double m_shift = 0.0;
  Index m_below = 0;
};

/**
 * The eigenpairs around the shift, without those of the constants: of a basis of so many vectors
 * those that have converged, nearest to the shift, with no other between them.
 *
 * @param known n x any, orthonormal in M: functions to leave out as well.
 * @param basis how many vectors it has.
 * @return false when cancelled. O(n basis^2), and as many solutions.
 */
bool findAround(const ShiftedLaplacian& shifted, const Eigen::MatrixXd& known, Index basis,
  const RunControl& control, FoundBand& band);
}

#endif
