#include "Support/RankOrders.h"

#include "Support/RankTree.h"

#include <exception>

namespace remesh
{
namespace
{
/** Does it, and keeps what is thrown first. */
template <class Work>
void keepFailure(std::exception_ptr& failure, const Work& work)
{
  try
  {
    work();
  }
  catch (const std::exception&)
  {
    failure = failure ? failure : std::current_exception();
  }
}
}

void dismissOthers(Ranks& ranks)
{
  handOn(ranks, Packet::of(RankOrder::Leave));
}

void beginAnswer(const Status& status, Packet& answer)
{
  answer.clear();
  answer.add(status.code);
  answer.add(status.message);
}

OtherRanks::~OtherRanks()
{
  while (this->moreAnswers())
  {
    try
    {
      m_ranks.receive(m_next++);
    }
    catch (const std::exception&)
    {
      continue; // whoever hears from it next finds it out
    }
  }
}

void OtherRanks::tell(
  RankOrder order, const Packet& forAll, const std::function<Packet(int)>& partFor)
{
  m_next = 1; // even where one cannot be reached, others answer
  std::exception_ptr failure;
  keepFailure(failure, [&] { handOn(m_ranks, Packet::of(order)); });
  if (isForAll(order))
  {
    keepFailure(failure, [&] { handOn(m_ranks, forAll); });
  }
  for (int rank = 1; hasParts(order) && rank < m_ranks.count(); ++rank)
  {
    Packet part;
    keepFailure(failure, [&] { part = partFor(rank); });
    keepFailure(failure, [&] { m_ranks.send(rank, part); });
  }
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}

Packet OtherRanks::takeAnswer(Status& status)
{
  const int rank = m_next++;
  Packet packet = m_ranks.receive(rank);
  packet.take(status.code);
  packet.take(status.message);
  if (!status.ok())
  {
    status.message = "Process " + std::to_string(rank) + ": " + status.message;
  }
  return packet;
}
}
