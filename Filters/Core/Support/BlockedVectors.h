/**
 * @file BlockedVectors.h
 * @brief Parallel vector arithmetic whose sums do not depend on the threads.
 *
 * The vectors have a row of d numbers for each of n items. Dot products are summed within fixed
 * blocks of rows, in a fixed order, and the blocks in theirs.
 */
#ifndef remesh_BlockedVectors_h
#define remesh_BlockedVectors_h

#include "Support/Parallel.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace remesh
{
/** The common cut of all vectors of one length, and the control under which they are worked on. */
class BlockedVectors
{
public:
  BlockedVectors(Offset rows, int dimension, const RunControl& control)
    : m_blocks(Blocks::cut(rows, 64, std::max(1, (1 << 16) / dimension)))
    , m_dimension(dimension)
    , m_control(control.silent())
  {
  }

  /** How many numbers a vector has. */
  std::size_t size() const { return static_cast<std::size_t>(m_blocks.size * m_dimension); }

  /** Calls `body(row)` for each row, in parallel. */
  template <class Body>
  void forEachRow(const Body& body) const
  {
    m_complete &= forEachRange(m_blocks, m_control,
      [&](Offset begin, Offset end)
      {
        for (Offset row = begin; row < end; ++row)
        {
          body(static_cast<std::size_t>(row));
        }
      });
  }

  /** Calls `body(k)` for the index of each number, in parallel. */
  template <class Body>
  void forEach(const Body& body) const
  {
    m_complete &= forEachRange(m_blocks, m_control,
      [&](Offset begin, Offset end)
      {
        for (Offset k = begin * m_dimension; k < end * m_dimension; ++k)
        {
          body(static_cast<std::size_t>(k));
        }
      });
  }

  /** The same, `body(row, k)`, with the row of the number. */
  template <class Body>
  void forEachInRows(const Body& body) const
  {
    this->forEachRow(
      [&](std::size_t row)
      {
        const auto d = static_cast<std::size_t>(m_dimension);
        for (std::size_t k = row * d; k < (row + 1) * d; ++k)
        {
          body(row, k);
        }
      });
  }

  /** The sum of `part(begin, end)` over all blocks of numbers. */
  template <class Part>
  double sumOfBlocks(const Part& part) const
  {
    std::vector<double> partial(static_cast<std::size_t>(m_blocks.count()), 0.0);
    m_complete &= forEachBlock(m_blocks.count(), m_control,
      [&](Offset block)
      {
        partial[block] = part(static_cast<std::size_t>(m_blocks.begin(block) * m_dimension),
          static_cast<std::size_t>(m_blocks.end(block) * m_dimension));
      });
    return std::accumulate(partial.begin(), partial.end(), 0.0);
  }

  /** The sum of `term(k)` over the indices of all numbers. */
  template <class Term>
  double sum(const Term& term) const
  {
    return this->sumOfBlocks(
      [&](std::size_t begin, std::size_t end)
      {
        // Several chains of sums, so that the processor need not wait for each addition.
        double sums[chains] = {};
        std::size_t k = begin;
        for (; k + chains <= end; k += chains)
        {
          for (std::size_t c = 0; c < chains; ++c)
          {
            sums[c] += term(k + c);
          }
        }
        for (; k < end; ++k)
        {
          sums[0] += term(k);
        }
        return ((sums[0] + sums[1]) + (sums[2] + sums[3])) +
          ((sums[4] + sums[5]) + (sums[6] + sums[7]));
      });
  }

  /** False once a run was cancelled: then results so far are not to be used. */
  bool complete() const { return m_complete; }

private:
  static constexpr std::size_t chains = 8;

  Blocks m_blocks; ///< of rows
  Offset m_dimension;
  RunControl m_control;
  mutable bool m_complete = true;
};
}

#endif
