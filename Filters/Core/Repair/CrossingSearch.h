/**
 * @file CrossingSearch.h
 * @brief Finds triangles of a mesh that go through each other, while a few of them change.
 */
#ifndef remesh_CrossingSearch_h
#define remesh_CrossingSearch_h

#include "Mesh/TriangleTree.h"
#include "Support/RunControl.h"
#include "Support/Status.h"

#include <array>
#include <utility>
#include <vector>

namespace remesh
{
/**
 * Whether an edge of one triangle passes through the inside of the other. Not of those with a
 * common edge, and not within a common plane; where they touch, rounding may decide.
 *
 * @param first, second ids of the corners, that tell which are common.
 */
bool areCrossing(const Triple& first, const Triple& second, const std::vector<Point3>& positions);

/**
 * Triangles are looked up where they are when the search is made; those that have changed since
 * must be named, and are tried one by one: these are to be few.
 */
class CrossingSearch
{
public:
  using Pairs = std::vector<std::pair<Index, Index>>;

  /** @param triangles, positions are read in later calls, as they are then. O(T), in parallel. */
  CrossingSearch(const std::vector<Triple>& triangles, const std::vector<Point3>& positions,
    const RunControl& control);

  /**
   * All pairs, the lower number first, ascending.
   *
   * @return Cancelled; then `pairs` is of no use.
   * Cost: O(T log T) where triangles are about as large as those nearby; in parallel.
   */
  Status find(const RunControl& control, Pairs& pairs) const;

  /** How many triangles go through this one; without those without area, unless they changed. */
  Offset count(Index triangle) const;

  /** The triangle changes now, or from now on. */
  void setChanged(Index triangle);

private:
  bool findInTree(
    const std::vector<char>& isInTree, const RunControl& control, std::vector<Pairs>& found) const;
  bool findOthers(
    const std::vector<char>& isInTree, const RunControl& control, std::vector<Pairs>& found) const;
  /** Those that go through a triangle. */
  template <class Visit>
  void visitCrossing(Index triangle, std::vector<Index>& slots, const Visit& visit) const;

  const std::vector<Triple>& m_triangles;
  const std::vector<Point3>& m_positions;
  TriangleTree m_tree;
  std::vector<char> m_hasChanged; ///< T
  std::vector<Index> m_changed;
};
}

#endif
