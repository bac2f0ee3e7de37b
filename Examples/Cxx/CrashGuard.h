/**
 * The last line of defence against malformed files: some of VTK's readers follow any number they
 * find in a file, and may crash.
 */
#ifndef CrashGuard_h
#define CrashGuard_h

#include <string>

/**
 * While it lives, a crash prints one sentence, "remesh_surface: cannot read 'path': ...", and ends
 * the program with EXIT_CANNOT. To be used only while nothing has been written. One at a time.
 */
class CrashGuard
{
public:
  explicit CrashGuard(const std::string& path);
  ~CrashGuard();
  CrashGuard(const CrashGuard&) = delete;
  CrashGuard& operator=(const CrashGuard&) = delete;
};

#endif
