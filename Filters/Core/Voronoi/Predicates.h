/**
 * @file Predicates.h
 * @brief Exact decisions of the lower envelope over one facet, whatever the dimension.
 *
 * Over a facet with corners p_1, p_2, p_3 a site i is the affine function b -> sum_k b_k H_ik of
 * the barycentric coordinates b, where H_ik = |p_k - x_i|^2; the term of |p(b) - x_i|^2 that is
 * quadratic in b is the same for all sites. Its restricted cell is where its function is least.
 * With the stored doubles H as the exact input, each decision is the sign of a polynomial in at
 * most 12 of them: a floating-point filter first, expansions (J. R. Shewchuk, "Adaptive Precision
 * Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997) when it fails. Exact for
 * H values that are 0 or from 2^-300 to 2^300: no product of three then leaves a double's range.
 *
 * Ties are broken by symbolic perturbation, H_ik -> H_ik + eps_i at all three corners with
 * 0 < eps_0 << eps_1 << ...: where sites tie, the lower id wins. Every decision is thus strict, and
 * all together are those of one true arrangement (the lower envelope of the perturbed functions).
 */
#ifndef remesh_Predicates_h
#define remesh_Predicates_h

#include "Support/Types.h"

namespace remesh
{
/** A site as a facet sees it: its id and its squared distances to the three corners. */
struct FacetSite
{
  Index id = noIndex;
  double h[3] = { 0.0, 0.0, 0.0 };
};

/** Whether q is nearer than i at corner k. */
inline bool beatsAtCorner(const FacetSite& q, const FacetSite& i, int k)
{
  return q.h[k] < i.h[k] || (q.h[k] == i.h[k] && q.id < i.id);
}

/** Whether q beats i somewhere on the facet: affine functions cross nowhere unless at a corner. */
inline bool beatsSomewhere(const FacetSite& q, const FacetSite& i)
{
  return beatsAtCorner(q, i, 0) || beatsAtCorner(q, i, 1) || beatsAtCorner(q, i, 2);
}

/** How far a decision goes. */
enum class Decisions
{
  Exact,
  /** Takes what the filter finds, sure or not. To measure the cost of the rest: not robust. */
  FilterAlone
};

/**
 * Whether q beats i at the point where the bisector of i and j crosses the facet's edge from
 * corner k to corner (k + 1) % 3.
 *
 * @param leaving true when that edge, walked from k, leaves the cell of i at the point (i wins at
 *        the k side), false when it enters it.
 */
bool beatsOnEdge(const FacetSite& q, const FacetSite& i, const FacetSite& j, int k, bool leaving,
  Decisions decisions = Decisions::Exact);

/**
 * Whether q beats i at the point where the cells of i, j, m meet inside the facet, with j across
 * the edge of the piece of i that ends in the point and m across the edge that starts there
 * (the piece counter-clockwise in the facet's orientation).
 */
bool beatsInside(const FacetSite& q, const FacetSite& i, const FacetSite& j, const FacetSite& m,
  Decisions decisions = Decisions::Exact);
}

#endif
