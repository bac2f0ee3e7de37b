/**
 * @file BoxTree.h
 * @brief Bounding boxes of leaves, of eight neighbours among these each, and so on to the root.
 */
#ifndef remesh_BoxTree_h
#define remesh_BoxTree_h

#include "Mesh/BoxDistances.h"
#include "Support/Grouping.h"
#include "Support/RunControl.h"
#include "Support/Types.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace remesh
{
/**
 * Leaves are numbered; those with numbers near each other should be near each other in space. Node
 * k of level 0 has the leaves 8 k to 8 k + 7, and of level l the nodes of level l - 1 likewise.
 */
class BoxTree
{
public:
  /** A node or a leaf that is still to be looked into. */
  struct Pending
  {
    double squared; ///< distance of its box
    Index id;       ///< on its level
    int level;      ///< -1: a leaf
  };
  static constexpr int maxLevels = 11; ///< more than any number of leaves needs
  static constexpr int maxPending = (lanes - 1) * maxLevels + 1;

  BoxTree() = default;

  /**
   * @param boxOf `boxOf(leaf, lower, upper)` widens the box for what is in a leaf; from any thread.
   * @param control asked for cancellation; the tree of a cancelled run is empty.
   * Cost: O(leaves), in parallel; 55 bytes for each.
   */
  template <class BoxOf>
  BoxTree(Index leaves, const RunControl& control, const BoxOf& boxOf)
  {
    if (leaves == 0)
    {
      return;
    }
    bool goesOn = this->addLevel(leaves, control, boxOf);
    while (goesOn && m_levels.back().size() > 1)
    {
      goesOn = this->addLevel(static_cast<Index>(m_levels.back().size()), control,
        [&, below = m_levels.size() - 1](Index node, Point3& lower, Point3& upper)
        { widen(m_levels[below][node], lower, upper); });
    }
    if (!goesOn)
    {
      m_levels.clear();
    }
  }

  bool empty() const { return m_levels.empty(); }
  int levels() const { return static_cast<int>(m_levels.size()); }
  Pending root() const { return { 0.0, 0, this->levels() - 1 }; }
  Index nodes(int level) const { return static_cast<Index>(m_levels[level].size()); }

  /** The boxes of a node's children; a child that there is not has a box without a point. */
  const BoxGroup& node(int level, Index id) const { return m_levels[level][id]; }

  /** What a leaf or node is in, so many levels above it. */
  static Index ancestor(Index id, int levels)
  {
    static_assert(lanes == 8);
    return id >> (3 * levels);
  }

  /** Widens a box for all boxes of a group. */
  static void widen(const BoxGroup& boxes, Point3& lower, Point3& upper);

  /**
   * Calls `visit(leaf)` for all leaves from `first` to `last` that are in reach: `reaches` tells
   * that of the squared distance of a box, and may get stricter on the way. The nearest first, as a
   * rule. From any thread.
   */
  template <class Reaches, class Visit>
  void visitLeaves(
    Index first, Index last, const Point3& point, const Reaches& reaches, const Visit& visit) const
  {
    if (this->empty())
    {
      return;
    }
    int level = 0;
    while (ancestor(first, level + 1) != ancestor(last, level + 1))
    {
      ++level;
    }
    Pending pending[maxPending];
    int size = 0;
    pending[size++] = { 0.0, ancestor(first, level + 1), level };
    while (size > 0)
    {
      const Pending node = pending[--size];
      if (!reaches(node.squared))
      {
        continue;
      }
      if (node.level < 0)
      {
        visit(node.id);
        continue;
      }
      double squared[lanes];
      m_distances({ m_levels[node.level][node.id], point.data(), squared });
      const int bottom = size;
      const Index begin = std::max(ancestor(first, node.level), node.id * lanes);
      const Index end = std::min(ancestor(last, node.level), node.id * lanes + lanes - 1) + 1;
      for (Index child = begin; child < end; ++child)
      {
        if (const double distance2 = squared[child - node.id * lanes]; reaches(distance2))
        {
          size = insert({ distance2, child, node.level - 1 }, bottom, pending, size);
        }
      }
    }
  }

  /** Puts a node among those from `bottom` on, the nearest of which is last. Returns the size. */
  static int insert(const Pending& node, int bottom, Pending* pending, int size)
  {
    int at = size++;
    for (; at > bottom && pending[at - 1].squared < node.squared; --at)
    {
      pending[at] = pending[at - 1];
    }
    pending[at] = node;
    return size;
  }

private:
  /** A level over so many children; false once cancelled. */
  template <class BoxOf>
  bool addLevel(Index children, const RunControl& control, const BoxOf& boxOf)
  {
    std::vector<BoxGroup> level((static_cast<std::size_t>(children) + lanes - 1) / lanes);
    const bool done = forEachItem(static_cast<Offset>(level.size()), control,
      [&](Offset node)
      {
        for (int k = 0; k < lanes; ++k)
        {
          Point3 lower = Point3::Constant(std::numeric_limits<double>::infinity());
          Point3 upper = -lower;
          if (const Offset child = node * lanes + k; child < children)
          {
            boxOf(static_cast<Index>(child), lower, upper);
          }
          for (int axis = 0; axis < 3; ++axis)
          {
            level[node].lower[axis][k] = lower[axis];
            level[node].upper[axis][k] = upper[axis];
          }
        }
      });
    m_levels.push_back(std::move(level));
    return done;
  }

  std::vector<std::vector<BoxGroup>> m_levels; ///< of leaves' boxes first, one node last
  BoxDistanceEvaluation m_distances = boxDistanceEvaluation(widestInstructionSet());
};
}

#endif
