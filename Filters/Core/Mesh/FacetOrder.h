/**
 * @file FacetOrder.h
 * @brief An order of facets, and of the corners of each, that only the surface decides.
 *
 * The same surface comes in different orders, as from a reader, from the parts of a distributed
 * one, or from another program. What comes after the intake depends on the order of facets and
 * points, so these are made the same for all.
 */
#ifndef remesh_FacetOrder_h
#define remesh_FacetOrder_h

#include "Mesh/IntakeDraft.h"

namespace remesh
{
/** By coordinates: the first that differs counts. */
bool isBefore(const Point3& a, const Point3& b);

/**
 * Turns each facet, and what belongs to its corners, so that the first corner comes before the
 * other two by its coordinates. The sense of rotation stays. Facets with two corners in one place
 * are no facets: their corners stay in some order.
 *
 * @return false when cancelled. Cost: O(F), in parallel.
 */
[[nodiscard]] bool turnFacets(const RunControl& control, Draft& draft);

/**
 * Facets along the Hilbert curve of their centroids. Ties: by the coordinates of the corners, then
 * by what the caller's data has there (`TriangleSoup::compareValues`), then as they come.
 *
 * @param draft with turned facets.
 * @return F facets; of no use when cancelled. Cost: O(F), in parallel.
 */
std::vector<Index> orderFacets(
  const TriangleSoup& soup, const Draft& draft, const RunControl& control);

/** Puts the facets of a draft, and the marks, in an order. @return false when cancelled. */
[[nodiscard]] bool moveFacets(const std::vector<Index>& order, const RunControl& control,
  Draft& draft, std::vector<unsigned char>& marked);
}

#endif
