#include "Run/Verdict.h"

#include <tuple>

namespace remesh
{
namespace
{
auto inOrder(const Verdict& v)
{
  return std::tie(v.pointsOff, v.isUnproven, v.pointsForced, v.intrusions, v.faults, v.inverted,
    v.strays, v.crossings, v.refilled, v.reserve);
}
}

bool operator<(const Verdict& a, const Verdict& b)
{
  return inOrder(a) < inOrder(b);
}

bool operator==(const Verdict& a, const Verdict& b)
{
  return inOrder(a) == inOrder(b);
}
}
