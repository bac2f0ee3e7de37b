/**
 * @file SpectralEmbedding.h
 * @brief Places in R^d by eigenfunctions: their distances are those of a kernel.
 */
#ifndef remesh_SpectralEmbedding_h
#define remesh_SpectralEmbedding_h

#include "Spectrum/Eigenfunctions.h"

namespace remesh
{
/** What an eigenfunction of the eigenvalue lambda is multiplied by. */
enum class SpectralScaling
{
  None,        ///< 1
  CommuteTime, ///< lambda^(-1/2): distances are those of a random walk there and back
  Diffusion,   ///< exp(-t lambda): of heat after the time t
  Biharmonic   ///< 1 / lambda
};

struct SpectralOptions
{
  Index dimension = 6; ///< d, from 1 to the unknowns less the constants
  SpectralScaling scaling = SpectralScaling::CommuteTime;
  double time = 0.0; ///< of diffusion, length^2
  MassMatrix mass = MassMatrix::Lumped;
  BorderCondition border = BorderCondition::Natural;
};

struct SpectralEmbedding
{
  std::vector<double> eigenvalues; ///< d, ascending, 1 / length^2
  /** unknowns x d, scaled. */
  Eigen::MatrixXd functions;
  std::vector<Index> unknowns; ///< V, the row of each point; noIndex: all 0
};

/** @return Cancelled, or InvalidInput where there are not so many functions, or no finite ones. */
Status embedSpectrally(const SurfaceMesh& mesh, const SpectralOptions& options,
  const RunControl& control, SpectralEmbedding& embedding);
}

#endif
