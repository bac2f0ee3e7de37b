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

  /** Of a facet that was not split. */
  static FacetOrigin whole(Index facet)
  {
    return { facet, { { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } } };
  }
  bool isWhole() const { return this->corners == whole(this->facet).corners; }

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

/** The same for all facets, as it is kept: most were not split, and take four bytes. */
class FacetOrigins
{
public:
  FacetOrigins() = default;
  explicit FacetOrigins(const std::vector<FacetOrigin>& origins);

  std::size_t size() const { return m_facets.size(); }
  FacetOrigin operator[](std::size_t facet) const
  {
    const Index at = m_facets[facet];
    return at >= 0 ? FacetOrigin::whole(at) : m_parts[-1 - at];
  }

private:
  std::vector<Index> m_facets; ///< F, the facet before; or -1 - k for the k-th part
  std::vector<FacetOrigin> m_parts;
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
  const FacetOrigins& origins, const CornerCoordinates& coordinates);
}

#endif
