#include "CrashGuard.h"

#include "Failure.h"

#include <csignal>
#include <unistd.h>

namespace
{
const int crashes[] = { SIGSEGV, SIGBUS, SIGFPE, SIGABRT };

std::string sentence;

/** Calls only what a signal handler may call. */
void HandleCrash(int)
{
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, sentence.data(), sentence.size());
  _exit(EXIT_CANNOT);
}
} // namespace

CrashGuard::CrashGuard(const std::string& path)
{
  sentence = "remesh_surface: cannot read '" + path + "': malformed file, VTK's reader crashed\n";
  for (const int crash : crashes)
  {
    std::signal(crash, HandleCrash);
  }
}

CrashGuard::~CrashGuard()
{
  for (const int crash : crashes)
  {
    std::signal(crash, SIG_DFL);
  }
}
