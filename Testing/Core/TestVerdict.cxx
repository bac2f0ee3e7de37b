// Run/Verdict: the order of its entries, which decides between two meshes everywhere.

#include "Run/Verdict.h"
#include "TestChecks.h"

#include <array>
#include <functional>

using namespace remesh;

namespace
{
using Entry = std::function<void(Verdict&)>;

/** Each makes one entry wrong, the worst first. */
const std::array<Entry, 10> entries{ [](Verdict& v) { v.pointsOff = 1; },
  [](Verdict& v) { v.isUnproven = true; }, [](Verdict& v) { v.pointsForced = 1; },
  [](Verdict& v) { v.intrusions = 1; }, [](Verdict& v) { v.faults = 1; },
  [](Verdict& v) { v.inverted = 1; }, [](Verdict& v) { v.strays = 1; },
  [](Verdict& v) { v.crossings = 1; }, [](Verdict& v) { v.refilled = 1; },
  [](Verdict& v) { v.reserve = 1; } };

/** One entry that is wrong is worse than all that come after it. */
void testOrder()
{
  for (std::size_t k = 0; k < entries.size(); ++k)
  {
    Verdict one;
    entries[k](one);
    Verdict later;
    for (std::size_t other = k + 1; other < entries.size(); ++other)
    {
      entries[other](later);
    }
    CHECK(later < one);
    CHECK(!(one < later));
    CHECK(Verdict() < one);
    CHECK(!(one == later));
  }
}

void testEqual()
{
  Verdict some;
  some.strays = 3;
  CHECK(some == some);
  CHECK(!(some < some));
  CHECK(Verdict() == Verdict());
}
}

int TestVerdict(int, char*[])
{
  testOrder();
  testEqual();
  return test::result();
}
