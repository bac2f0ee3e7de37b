#include "Voronoi/FacetBatch.h"

#include "Voronoi/FacetLanes.h"

namespace remesh
{
namespace
{
/** Borders meet in a clear place only if the sine of their angle, in barycentric coordinates, is
 *  larger. */
constexpr double leastSine = 1e-6;
constexpr double smallest = std::numeric_limits<double>::min();

/** On the edge from corner k to l. */
[[gnu::always_inline]] inline void placeOnEdge(int k, int l, const Lanes& along, Places& place)
{
  place.b[k] = 1.0 - along;
  place.b[l] = along;
  place.b[3 - k - l] = Lanes{};
}

/** Of a function with these values at the corners. */
[[gnu::always_inline]] inline void evaluate(
  const Places& place, const Lanes values[3], Lanes& value)
{
  value = place.b[0] * values[0] + place.b[1] * values[1] + place.b[2] * values[2];
}

[[gnu::always_inline]] inline void subtract(const Shares& part, Shares& shares)
{
  for (int k = 0; k < 3; ++k)
  {
    shares.weights[k] -= part.weights[k];
  }
  shares.quadratic -= part.quadratic;
}

[[gnu::always_inline]] inline void addNegative(const Lanes& values, LaneBits& any)
{
  LaneBits negative;
  findNegative(values, negative);
  any |= negative;
}

/** A bit for each lane without a mark. */
[[gnu::always_inline]] inline unsigned unmarked(const LaneBits& marks)
{
  return ~bitsOf(marks) & ((1U << lanes) - 1U);
}

/** A site that has the triangle which its border with the reference cuts off at its corner. */
template <int D>
struct CutOffCorner
{
  Lanes offsets[FacetBatch<D>::room];
  Lanes values[3];
  Places crossings[2]; ///< on the edges to the next corner, and to the one after
  Lanes along[2];
  Shares shares;

  /** Its corner is k, its vertices are from this one on. */
  [[gnu::always_inline]] inline void cut(
    FacetLanes<D>& facets, int part, int k, int vertex, LaneBits& unclear)
  {
    facets.look(part, offsets, values);
    const Lanes lead = -values[k];
    const Lanes scale = lead + values[(k + 1) % 3] + values[(k + 2) % 3];
    Lanes share{};
    share += 1.0;
    addNegative(lead, unclear);
    for (int e = 0; e < 2; ++e)
    {
      const int l = (k + 1 + e) % 3;
      addNegative(values[l], unclear);
      addNegative(lead + values[l] - smallest, unclear);
      along[e] = lead / (lead + values[l]);
      placeOnEdge(k, l, along[e], crossings[e]);
      facets.addVertex(vertex + e, crossings[e], Lanes{}, scale);
      share *= along[e];
    }
    facets.addTriangle(k, crossings[0], crossings[1], share, shares);
    facets.addPart(part, shares, offsets, values);
  }
};

template <int D>
struct TwoCells
{
  [[gnu::always_inline]] static inline unsigned run(FacetBatch<D>& batch)
  {
    FacetLanes<D> facets(batch);
    LaneBits unclear{};
    CutOffCorner<D> single;
    single.cut(facets, 1, 0, 0, unclear);
    Shares rest;
    facets.addWhole(rest);
    subtract(single.shares, rest);
    facets.addPart(0, rest, nullptr, nullptr);
    return unmarked(unclear);
  }
};

template <int D>
struct Strip
{
  [[gnu::always_inline]] static inline unsigned run(FacetBatch<D>& batch)
  {
    FacetLanes<D> facets(batch);
    LaneBits unclear{};
    CutOffCorner<D> next;
    CutOffCorner<D> last;
    next.cut(facets, 1, 1, 0, unclear);
    last.cut(facets, 2, 2, 2, unclear);
    // On the edge between them the reference has a part, too.
    addNegative(1.0 - closest - next.along[0] - last.along[1], unclear);
    Shares rest;
    facets.addWhole(rest);
    subtract(next.shares, rest);
    subtract(last.shares, rest);
    facets.addPart(0, rest, nullptr, nullptr);
    return unmarked(unclear);
  }
};

/** Their borders start on one edge each and meet; each has two triangles at its corner. */
template <int D>
struct Meeting
{
  FacetLanes<D> facets;
  Lanes offsets[2][FacetBatch<D>::room]; ///< of the second and the third site
  Lanes values[3][3] = {};               ///< by sites; those of the reference are zero
  Places crossings[3];                   ///< on the edge from corner k to the next
  Lanes along[3];
  Lanes levels[3]; ///< at the crossings
  Places center;
  Lanes scale{};
  LaneBits unclear{};

  [[gnu::always_inline]] inline explicit Meeting(FacetBatch<D>& batch)
    : facets(batch)
  {
    facets.look(1, offsets[0], values[1]);
    facets.look(2, offsets[1], values[2]);
  }

