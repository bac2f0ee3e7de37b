/**
 * @file TriangleTree.h
 * @brief The closest point of a whole surface to a point of R^3.
 *
 * A tree of bounding boxes over the triangles in the order of a Hilbert curve. Not a locator of
 * VTK's: those sort with the back-end at hand, and which of two triangles that share the closest
 * point they find then depends on it.
 */
#ifndef remesh_TriangleTree_h
#define remesh_TriangleTree_h

#include "Mesh/ClosestPoint.h"
#include "Support/RunControl.h"
#include "Support/Types.h"

#include <algorithm>
#include <vector>

namespace remesh
{
/** Triangles as they stand in the caller's data; nothing is merged or turned. */
struct Triangles
{
  const std::vector<Point3>& points;    ///< P, in R^3
  const std::vector<Triple>& triangles; ///< T x 3, ids into `points`

  Offset count() const { return static_cast<Offset>(this->triangles.size()); }
  std::array<Point3, 3> corners(Offset triangle) const
  {
    const auto& [a, b, c] = this->triangles[triangle];
    return { this->points[a], this->points[b], this->points[c] };
  }
};

class TriangleTree
{
public:
  /** A place of the surface. */
  struct Place
  {
    Index slot = noIndex; ///< the triangle's number within the tree; noIndex: nothing found
    ClosestPoint at = { { 0.0, 0.0, 0.0 }, std::numeric_limits<double>::infinity() };
  };

  /**
   * Triangles without area (see `hasArea`) are left out: the tree may be empty. The points must be
   * finite, and within `largestCoordinate` (Mesh/Intake.h).
   *
   * @param control asked for cancellation; the tree of a cancelled run is of no use.
   * Cost: O(T), in parallel but for the boxes' joining. About 100 bytes per triangle. The tree
   * holds all it needs.
   */
  explicit TriangleTree(const Triangles& surface, const RunControl& control = RunControl());

  bool empty() const { return m_ids.empty(); }

  /**
   * The closest place of the surface. Where several triangles are as close, one of them: the
   * same whatever the threads, but no particular one (see `visitWithin`).
   *
   * @param hint the slot of a triangle that may be close, as found for a point nearby: saves time.
   * Cost: O(log T) where the surface is not about equally far everywhere. From any thread.
   */
  Place closest(const Point3& point, Index hint = noIndex) const;

  /** Calls `visit(Place)` for each triangle no further than the root of `squaredRadius`. */
  template <class Visit>
  void visitWithin(const Point3& point, double squaredRadius, const Visit& visit) const;

  /** The closest place of one triangle of the tree. */
  Place closestOn(Index slot, const Point3& point) const;

  Index triangleOf(Index slot) const { return m_ids[slot]; } ///< the caller's id
  const std::array<Point3, 3>& cornersOf(Index slot) const { return m_corners[slot]; }
  Point3 positionOf(const Place& place) const
  {
    const std::array<Point3, 3>& p = m_corners[place.slot];
    return place.at.b[0] * p[0] + place.at.b[1] * p[1] + place.at.b[2] * p[2];
  }

private:
  static constexpr Index leafSize = 4;

  struct Box
  {
    Point3 lower;
    Point3 upper;

    double squaredDistance(const Point3& point) const
    {
      return (this->lower - point).cwiseMax(point - this->upper).cwiseMax(0.0).squaredNorm();
    }
  };

  /** A node over the leaves [begin, end): its children follow it, first the one over [begin,
   * middle). */
  struct Node
  {
    Index box;
    Index begin;
    Index end;
    double squaredDistance;

    bool isLeaf() const { return this->end - this->begin == 1; }
  };

  Box joinBoxes(Index box, Index begin, Index end);
  void children(const Node& node, const Point3& point, Node (&found)[2]) const;
  Node root(const Point3& point) const;

  /** Deep enough for any tree: one node waits on each level. */
  struct Stack
  {
    Node nodes[64];
    int size = 0;

    void push(const Node& node) { this->nodes[this->size++] = node; }
    Node pop() { return this->nodes[--this->size]; }
  };

  std::vector<Index> m_ids;                     ///< S, the caller's triangles
  std::vector<std::array<Point3, 3>> m_corners; ///< S
  std::vector<Box> m_boxes;                     ///< of the nodes, depth first
};

template <class Visit>
void TriangleTree::visitWithin(const Point3& point, double squaredRadius, const Visit& visit) const
{
  if (this->empty())
  {
    return;
  }
  Stack stack;
  stack.push(this->root(point));
  while (stack.size > 0)
  {
    const Node node = stack.pop();
    if (node.squaredDistance > squaredRadius)
    {
      continue;
    }
    if (!node.isLeaf())
    {
      Node found[2];
      this->children(node, point, found);
      stack.push(found[1]);
      stack.push(found[0]);
      continue;
    }
    const auto end = std::min<Index>((node.begin + 1) * leafSize, static_cast<Index>(m_ids.size()));
    for (Index slot = node.begin * leafSize; slot < end; ++slot)
    {
      const Place place = this->closestOn(slot, point);
      if (place.at.squared <= squaredRadius)
      {
        visit(place);
      }
    }
  }
}
}

#endif
