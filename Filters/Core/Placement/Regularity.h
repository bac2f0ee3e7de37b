/**
 * @file Regularity.h
 * @brief How even a mesh is in R^d, and how far its vertices may slide before it is less so.
 */
#ifndef remesh_Regularity_h
#define remesh_Regularity_h

#include "Placement/CellForms.h"

namespace remesh
{
/** Lengths are measured by the metrics of the cells at both ends of an edge. */
struct Regularity
{
  double evenEdges = 1.0;      ///< share of the edges of 0.71 to 1.41 times the mean length
  double roundTriangles = 1.0; ///< mean of twice the inscribed circles' radii over the others'

  /** Whether both are there but for `loss`. */
  bool isWithin(double loss, const Regularity& other) const
  {
    return this->evenEdges >= other.evenEdges - loss &&
      this->roundTriangles >= other.roundTriangles - loss;
  }
};

/** Of the triangles that have vertices which are not fixed. O(T), in one thread. */
Regularity regularityOf(
  const PlacementProblem& problem, const CellForms& cells, const std::vector<Point3>& positions);

/**
 * Takes all vertices back along the surface, by the same share of their ways, until the mesh is as
 * regular as at the start but for `most`.
 *
 * @param start K. Across the surface, vertices stay where they are.
 * @param positions K; changed.
 * @return whether they were.
 * Cost: O(T) a few times.
 */
bool limitSliding(const PlacementProblem& problem, const CellForms& cells, double most,
  const std::vector<Point3>& start, std::vector<Point3>& positions);
}

#endif
