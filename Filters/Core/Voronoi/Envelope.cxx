#include "Voronoi/Envelope.h"

#include "Support/CompiledInLanes.h"
#include "Voronoi/EnvelopeBuilder.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace remesh
{
namespace
{
/** Far beyond all that is reached. No infinity, whose low bits are no number's. */
constexpr double never = 1e200;
/** Where two sites come as close to each other, in barycentric coordinates, there is no clear one.
 */
constexpr double closestSites = 1e-9;

/** A border's end that is still without its other end; `left` and `right` of the way inwards. */
struct OpenEnd
{
  int left;
  int right;
  int third; ///< the other site that meets here, or -1
  int vertex;
};

/** Where along an edge of the facet one site takes over from another. */
struct Takeover
{
  double along;
  int from;
  int to;
};

/** An edge of the facet, from the owner of one corner to that of the next, as far as known. */
struct EdgeCourse
{
  int current;
  int last;
  double along = 0.0;
  int count = 0;
  Takeover takeovers[Envelope::maxSites + 1];
};

/** The two least of numbers. */
struct LeastTwo
{
  double least = never;
  double second = never;

  [[gnu::always_inline]] inline LeastTwo() = default;
  [[gnu::always_inline]] inline LeastTwo(double a, double b)
    : least(std::min(a, b))
    , second(std::max(a, b))
  {
  }
  [[gnu::always_inline]] inline LeastTwo(const LeastTwo& a, const LeastTwo& b)
    : least(std::min(a.least, b.least))
    , second(std::min(std::max(a.least, b.least), std::min(a.second, b.second)))
  {
  }
};

/** One run of the tracing. */
template <class L>
struct Tracing : EnvelopeBuilder
{
  using Slots = double[Envelope::maxSites];
  static constexpr unsigned long long slotBits = Envelope::maxSites - 1;
  static_assert((Envelope::maxSites & slotBits) == 0);

  OpenEnd open[Envelope::maxVertices];
  int numberOpen = 0;
  EdgeCourse edges[3];
  alignas(64) Slots reached[3];
  alignas(64) Slots numbered[3]; ///< the same, with the slot in the lowest bits

  using EnvelopeBuilder::EnvelopeBuilder;

  /** Keeps how far from here the slots of a group are reached. */
  [[gnu::always_inline]] inline void keep(const L& way, int first, int k)
  {
    static constexpr unsigned long long numbers[lanes] = { 0, 1, 2, 3, 4, 5, 6, 7 };
    store(way, reached[k] + first);
    for (int part = 0; part < L::parts; ++part)
    {
      typename L::Bits::Vector bits;
      typename L::Bits::Vector slots;
      std::memcpy(&bits, &way.part[part], sizeof bits);
      std::memcpy(&slots, numbers + part * L::width, sizeof slots);
      bits = (bits & ~slotBits) | (slots + static_cast<unsigned long long>(first));
      std::memcpy(numbered[k] + first + part * L::width, &bits, sizeof bits);
    }
  }

  /**
   * The slot that is reached first, or -1 if none is, or another within `tie` of it. Which one it
   * is cannot be foreseen: so there are no branches, and it is in the number itself.
   */
  [[gnu::always_inline]] inline int firstReached(int k, double tie) const
  {
    LeastTwo all;
    for (int q = 0; q < this->envelope.count; q += lanes)
    {
      const double* n = numbered[k] + q;
      const LeastTwo low({ n[0], n[1] }, { n[2], n[3] });
      const LeastTwo high({ n[4], n[5] }, { n[6], n[7] });
      all = { all, { low, high } };
    }
    unsigned long long bits = 0;
    std::memcpy(&bits, &all.least, sizeof bits);
    return all.least < 0.5 * never && all.second > all.least + tie
      ? static_cast<int>(bits & slotBits)
      : -1;
  }

  /** Step 2: joins the end to its other end, if that is known. */
  [[gnu::always_inline]] inline void addEnd(int left, int right, int third, int vertex)
  {
    for (int k = 0; k < numberOpen; ++k)
    {
      if (open[k].left == right && open[k].right == left)
      {
        this->addBorder(open[k].vertex, vertex, right, left);
        open[k] = open[--numberOpen];
        return;
      }
    }
    open[numberOpen++] = { left, right, third, vertex };
  }

  /** Where all sites take over from the current one along the edge from corner k. */
  template <int k>
  [[gnu::always_inline]] inline void look()
  {
    const double* atK = this->envelope.values[k];
    const double* atL = this->envelope.values[(k + 1) % 3];
    const double hereK = atK[edges[k].current];
    const double hereL = atL[edges[k].current];
    for (int q = 0; q < this->envelope.count; q += lanes)
    {
      L gapK;
      L gapL;
      typename L::Bits takesOver;
      load(atK + q, gapK);
      load(atL + q, gapL);
      gapK -= hereK;
      gapL -= hereL;
      findNegative(gapL, takesOver);
      L crossing = gapK / (gapK - gapL);
      keepChosen(takesOver, never, crossing);
      this->keep(crossing, q, k);
    }
  }

  /** Goes to the next site along an edge, if it does not end; false: there is no clear one. */
  [[gnu::always_inline]] inline bool takeOver(int k)
  {
    EdgeCourse& edge = edges[k];
    const bool ends = edge.current == edge.last;
    const int found = this->firstReached(k, closestSites);
    const int next = found < 0 ? edge.current : found;
    const double along = std::min(std::max(reached[k][next], edge.along), 1.0);
    edge.takeovers[edge.count] = { along, edge.current, next };
    edge.count += !ends;
    edge.current = ends ? edge.current : next;
    edge.along = ends ? edge.along : along;
    return ends || found >= 0;
  }

  /** Step 1, a step of all edges at a time: the processor does not wait for each alone. */
  [[gnu::always_inline]] inline bool traceEdges()
  {
    for (int step = 0; edges[0].current != edges[0].last || edges[1].current != edges[1].last ||
         edges[2].current != edges[2].last;
         ++step)
    {
      if (step == this->envelope.count)
      {
        return false;
      }
      this->template look<0>();
      this->template look<1>();
      this->template look<2>();
      const bool clear0 = this->takeOver(0);
      const bool clear1 = this->takeOver(1);
      const bool clear2 = this->takeOver(2);
      if (!(clear0 & clear1 & clear2))
      {
        return false;
      }
    }
    return edges[0].count + edges[1].count + edges[2].count + 3 <= Envelope::maxVertices;
  }

  /** The ends of borders on an edge of the facet. */
  template <int k>
  [[gnu::always_inline]] inline void addEdge()
  {
    const EdgeCourse& edge = edges[k];
    double along = 0.0;
    for (int t = 0; t < edge.count; ++t)
    {
      const Takeover& next = edge.takeovers[t];
      if (k == 1)
      {
        this->addEdgePiece(along, next.along, next.from);
      }
      addEnd(next.from, next.to, -1, this->template addCrossing<k>(next.along, next.from, next.to));
      along = next.along;
    }
    if (k == 1)
    {
      this->addEdgePiece(along, 1.0, edge.last);
    }
  }

  /** Step 3, from one open end. */
  [[gnu::always_inline]] inline bool traceBorder(const OpenEnd& end)
  {
    const int i = end.left;
    const int j = end.right;
    const auto& values = this->envelope.values;
    const double* start = this->envelope.vertices[end.vertex].b;
    const double b0 = start[0];
    const double b1 = start[1];
    const double b2 = start[2];
    const double e0 = values[0][j] - values[0][i];
    const double e1 = values[1][j] - values[1][i];
    const double e2 = values[2][j] - values[2][i];
    const double way0 = e1 - e2;
    const double way1 = e2 - e0;
    const double way2 = e0 - e1;
    const double here0 = values[0][i];
    const double here1 = values[1][i];
    const double here2 = values[2][i];
    for (int q = 0; q < this->envelope.count; q += lanes)
    {
      L d0;
      L d1;
      L d2;
      load(values[0] + q, d0);
      load(values[1] + q, d1);
      load(values[2] + q, d2);
      d0 -= here0;
      d1 -= here1;
      d2 -= here2;
      const L gap = d0 * b0 + d1 * b1 + d2 * b2;
      const L slope = d0 * way0 + d1 * way1 + d2 * way2;
      typename L::Bits falling;
      findNegative(slope, falling);
      L way = -gap / slope;
      keepChosen(falling, never, way);
      this->keep(way, q, 0); // who stands for no site is reached outside of the facet
    }
    numbered[0][i] = never;
    numbered[0][j] = never;
    numbered[0][end.third < 0 ? i : end.third] = never;
    const double widest = std::max({ std::abs(way0), std::abs(way1), std::abs(way2) });
    const int third = this->firstReached(0, closestSites / widest);
    if (third < 0 || this->envelope.numberOfVertices + 3 > Envelope::maxVertices)
    {
      return false;
    }
    const double far = std::max(0.0, reached[0][third]);
    const double v0 = b0 + far * way0;
    const double v1 = b1 + far * way1;
    const double v2 = b2 + far * way2;
    if (!(std::min({ v0, v1, v2 }) > -this->maxOutside))
    {
      return false;
    }
    const int vertex = this->addVertex(v0, v1, v2, i, j, third);
    this->addBorder(end.vertex, vertex, i, j);
    addEnd(i, third, j, vertex);
    addEnd(third, j, i, vertex);
    return true;
  }

  [[gnu::always_inline]] inline bool run()
  {
    this->begin();
    const int* owners = this->envelope.owners;
    for (int k = 0; k < 3; ++k)
    {
      if (owners[k] < 0)
      {
        return false; // coincident sites, or a bisector through the corner
      }
      this->addVertex(k == 0, k == 1, k == 2, owners[k], owners[k], owners[k]);
      edges[k].current = owners[k];
      edges[k].last = owners[(k + 1) % 3];
    }
    if (!this->traceEdges())
    {
      return false;
    }
    this->template addEdge<0>();
    this->template addEdge<1>();
    this->template addEdge<2>();
    while (numberOpen > 0)
    {
      const OpenEnd end = open[--numberOpen];
      if (!traceBorder(end))
      {
        return false;
      }
    }
    return this->normalize();
  }
};

struct TracingRun
{
  template <class L>
  [[gnu::always_inline]] static inline bool run(Envelope& envelope)
  {
    return Tracing<L>(envelope).run();
  }
};
}

EnvelopeTracing envelopeTracing(InstructionSet set)
{
  return CompiledInLanes<TracingRun, Envelope&>::select(set);
}
}
