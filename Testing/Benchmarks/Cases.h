/**
 * @file Cases.h
 * @brief The table of what is measured. To add a case, add a row in Cases.cxx.
 */
#ifndef remesh_benchmark_Cases_h
#define remesh_benchmark_Cases_h

#include "Results.h"
#include "Surfaces.h"

#include <functional>

namespace remesh::benchmark
{
/** The surfaces of a session, each made when it is first asked for. */
class Workshop
{
public:
  explicit Workshop(const Settings& settings)
    : m_settings(settings)
  {
  }

  const Settings& settings() const { return m_settings; }
  /** The scan, or the generated surface of its size. */
  const Surface& fine();
  /** The same, subdivided twice: 16 times as many triangles. */
  const Surface& finest();
  /** A number of triangles or points, divided by the settings' `shrink`. */
  Offset shrunk(double number) const;

private:
  Settings m_settings;
  Surface m_fine;
  Surface m_finest;
};

struct Case
{
  std::string name;
  std::string what; ///< for --list
  std::function<void(Workshop&, CaseResult&)> run;
};

const std::vector<Case>& allCases();
}

#endif
