/**
 * @file Components.h
 * @brief Connected components of the restricted cells: the vertices of the dual.
 *
 * The dual over components instead of cells (the multi-nerve of B. Levy, Y. Liu, "Lp Centroidal
 * Voronoi Tessellation and its applications", 2010) keeps the two sides of a thin plate apart: a
 * cell that reaches both has two components, and each becomes a vertex of its own.
 */
#ifndef remesh_Components_h
#define remesh_Components_h

#include "Features/FeatureSites.h"
#include "Support/RunControl.h"
#include "Support/Status.h"
#include "Voronoi/VertexPlaces.h"

namespace remesh
{
struct Components
{
  std::vector<Index> ofPiece;     ///< P, component of each piece; or freed (Remesh.cxx)
  std::vector<Index> sites;       ///< K, ascending; the first of several copies
  std::vector<Index> ranks;       ///< K, 0, 1, ... among the components of the same site
  std::vector<Offset> pieceBegin; ///< K + 1, into `pieces`
  std::vector<Index> pieces;      ///< pieces of each component, ascending

  std::vector<double> mass;      ///< K, density times area in R^d, scaled units
  std::vector<double> area;      ///< K, area in R^3
  std::vector<double> energy;    ///< K, integral of density times |x - x_i|^2, scaled units
  std::vector<Point3> centroids; ///< K, centroid by mass, in R^3; feature points: their place
  std::vector<Index> apexes;     ///< that hold those of the surface (Features.h), or noIndex

  Index count() const { return static_cast<Index>(this->sites.size()); }
};

/** A diagram, and how the facets that it divides hang together. */
struct JoinedDiagram
{
  const SurfaceMesh& mesh;
  VertexPlaces places;
  const EdgeTable& edges;                 ///< of the surface as it is embedded
  const std::vector<Index>& owners;       ///< C, the site that owns each corner
  const FeatureSites* features = nullptr; ///< the sites on features, if there are any
};

/**
 * Pieces of a cell belong together where they share a segment of a facet's edge, or a corner.
 *
 * Pieces at which the copies of a feature's site sit belong together, too.
 *
 * Cost: O(P) in parallel, O(P) memory. Components are ordered by site, then by their first piece.
 */
Status findComponents(
  const JoinedDiagram& joined, const RunControl& control, Components& components);

/**
 * The component that holds each of these points of the surface (ascending), in the first facet
 * there with a piece of the point's owner; noIndex if there is none. O(F).
 */
std::vector<Index> componentsAt(
  const JoinedDiagram& joined, const std::vector<Index>& points, const Components& components);

/** Area in R^3 of the cells of n sites, unit of the points. Cost: O(P), in one thread. */
std::vector<double> measureCellAreas(
  const SurfaceMesh& mesh, const Diagram& diagram, Index numberOfSites);
}

#endif
