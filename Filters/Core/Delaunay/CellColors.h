/**
 * @file CellColors.h
 * @brief A few colours for the cells, such that neighbours differ.
 */
#ifndef remesh_CellColors_h
#define remesh_CellColors_h

#include "Delaunay/Dual.h"
#include "Support/Grouping.h"

namespace remesh
{
/**
 * Colours the vertices of a graph with few colours: no two neighbours have the same, and each
 * colour is about as frequent as the others.
 *
 * 1. Take away a vertex with the fewest neighbours left, again and again: no more are left then
 *    than the largest such number, five in the plane (D. W. Matula, L. L. Beck, "Smallest-last
 *    ordering and clustering and graph coloring algorithms", 1983).
 * 2. Put them back, last one first, each with the least used of the colours that its neighbours
 *    have not; one more than that number suffices.
 *
 * @param neighbors of each vertex, each once, none of them the vertex itself, both ways.
 * @return from 0 on; the same for the same graph. O(vertices + edges), in one thread.
 */
std::vector<int> colorGraph(const Groups& neighbors);

/**
 * Colours for the cells of n sites: the copies of one vertex have the same, and cells that share a
 * segment, or are joined by an edge of the dual, differ. Six colours at most on a sphere.
 *
 * @param features the sites on features, or nullptr.
 * @return n values from 0 on. O(P log P), in one thread: a hundredth of a run.
 */
std::vector<int> colorCells(const Diagram& diagram, const Components& components, const Dual& dual,
  Index numberOfSites, const FeatureSites* features = nullptr);
}

#endif
