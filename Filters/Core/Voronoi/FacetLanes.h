/**
 * @file FacetLanes.h
 * @brief What all patterns of FacetBatch.h share: corners and sites in lanes, vertices, parts.
 *
 * All of it is inlined into functions that are compiled for a set of instructions
 * (CompiledInLanes.h).
 */
#ifndef remesh_FacetLanes_h
#define remesh_FacetLanes_h

#include "Support/LaneColumns.h"
#include "Voronoi/FacetBatch.h"

#include <limits>

namespace remesh
{
/** Only who is farther above than this part of the owners' differences is clearly above. */
constexpr double closest = 1e-9;
/** Far above the rounding of values, in parts of a vertex's squared distance. */
constexpr double relativeRounding = 1e-13;
/** Borders meet in a clear place only if the sine of their angle, in barycentric coordinates, is
 *  larger. */
constexpr double minSine = 1e-6;
constexpr double smallest = std::numeric_limits<double>::min();

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

/** What all patterns have in common. */
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
    readColumns(batch.sites[0], d, from);
    for (int k = 0; k < 3; ++k)
    {
      readColumns(batch.corners[k], d, at[k]);
      for (int m = 0; m < d; ++m)
      {
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
    readColumns(batch.sites[other], d, offsets);
    for (int m = 0; m < d; ++m)
    {
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

  /** Adds a triangle that is this share of the facet. */
  [[gnu::always_inline]] inline void addTriangle(const Places<L>& p, const Places<L>& q,
    const Places<L>& r, const L& share, Shares<L>& shares) const
  {
    Places<L> center;
    for (int c = 0; c < 3; ++c)
    {
      center.b[c] = (p.b[c] + q.b[c] + r.b[c]) * (1.0 / 3.0);
      shares.weights[c] += share * center.b[c];
    }
    L sum{};
    addQuadratic(p, 1.0 / 12.0, sum);
    addQuadratic(q, 1.0 / 12.0, sum);
    addQuadratic(r, 1.0 / 12.0, sum);
    addQuadratic(center, 9.0 / 12.0, sum);
    shares.quadratic += share * sum;
  }

  /** The triangle between corner k and two places. */
  [[gnu::always_inline]] inline void addCorner(
    int k, const Places<L>& p, const Places<L>& q, const L& share, Shares<L>& shares) const
  {
    Places<L> corner{};
    corner.b[k] = L(1.0);
    this->addTriangle(p, q, corner, share, shares);
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

/** On the edge from corner k to l. */
template <class L>
[[gnu::always_inline]] inline void placeOnEdge(int k, int l, const L& along, Places<L>& place)
{
  place.b[k] = 1.0 - along;
  place.b[l] = along;
  place.b[3 - k - l] = L{};
}

/** Of a function with these values at the corners. */
template <class L>
[[gnu::always_inline]] inline void evaluate(const Places<L>& place, const L values[3], L& value)
{
  value = place.b[0] * values[0] + place.b[1] * values[1] + place.b[2] * values[2];
}

template <class L>
[[gnu::always_inline]] inline void subtract(const Shares<L>& part, Shares<L>& shares)
{
  for (int k = 0; k < 3; ++k)
  {
    shares.weights[k] -= part.weights[k];
  }
  shares.quadratic -= part.quadratic;
}

/** The point where two functions are zero, from their values at the corners. */
template <class L>
[[gnu::always_inline]] inline void findMeeting(
  const L p[3], const L q[3], Places<L>& place, typename L::Bits& unclear)
{
  const L c[3] = { p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2],
    p[0] * q[1] - p[1] * q[0] };
  const L sum = c[0] + c[1] + c[2];
  const L lengths =
    (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) * (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]);
  addNegative(sum * sum - minSine * minSine * lengths - smallest, unclear);
  for (int k = 0; k < 3; ++k)
  {
    place.b[k] = c[k] / sum;
    addNegative(place.b[k], unclear);
  }
}

/** Where a function that is `high` here and `-low` there is zero; both must be positive. */
template <class L>
[[gnu::always_inline]] inline void findZero(
  const L& high, const L& low, L& along, typename L::Bits& unclear)
{
  addNegative(high - smallest, unclear);
  addNegative(low - smallest, unclear);
  along = high / (high + low);
}

/** A bit for each lane without a mark. */
template <class Bits>
[[gnu::always_inline]] inline unsigned unmarked(const Bits& marks)
{
  return ~bitsOf(marks) & ((1U << lanes) - 1U);
}
}

#endif
