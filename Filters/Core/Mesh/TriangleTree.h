/**
 * @file TriangleTree.h
 * @brief The closest point of a whole surface to a point of R^3, and triangles that may meet.
 *
 * A tree of bounding boxes (BoxTree.h) over the triangles in the order of a Hilbert curve.
 * Not a locator of VTK's: those sort with the back-end at hand, and which of two triangles that
 * share the closest point they find then depends on it.
 */
#ifndef remesh_TriangleTree_h
#define remesh_TriangleTree_h

#include "Mesh/BoxTree.h"
#include "Mesh/ClosestPoint.h"
#include "Mesh/PointPacket.h"
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
   * Cost: O(T), in parallel. About 32 bytes per triangle. The points and triangles are not copied:
   * they must outlive the tree. What is found of triangles that have changed since is of no use.
   */
  explicit TriangleTree(const Triangles& surface, const RunControl& control = RunControl());

  bool empty() const { return m_ids.empty(); }
  Index size() const { return static_cast<Index>(m_ids.size()); } ///< of triangles with area

  /**
   * The closest place of the surface. Where several triangles are as close, one of them: the
   * same whatever the threads, but no particular one (see `findClosest`).
   *
   * @param hint the slot of a triangle that may be close, as found for a point nearby: saves time.
   * Cost: O(log T) where the surface is not about equally far everywhere. From any thread.
   */
  Place closest(const Point3& point, Index hint = noIndex) const;

  /** Points that are searched for together, and what was found. */
  struct Packet
  {
    PointPacket points; ///< all `lanes` of them: repeat one where there are fewer
    Index slots[lanes]; ///< of the closest triangles; before, of some that may be close, or noIndex
  };

  /**
   * The closest triangles, and the squared distances, of several points, in half the time of as
   * many single searches if they are near each other. Rounded otherwise: of two triangles that are
   * as close up to rounding another one may be found.
   *
   * @param packet its distances are set, whatever they were; slots are noIndex in an empty tree.
   */
  void findClosest(Packet& packet) const;

  /** Of distances: what counts as equally close. */
  struct Tolerance
  {
    double relative; ///< of the least distance
    double absolute; ///< in the unit of the points
  };

  /**
   * The place on each triangle that is as close as the closest one: no further than
   * (1 + relative) of its distance + absolute.
   *
   * @param squared the squared distance of a triangle that may be close, or infinity: saves time.
   * @param places in no particular order; empty if the tree is. Replaced.
   * Cost: that of `closest`, and of the places.
   */
  void findClosest(const Point3& point, const Tolerance& tolerance, double squared,
    std::vector<Place>& places) const;

  /**
   * The slots of all triangles within a distance of a point, and of a few others near them; in no
   * particular order, but the same whatever the threads. Replaced. From any thread.
   */
  void findWithin(const Point3& point, double distance, std::vector<Index>& slots) const;

  /** The triangles are in so many groups of neighbours. */
  Index numberOfGroups() const { return m_boxes.empty() ? 0 : m_boxes.nodes(0); }

  /**
   * Calls `visit(slot, other)` for the triangles of a group and all later ones in the tree that
   * may meet them, for each pair once if it is called for all groups. From any thread.
   *
   * @param groups scratch.
   * Cost: O(log T) for the group, where triangles are about as large as those nearby.
   */
  template <class Visit>
  void visitMeeting(Index group, std::vector<Index>& groups, const Visit& visit) const
  {
    this->findGroups(group, groups);
    const Index last = std::min(this->size(), (group + 1) * groupSize);
    for (Index slot = group * groupSize; slot < last; ++slot)
    {
      const auto [a, b, c] = this->cornersOf(slot);
      const Point3 lower = a.cwiseMin(b).cwiseMin(c);
      const Point3 upper = a.cwiseMax(b).cwiseMax(c);
      for (const Index near : groups)
      {
        unsigned leaves = m_meet({ m_boxes.node(0, near), lower.data(), upper.data() });
        for (; leaves != 0; leaves &= leaves - 1)
        {
          const Index first = near * groupSize + __builtin_ctz(leaves) * leafSize;
          const Index end = std::min(this->size(), first + leafSize);
          for (Index other = std::max(first, slot + 1); other < end; ++other)
          {
            visit(slot, other);
          }
        }
      }
    }
  }

  /** The closest place of one triangle of the tree. */
  Place closestOn(Index slot, const Point3& point) const;

  Index triangleOf(Index slot) const { return m_ids[slot]; } ///< the caller's id
  std::array<Point3, 3> cornersOf(Index slot) const { return m_surface.corners(m_ids[slot]); }
  Point3 positionOf(const Place& place) const
  {
    const std::array<Point3, 3> p = this->cornersOf(place.slot);
    return place.at.b[0] * p[0] + place.at.b[1] * p[1] + place.at.b[2] * p[2];
  }

private:
  static constexpr Index leafSize = 2;
  static constexpr Index groupSize = lanes * leafSize;
  using Pending = BoxTree::Pending;

  Index leaves() const { return static_cast<Index>((m_ids.size() + leafSize - 1) / leafSize); }
  void findGroups(Index group, std::vector<Index>& groups) const;

  /** Calls `visit(slot)` for the triangles of all leaves that are in reach (BoxTree.h). */
  template <class Reaches, class Visit>
  void visitLeaves(const Point3& point, const Reaches& reaches, const Visit& visit) const;

  /** Puts the children that some point may be nearer to than known on the stack, nearest last. */
  int pushChildren(const Packet& packet, const Point3 (&box)[2], const Pending& node,
    Pending* pending, int size) const;
  /** Whether some point may be nearer to a node, not the root, than known. */
  bool isInReach(const Packet& packet, const Pending& node) const;
  void takeCloser(Index slot, Packet& packet) const;
  /** Of the triangles that may be close; returns these. */
  std::array<Index, lanes> takeHints(Packet& packet) const;

  Triangles m_surface;
  std::vector<Index> m_ids; ///< S, the caller's triangles
  BoxTree m_boxes;
  BoxMeetingEvaluation m_meet = boxMeetingEvaluation(widestInstructionSet());
  PacketGroupEvaluation m_packetGroup = packetGroupEvaluation(widestInstructionSet());
  PacketBoxEvaluation m_packetBox = packetBoxEvaluation(widestInstructionSet());
  PacketPlaceEvaluation m_packetPlaces = packetPlaceEvaluation(widestInstructionSet());
};
}

#endif
