#include "Adaptors/MemoryCheck.h"

#include "Optimization/QuasiNewton.h"

#include "vtksys/SystemInformation.hxx"

#include <cmath>
#include <string>

namespace remesh
{
namespace
{
/** Vectors of n x d doubles that a run holds at once: sites, trial, direction, two moments, tree.
 */
constexpr double vectors = 6.0;
/** Neighbour list, cell sums, owners and the like: bytes per site. */
constexpr double otherBytes = 600.0;
}

Status checkMemory(Offset numberOfSites, int dimension, int historyLength)
{
  const double perCoordinate = vectors * sizeof(double) + historyBytes * (historyLength + 1);
  const double needed =
    static_cast<double>(numberOfSites) * (dimension * perCoordinate + otherBytes);
  vtksys::SystemInformation system;
  const double total = static_cast<double>(system.GetHostMemoryTotal()) * 1024.0;
  if (!(total > 0.0) || needed <= total)
  {
    return Status::success();
  }
  const auto gigabytes = [](double bytes)
  { return std::to_string(static_cast<Offset>(std::ceil(bytes / 1e9))); };
  return { StatusCode::OutOfMemory,
    std::to_string(numberOfSites) + " points in " + std::to_string(dimension) +
      " dimensions need about " + gigabytes(needed) + " GB of memory; this machine has " +
      gigabytes(total) + "." };
}
}
