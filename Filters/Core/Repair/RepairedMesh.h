/**
 * @file RepairedMesh.h
 * @brief A mesh while inverted triangles are turned back: how bad each is, and what may change.
 */
#ifndef remesh_RepairedMesh_h
#define remesh_RepairedMesh_h

#include "Placement/NearbySurface.h"
#include "Placement/PlacementProblem.h"

#include <map>
#include <set>

namespace remesh
{
/** Above all that the other costs of a star sum to. */
constexpr double strayCost = 1000.0; ///< of a triangle that faces other parts of the surface
constexpr double invertedCost = 100.0 * strayCost; ///< its own part: above that of a star of strays

class RepairedMesh
{
public:
  /**
   * @param shapes K, the positions whose triangles' shapes are to be kept, roughly.
   * @param triangles, positions are changed as the mesh is.
   */
  RepairedMesh(const PlacementProblem& problem, const NearbySurface& surface,
    const std::vector<Point3>& shapes, std::vector<Triple>& triangles,
    std::vector<Point3>& positions);

  /** The triangles around a vertex, ascending. */
  std::vector<Index> star(Index vertex) const;
  /** The other vertices of the triangles of a star, each once, ascending. */
  std::vector<Index> neighbours(Index vertex) const;
  /** The point of the surface closest to a place, among the cells of a vertex and its neighbours.
   */
  Point3 onSurface(Index vertex, const Point3& place) const;

  /** Against the surface (NearbySurface.h). */
  bool isInverted(const Triple& triangle) const;
  /** What a triangle deviates from the surface's normal and its shape; far more if it is inverted.
   */
  double cost(const Triple& triangle) const;
  double costOfStar(const std::vector<Index>& star) const;

  /** Two triangles, and those that share their four vertices with the other diagonal. */
  struct EdgeFlip
  {
    std::array<Index, 2> old;
    std::array<Triple, 2> fresh;
  };

  /**
   * Looks at the edge opposite to corner k of a triangle: whether it can be turned over with no
   * change of topology and no loss of a feature.
   */
  bool canFlip(Index triangle, int k, EdgeFlip& flip) const;

  /** Replaces the two triangles; their stars follow. */
  void apply(const EdgeFlip& flip);

  /**
   * The triangle on the other side of the edge opposite to corner k of a triangle; noIndex where
   * that is a feature, or there is not just one other, or it turns the other way.
   */
  Index beyond(Index triangle, int k) const;

  /** Puts triangles in the place of as many others; the stars follow. */
  void replace(const std::vector<Index>& old, const std::vector<Triple>& fresh);

  const std::vector<Triple>& triangles() const { return m_triangles; }
  const std::vector<Point3>& positions() const { return m_positions; }
  std::vector<Point3>& positions() { return m_positions; }

private:
  Index acrossEdge(Index triangle, Index a, Index b) const;
  bool mayLose(Index vertex) const;

  const NearbySurface& m_surface;
  const std::vector<Point3>& m_shapes;
  std::vector<Triple>& m_triangles;
  std::vector<Point3>& m_positions;
  VertexStars m_stars;
  std::map<Index, std::vector<Index>> m_changedStars; ///< where edges have been turned
  std::set<std::pair<Index, Index>> m_featureEdges;   ///< lower vertex first
};
}

#endif
