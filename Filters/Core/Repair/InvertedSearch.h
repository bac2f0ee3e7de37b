/**
 * @file InvertedSearch.h
 * @brief Finds triangles that face against the surface, in a mesh that changes between searches.
 */
#ifndef remesh_InvertedSearch_h
#define remesh_InvertedSearch_h

#include "Placement/NearbySurface.h"
#include "Support/RunControl.h"
#include "Support/Status.h"

namespace remesh
{
/**
 * Remembers the mesh of the last search. A triangle is looked at again only if it has other corners
 * now, or if one of them has moved. Repairs change few triangles, so a search is cheap. A mesh
 * without inverted triangles needs no repair: as long as no other was searched, none is remembered.
 */
class InvertedSearch
{
public:
  /** @param surface must outlive it. */
  explicit InvertedSearch(const NearbySurface& surface)
    : m_surface(surface)
  {
  }

  /**
   * Lists the inverted triangles, ascending: those whose normal makes more than 90 degrees with
   * that of the closest facet, and those without a normal (NearbySurface.h, which tells among which
   * facets the closest one is).
   *
   * @param triangles T, as many in each search.
   * @param suspects T, or nullptr: in the first search only those marked by 1 are looked at, and no
   *        others are inverted.
   * @return Cancelled, then `inverted` is of no use; or success.
   * Cost, in parallel: O(T), and O(pieces of its cells) for each triangle that is looked at, and
   * O(log F) for it if the surface is a whole one. A first search without suspects goes over all
   * pieces once, and then looks closer only at triangles where the cells bend far.
   */
  Status find(const std::vector<Triple>& triangles, const std::vector<Point3>& positions,
    const RunControl& control, std::vector<Index>& inverted,
    const std::vector<char>* suspects = nullptr);

  /**
   * Remembers a mesh that is known without a search.
   *
   * @param inverted its inverted triangles, ascending.
   */
  void know(const std::vector<Triple>& triangles, const std::vector<Point3>& positions,
    const std::vector<Index>& inverted);

private:
  bool isKnown(std::size_t triangle, const std::vector<Triple>& triangles,
    const std::vector<Point3>& positions, const std::vector<char>* suspects) const;

  const NearbySurface& m_surface;
  std::vector<char> m_isInverted;  ///< T, of the last search; empty before the first
  std::vector<Triple> m_triangles; ///< of the last search; empty if none was inverted so far
  std::vector<Point3> m_positions; ///< likewise
};
}

#endif
