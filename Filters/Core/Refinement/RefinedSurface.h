/**
 * @file RefinedSurface.h
 * @brief A surface whose facets were split, and where each of them lies on the one it was before.
 *
 * Splits are at the middles of edges, so that barycentric coordinates of the new corners are exact
 * (multiples of 2^-k, k the number of splits, at most `maxSplits`). The places of middles are
 * rounded to doubles, alike for all facets around: the surface stays closed, and is off by no more
 * than that rounding.
 */
#ifndef remesh_RefinedSurface_h
#define remesh_RefinedSurface_h

#include "Embedding/CornerCoordinates.h"
#include "Features/Features.h"
#include "Mesh/SurfaceMesh.h"

#include <optional>

namespace remesh
{
/** Floats hold multiples of 2^-24 up to 1. */
constexpr int maxSplits = 24;

struct FacetOrigin
{
  Index facet; ///< of the surface before
  /** Barycentric coordinates there of this facet's corners. */
  std::array<std::array<float, 3>, 3> corners;

  /** Of a place on this facet, there. */
  std::array<double, 3> place(const double b[3]) const
  {
    std::array<double, 3> there{ 0.0, 0.0, 0.0 };
    for (int k = 0; k < 3; ++k)
    {
      for (int j = 0; j < 3; ++j)
      {
        there[j] += b[k] * static_cast<double>(this->corners[k][j]);
      }
    }
    return there;
  }
};

struct RefinedSurface
{
  /** Facets in the order of those they came from; `facetInputPoints` are none. */
  SurfaceMesh mesh;
  std::optional<Features> features; ///< the same ones, along split edges
  std::vector<FacetOrigin> origins; ///< F
};

/** Rows of the corners before, linearly in their facets; none is lent. */
CornerCoordinates interpolateCorners(const SurfaceMesh& before, const SurfaceMesh& refined,
  const std::vector<FacetOrigin>& origins, const CornerCoordinates& coordinates);
}

#endif
