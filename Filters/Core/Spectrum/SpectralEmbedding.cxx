#include "Spectrum/SpectralEmbedding.h"

#include <cmath>
#include <string>
#include <utility>

namespace remesh
{
namespace
{
double factorOf(const SpectralOptions& options, double eigenvalue)
{
  switch (options.scaling)
  {
    case SpectralScaling::CommuteTime:
      return 1.0 / std::sqrt(eigenvalue);
    case SpectralScaling::Diffusion:
      return std::exp(-options.time * eigenvalue);
    case SpectralScaling::Biharmonic:
      return 1.0 / eigenvalue;
    default:
      return 1.0;
  }
}
}

Status embedSpectrally(const SurfaceMesh& mesh, const SpectralOptions& options,
  const RunControl& control, SpectralEmbedding& embedding)
{
  SurfaceLaplacian laplacian;
  Status status = buildLaplacian(mesh, options.mass, options.border, control, laplacian);
  if (!status.ok())
  {
    return status;
  }
  const Index most = laplacian.size - laplacian.numberOfConstants;
  if (options.dimension > most)
  {
    return Status::invalid("The surface has " + std::to_string(most) +
      " eigenfunctions beside constants, but " + std::to_string(options.dimension) +
      " are asked for.");
  }
  Eigenpairs pairs;
  status = findEigenfunctions(laplacian, options.dimension, control, pairs);
  if (!status.ok())
  {
    return status;
  }
  for (Index k = 0; k < options.dimension; ++k)
  {
    pairs.functions.col(k) *= factorOf(options, pairs.values[k]);
  }
  if (!pairs.functions.allFinite())
  {
    return Status::invalid("The eigenfunctions are not finite: the surface has triangles whose "
                           "angles are nothing but rounding. Remesh it first.");
  }
  embedding.eigenvalues = std::move(pairs.values);
  embedding.functions = std::move(pairs.functions);
  embedding.unknowns = std::move(laplacian.unknowns);
  return Status::success();
}
}
