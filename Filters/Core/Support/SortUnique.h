/**
 * @file SortUnique.h
 * @brief Each value once, ascending.
 */
#ifndef remesh_SortUnique_h
#define remesh_SortUnique_h

#include <algorithm>
#include <vector>

namespace remesh
{
template <class Value>
void sortUnique(std::vector<Value>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}
}

#endif