  [[gnu::always_inline]] inline void cross(int k)
  {
    const int l = (k + 1) % 3;
    const int m = (k + 2) % 3;
    const Lanes lead = values[l][k] - values[k][k];
    const Lanes lag = values[k][l] - values[l][l];
    along[k] = lead / (lead + lag);
    placeOnEdge(k, l, along[k], crossings[k]);
    scale += lead + lag;
    addNegative(lead - smallest, unclear);
    addNegative(lag - smallest, unclear);
    // The third may have a part of this edge, or comes close to it.
    Lanes third;
    evaluate(crossings[k], values[m], third);
    evaluate(crossings[k], values[k], levels[k]);
    third -= levels[k] + closest * (lead + lag);
    store(third, facets.batch.leads[k]);
    addNegative(third, unclear);
  }

  /** The point as far from all three. */
  [[gnu::always_inline]] inline void meet()
  {
    const auto& p = values[1];
    const auto& q = values[2];
    const Lanes c[3] = { p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2],
      p[0] * q[1] - p[1] * q[0] };
    const Lanes sum = c[0] + c[1] + c[2];
    const Lanes lengths =
      (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) * (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]);
    addNegative(sum * sum - leastSine * leastSine * lengths - smallest, unclear);
    for (int k = 0; k < 3; ++k)
    {
      center.b[k] = c[k] / sum;
      addNegative(center.b[k], unclear);
    }
  }

  [[gnu::always_inline]] inline void addParts()
  {
    Shares rest;
    facets.addWhole(rest);
    for (int k = 0; k < 2; ++k)
    {
      const int l = (k + 1) % 3;
      const int m = (k + 2) % 3;
      Shares corner;
      facets.addTriangle(k, crossings[k], center, along[k] * center.b[m], corner);
      facets.addTriangle(k, center, crossings[m], center.b[l] * (1.0 - along[m]), corner);
      subtract(corner, rest);
      facets.addPart(k, corner, k == 0 ? nullptr : offsets[0], k == 0 ? nullptr : values[1]);
    }
    facets.addPart(2, rest, offsets[1], values[2]);
  }

  [[gnu::always_inline]] static inline unsigned run(FacetBatch<D>& batch)
  {
    Meeting three(batch);
    for (int k = 0; k < 3; ++k)
    {
      three.cross(k);
    }
    three.meet();
    for (int k = 0; k < 3; ++k)
    {
      three.facets.addVertex(k, three.crossings[k], three.levels[k], three.scale);
    }
    three.facets.addVertex(3, three.center, Lanes{}, three.scale);
    three.addParts();
    return unmarked(three.unclear);
  }
};

/** All lists are short: how many lanes are marked is added up once. */
template <int D, int Vertices>
struct Rivals
{
  [[gnu::always_inline]] static inline int run(const FacetRivals<D>& task)
  {
    const FacetBatch<D>& batch = task.batch;
    const int d = D == Eigen::Dynamic ? batch.dimension : D;
    LaneBits marked{};
    for (int first = 0; first < task.count; first += lanes)
    {
      Lanes below[Vertices] = {};
      Lanes row;
      const double* column = task.offsets + first;
      for (int m = 0; m < d; ++m, column += task.stride)
      {
        load(column, row);
        for (int v = 0; v < Vertices; ++v)
        {
          below[v] += batch.vertices[v][m][task.lane] * row;
        }
      }
      load(column, row);
      LaneBits any{};
      for (int v = 0; v < Vertices; ++v)
      {
        addNegative(row - below[v] - batch.levels[v][task.lane], any);
      }
      marked -= any; // all bits: minus one
    }
    unsigned long long counts[lanes];
    std::memcpy(counts, &marked, sizeof counts);
    return static_cast<int>(((counts[0] + counts[1]) + (counts[2] + counts[3])) +
      ((counts[4] + counts[5]) + (counts[6] + counts[7])));
  }
};
}

template <int D>
FacetKernels<D> FacetKernels<D>::of(FacetPattern pattern, InstructionSet set)
{
  using Batch = FacetBatch<D>&;
  using Task = const FacetRivals<D>&;
  switch (pattern)
  {
    case FacetPattern::TwoCells:
      return { CompiledFor<TwoCells<D>, Batch>::select(set),
        CompiledFor<Rivals<D, 2>, Task>::select(set) };
    case FacetPattern::Meeting:
      return { CompiledFor<Meeting<D>, Batch>::select(set),
        CompiledFor<Rivals<D, 4>, Task>::select(set) };
    case FacetPattern::Strip:
      break;
  }
  return { CompiledFor<Strip<D>, Batch>::select(set),
    CompiledFor<Rivals<D, 4>, Task>::select(set) };
}

template struct FacetKernels<3>;
template struct FacetKernels<6>;
template struct FacetKernels<Eigen::Dynamic>;
}
