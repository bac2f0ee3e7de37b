/**
 * @file DisjointSets.h
 * @brief Sets of items that only ever merge; the lowest item stands for its set.
 *
 * Union by lowest item with path halving (R. Tarjan, J. van Leeuwen, 1984). Threads may find and
 * unite at the same time: a root is made the child of a lower one by one compare-and-exchange,
 * tried again when another thread was faster. The sets and their representatives do not depend on
 * the order of the unions.
 */
#ifndef remesh_DisjointSets_h
#define remesh_DisjointSets_h

#include "Support/Types.h"

#include <atomic>
#include <utility>
#include <vector>

namespace remesh
{
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t size)
    : m_parents(size)
  {
    Index item = 0;
    for (std::atomic<Index>& parent : m_parents)
    {
      parent.store(item++, std::memory_order_relaxed);
    }
  }

  /** The lowest item of the set, unless another thread is uniting sets: then one of its items. */
  Index find(Index item)
  {
    Index parent = m_parents[item].load(std::memory_order_relaxed);
    while (parent != item)
    {
      const Index above = m_parents[parent].load(std::memory_order_relaxed);
      // No root, and never one again: no one unites it, and any item above it will do.
      if (above != parent)
      {
        m_parents[item].store(above, std::memory_order_relaxed);
      }
      item = above;
      parent = m_parents[item].load(std::memory_order_relaxed);
    }
    return item;
  }

  void unite(Index a, Index b)
  {
    for (;;)
    {
      a = this->find(a);
      b = this->find(b);
      if (a == b)
      {
        return;
      }
      if (a < b)
      {
        std::swap(a, b);
      }
      Index root = a;
      if (m_parents[a].compare_exchange_strong(root, b, std::memory_order_relaxed))
      {
        return;
      }
    }
  }

  bool isLowest(Index item) const
  {
    return m_parents[item].load(std::memory_order_relaxed) == item;
  }

private:
  std::vector<std::atomic<Index>> m_parents; ///< never above the item itself
};
}

#endif
