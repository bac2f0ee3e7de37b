#include "Refinement/PieceFlips.h"

#include "Support/Parallel.h"

#include <algorithm>
#include <tuple>

namespace remesh
{
namespace
{
constexpr double gain = 1e-6; // relative: less is rounding

using Corner = std::array<float, 3>;

int next(int k)
{
  return (k + 1) % 3;
}

/** Above 0 where three places turn left. Exact: coordinates are multiples of 2^-24. */
double turnOf(const Corner& a, const Corner& b, const Corner& c)
{
  const auto difference = [](const Corner& from, const Corner& to, int k)
  { return static_cast<double>(to[k]) - static_cast<double>(from[k]); };
  return difference(a, b, 1) * difference(a, c, 2) - difference(a, b, 2) * difference(a, c, 1);
}

/** The pieces of one facet. */
class Facet
{
public:
  Facet(const PieceShapes& shapes, const Pieces& pieces)
    : m_shapes(shapes)
    , m_pieces(pieces)
  {
  }

  void run(Index begin, Index end)
  {
    m_begin = begin;
    m_energies.clear();
    for (Index piece = begin; piece < end; ++piece)
    {
      m_energies.push_back(m_shapes.energy(m_pieces.origins[piece]));
    }
    if (*std::max_element(m_energies.begin(), m_energies.end()) <= m_shapes.enough)
    {
      return;
    }
    this->join(end);
    while (!m_waiting.empty())
    {
      const Index side = m_waiting.back();
      m_waiting.pop_back();
      if (m_across[side] != noIndex)
      {
        this->tryFlip(side);
      }
    }
  }

private:
  /** Finds what is across each side. That of a piece after corner k: 3 (piece - begin) + k. */
  void join(Index end)
  {
    m_sides.clear();
    m_waiting.clear();
    m_across.assign(3 * static_cast<std::size_t>(end - m_begin), noIndex);
    for (Index piece = m_begin; piece < end; ++piece)
    {
      const Triple& points = m_pieces.points[piece];
      for (int k = 0; k < 3; ++k)
      {
        m_sides.emplace_back(std::min(points[k], points[next(k)]),
          std::max(points[k], points[next(k)]), 3 * (piece - m_begin) + k);
      }
    }
    std::sort(m_sides.begin(), m_sides.end());
    for (std::size_t i = 0; i + 1 < m_sides.size(); ++i)
    {
      const auto& [low, high, side] = m_sides[i];
      const auto& [otherLow, otherHigh, other] = m_sides[i + 1];
      if (low == otherLow && high == otherHigh)
      {
        m_across[side] = other;
        m_across[other] = side;
        m_waiting.push_back(side);
      }
    }
  }

  void tryFlip(Index side)
  {
    const Index other = m_across[side];
    const Index f = m_begin + side / 3;
    const Index g = m_begin + other / 3;
    const int k = static_cast<int>(side % 3);
    const int l = static_cast<int>(other % 3);
    const FacetOrigin& first = m_pieces.origins[f];
    const FacetOrigin& second = m_pieces.origins[g];
    double& firstEnergy = m_energies[f - m_begin];
    double& secondEnergy = m_energies[g - m_begin];
    if (std::max(firstEnergy, secondEnergy) <= m_shapes.enough)
    {
      return;
    }
    // first: a b c, second: b a d
    const Corner& a = first.corners[k];
    const Corner& b = first.corners[next(k)];
    const Corner& c = first.corners[next(next(k))];
    const Corner& d = second.corners[next(next(l))];
    if (!(turnOf(a, d, c) > 0.0 && turnOf(d, b, c) > 0.0))
    {
      return;
    }
    const FacetOrigin newFirst{ first.facet, { a, d, c } };
    const FacetOrigin newSecond{ first.facet, { d, b, c } };
    const double newFirstEnergy = m_shapes.energy(newFirst);
    const double newSecondEnergy = m_shapes.energy(newSecond);
    if (newFirstEnergy + newSecondEnergy < (1.0 - gain) * (firstEnergy + secondEnergy))
    {
      m_pieces.origins[f] = newFirst;
      m_pieces.origins[g] = newSecond;
      firstEnergy = newFirstEnergy;
      secondEnergy = newSecondEnergy;
      this->flip(side, other);
    }
  }

  /** What is not of the pieces' origins. */
  void flip(Index side, Index other)
  {
    const Index f = side / 3;
    const Index g = other / 3;
    const int k = static_cast<int>(side % 3);
    const int l = static_cast<int>(other % 3);
    const Triple first = m_pieces.points[m_begin + f];
    const Triple second = m_pieces.points[m_begin + g];
    const Index c = first[next(next(k))];
    const Index d = second[next(next(l))];
    m_pieces.points[m_begin + f] = { first[k], d, c };
    m_pieces.points[m_begin + g] = { d, first[next(k)], c };
    const Index sides[4] = { 3 * g + next(l), 3 * f + next(next(k)), 3 * g + next(next(l)),
      3 * f + next(k) };
    const Index places[4] = { 3 * f, 3 * f + 2, 3 * g, 3 * g + 1 };
    Index beyond[4];
    FeatureKind kinds[4] = {};
    for (int i = 0; i < 4; ++i)
    {
      beyond[i] = m_across[sides[i]];
      kinds[i] = this->kindOf(sides[i]);
    }
    for (int i = 0; i < 4; ++i)
    {
      m_across[places[i]] = beyond[i];
      this->setKind(places[i], kinds[i]);
      if (beyond[i] != noIndex)
      {
        m_across[beyond[i]] = places[i];
        m_waiting.push_back(places[i]);
      }
    }
    m_across[3 * f + 1] = 3 * g + 2;
    m_across[3 * g + 2] = 3 * f + 1;
    this->setKind(3 * f + 1, FeatureKind::None);
    this->setKind(3 * g + 2, FeatureKind::None);
  }

  FeatureKind kindOf(Index side) const
  {
    return m_pieces.kinds.empty() ? FeatureKind::None
                                  : m_pieces.kinds[m_begin + side / 3][side % 3];
  }

  void setKind(Index side, FeatureKind kind)
  {
    if (!m_pieces.kinds.empty())
    {
      m_pieces.kinds[m_begin + side / 3][side % 3] = kind;
    }
  }

  const PieceShapes& m_shapes;
  Pieces m_pieces;
  Index m_begin = 0;
  std::vector<double> m_energies;
  std::vector<Index> m_across; ///< of each side
  std::vector<Index> m_waiting;
  std::vector<std::tuple<Index, Index, Index>> m_sides; ///< both points, side
};
}

bool flipPieces(const PieceShapes& shapes, const RunControl& control, Pieces pieces)
{
  std::vector<Index> begins; // of facets that are in pieces, and their ends
  std::vector<Index> ends;
  const auto count = static_cast<Index>(pieces.origins.size());
  for (Index begin = 0, end = 0; begin < count; begin = end)
  {
    while (end < count && pieces.origins[end].facet == pieces.origins[begin].facet)
    {
      ++end;
    }
    if (end - begin > 1)
    {
      begins.push_back(begin);
      ends.push_back(end);
    }
  }
  return forEachRange(Blocks::cut(static_cast<Offset>(begins.size()), 256, 1 << 10), control,
    [&](Offset first, Offset last)
    {
      Facet facet(shapes, pieces);
      for (Offset i = first; i < last; ++i)
      {
        facet.run(begins[i], ends[i]);
      }
    });
}
}
