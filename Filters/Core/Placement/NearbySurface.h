/**
 * @file NearbySurface.h
 * @brief The closest point of the surface among the facets of a few cells.
 */
#ifndef remesh_NearbySurface_h
#define remesh_NearbySurface_h

#include "Delaunay/SurfaceLocation.h"
#include "Mesh/BoxTree.h"
#include "Placement/NormalCones.h"
#include "Placement/PlacementProblem.h"
#include "Placement/WholeSurface.h"
#include "Support/RunControl.h"

#include <memory>
#include <vector>

namespace remesh
{
/** Which way a triangle faces. */
struct Facing
{
  /**
   * Cosine between its normal and that of the facet closest to its centroid, among those of the
   * cells of its vertices; -1 without a normal.
   */
  double cosine;
  /**
   * Where the whole surface is known, and `cosine` is not below 0: the least with its closest
   * facets, too; else `cosine`.
   */
  double least;
};

/**
 * Looks among the facets that the cells of given components meet: unlike a search over the whole
 * surface (WholeSurface.h), never on another sheet. A search among the p pieces of cells takes
 * O(log p) where the point is near them, and a pass over all p where they are few.
 */
class NearbySurface
{
public:
  /**
   * @param minHeight unit of the points; triangles less high, and far less than long, have no
   *        normal.
   * @param control asked for cancellation; after a cancelled run nothing that is found is of use.
   * Cost: O(F + P), in parallel; 4 bytes a facet, and 4 a piece where cells have many.
   */
  NearbySurface(const PlacementProblem& problem, const RunControl& control, double minHeight = 0.0);

  /**
   * The same facets, but a triangle is inverted, too, where it faces against a facet of another
   * part of the surface that is closer to its centroid: of another sheet, or beyond a fold. Of
   * those that are as close, only if the closest point is on an edge of its own facet. O(1).
   */
  NearbySurface(const NearbySurface& own, const WholeSurface& whole);

  /** The closest point; its facet is noIndex without pieces. */
  SurfaceLocation closest(const Index* begin, const Index* end, const Point3& point) const;

  /** Its place; the point itself without pieces. */
  Point3 closestPoint(const Index* begin, const Index* end, const Point3& point) const;

  /**
   * The normal of the facet closest to a triangle's centroid, among those of the cells of its three
   * vertices; zero without pieces.
   */
  Point3 normalNear(const Triple& components, const std::array<Point3, 3>& corners) const;

  Facing facingOf(const Triple& components, const std::array<Point3, 3>& corners) const;
  bool isInverted(const Triple& components, const std::array<Point3, 3>& corners) const
  {
    return this->facingOf(components, corners).least < 0.0;
  }
  /** The same, without a look for the closest facet where all that may be it face along. */
  bool isInverted(
    const Triple& components, const std::array<Point3, 3>& corners, const NormalCones& cones) const;
  const PlacementProblem& problem() const { return m_problem; }

private:
  SurfaceLocation locationNear(
    const Triple& components, const std::array<Point3, 3>& corners) const;
  Point3 positionOf(const SurfaceLocation& at) const;
  Point3 normalOf(Index facet) const;
  /** Whether a triangle's corners are all but collinear. */
  bool isFlat(const std::array<Point3, 3>& corners) const;

  const PlacementProblem& m_problem;
  double m_leastHeight;
  const WholeSurface* m_whole = nullptr;

  /** What rules facets out. */
  struct Bounds
  {
    std::vector<float> reach; ///< F, at least the distance from a facet's first point to others
    BoxTree boxes;            ///< of runs of `leafSize` entries of `Components::pieces`
  };
  static constexpr Index leafSize = 16;
  std::shared_ptr<const Bounds> m_bounds;
};
}

#endif
