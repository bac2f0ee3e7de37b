/**
 * @file CornerCells.h
 * @brief The cells on a facet where only the sites that own its corners have a part.
 *
 * That is most facets that are small against the cells. Two owners part along a line, three in a
 * point. Functions on a facet are affine here: another site has no part if it is above at all
 * vertices of the parts; where that is not clear, or there is another way for three to part, it is
 * left to the tracing (Envelope.h).
 *
 * Cost: O(1), for at most `lanes` sites.
 */
#ifndef remesh_CornerCells_h
#define remesh_CornerCells_h

#include "Voronoi/EnvelopeBuilder.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace remesh
{
class CornerCells
{
public:
  explicit CornerCells(Envelope& envelope)
    : m_builder(envelope)
    , m_envelope(envelope)
  {
  }

  /** The parts of the owners of the three corners, which are vertices; false: as before. */
  [[gnu::always_inline]] inline bool share(const int owners[3])
  {
    if (m_envelope.count > lanes)
    {
      return false;
    }
    const bool equal[3] = { owners[1] == owners[2], owners[2] == owners[0],
      owners[0] == owners[1] };
    if (equal[0] && equal[1])
    {
      return false;
    }
    const bool shared = equal[0] ? this->shareBetweenTwo(0, owners)
      : equal[1]                 ? this->shareBetweenTwo(1, owners)
      : equal[2]                 ? this->shareBetweenTwo(2, owners)
                                 : this->shareAmongThree(owners);
    if (!shared)
    {
      m_envelope.numberOfVertices = 3;
    }
    return shared;
  }

private:
  /** Only who is farther above than this part of the owners' differences is clearly above. */
  static constexpr double closest = 1e-9;
  /** Where borders meet is told only if the sine of their angle, in barycentric coordinates, is
   *  larger. */
  static constexpr double leastSine = 1e-6;

  /** Whether the sites of all slots but `owners` (bits) are above the cells, at each vertex. */
  [[gnu::always_inline]] inline bool othersAreAbove(double margin, unsigned owners) const
  {
    Lanes at[3];
    LaneBits low{};
    for (int k = 0; k < 3; ++k)
    {
      load(m_envelope.values[k], at[k]);
    }
    for (int v = 0; v < m_envelope.numberOfVertices; ++v)
    {
      const Envelope::Vertex& vertex = m_envelope.vertices[v];
      const double* b = vertex.b;
      const int slot = vertex.sites[0];
      const double level = b[0] * m_envelope.values[0][slot] + b[1] * m_envelope.values[1][slot] +
        b[2] * m_envelope.values[2][slot];
      LaneBits below;
      findNegative(at[0] * b[0] + at[1] * b[1] + at[2] * b[2] - (level + margin), below);
      low |= below;
    }
    return (bitsOf(low) & ~owners) == 0;
  }

  /** One has the corner k alone, and its part is the triangle that their border cuts off there. */
  [[gnu::always_inline]] inline bool shareBetweenTwo(int k, const int owners[3])
  {
    const int l = (k + 1) % 3;
    const int m = (k + 2) % 3;
    const int single = owners[k];
    const int other = owners[l];
    const auto& values = m_envelope.values;
    const double lead = values[k][other] - values[k][single];
    const double lagL = values[l][single] - values[l][other];
    const double lagM = values[m][single] - values[m][other];
    const double alongL = lead / (lead + lagL);
    const double alongM = lead / (lead + lagM);
    if (!(lead >= 0.0 && lagL >= 0.0 && lagM >= 0.0 && lead + lagL > 0.0 && lead + lagM > 0.0))
    {
      return false;
    }
    m_builder.addCrossing(k, l, alongL, single, other);
    m_builder.addCrossing(k, m, alongM, single, other);
    if (m_envelope.count > 2 &&
      !this->othersAreAbove(closest * (lead + lagL + lagM), 1U << single | 1U << other))
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
    const double whole[6] = { 1.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0, 1.0 / 12.0, 1.0 / 6.0 };
    for (int t = 0; t < 6; ++t)
    {
      m_envelope.moments[single][t] = part[t];
      m_envelope.moments[other][t] = whole[t] - part[t];
    }
    return true;
  }

  /** Their borders start on one edge each and meet. */
  [[gnu::always_inline]] inline bool shareAmongThree(const int owners[3])
  {
    const auto& values = m_envelope.values;
    double along[3];
    int crossings[3];
    double scale = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const int l = (k + 1) % 3;
      const int m = (k + 2) % 3;
      const double lead = values[k][owners[l]] - values[k][owners[k]];
      const double lag = values[l][owners[k]] - values[l][owners[l]];
      along[k] = lead / (lead + lag);
      const double third = (1.0 - along[k]) * (values[k][owners[m]] - values[k][owners[k]]) +
        along[k] * (values[l][owners[m]] - values[l][owners[k]]);
      if (!(lead > 0.0 && lag > 0.0 && third > closest * (lead + lag)))
      {
        return false; // the third has a part of this edge, or comes close to it
      }
      scale += lead + lag;
      crossings[k] = m_builder.addCrossing(k, l, along[k], owners[k], owners[l]);
    }
    const int center = this->addMeeting(owners);
    if (center < 0 ||
      (m_envelope.count > 3 &&
        !this->othersAreAbove(
          closest * scale, 1U << owners[0] | 1U << owners[1] | 1U << owners[2])))
    {
      return false;
    }
    for (int k = 0; k < 3; ++k)
    {
      m_builder.addBorder(crossings[k], center, owners[k], owners[(k + 1) % 3]);
    }
    m_builder.addEdgePiece(0.0, along[1], owners[1]);
    m_builder.addEdgePiece(along[1], 1.0, owners[2]);
    if (!m_builder.normalize())
    {
      m_builder.clearMoments();
      return false;
    }
    return true;
  }

  /** The point as far from all three, or -1. */
  [[gnu::always_inline]] inline int addMeeting(const int owners[3])
  {
    double p[3];
    double q[3];
    double longestP = 0.0;
    double longestQ = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const double* at = m_envelope.values[k];
      p[k] = at[owners[1]] - at[owners[0]];
      q[k] = at[owners[2]] - at[owners[0]];
      longestP = std::max(longestP, std::abs(p[k]));
      longestQ = std::max(longestQ, std::abs(q[k]));
    }
    const double c[3] = { p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2],
      p[0] * q[1] - p[1] * q[0] };
    const double sum = c[0] + c[1] + c[2];
    if (!(std::abs(sum) > leastSine * longestP * longestQ))
    {
      return -1;
    }
    const double b[3] = { c[0] / sum, c[1] / sum, c[2] / sum };
    return std::min({ b[0], b[1], b[2] }) > 0.0
      ? m_builder.addVertex(b[0], b[1], b[2], owners[0], owners[1], owners[2])
      : -1;
  }

  EnvelopeBuilder m_builder;
  Envelope& m_envelope;
};
}

#endif
