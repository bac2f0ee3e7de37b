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

/** A bit for each lane without a mark. */
template <class Bits>
[[gnu::always_inline]] inline unsigned unmarked(const Bits& marks)
{
  return ~bitsOf(marks) & ((1U << lanes) - 1U);
}

/** A site that has the triangle which its border with the reference cuts off at its corner. */
template <int D, class L>
struct CutOffCorner
{
  L offsets[FacetBatch<D>::room];
  L values[3];
  Places<L> crossings[2]; ///< on the edges to the next corner, and to the one after
  L along[2];
  Shares<L> shares;

  /** Its corner is k, its vertices are from this one on. */
  [[gnu::always_inline]] inline void cut(
    FacetLanes<D, L>& facets, int part, int k, int vertex, typename L::Bits& unclear)
  {
    facets.look(part, offsets, values);
    const L lead = -values[k];
    const L scale = lead + values[(k + 1) % 3] + values[(k + 2) % 3];
    L share(1.0);
    addNegative(lead, unclear);
    for (int e = 0; e < 2; ++e)
    {
      const int l = (k + 1 + e) % 3;
      addNegative(values[l], unclear);
      addNegative(lead + values[l] - smallest, unclear);
      along[e] = lead / (lead + values[l]);
      placeOnEdge(k, l, along[e], crossings[e]);
      facets.addVertex(vertex + e, crossings[e], L{}, scale);
      share *= along[e];
    }
    facets.addTriangle(k, crossings[0], crossings[1], share, shares);
    facets.addPart(part, shares, offsets, values);
  }
};

template <int D>
struct TwoCells
{
  template <class L>
  [[gnu::always_inline]] static inline unsigned run(FacetBatch<D>& batch)
  {
    FacetLanes<D, L> facets(batch);
    typename L::Bits unclear{};
    CutOffCorner<D, L> single;
    single.cut(facets, 1, 0, 0, unclear);
    Shares<L> rest;
    facets.addWhole(rest);
    subtract(single.shares, rest);
    facets.addPart(0, rest, nullptr, nullptr);
    return unmarked(unclear);
  }
};

template <int D>
struct Strip
{
  template <class L>
  [[gnu::always_inline]] static inline unsigned run(FacetBatch<D>& batch)
  {
    FacetLanes<D, L> facets(batch);
    typename L::Bits unclear{};
    CutOffCorner<D, L> next;
    CutOffCorner<D, L> last;
    next.cut(facets, 1, 1, 0, unclear);
    last.cut(facets, 2, 2, 2, unclear);
    // On the edge between them the reference has a part, too.
    addNegative(1.0 - closest - next.along[0] - last.along[1], unclear);
    Shares<L> rest;
    facets.addWhole(rest);
    subtract(next.shares, rest);
    subtract(last.shares, rest);
    facets.addPart(0, rest, nullptr, nullptr);
    return unmarked(unclear);
  }
};

/** Their borders start on one edge each and meet; each has two triangles at its corner. */
template <int D, class L>
struct MeetingCells
{
  FacetLanes<D, L> facets;
  L offsets[2][FacetBatch<D>::room]; ///< of the second and the third site
  L values[3][3] = {};               ///< by sites; those of the reference are zero
  Places<L> crossings[3];            ///< on the edge from corner k to the next
  L along[3];
  L levels[3]; ///< at the crossings
  Places<L> center;
  L scale{};
  typename L::Bits unclear{};

  [[gnu::always_inline]] inline explicit MeetingCells(FacetBatch<D>& batch)
    : facets(batch)
  {
    facets.look(1, offsets[0], values[1]);
    facets.look(2, offsets[1], values[2]);
  }

  [[gnu::always_inline]] inline void cross(int k)
  {
    const int l = (k + 1) % 3;
    const int m = (k + 2) % 3;
    const L lead = values[l][k] - values[k][k];
    const L lag = values[k][l] - values[l][l];
    along[k] = lead / (lead + lag);
    placeOnEdge(k, l, along[k], crossings[k]);
    scale += lead + lag;
    addNegative(lead - smallest, unclear);
    addNegative(lag - smallest, unclear);
    // The third may have a part of this edge, or comes close to it.
    L third;
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
    const L c[3] = { p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2],
      p[0] * q[1] - p[1] * q[0] };
    const L sum = c[0] + c[1] + c[2];
    const L lengths =
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
    Shares<L> rest;
    facets.addWhole(rest);
    for (int k = 0; k < 2; ++k)
    {
      const int l = (k + 1) % 3;
      const int m = (k + 2) % 3;
      Shares<L> corner;
      facets.addTriangle(k, crossings[k], center, along[k] * center.b[m], corner);
      facets.addTriangle(k, center, crossings[m], center.b[l] * (1.0 - along[m]), corner);
      subtract(corner, rest);
      facets.addPart(k, corner, k == 0 ? nullptr : offsets[0], k == 0 ? nullptr : values[1]);
    }
    facets.addPart(2, rest, offsets[1], values[2]);
  }

  [[gnu::always_inline]] static inline unsigned run(FacetBatch<D>& batch)
  {
    MeetingCells three(batch);
    for (int k = 0; k < 3; ++k)
    {
      three.cross(k);
    }
    three.meet();
    for (int k = 0; k < 3; ++k)
    {
      three.facets.addVertex(k, three.crossings[k], three.levels[k], three.scale);
    }
    three.facets.addVertex(3, three.center, L{}, three.scale);
    three.addParts();
    return unmarked(three.unclear);
  }
};

template <int D>
struct Meeting
{
  template <class L>
  [[gnu::always_inline]] static inline unsigned run(FacetBatch<D>& batch)
  {
    return MeetingCells<D, L>::run(batch);
  }
};

/** All lists are short: how many lanes are marked is added up once. */
template <int D, int Vertices>
struct Rivals
{
  template <class L>
  [[gnu::always_inline]] static inline int run(const FacetRivals<D>& task)
  {
    const FacetBatch<D>& batch = task.batch;
    const int d = D == Eigen::Dynamic ? batch.dimension : D;
    typename L::Bits marked{};
    for (int first = 0; first < task.count; first += lanes)
    {
      L below[Vertices] = {};
      L row;
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
      typename L::Bits any{};
      for (int v = 0; v < Vertices; ++v)
      {
        addNegative(row - below[v] - batch.levels[v][task.lane], any);
      }
      count(any, marked);
    }
    return sumOf(marked);
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
      return { CompiledInLanes<TwoCells<D>, Batch>::select(set),
        CompiledInLanes<Rivals<D, 2>, Task>::select(set) };
    case FacetPattern::Meeting:
      return { CompiledInLanes<Meeting<D>, Batch>::select(set),
        CompiledInLanes<Rivals<D, 4>, Task>::select(set) };
    case FacetPattern::Strip:
      break;
  }
  return { CompiledInLanes<Strip<D>, Batch>::select(set),
    CompiledInLanes<Rivals<D, 4>, Task>::select(set) };
}

template struct FacetKernels<3>;
template struct FacetKernels<6>;
template struct FacetKernels<Eigen::Dynamic>;
}
