/**
 * @file PhaseTimer.h
 * @brief Where the time of a run goes: wall and processor seconds, summed up by phase.
 */
#ifndef remesh_PhaseTimer_h
#define remesh_PhaseTimer_h

#include <chrono>
#include <ctime>

namespace remesh
{
/** Time spent; the processor seconds are those of all threads of the process. */
struct Elapsed
{
  double wall = 0.0;
  double processor = 0.0;
};

/**
 * Adds the time from its making to its end to one phase, or from phase to phase. Costs about a
 * microsecond for each: for whole loops, not for their bodies.
 */
class PhaseTimer
{
public:
  explicit PhaseTimer(Elapsed& phase)
    : m_phase(&phase)
  {
  }
  ~PhaseTimer() { this->stop(); }
  PhaseTimer(const PhaseTimer&) = delete;
  PhaseTimer& operator=(const PhaseTimer&) = delete;

  /** Ends the current phase and begins `phase`. */
  void next(Elapsed& phase)
  {
    this->stop();
    m_phase = &phase;
  }

private:
  void stop()
  {
    const auto wall = std::chrono::steady_clock::now();
    const std::clock_t processor = std::clock();
    m_phase->wall += std::chrono::duration<double>(wall - m_wall).count();
    m_phase->processor += static_cast<double>(processor - m_processor) / CLOCKS_PER_SEC;
    m_wall = wall;
    m_processor = processor;
  }

  Elapsed* m_phase;
  std::chrono::steady_clock::time_point m_wall = std::chrono::steady_clock::now();
  std::clock_t m_processor = std::clock();
};
}

#endif
