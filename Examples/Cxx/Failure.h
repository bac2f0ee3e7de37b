/**
 * The one way in which remesh_surface gives up: an exit status and one sentence, thrown where the
 * reason is known and printed by main().
 */
#ifndef Failure_h
#define Failure_h

#include <stdexcept>
#include <string>

enum ExitStatus
{
  EXIT_CANNOT = 1, // the files or the surface do not allow it
  EXIT_USAGE = 2   // the command line makes no sense
};

class Failure : public std::runtime_error
{
public:
  explicit Failure(const std::string& sentence, ExitStatus exitStatus = EXIT_CANNOT)
    : std::runtime_error(sentence)
    , Status(exitStatus)
  {
  }

  ExitStatus Status;
};

#endif
