/**
 * @file EnvelopeBuilder.h
 * @brief What adds vertices and borders to an Envelope, and from these its cells' integrals.
 *
 * Each border adds to the integrals of the two cells beside it (Green's theorem); of the facet's
 * edges only edge 1 adds anything, as u = 0 or v = 0 on the others.
 *
 * All of it is inlined into functions that are compiled for a set of instructions
 * (CompiledInLanes.h).
 */
#ifndef remesh_EnvelopeBuilder_h
#define remesh_EnvelopeBuilder_h

#include "Support/Lanes.h"
#include "Voronoi/Envelope.h"

namespace remesh
{
struct EnvelopeBuilder
{
  /** So far outside of the facet, or below nothing, rounding has gone wrong. */
  static constexpr double maxOutside = 1e-9;

  Envelope& envelope;

  explicit EnvelopeBuilder(Envelope& built)
    : envelope(built)
  {
  }

  /** No cell has a part yet. */
  [[gnu::always_inline]] inline void begin()
  {
    envelope.numberOfVertices = 0;
    clearMoments();
  }

  [[gnu::always_inline]] inline void clearMoments()
  {
    for (int q = 0; q < envelope.count; ++q)
    {
      for (double& moment : envelope.moments[q])
      {
        moment = 0.0;
      }
    }
  }

  [[gnu::always_inline]] inline int addVertex(
    double b0, double b1, double b2, int first, int second, int third)
  {
    envelope.vertices[envelope.numberOfVertices] = { { b0, b1, b2 }, { first, second, third } };
    return envelope.numberOfVertices++;
  }

  /** On the facet's edge from corner k to the next, where `second` follows `first`. */
  template <int k>
  [[gnu::always_inline]] inline int addCrossing(double along, int first, int second)
  {
    const double b[3] = { 1.0 - along, along, 0.0 };
    return addVertex(b[(3 - k) % 3], b[(4 - k) % 3], b[(5 - k) % 3], first, second, first);
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
      if (!(moments[0] > -maxOutside))
      {
        return false;
      }
    }
    return true;
  }
};
}

#endif
