#include "Voronoi/Envelope.h"

#include "Support/Lanes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace remesh
{
namespace
{
constexpr double never = std::numeric_limits<double>::infinity();
/** So far outside of the facet, or below nothing, rounding has gone wrong. */
constexpr double mostOutside = 1e-9;
/** Where two sites come as close to each other, in barycentric coordinates, there is no clear one.
 */
constexpr double closest = 1e-9;
/** The value of slots that stand for no site. */
constexpr double unreachable = 1e100;

/** A border's end that is still without its other end; `left` and `right` of the way inwards. */
struct OpenEnd
{
  int left;
  int right;
  int third; ///< the other site that meets here, or -1
  int vertex;
};

/** One run of the tracing. */
struct Tracing
{
  Envelope& envelope;
  OpenEnd open[Envelope::mostVertices];
  int numberOpen = 0;
  alignas(64) double reached[Envelope::mostSites];

  explicit Tracing(Envelope& traced)
    : envelope(traced)
  {
  }

  /**
   * The site with the least number, or -1 if there is none, or another within `tie` of it. Without
   * branches: which one it is cannot be foreseen.
   */
  [[gnu::always_inline]] inline int leastOf(const double* numbers, double tie) const
  {
    double least = never;
    for (int q = 0; q < envelope.padded; q += lanes)
    {
      const double* n = numbers + q;
      const double low = std::min(std::min(n[0], n[1]), std::min(n[2], n[3]));
      const double high = std::min(std::min(n[4], n[5]), std::min(n[6], n[7]));
      least = std::min(least, std::min(low, high));
    }
    if (!(least < never))
    {
      return -1;
    }
    const double bound = least + tie;
    int last = 0;
    int found = 0;
    for (int q = 0; q < envelope.padded; ++q)
    {
      const int near = numbers[q] <= bound ? 1 : 0;
      last += near * q;
      found += near;
    }
    return found == 1 ? last : -1;
  }

  [[gnu::always_inline]] inline int addVertex(
    double b0, double b1, double b2, int first, int second, int third)
  {
    envelope.vertices[envelope.numberOfVertices] = { { b0, b1, b2 }, { first, second, third } };
    return envelope.numberOfVertices++;
  }

  /** The border from a to b, `left` on its left side, adds to both. */
  [[gnu::always_inline]] inline void addBorder(int a, int b, int left, int right)
  {
    const double* p = envelope.vertices[a].b;
    const double* q = envelope.vertices[b].b;
    const double cross = p[1] * q[2] - q[1] * p[2];
    const double terms[6] = { cross, cross * (p[1] + q[1]), cross * (p[2] + q[2]),
      cross * (p[1] * p[1] + p[1] * q[1] + q[1] * q[1]),
      cross * (p[1] * q[2] + q[1] * p[2] + 2.0 * (p[1] * p[2] + q[1] * q[2])),
      cross * (p[2] * p[2] + p[2] * q[2] + q[2] * q[2]) };
    for (int t = 0; t < 6; ++t)
    {
      envelope.moments[left][t] += terms[t];
      envelope.moments[right][t] -= terms[t];
    }
  }

  /** The same for a piece of the facet's edge 1, which has a site on its left alone. */
  [[gnu::always_inline]] inline void addEdgePiece(double from, double to, int site)
  {
    const double cross = to - from;
    const double p1 = 1.0 - from;
    const double q1 = 1.0 - to;
    double* moments = envelope.moments[site];
    moments[0] += cross;
    moments[1] += cross * (p1 + q1);
    moments[2] += cross * (from + to);
    moments[3] += cross * (p1 * p1 + p1 * q1 + q1 * q1);
    moments[4] += cross * (p1 * to + q1 * from + 2.0 * (p1 * from + q1 * to));
    moments[5] += cross * (from * from + from * to + to * to);
  }

  /** Step 2: joins the end to its other end, if that is known. */
  [[gnu::always_inline]] inline void addEnd(int left, int right, int third, int vertex)
  {
    for (int k = 0; k < numberOpen; ++k)
    {
      if (open[k].left == right && open[k].right == left)
      {
        addBorder(open[k].vertex, vertex, right, left);
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
    const double* atK = envelope.values[k];
    const double* atL = envelope.values[l];
    double along = 0.0;
    int current = owners[k];
    for (int step = 0; current != owners[l]; ++step)
    {
      const double hereK = atK[current];
      const double hereL = atL[current];
      for (int q = 0; q < envelope.padded; q += lanes)
      {
        Lanes gapK;
        Lanes gapL;
        LaneBits takesOver;
        load(atK + q, gapK);
        load(atL + q, gapL);
        gapK -= hereK;
        gapL -= hereL;
        findNegative(gapL, takesOver);
        storeChosen(gapK / (gapK - gapL), takesOver, reached + q);
      }
      const int next = leastOf(reached, closest);
      if (next < 0 || step > envelope.count ||
        envelope.numberOfVertices + 3 > Envelope::mostVertices)
      {
        return false;
      }
      const double crossing = std::clamp(reached[next], along, 1.0);
      if (k == 1)
      {
        addEdgePiece(along, crossing, current);
      }
      double b[3] = { 0.0, 0.0, 0.0 };
      b[k] = 1.0 - crossing;
      b[l] = crossing;
      addEnd(current, next, -1, addVertex(b[0], b[1], b[2], current, next, current));
      along = crossing;
      current = next;
    }
    if (k == 1)
    {
      addEdgePiece(along, 1.0, current);
    }
    return true;
  }

  /** Step 3, from one open end. */
  [[gnu::always_inline]] inline bool traceBorder(const OpenEnd& end)
  {
    const int i = end.left;
    const int j = end.right;
    const auto& values = envelope.values;
    const double* start = envelope.vertices[end.vertex].b;
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
    for (int q = 0; q < envelope.padded; q += lanes)
    {
      Lanes d0;
      Lanes d1;
      Lanes d2;
      load(values[0] + q, d0);
      load(values[1] + q, d1);
      load(values[2] + q, d2);
      d0 -= here0;
      d1 -= here1;
      d2 -= here2;
      const Lanes gap = d0 * b0 + d1 * b1 + d2 * b2;
      const Lanes slope = d0 * way0 + d1 * way1 + d2 * way2;
      LaneBits falling;
      findNegative(slope, falling);
      storeChosen(-gap / slope, falling, reached + q);
    }
    for (int q = envelope.count; q < envelope.padded; ++q)
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
    if (third < 0 || envelope.numberOfVertices + 3 > Envelope::mostVertices)
    {
      return false;
    }
    const double far = std::max(0.0, reached[third]);
    const double v0 = b0 + far * way0;
    const double v1 = b1 + far * way1;
    const double v2 = b2 + far * way2;
    if (!(std::min({ v0, v1, v2 }) > -mostOutside))
    {
      return false;
    }
    const int vertex = addVertex(v0, v1, v2, i, j, third);
    addBorder(end.vertex, vertex, i, j);
    addEnd(i, third, j, vertex);
    addEnd(third, j, i, vertex);
    return true;
  }

  [[gnu::always_inline]] inline void pad()
  {
    envelope.padded = (envelope.count + lanes - 1) / lanes * lanes;
    for (int q = envelope.count; q < envelope.padded; ++q)
    {
      envelope.values[0][q] = envelope.values[1][q] = envelope.values[2][q] = unreachable;
    }
    for (int q = 0; q < envelope.count; ++q)
    {
      for (double& moment : envelope.moments[q])
      {
        moment = 0.0;
      }
    }
  }

  /** From Green's sums to integrals over the facet's area; false where a part is less than none. */
  [[gnu::always_inline]] inline bool normalize()
  {
    for (int q = 0; q < envelope.count; ++q)
    {
      double* moments = envelope.moments[q];
      moments[1] *= 1.0 / 3.0;
      moments[2] *= 1.0 / 3.0;
      moments[3] *= 1.0 / 6.0;
      moments[4] *= 1.0 / 12.0;
      moments[5] *= 1.0 / 6.0;
      if (!(moments[0] > -mostOutside))
      {
        return false;
      }
    }
    return true;
  }

  /**
   * Two sites: one of them has the corner k alone, and its part is the triangle that their border
   * cuts off there.
   */
  [[gnu::always_inline]] inline bool shareBetweenTwo(const int owners[3])
  {
    int k = 0;
    while (owners[(k + 1) % 3] != owners[(k + 2) % 3])
    {
      ++k;
    }
    const int single = owners[k];
    const int l = (k + 1) % 3;
    const int m = (k + 2) % 3;
    const double sign = single == 0 ? 1.0 : -1.0; // the lead of the single one, at its corner
    const double lead = sign * (envelope.values[k][1] - envelope.values[k][0]);
    const double lagL = sign * (envelope.values[l][0] - envelope.values[l][1]);
    const double lagM = sign * (envelope.values[m][0] - envelope.values[m][1]);
    const double alongL = lead / (lead + lagL);
    const double alongM = lead / (lead + lagM);
    if (!(lead >= 0.0 && lagL >= 0.0 && lagM >= 0.0 && lead + lagL > 0.0 && lead + lagM > 0.0))
    {
      return false;
    }
    // Means over the triangle of the barycentric coordinates and their products.
    double mean[3];
    double square[3];
    double product[3]; // of the two coordinates other than the index
    mean[l] = alongL / 3.0;
    mean[m] = alongM / 3.0;
    mean[k] = 1.0 - mean[l] - mean[m];
    square[l] = alongL * alongL / 6.0;
    square[m] = alongM * alongM / 6.0;
    product[k] = alongL * alongM / 12.0;
    product[m] = mean[l] - square[l] - product[k];
    product[l] = mean[m] - square[m] - product[k];
    square[k] = mean[k] - product[l] - product[m];
    const double fraction = alongL * alongM;
    const double part[6] = { fraction, fraction * mean[1], fraction * mean[2], fraction * square[1],
      fraction * product[0], fraction * square[2] };
    for (const int other : { l, m })
    {
      double b[3] = { 0.0, 0.0, 0.0 };
      b[other] = other == l ? alongL : alongM;
      b[k] = 1.0 - b[other];
      addVertex(b[0], b[1], b[2], 0, 1, 0);
    }
    const double whole[6] = { 1.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0, 1.0 / 12.0, 1.0 / 6.0 };
    for (int t = 0; t < 6; ++t)
    {
      envelope.moments[single][t] = part[t];
      envelope.moments[1 - single][t] = whole[t] - part[t];
    }
    return true;
  }

  [[gnu::always_inline]] inline bool run()
  {
    pad();
    envelope.numberOfVertices = 0;
    int owners[3];
    for (int k = 0; k < 3; ++k)
    {
      owners[k] = leastOf(envelope.values[k], 0.0);
      if (owners[k] < 0)
      {
        return false; // coincident sites, or a bisector through the corner
      }
      addVertex(k == 0, k == 1, k == 2, owners[k], owners[k], owners[k]);
    }
    if (envelope.count == 2 && (owners[0] != owners[1] || owners[0] != owners[2]))
    {
      return shareBetweenTwo(owners);
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
    return normalize();
  }
};

struct TracingRun
{
  [[gnu::always_inline]] static inline bool run(Envelope& envelope)
  {
    return Tracing(envelope).run();
  }
};
}

EnvelopeTracing envelopeTracing(InstructionSet set)
{
  return CompiledFor<TracingRun, Envelope&>::select(set);
}
}
