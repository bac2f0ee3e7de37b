/**
 * @file FacetLanes.h
 * @brief What all patterns of FacetBatch.h share: corners and sites in lanes, vertices, parts.
 *
 * All of it is inlined into functions that are compiled for a set of instructions (Lanes.h).
 */
#ifndef remesh_FacetLanes_h
#define remesh_FacetLanes_h

#include "Voronoi/FacetBatch.h"

namespace remesh
{
/** Only who is farther above than this part of the owners' differences is clearly above. */
constexpr double closest = 1e-9;
/** Far above the rounding of values, in parts of a vertex's squared distance. */
constexpr double relativeRounding = 1e-13;

[[gnu::always_inline]] inline void readColumn(const double* const* rows, int m, Lanes& column)
{
  column = Lanes{ rows[0][m], rows[1][m], rows[2][m], rows[3][m], rows[4][m], rows[5][m],
    rows[6][m], rows[7][m] };
}

/** A point in each facet. */
struct Places
{
  Lanes b[3];
};

/** The integrals of a part but for the facet's mass. */
struct Shares
{
  Lanes weights[3]{}; ///< of the barycentric coordinates
  Lanes quadratic{};  ///< of sum b_k b_l |p_k - p_l|^2
};

/** What both ways to share have in common. */
template <int D>
struct FacetLanes
{
  FacetBatch<D>& batch;
  int d;
  Lanes from[FacetBatch<D>::room];  ///< the reference
  Lanes at[3][FacetBatch<D>::room]; ///< corners, from the reference
  Lanes squared[3];
  Lanes mass;
  Lanes edge2[3];

  [[gnu::always_inline]] inline explicit FacetLanes(FacetBatch<D>& given)
    : batch(given)
    , d(D == Eigen::Dynamic ? given.dimension : D)
  {
    load(batch.mass, mass);
    for (int k = 0; k < 3; ++k)
    {
      load(batch.edge2[k], edge2[k]);
      squared[k] = Lanes{};
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
  [[gnu::always_inline]] inline void look(int other, Lanes offsets[], Lanes values[3])
  {
    Lanes length2{};
    Lanes along[3] = {};
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
    int vertex, const Places& place, const Lanes& level, const Lanes& scale)
  {
    Lanes length2{};
    for (int m = 0; m < d; ++m)
    {
      const Lanes offset = place.b[0] * at[0][m] + place.b[1] * at[1][m] + place.b[2] * at[2][m];
      length2 += offset * offset;
      store(2.0 * offset, batch.vertices[vertex][m]);
    }
    store(length2, batch.squared[vertex]);
    store(level + closest * scale + relativeRounding * length2, batch.levels[vertex]);
  }

  [[gnu::always_inline]] inline void addQuadratic(const Places& p, double factor, Lanes& sum) const
  {
    sum += factor *
      (p.b[0] * p.b[1] * edge2[0] + p.b[1] * p.b[2] * edge2[1] + p.b[2] * p.b[0] * edge2[2]);
  }

  /** Adds the triangle between corner k and two places. */
  [[gnu::always_inline]] inline void addTriangle(
    int k, const Places& p, const Places& q, const Lanes& share, Shares& shares) const
  {
    Places center;
    for (int c = 0; c < 3; ++c)
    {
      center.b[c] = (p.b[c] + q.b[c] + (c == k ? 1.0 : 0.0)) * (1.0 / 3.0);
      shares.weights[c] += share * center.b[c];
    }
    Lanes sum{};
    addQuadratic(p, 1.0 / 12.0, sum);
    addQuadratic(q, 1.0 / 12.0, sum);
    addQuadratic(center, 9.0 / 12.0, sum);
    shares.quadratic += share * sum;
  }

  /** Adds the whole facet. */
  [[gnu::always_inline]] inline void addWhole(Shares& shares) const
  {
    for (Lanes& weight : shares.weights)
    {
      weight += 1.0 / 3.0;
    }
    shares.quadratic += (edge2[0] + edge2[1] + edge2[2]) * (1.0 / 12.0);
  }

  /** Writes the sums of a site with these offsets from the reference, or none, and values. */
  [[gnu::always_inline]] inline void addPart(
    int part, const Shares& shares, const Lanes* offsets, const Lanes* values)
  {
    Lanes weights[3];
    Lanes energy = -shares.quadratic;
    for (int k = 0; k < 3; ++k)
    {
      weights[k] = mass * shares.weights[k];
      energy += shares.weights[k] * (values ? squared[k] + values[k] : squared[k]);
    }
    LaneBits negative;
    findNegative(energy, negative);
    replaceChosen(Lanes{}, negative, energy);
    const Lanes sum = weights[0] + weights[1] + weights[2];
    store(sum, batch.sums[part][0]);
    store(mass * energy, batch.sums[part][1]);
    for (int m = 0; m < d; ++m)
    {
      const Lanes moment = weights[0] * at[0][m] + weights[1] * at[1][m] + weights[2] * at[2][m];
      store(offsets ? moment - sum * offsets[m] : moment, batch.sums[part][2 + m]);
    }
  }
};
}

#endif
