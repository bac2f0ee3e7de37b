#include "Interruption.h"

#include "Failure.h"

#include <csignal>

namespace
{
volatile std::sig_atomic_t interrupted = 0;

void HandleSignal(int number)
{
  interrupted = number;
}
} // namespace

void CatchInterruptions()
{
  for (int signal : { SIGINT, SIGTERM, SIGHUP })
  {
    if (std::signal(signal, HandleSignal) == SIG_IGN)
    {
      std::signal(signal, SIG_IGN);
    }
  }
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
}

bool Interrupted()
{
  return interrupted != 0;
}

void StopIfInterrupted()
{
  if (Interrupted())
  {
    throw Failure("interrupted");
  }
}

void DieIfInterrupted()
{
  if (Interrupted())
  {
    std::signal(interrupted, SIG_DFL);
    std::raise(interrupted);
  }
}
