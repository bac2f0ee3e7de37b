/**
 * @file FacetLanes.h
 * @brief What all patterns of FacetBatch.h share: corners and sites in lanes, vertices, parts.
 *
 * All of it is inlined into functions that are compiled for a set of instructions (NativeLanes.h).
 */
#ifndef remesh_FacetLanes_h
#define remesh_FacetLanes_h

#include "Support/NativeLanes.h"
#include "Voronoi/FacetBatch.h"

namespace remesh
{
/** Only who is farther above than this part of the owners' differences is clearly above. */
constexpr double closest = 1e-9;
/** Far above the rounding of values, in parts of a vertex's squared distance. */
constexpr double relativeRounding = 1e-13;

/** A point in each facet. */
template <class L>
struct Places
{
  L b[3];
};

/** The integrals of a part but for the facet's mass. */
template <class L>
struct Shares
{
  L weights[3]{}; ///< of the barycentric coordinates
  L quadratic{};  ///< of sum b_k b_l |p_k - p_l|^2
};

/** What both ways to share have in common. */
template <int D, class L>
struct FacetLanes
{
  FacetBatch<D>& batch;
  int d;
  L from[FacetBatch<D>::room];  ///< the reference
  L at[3][FacetBatch<D>::room]; ///< corners, from the reference
  L squared[3];
  L mass;
  L edge2[3];

  [[gnu::always_inline]] inline explicit FacetLanes(FacetBatch<D>& given)
    : batch(given)
    , d(D == Eigen::Dynamic ? given.dimension : D)
  {
    load(batch.mass, mass);
    for (int k = 0; k < 3; ++k)
    {
      load(batch.edge2[k], edge2[k]);
      squared[k] = L{};
    }
    for (int m = 0; m < d; ++m)
    {
      readColumn(batch.sites[0], m, from[m]);
      for (int k = 0; k < 3; ++k)
      {
        readColumn(batch.corners[k], m, at[k][m]);
        at[k][m] -= from[m];
        squared[k] += at[k][m] * at[k][m];
      }
    }
  }

  /** Offsets of another site, and its values at the corners. */
  [[gnu::always_inline]] inline void look(int other, L offsets[], L values[3])
  {
    L length2{};
    L along[3] = {};
    for (int m = 0; m < d; ++m)
    {
      readColumn(batch.sites[other], m, offsets[m]);
      offsets[m] -= from[m];
      length2 += offsets[m] * offsets[m];
      for (int k = 0; k < 3; ++k)
      {
        along[k] += at[k][m] * offsets[m];
      }
    }
    for (int k = 0; k < 3; ++k)
    {
      values[k] = length2 - 2.0 * along[k];
    }
  }

  /** A vertex of the cells with a level but for the margins; `scale`: the owners' differences. */
  [[gnu::always_inline]] inline void addVertex(
    int vertex, const Places<L>& place, const L& level, const L& scale)
  {
    L length2{};
    for (int m = 0; m < d; ++m)
    {
      const L offset = place.b[0] * at[0][m] + place.b[1] * at[1][m] + place.b[2] * at[2][m];
      length2 += offset * offset;
      store(2.0 * offset, batch.vertices[vertex][m]);
    }
    store(length2, batch.squared[vertex]);
    store(level + closest * scale + relativeRounding * length2, batch.levels[vertex]);
  }

  [[gnu::always_inline]] inline void addQuadratic(const Places<L>& p, double factor, L& sum) const
  {
    sum += factor *
      (p.b[0] * p.b[1] * edge2[0] + p.b[1] * p.b[2] * edge2[1] + p.b[2] * p.b[0] * edge2[2]);
  }

  /** Adds the triangle between corner k and two places. */
  [[gnu::always_inline]] inline void addTriangle(
    int k, const Places<L>& p, const Places<L>& q, const L& share, Shares<L>& shares) const
  {
    Places<L> center;
    for (int c = 0; c < 3; ++c)
    {
      center.b[c] = (p.b[c] + q.b[c] + (c == k ? 1.0 : 0.0)) * (1.0 / 3.0);
      shares.weights[c] += share * center.b[c];
    }
    L sum{};
    addQuadratic(p, 1.0 / 12.0, sum);
    addQuadratic(q, 1.0 / 12.0, sum);
    addQuadratic(center, 9.0 / 12.0, sum);
    shares.quadratic += share * sum;
  }

  /** Adds the whole facet. */
  [[gnu::always_inline]] inline void addWhole(Shares<L>& shares) const
  {
    for (L& weight : shares.weights)
    {
      weight += 1.0 / 3.0;
    }
    shares.quadratic += (edge2[0] + edge2[1] + edge2[2]) * (1.0 / 12.0);
  }

  /** Writes the sums of a site with these offsets from the reference, or none, and values. */
  [[gnu::always_inline]] inline void addPart(
    int part, const Shares<L>& shares, const L* offsets, const L* values)
  {
    L weights[3];
    L energy = -shares.quadratic;
    for (int k = 0; k < 3; ++k)
    {
      weights[k] = mass * shares.weights[k];
      energy += shares.weights[k] * (values ? squared[k] + values[k] : squared[k]);
    }
    keepPositive(energy);
    const L sum = weights[0] + weights[1] + weights[2];
    store(sum, batch.sums[part][0]);
    store(mass * energy, batch.sums[part][1]);
    for (int m = 0; m < d; ++m)
    {
      const L moment = weights[0] * at[0][m] + weights[1] * at[1][m] + weights[2] * at[2][m];
      store(offsets ? moment - sum * offsets[m] : moment, batch.sums[part][2 + m]);
    }
  }
};
}

#endif
