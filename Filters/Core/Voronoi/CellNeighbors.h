/**
 * @file CellNeighbors.h
 * @brief Which cells of a diagram touch along a segment.
 */
#ifndef remesh_CellNeighbors_h
#define remesh_CellNeighbors_h

#include "Support/Grouping.h"
#include "Support/SortUnique.h"
#include "Support/Status.h"
#include "Voronoi/Diagram.h"

#include <algorithm>
#include <iterator>

namespace remesh
{
/**
 * Calls `visit(site, neighbors)` for each of n sites, in parallel, with the sites whose cells share
 * a segment with its cell, ascending.
 *
 * @return Cancelled; then some sites have not been visited.
 * Cost: O(P) but for the neighbours of a site, which are sorted.
 */
template <class Visit>
Status forEachCell(
  const Diagram& diagram, Index numberOfSites, const RunControl& control, const Visit& visit)
{
  Groups pieces;
  const bool done = groupByKey(
                      diagram.numberOfPieces(), numberOfSites, control.silent(),
                      [&](Offset piece) { return diagram.sites[piece]; }, pieces) &&
    forEachRange(longBlocks(numberOfSites), control,
      [&](Offset begin, Offset end)
      {
        std::vector<Index> neighbors;
        for (Offset site = begin; site < end; ++site)
        {
          neighbors.clear();
          for (Offset p = pieces.begins[site]; p < pieces.begins[site + 1]; ++p)
          {
            const Index piece = pieces.items[p];
            std::copy_if(diagram.across.begin() + diagram.vertexBegin[piece],
              diagram.across.begin() + diagram.vertexBegin[piece + 1],
              std::back_inserter(neighbors), [](Index across) { return across >= 0; });
          }
          sortUnique(neighbors);
          visit(static_cast<Index>(site), neighbors);
        }
      });
  return done ? Status::success() : Status::cancelled();
}
}

#endif
