/**
 * @file DisjointSets.h
 * @brief Sets of items that only ever merge; the lowest item stands for its set.
 *
 * Union by lowest item with path halving (R. Tarjan, J. van Leeuwen, 1984). The sets and their
 * representatives do not depend on the order of the unions.
 */
#ifndef remesh_DisjointSets_h
#define remesh_DisjointSets_h

#include "Support/Types.h"

#include <numeric>
#include <vector>

namespace remesh
{
struct DisjointSets
{
  std::vector<Index> parent; ///< never above the item itself

  explicit DisjointSets(std::size_t size)
    : parent(size)
  {
    std::iota(this->parent.begin(), this->parent.end(), Index(0));
  }

  Index find(Index item)
  {
    while (this->parent[item] != item)
    {
      this->parent[item] = this->parent[this->parent[item]];
      item = this->parent[item];
    }
    return item;
  }

  void unite(Index a, Index b)
  {
    a = this->find(a);
    b = this->find(b);
    this->parent[std::max(a, b)] = std::min(a, b);
  }

  /** The number of sets. */
  Index count() const
  {
    Index roots = 0;
    for (std::size_t i = 0; i < this->parent.size(); ++i)
    {
      roots += this->parent[i] == static_cast<Index>(i);
    }
    return roots;
  }
};
}

#endif
