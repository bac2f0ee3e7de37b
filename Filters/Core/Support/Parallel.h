/**
 * @file Parallel.h
 * @brief Loops over blocks of work, and scratch memory for them. The one seam to vtkSMPTools.
 *
 * Reproducibility rests on two rules that the callers keep: the cut into blocks depends on the
 * data alone, never on the threads; and a block writes only what belongs to it. Partial results
 * are then joined in the order of the blocks.
 */
#ifndef remesh_Parallel_h
#define remesh_Parallel_h

#include "Support/RunControl.h"
#include "Support/Types.h"

#include <functional>
#include <memory>
#include <mutex>
#include <numeric>
#include <vector>

namespace remesh
{
/** A cut of [0, size) into blocks of equal length (the last may be shorter). */
struct Blocks
{
  Offset size = 0;
  Offset length = 1;

  Offset count() const { return (this->size + this->length - 1) / this->length; }
  Offset begin(Offset block) const { return block * this->length; }
  Offset end(Offset block) const { return std::min(this->size, (block + 1) * this->length); }

  /** About `wanted` blocks, none longer than `longest`. */
  static Blocks cut(Offset size, Offset wanted, Offset longest);
};

/**
 * Calls `body(block)` once for each block, in parallel, in no fixed order. Between groups of
 * blocks the calling thread reports progress in the control's current phase. The first
 * exception of a block is thrown on to the caller; blocks that have not begun by then are not run.
 *
 * @return false when the run was cancelled; then some blocks have not been run.
 */
[[nodiscard]] bool forEachBlock(
  Offset numberOfBlocks, const RunControl& control, const std::function<void(Offset)>& body);

/** As above, over the items [begin, end) of each block of `blocks`. */
[[nodiscard]] bool forEachRange(
  const Blocks& blocks, const RunControl& control, const std::function<void(Offset, Offset)>& body);

/** As above, item by item. */
template <class Body>
[[nodiscard]] bool forEachItem(const Blocks& blocks, const RunControl& control, const Body& body)
{
  return forEachRange(blocks, control,
    [&](Offset begin, Offset end)
    {
      for (Offset item = begin; item < end; ++item)
      {
        body(item);
      }
    });
}

/** `term(i)` summed over [0, size) in the order of the blocks; stops early when cancelled. */
template <class Term>
[[nodiscard]] bool sumInBlocks(
  const Blocks& blocks, const RunControl& control, const Term& term, double& sum)
{
  std::vector<double> parts(static_cast<std::size_t>(blocks.count()), 0.0);
  const bool done = forEachBlock(blocks.count(), control,
    [&](Offset block)
    {
      double part = 0.0;
      for (Offset i = blocks.begin(block); i < blocks.end(block); ++i)
      {
        part += term(static_cast<std::size_t>(i));
      }
      parts[static_cast<std::size_t>(block)] = part;
    });
  sum = std::accumulate(parts.begin(), parts.end(), 0.0);
  return done;
}

/** Reusable scratch objects: a block borrows one and gives it back when the lease ends. */
template <class T>
class ScratchPool
{
public:
  /** Gives an object back. There is room for it, so that the end of a lease cannot fail. */
  struct Return
  {
    ScratchPool* pool;

    void operator()(T* used) const noexcept
    {
      const std::lock_guard<std::mutex> guard(this->pool->m_lock);
      this->pool->m_idle.emplace_back(used);
    }
  };
  using Lease = std::unique_ptr<T, Return>;

  explicit ScratchPool(std::function<std::unique_ptr<T>()> make)
    : m_make(std::move(make))
  {
  }

  Lease borrow()
  {
    std::unique_ptr<T> item = this->takeIdle();
    if (!item)
    {
      item = m_make();
      const std::lock_guard<std::mutex> guard(m_lock);
      m_idle.reserve(m_made + 1);
      ++m_made;
    }
    return Lease(item.release(), Return{ this });
  }

private:
  std::unique_ptr<T> takeIdle()
  {
    const std::lock_guard<std::mutex> guard(m_lock);
    if (m_idle.empty())
    {
      return nullptr;
    }
    std::unique_ptr<T> item = std::move(m_idle.back());
    m_idle.pop_back();
    return item;
  }

  std::function<std::unique_ptr<T>()> m_make;
  std::mutex m_lock;
  std::vector<std::unique_ptr<T>> m_idle; ///< with room for all that were made
  std::size_t m_made = 0;
};
}

#endif
