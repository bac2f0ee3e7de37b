/**
 * @file EmbeddedSurface.h
 * @brief The surface in R^d: what the Voronoi and optimisation stages work on.
 *
 * These stages know d and never what the coordinates mean. Coordinates are centred and scaled by a
 * power of two (exact), so that they are at most 1 in size; `toCaller` undoes it.
 */
#ifndef remesh_EmbeddedSurface_h
#define remesh_EmbeddedSurface_h

#include "Mesh/SurfaceMesh.h"

namespace remesh
{
/** What does not change about a facet while the sites move. */
struct FacetConstants
{
  double mass = 0.0;                   ///< area in R^d
  double area = 0.0;                   ///< area in R^3, in the unit of the points
  double radius = 0.0;                 ///< largest distance from the centre to a corner, in R^d
  double edge2[3] = { 0.0, 0.0, 0.0 }; ///< squared length in R^d of edge k, corners k, k + 1
};

struct EmbeddedSurface
{
  int dimension = 0;
  std::vector<double> corners;           ///< C x d, centred and scaled
  std::vector<Triple> facetCorners;      ///< F x 3
  std::vector<FacetConstants> constants; ///< F
  std::vector<double> center;            ///< d, in the caller's units
  double unit = 1.0;                     ///< the caller's units per scaled unit, a power of two
  double mass = 0.0;                     ///< sum of the facets' masses, scaled units

  Index numberOfFacets() const { return static_cast<Index>(this->facetCorners.size()); }
  Index numberOfCorners() const
  {
    return static_cast<Index>(this->corners.size() / static_cast<std::size_t>(this->dimension));
  }
  const double* corner(Index id) const
  {
    return this->corners.data() + static_cast<std::size_t>(id) * this->dimension;
  }

  /** Coordinate k of a point, in the caller's units. */
  double toCaller(double scaled, int k) const { return scaled * this->unit + this->center[k]; }
  double toScaled(double coordinate, int k) const
  {
    return (coordinate - this->center[k]) / this->unit;
  }
};

/** n points of R^d, row by row, in the scaled units of an EmbeddedSurface. */
struct Sites
{
  int dimension = 0;
  std::vector<double> coordinates; ///< n x d

  Index count() const
  {
    return this->dimension > 0
      ? static_cast<Index>(this->coordinates.size() / static_cast<std::size_t>(this->dimension))
      : 0;
  }
  const double* site(Index id) const
  {
    return this->coordinates.data() + static_cast<std::size_t>(id) * this->dimension;
  }
  double* site(Index id)
  {
    return this->coordinates.data() + static_cast<std::size_t>(id) * this->dimension;
  }
};
}

#endif
