#include "Voronoi/FacetBatch.h"

#include "Support/CompiledInLanes.h"
#include "Voronoi/FacetLanes.h"

namespace remesh
{
namespace
{
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
    facets.addCorner(k, crossings[0], crossings[1], share, shares);
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

  [[gnu::always_inline]] inline void addParts()
  {
    Shares<L> rest;
    facets.addWhole(rest);
    for (int k = 0; k < 2; ++k)
    {
      const int l = (k + 1) % 3;
      const int m = (k + 2) % 3;
      Shares<L> corner;
      facets.addCorner(k, crossings[k], center, along[k] * center.b[m], corner);
      facets.addCorner(k, center, crossings[m], center.b[l] * (1.0 - along[m]), corner);
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
    findMeeting(three.values[1], three.values[2], three.center, three.unclear);
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

/** The second site has corner 0, and a third one is between it and the reference there. */
template <int D, class L>
struct ThirdBetween
{
  FacetLanes<D, L> facets;
  L offsets[2][FacetBatch<D>::room]; ///< of the second and the third site
  L values[2][3];
  L gaps[3]; ///< of the third one above the second
  L scale{};
  typename L::Bits unclear{};

  [[gnu::always_inline]] inline explicit ThirdBetween(FacetBatch<D>& batch)
    : facets(batch)
  {
    facets.look(1, offsets[0], values[0]);
    facets.look(2, offsets[1], values[1]);
    for (int k = 0; k < 3; ++k)
    {
      gaps[k] = values[1][k] - values[0][k];
      scale += (k == 0 ? -1.0 : 1.0) * values[0][k];
      addNegative((k == 0 ? -1.0 : 1.0) * values[0][k], unclear);
    }
  }

  /** On the edge from corner 0 to l: the ends of the third one's part. */
  [[gnu::always_inline]] inline void cross(int l, L& begin, L& end)
  {
    findZero(gaps[0], -gaps[l], begin, unclear);
    findZero(-values[1][0], values[1][l], end, unclear);
  }

  [[gnu::always_inline]] inline void addVertexOfSecond(int vertex, const Places<L>& place)
  {
    L level;
    evaluate(place, values[0], level);
    facets.addVertex(vertex, place, level, scale);
  }

  /** What the second and the third one have, and the reference has the rest. */
  [[gnu::always_inline]] inline void addParts(const Shares<L>& second, const Shares<L>& third)
  {
    Shares<L> rest;
    facets.addWhole(rest);
    subtract(second, rest);
    subtract(third, rest);
    facets.addPart(0, rest, nullptr, nullptr);
    facets.addPart(1, second, offsets[0], values[0]);
    facets.addPart(2, third, offsets[1], values[1]);
  }
};

template <int D>
struct Notch
{
  template <class L>
  [[gnu::always_inline]] static inline unsigned run(FacetBatch<D>& batch)
  {
    ThirdBetween<D, L> cells(batch);
    const auto& second = cells.values[0];
    L begin;
    L end;
    L along[2]; // to where the second one would meet the reference
    Places<L> places[2];
    Places<L> ends[2];
    Places<L> center;
    cells.cross(1, begin, end);
    for (int e = 0; e < 2; ++e)
    {
      findZero(-second[0], second[e + 1], along[e], cells.unclear);
      placeOnEdge(0, e + 1, along[e], places[e]);
    }
    placeOnEdge(0, 1, begin, ends[0]);
    placeOnEdge(0, 1, end, ends[1]);
    findMeeting(second, cells.values[1], center, cells.unclear);
    addNegative(along[0] - begin, cells.unclear);
    addNegative(end - along[0], cells.unclear);
    L above; // of the third one, where the others' border ends
    evaluate(places[1], cells.values[1], above);
    addNegative(above - closest * cells.scale, cells.unclear);
    cells.addVertexOfSecond(0, ends[0]);
    cells.facets.addVertex(1, ends[1], L{}, cells.scale);
    cells.facets.addVertex(2, center, L{}, cells.scale);
    cells.facets.addVertex(3, places[1], L{}, cells.scale);
    Shares<L> corner;
    Shares<L> ofSecond; // what the third one takes
    Shares<L> third;
    cells.facets.addCorner(0, places[0], places[1], along[0] * along[1], corner);
    cells.facets.addTriangle(
      ends[0], places[0], center, (along[0] - begin) * center.b[2], ofSecond);
    cells.facets.addTriangle(ends[0], ends[1], center, (end - begin) * center.b[2], third);
    subtract(ofSecond, corner);
    cells.addParts(corner, third);
    return unmarked(cells.unclear);
  }
};

template <int D>
struct Band
{
  template <class L>
  [[gnu::always_inline]] static inline unsigned run(FacetBatch<D>& batch)
  {
    ThirdBetween<D, L> cells(batch);
    Places<L> begins[2];
    Places<L> ends[2];
    L nearShare(1.0);
    L farShare(1.0);
    for (int e = 0; e < 2; ++e)
    {
      L begin;
      L end;
      cells.cross(e + 1, begin, end);
      addNegative(end - begin - closest, cells.unclear);
      placeOnEdge(0, e + 1, begin, begins[e]);
      placeOnEdge(0, e + 1, end, ends[e]);
      cells.addVertexOfSecond(e, begins[e]);
      cells.facets.addVertex(2 + e, ends[e], L{}, cells.scale);
      nearShare *= begin;
      farShare *= end;
    }
    Shares<L> second;
    Shares<L> third;
    cells.facets.addCorner(0, begins[0], begins[1], nearShare, second);
    cells.facets.addCorner(0, ends[0], ends[1], farShare, third);
    subtract(second, third);
    cells.addParts(second, third);
    return unmarked(cells.unclear);
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
  const RivalCount<D> count = pattern == FacetPattern::TwoCells
    ? CompiledInLanes<Rivals<D, 2>, Task>::select(set)
    : CompiledInLanes<Rivals<D, 4>, Task>::select(set);
  switch (pattern)
  {
    case FacetPattern::TwoCells:
      return { CompiledInLanes<TwoCells<D>, Batch>::select(set), count };
    case FacetPattern::Meeting:
      return { CompiledInLanes<Meeting<D>, Batch>::select(set), count };
    case FacetPattern::Strip:
      return { CompiledInLanes<Strip<D>, Batch>::select(set), count };
    case FacetPattern::Notch:
      return { CompiledInLanes<Notch<D>, Batch>::select(set), count };
    case FacetPattern::Band:
      break;
  }
  return { CompiledInLanes<Band<D>, Batch>::select(set), count };
}

template struct FacetKernels<3>;
template struct FacetKernels<6>;
template struct FacetKernels<Eigen::Dynamic>;
}
