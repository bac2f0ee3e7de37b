/**
 * @file CrossingSearch.h
 * @brief Finds triangles that go through each other, in a mesh of which a few triangles change.
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
 * Whether an edge of one triangle passes through the inside of the other. False if they have a
 * common edge, or lie in a common plane. Where they just touch, rounding may decide.
 *
 * @param first, second corners of the two triangles, as numbers into `positions`. Corners with the
 *        same number are common.
 */
bool areCrossing(const Triple& first, const Triple& second, const std::vector<Point3>& positions);

/**
 * The constructor puts all triangles into a tree. A triangle that changes later must be named
 * (`setChanged`): it is tried against each triangle asked about, without the tree. So few may
 * change.
 */
class CrossingSearch
{
public:
  using Pairs = std::vector<std::pair<Index, Index>>;

  /**
   * Cost: O(T), in parallel.
   *
   * @param triangles, positions must outlive it. Later calls read what is in them then.
   */
  CrossingSearch(const std::vector<Triple>& triangles, const std::vector<Point3>& positions,
    const RunControl& control);

  /**
   * Finds all pairs of triangles that cross: the lower number first, ascending.
   *
   * @return Cancelled; then `pairs` is of no use.
   * Cost: O(T log T) where triangles are about as large as those nearby; in parallel.
   */
  Status find(const RunControl& control, Pairs& pairs) const;

  const std::vector<Triple>& triangles() const { return m_triangles; }

  /** How many triangles go through this one. Those without an area count only if they changed. */
  Offset count(Index triangle) const;

  /** Must be called for a triangle before the first call that is to see its change. */
  void setChanged(Index triangle);

private:
  bool findInTree(
    const std::vector<char>& isInTree, const RunControl& control, std::vector<Pairs>& found) const;
  bool findOthers(
    const std::vector<char>& isInTree, const RunControl& control, std::vector<Pairs>& found) const;
  /** Calls `visit` with each triangle that goes through this one. */
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
