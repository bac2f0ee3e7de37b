#include "Voronoi/Envelope.h"

#include "Support/CompiledInLanes.h"
#include "Voronoi/EnvelopeBuilder.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace remesh
{
namespace
{
constexpr double never = std::numeric_limits<double>::infinity();
/** Where two sites come as close to each other, in barycentric coordinates, there is no clear one.
 */
constexpr double closest = 1e-9;

/** A border's end that is still without its other end; `left` and `right` of the way inwards. */
struct OpenEnd
{
  int left;
  int right;
  int third; ///< the other site that meets here, or -1
  int vertex;
};

/** One run of the tracing. */
template <class L>
struct Tracing : EnvelopeBuilder
{
  OpenEnd open[Envelope::mostVertices];
  int numberOpen = 0;
  alignas(64) double reached[Envelope::mostSites];

  using EnvelopeBuilder::EnvelopeBuilder;

  /**
   * The site with the least number, or -1 if there is none, or another within `tie` of it. Without
   * branches: which one it is cannot be foreseen.
   */
  [[gnu::always_inline]] inline int leastOf(const double* numbers, double tie) const
  {
    double least = never;
    for (int q = 0; q < this->envelope.count; q += lanes)
    {
      least = std::min(least, leastOfLanes(numbers + q));
    }
    if (!(least < never))
    {
      return -1;
    }
    const double bound = least + tie;
    std::uint64_t near = 0;
    for (int q = 0; q < this->envelope.count; q += lanes)
    {
      L lead;
      typename L::Bits beyond;
      load(numbers + q, lead);
      findNegative(bound - lead, beyond);
      near |= static_cast<std::uint64_t>(bitsOf(beyond) ^ ((1U << lanes) - 1U)) << q;
    }
    return (near & (near - 1)) == 0 ? __builtin_ctzll(near) : -1;
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

  /** Step 1, along the facet's edge from corner k. */
  [[gnu::always_inline]] inline bool traceEdge(int k, const int owners[3])
  {
    const int l = (k + 1) % 3;
    const double* atK = this->envelope.values[k];
    const double* atL = this->envelope.values[l];
    double along = 0.0;
    int current = owners[k];
    for (int step = 0; current != owners[l]; ++step)
    {
      const double hereK = atK[current];
      const double hereL = atL[current];
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
        store(crossing, reached + q);
      }
      const int next = leastOf(reached, closest);
      if (next < 0 || step > this->envelope.count ||
        this->envelope.numberOfVertices + 3 > Envelope::mostVertices)
      {
        return false;
      }
      const double crossing = std::clamp(reached[next], along, 1.0);
      if (k == 1)
      {
        this->addEdgePiece(along, crossing, current);
      }
      addEnd(current, next, -1, this->addCrossing(k, l, crossing, current, next));
      along = crossing;
      current = next;
    }
    if (k == 1)
    {
      this->addEdgePiece(along, 1.0, current);
    }
    return true;
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
      store(way, reached + q);
    }
    for (int q = this->envelope.count; q % lanes != 0; ++q)
    {
      reached[q] = never;
    }
    reached[i] = never;
    reached[j] = never;
    if (end.third >= 0)
    {
      reached[end.third] = never;
    }
    const double widest = std::max({ std::abs(way0), std::abs(way1), std::abs(way2) });
    const int third = leastOf(reached, closest / widest);
    if (third < 0 || this->envelope.numberOfVertices + 3 > Envelope::mostVertices)
    {
      return false;
    }
    const double far = std::max(0.0, reached[third]);
    const double v0 = b0 + far * way0;
    const double v1 = b1 + far * way1;
    const double v2 = b2 + far * way2;
    if (!(std::min({ v0, v1, v2 }) > -this->mostOutside))
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
    }
    for (int k = 0; k < 3; ++k)
    {
      if (!traceEdge(k, owners))
      {
        return false;
      }
    }
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
