/**
 * @file RepairedMesh.h
 * @brief A mesh that repairs change: what its triangles cost, and which edges may flip.
 */
#ifndef remesh_RepairedMesh_h
#define remesh_RepairedMesh_h

#include "Placement/NearbySurface.h"
#include "Placement/PlacementProblem.h"

#include <map>
#include <set>

namespace remesh
{
/** Cost of a stray. More than a star of triangles can cost that face the right way. */
constexpr double strayCost = 1000.0;
/** Cost of an inverted triangle. More than a star of strays can cost. */
constexpr double invertedCost = 100.0 * strayCost;

class RepairedMesh
{
public:
  /**
   * @param shapes K, positions; triangles are to keep about the shapes they have there.
   * @param triangles, positions the mesh: changed in place. All must outlive it.
   */
  RepairedMesh(const PlacementProblem& problem, const NearbySurface& surface,
    const std::vector<Point3>& shapes, std::vector<Triple>& triangles,
    std::vector<Point3>& positions);

  /** The triangles around a vertex, ascending. */
  std::vector<Index> star(Index vertex) const;
  /** The other vertices of the triangles of a star, each once, ascending. */
  std::vector<Index> neighbours(Index vertex) const;
  /** The point closest to a place on the cells of a vertex and of its neighbours. */
  Point3 onSurface(Index vertex, const Point3& place) const;

  /** Whether it is inverted, or a stray if the surface is a whole one (NearbySurface.h). */
  bool isInverted(const Triple& triangle) const;
  /**
   * How bad a triangle is: its deviation from the surface's normal, from 0 to 2, and a little for
   * its deviation from the shape in `shapes`. A stray or an inverted triangle costs far more.
   */
  double cost(const Triple& triangle) const;
  /** The sum over some triangles. */
  double costOfStar(const std::vector<Index>& star) const;

  /** Two triangles, and the two that have the same four vertices and the other diagonal. */
  struct EdgeFlip
  {
    std::array<Index, 2> old;    ///< numbers of the triangles
    std::array<Triple, 2> fresh; ///< corners that they get
  };

  /**
   * Whether the edge opposite to corner k of a triangle can be flipped: the topology must stay, and
   * no edge of a feature may be lost.
   *
   * @param flip is what `apply` takes, if it can.
   */
  bool canFlip(Index triangle, int k, EdgeFlip& flip) const;

  /** Flips an edge, and brings the stars up to date. To undo it, apply the opposite flip. */
  void apply(const EdgeFlip& flip);

  /**
   * The triangle on the other side of the edge opposite to corner k of a triangle. noIndex if the
   * edge is a feature's or the border's, has more than two triangles, or if the other triangle is
   * oriented the other way.
   */
  Index beyond(Index triangle, int k) const;

  /** Replaces triangles by as many others, and brings the stars up to date. */
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
  std::map<Index, std::vector<Index>> m_changedStars; ///< of vertices where triangles were replaced
  std::set<std::pair<Index, Index>> m_featureEdges;   ///< lower vertex first
};
}

#endif
