#include "Support/RankTree.h"

#include <algorithm>
#include <exception>
#include <optional>

namespace remesh
{
namespace
{
/** The rank that a rank, not the first, hears from. */
int tellerOf(int rank)
{
  return rank & (rank - 1);
}
}

std::vector<int> hearersOf(int rank, int count)
{
  std::vector<int> hearers;
  for (int bit = 1; rank + bit < count && (rank & bit) == 0; bit *= 2)
  {
    hearers.push_back(rank + bit);
  }
  std::reverse(hearers.begin(), hearers.end());
  return hearers;
}

void handOn(Ranks& ranks, const Packet& packet)
{
  std::optional<std::runtime_error> lost;
  for (const int rank : hearersOf(ranks.own(), ranks.count()))
  {
    try
    {
      ranks.send(rank, packet);
    }
    catch (const std::runtime_error& error)
    {
      lost = lost ? lost : error;
    }
  }
  if (lost)
  {
    throw *lost;
  }
}

Packet hear(Ranks& ranks)
{
  Packet packet;
  std::exception_ptr failure;
  try
  {
    packet = ranks.receive(tellerOf(ranks.own()));
  }
  catch (const std::exception&)
  {
    failure = std::current_exception();
  }
  try
  {
    handOn(ranks, packet);
  }
  catch (const std::runtime_error&)
  {
    // The first finds it out: that rank does not answer. This one has heard, and works on.
  }
  if (failure)
  {
    std::rethrow_exception(failure);
  }
  return packet;
}
}
