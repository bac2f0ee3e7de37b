/**
 * @file RunControl.h
 * @brief Progress out, cancellation in: the one context that goes through all stages.
 *
 * `report` is called by the thread that called the core, never by a worker, with a fraction that
 * never falls. `cancelled` may be asked by any thread.
 */
#ifndef remesh_RunControl_h
#define remesh_RunControl_h

#include <algorithm>
#include <functional>
#include <utility>

namespace remesh
{
/**
 * How blocks of parallel work are run. `Smp` is the product; the others let tests show that the
 * result does not depend on order and threads.
 */
enum class Schedule
{
  Smp,            ///< vtkSMPTools, in the back-end and with the threads that are set
  ShuffledBlocks, ///< one thread, blocks in a shuffled order
  EightThreads    ///< eight threads of their own, however few cores there are
};

class RunControl
{
public:
  using Report = std::function<void(double fraction, const char* phase)>;
  using Cancelled = std::function<bool()>;

  RunControl() = default;
  RunControl(Report report, Cancelled cancelled)
    : m_report(std::move(report))
    , m_cancelled(std::move(cancelled))
  {
  }

  /** A control for a part of the run: what it calls its whole is [begin, end] of this one's. */
  RunControl part(double begin, double end) const
  {
    RunControl inner = *this;
    inner.m_lower = m_lower + begin * (m_upper - m_lower);
    inner.m_upper = m_lower + end * (m_upper - m_lower);
    inner.m_begin = inner.m_lower;
    inner.m_end = inner.m_upper;
    return inner;
  }

  /** The part [begin, end] of this control's whole that following reports fill, by this name. */
  void enterPhase(const char* name, double begin, double end)
  {
    m_phase = name;
    m_begin = m_lower + begin * (m_upper - m_lower);
    m_end = m_lower + end * (m_upper - m_lower);
    this->report(0.0);
  }

  /** A control whose reports fill the `index`-th of `count` equal steps of the current phase. */
  RunControl step(int index, int count) const
  {
    RunControl inner = *this;
    const double width = (m_end - m_begin) / std::max(count, 1);
    inner.m_begin = m_begin + index * width;
    // The next step's beginning, bit by bit, and never beyond the phase: reports must not fall.
    inner.m_end = index + 1 < count ? m_begin + (index + 1) * width : m_end;
    return inner;
  }

  /** The same control, whose phase has this name from now on. */
  RunControl named(const char* phase) const
  {
    RunControl inner = *this;
    inner.m_phase = phase;
    inner.report(0.0);
    return inner;
  }

  /** A control that can be cancelled but reports nothing: for loops that are too short to tell. */
  RunControl silent() const
  {
    RunControl inner = *this;
    inner.m_report = nullptr;
    return inner;
  }

  /** Reports a fraction (0 to 1) of the current phase; only the calling thread may do so. */
  void report(double fraction) const
  {
    if (m_report)
    {
      const double reached = m_begin + std::max(fraction, 0.0) * (m_end - m_begin);
      m_report(fraction < 1.0 ? std::min(reached, m_end) : m_end, m_phase);
    }
  }

  bool cancelled() const { return m_cancelled && m_cancelled(); }

  Schedule schedule = Schedule::Smp;

private:
  Report m_report;
  Cancelled m_cancelled;
  const char* m_phase = "";
  double m_lower = 0.0; ///< the whole
  double m_upper = 1.0;
  double m_begin = 0.0; ///< the current phase
  double m_end = 1.0;
};
}

#endif
