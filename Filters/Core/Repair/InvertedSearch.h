/**
 * @file InvertedSearch.h
 * @brief Finds triangles that face against the surface, again and again while the mesh changes.
 */
#ifndef remesh_FlipSearch_h
#define remesh_FlipSearch_h

#include "Placement/NearbySurface.h"
#include "Support/RunControl.h"
#include "Support/Status.h"

namespace remesh
{
/**
 * Judges a triangle only if it is another than in the search before, or one of its corners has
 * moved since: repairs touch few of them. The surface must be the same.
 */
class InvertedSearch
{
public:
  explicit InvertedSearch(const NearbySurface& surface)
    : m_surface(surface)
  {
  }

  /**
   * The triangles whose normal makes more than 90 degrees with that of the closest facet of their
   * cells, or of the whole surface if it is known, or that have none (NearbySurface.h), ascending.
   * Parallel. O(T), and for each that is judged O(pieces of its cells), and O(log F) if the whole
   * surface is known; where all are judged, O(pieces of all cells), and that for the few triangles
   * alone where the cells bend far.
   *
   * @param triangles T, as many in each search.
   * @param suspects T, if given: in the first search, no others are inverted.
   * @return Cancelled; then `inverted` is of no use.
   */
  Status find(const std::vector<Triple>& triangles, const std::vector<Point3>& positions,
    const RunControl& control, std::vector<Index>& inverted,
    const std::vector<char>* suspects = nullptr);

private:
  const NearbySurface& m_surface;
  std::vector<char> m_isInverted;  ///< T, as of the last search; none before the first
  std::vector<Triple> m_triangles; ///< of the last search; none if nothing was inverted
  std::vector<Point3> m_positions; ///< likewise
};
}

#endif
