/**
 * @file TestCancels.h
 * @brief Work that is told to stop, at moments spread over the whole of it.
 */
#ifndef remesh_TestCancels_h
#define remesh_TestCancels_h

#include "Support/RunControl.h"
#include "Support/Status.h"
#include "TestChecks.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <limits>
#include <string>

namespace remesh::test
{
using Work = std::function<Status(const RunControl&)>;

/** Runs the work, which is told to stop when it asks for the k-th time; how often it asked. */
inline int askedUntil(const Work& work, int k, StatusCode& code)
{
  std::atomic<int> asked(0);
  const RunControl control(nullptr, [&]() { return ++asked >= k; });
  code = work(control).code;
  return asked;
}

/**
 * Whenever it is told so, work stops soon and says so, and reads nothing that was not computed:
 * for about `moments` runs, at the first questions of all and evenly from there.
 */
inline void checkCancels(const std::string& name, const Work& work, int moments = 60)
{
#ifdef __SANITIZE_ADDRESS__
  moments /= 3; // each run takes ten times as long
#endif
  const auto expect = [&](bool right, const std::string& what)
  { check(right, __FILE__, __LINE__, name + ": " + what); };
  StatusCode code = StatusCode::Ok;
  const int all = askedUntil(work, std::numeric_limits<int>::max(), code);
  expect(code == StatusCode::Ok, "fails");
  expect(all > 10, "asks " + std::to_string(all) + " times");
  for (int k = 1; k <= all; k += k < moments / 4 ? 1 : 1 + all / moments)
  {
    const int asked = askedUntil(work, k, code);
    if (asked < k) // it was not told: how often it asks depends on which thread has which blocks
    {
      expect(code == StatusCode::Ok, "fails");
      expect(k > all / 2, "asks half as often as before");
      continue;
    }
    const std::string where = "told to stop at question " + std::to_string(k);
    expect(code == StatusCode::Cancelled, where + ": does not say so");
    expect(asked < k + 64, where + ": goes on"); // loops that end before their first block
  }
}
}

#endif
