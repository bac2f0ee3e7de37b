/**
 * @file Envelope.h
 * @brief The restricted cells on one facet as a lower envelope, traced with rounded arithmetic.
 *
 * On a facet, |x - x_q|^2 differs from |x - x_o|^2 by an affine function of the barycentric
 * coordinates: three numbers a site, whatever d is. The cells are where these functions are least.
 * Tracing their common borders makes each vertex once, and each border adds to the integrals of
 * the two cells beside it (Green's theorem):
 *
 * 1. along each edge of the facet, from its owner at one corner, the site that takes over first, a
 *    step of all three edges at a time; where it does, a border between two cells starts inwards;
 * 2. the two ends of a border know each other by their pair of sites (cells are convex: two share
 *    at most one border in a facet);
 * 3. from an end without its other end, the site that is met first along the border makes a vertex
 *    of three cells, where two further borders start.
 *
 * Nothing here is exact: a facet where two sites come too close to tell which is first, or where
 * the ends do not fit together, is refused and left to FacetDecomposition. All sites are looked at
 * in each step, several at once.
 *
 * Cost: O(v k / lanes) for v vertices and k sites.
 */
#ifndef remesh_Envelope_h
#define remesh_Envelope_h

#include "Support/InstructionSet.h"
#include "Support/Lanes.h"

#include <algorithm>

namespace remesh
{
struct Envelope
{
  /** The value of slots that stand for no site. */
  static constexpr double unreachable = 1e100;
  static constexpr int maxSites = 64;
  static constexpr int maxVertices = 3 * maxSites;

  /** The affine functions at the facet's corners, and far above up to whole lanes. */
  int count = 0;
  alignas(64) double values[3][maxSites];

  /** The slot that is least at each corner; -1 if several are, or none is there. */
  int owners[3];
  double least[3];

  /**
   * Over each cell's part of the facet, in barycentric coordinates u = b_1, v = b_2: the integrals
   * of 1, u, v, uu, uv, vv, divided by the facet's area. Zero for a site without a part.
   */
  double moments[maxSites][6];

  /** Corners of the facet (one site), crossings of its edges (two), points of three cells. */
  struct Vertex
  {
    double b[3];
    int sites[3]; ///< slots; the first one repeated where there are fewer
  };
  int numberOfVertices = 0;
  Vertex vertices[maxVertices];

  /** No site yet. */
  void clear()
  {
    this->count = 0;
    for (int k = 0; k < 3; ++k)
    {
      this->owners[k] = -1;
      this->least[k] = unreachable;
    }
  }

  /** Adds a site that the facet's cells may need; at most `maxSites`. */
  void add(const double atCorners[3])
  {
    if (this->count % lanes == 0)
    {
      for (double(&row)[maxSites] : this->values)
      {
        std::fill_n(row + this->count, lanes, unreachable);
      }
    }
    for (int k = 0; k < 3; ++k)
    {
      const double value = atCorners[k];
      this->values[k][this->count] = value;
      this->owners[k] = value < this->least[k] ? this->count
        : value == this->least[k]              ? -1
                                               : this->owners[k];
      this->least[k] = std::min(this->least[k], value);
    }
    ++this->count;
  }
};

using EnvelopeTracing = bool (*)(Envelope&);

/**
 * Traces the cells; false where rounding got in the way. Compiled for a set of instructions; all
 * give the same bits.
 */
EnvelopeTracing envelopeTracing(InstructionSet set);
}

#endif
