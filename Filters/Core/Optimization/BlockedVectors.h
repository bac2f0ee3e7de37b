/**
 * @file BlockedVectors.h
 * @brief Parallel vector arithmetic whose sums do not depend on the threads.
 *
 * Dot products are summed within fixed blocks, in a fixed order, and the blocks in theirs.
 */
#ifndef remesh_BlockedVectors_h
#define remesh_BlockedVectors_h

#include "Support/Parallel.h"

#include <vector>

namespace remesh
{
/** The common cut of all vectors of one length, and the control under which they are worked on. */
class BlockedVectors
{
public:
  BlockedVectors(std::size_t size, const RunControl& control)
    : m_blocks(Blocks::cut(static_cast<Offset>(size), 64, 1 << 16))
    , m_control(control.silent())
  {
  }

  /** Calls `body(k)` for each index, in parallel. */
  template <class Body>
  void forEach(const Body& body) const
  {
    m_complete &= forEachRange(m_blocks, m_control,
      [&](Offset begin, Offset end)
      {
        for (Offset k = begin; k < end; ++k)
        {
          body(static_cast<std::size_t>(k));
        }
      });
  }

  /** The sum of `term(k)` over all indices. */
  template <class Term>
  double sum(const Term& term) const
  {
    std::vector<double> partial(static_cast<std::size_t>(m_blocks.count()), 0.0);
    m_complete &= forEachBlock(m_blocks.count(), m_control,
      [&](Offset block)
      {
        // Several chains of sums, so that the processor need not wait for each addition.
        double sums[chains] = {};
        Offset k = m_blocks.begin(block);
        for (; k + chains <= m_blocks.end(block); k += chains)
        {
          for (Offset c = 0; c < chains; ++c)
          {
            sums[c] += term(static_cast<std::size_t>(k + c));
          }
        }
        for (; k < m_blocks.end(block); ++k)
        {
          sums[0] += term(static_cast<std::size_t>(k));
        }
        partial[block] =
          ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7]));
      });
    double total = 0.0;
    for (const double value : partial)
    {
      total += value;
    }
    return total;
  }

  /** False once a run was cancelled: then results so far are not to be used. */
  bool complete() const { return m_complete; }

private:
  static constexpr Offset chains = 8;

  Blocks m_blocks;
  RunControl m_control;
  mutable bool m_complete = true;
};
}

#endif
