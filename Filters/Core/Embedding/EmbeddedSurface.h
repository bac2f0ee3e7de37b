/**
 * @file EmbeddedSurface.h
 * @brief The surface in R^d: what the Voronoi and optimisation stages work on.
 *
 * These stages know d and never what the coordinates mean. Coordinates are centred and scaled by a
 * power of two (exact), so that they are at most 1 in size, and patches are put apart; `toCaller`
 * undoes it.
 *
 * A surface of many dimensions may read its coordinates from the caller's arrays (`source`) instead
 * of holding them; CornerReader gives the same values, to the bit, either way.
 */
#ifndef remesh_EmbeddedSurface_h
#define remesh_EmbeddedSurface_h

#include "Embedding/CornerCoordinates.h"
#include "Embedding/PatchLattice.h"
#include "Mesh/SurfaceMesh.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
/** What does not change about a facet while the sites move. */
struct FacetConstants
{
  double mass = 0.0;                   ///< density times area in R^d
  double edge2[3] = { 0.0, 0.0, 0.0 }; ///< squared length in R^d of edge k, corners k, k + 1

  /** Largest distance from the centre to a corner, in R^d, up to rounding. */
  double radius() const
  {
    // Medians: (2 a^2 + 2 b^2 - c^2) / 9 at a corner between edges of lengths a and b.
    const auto& [a, b, c] = this->edge2;
    return std::sqrt(2.0 * (a + b + c) - 3.0 * std::min({ a, b, c })) / 3.0;
  }
};

/**
 * From here on, coordinates are read as rarely as can be, and may be lent; surfaces of fewer
 * dimensions hold theirs, as a copy is small, and reading it is what the time goes into.
 */
constexpr int manyDimensions = 64;

struct EmbeddedSurface
{
  int dimension = 0;
  PatchLattice patches;                  ///< where they are put, see separatePatches
  std::vector<double> corners;           ///< C x d, centred and scaled; none where `source` lends
  CornerCoordinates source;              ///< empty where `corners` holds the coordinates
  SharedArray<Triple> facetCorners;      ///< F x 3, the mesh's
  std::vector<FacetConstants> constants; ///< F
  std::vector<double> densities;         ///< F, weights of the energy, see weightByDensity; or none
  std::vector<double> center;            ///< d, in the caller's units
  double unit = 1.0;                     ///< the caller's units per scaled unit, a power of two
  double mass = 0.0;                     ///< sum of the facets' masses, scaled units
  double siteMeasure = 0.0;              ///< the same of their site measures
  double densityUnit = 1.0;              ///< the caller's per scaled unit, a power of two

  Index numberOfFacets() const { return static_cast<Index>(this->facetCorners.size()); }
  Index numberOfCorners() const
  {
    return static_cast<Index>(this->source.isLent()
        ? this->source.rows.size()
        : this->corners.size() / static_cast<std::size_t>(this->dimension));
  }
  bool hasDensity() const { return !this->densities.empty(); }
  double density(Index facet) const { return this->hasDensity() ? this->densities[facet] : 1.0; }
  /** Area in R^d. */
  double embeddedArea(Index facet) const
  {
    return this->constants[facet].mass / this->density(facet);
  }
  /** What the sites of a centroidal Voronoi tessellation are spread evenly over, on a facet. */
  double siteMeasureOf(Index facet) const
  {
    return this->constants[facet].mass / std::sqrt(this->density(facet));
  }
  /** The same for lengths: they are evenly spaced in length times this. */
  double lengthScale(Index facet) const { return std::sqrt(std::sqrt(this->density(facet))); }

  /** Only where the surface holds its corners; CornerReader serves all surfaces. */
  const double* corner(Index id) const
  {
    return this->corners.data() + static_cast<std::size_t>(id) * this->dimension;
  }

  /** Coordinate k of a point of the first patch, in the caller's units. */
  double toCaller(double scaled, int k) const { return scaled * this->unit + this->center[k]; }
  /** The d coordinates of any point in the caller's units. */
  void toCaller(const double* scaled, double* coordinates) const
  {
    const Index patch = this->patches.patchOf(scaled);
    for (int k = 0; k < this->dimension; ++k)
    {
      coordinates[k] = this->toCaller(scaled[k] - this->patches.offset(patch, k), k);
    }
  }
  double toScaled(double coordinate, int k) const
  {
    return (coordinate - this->center[k]) / this->unit;
  }

  /** Row of a corner that `source` lends, centred and scaled (d values). */
  void readScaled(Index id, double* row) const
  {
    this->source.read(id, row);
    const double inverse = 1.0 / this->unit; // of a power of two: as exact as dividing
    for (int k = 0; k < this->dimension; ++k)
    {
      row[k] = (row[k] - this->center[k]) * inverse;
    }
  }
};

/** n points of R^d, row by row, in the scaled units of an EmbeddedSurface. */
struct Sites
{
  int dimension = 0;
  Index fixed = 0;                 ///< the first so many never move
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
