#include "Run/RankWork.h"

#include "Comparison/SharedDistance.h"
#include "Support/RankTree.h"
#include "Voronoi/PartIntegration.h"

#include <exception>
#include <memory>
#include <new>
#include <stdexcept>

namespace remesh
{
namespace
{
/** What `work` returns, or what it throws in words. */
template <class Work>
Status tryTo(const Work& work)
{
  try
  {
    return work();
  }
  catch (const std::bad_alloc&)
  {
    return { StatusCode::OutOfMemory, "There is not enough memory for this run." };
  }
  catch (const std::exception& error)
  {
    return Status::invalid(error.what());
  }
}

class Worker
{
public:
  explicit Worker(Ranks& ranks)
    : m_ranks(ranks)
  {
  }

  /** False: there is no other order. */
  bool followNext()
  {
    RankOrder order = RankOrder::Leave;
    Status status = tryTo(
      [&]
      {
        hear(m_ranks).take(order);
        return Status::success();
      });
    const bool isLost = !status.ok(); // the rank that this one hears from
    if (!isLost && order == RankOrder::Leave)
    {
      return false;
    }
    status = isLost ? status : this->takeAll(order);
    beginAnswer(status, m_answer);
    if (status.ok())
    {
      status = tryTo([&] { return this->follow(order); });
    }
    if (!status.ok())
    {
      beginAnswer(status, m_answer);
    }
    m_ranks.send(Ranks::first, m_answer);
    return !isLost;
  }

private:
  /** What goes with an order, whatever fails. */
  Status takeAll(RankOrder order)
  {
    Status status;
    const auto take = [&](Packet& packet, const auto& from)
    {
      packet = Packet(); // makes room
      const Status taken = tryTo(
        [&]
        {
          packet = from();
          return Status::success();
        });
      status = status.ok() ? taken : status;
    };
    if (order != RankOrder::Integrate)
    {
      m_part.reset(); // before there is something else
      m_answer = Packet();
    }
    if (isForAll(order))
    {
      take(m_forAll, [&] { return hear(m_ranks); });
    }
    if (hasParts(order))
    {
      take(m_own, [&] { return m_ranks.receive(Ranks::first); });
    }
    return status;
  }

  /** Adds to the answer. */
  Status follow(RankOrder order)
  {
    if (order == RankOrder::Integrate)
    {
      return m_part ? m_part->integrate(m_forAll, m_answer)
                    : Status::invalid("There is no surface.");
    }
    if (order == RankOrder::MeasureDistance)
    {
      return sumPartDistances(m_forAll, m_own, m_answer);
    }
    m_part = std::make_unique<PartIntegration>(m_own);
    m_own = Packet();
    return Status::success();
  }

  Ranks& m_ranks;
  std::unique_ptr<PartIntegration> m_part;
  Packet m_forAll; // goes with the last order, as the next
  Packet m_own;
  Packet m_answer; // kept for its memory
};
}

void workForFirst(Ranks& ranks)
{
  Worker worker(ranks);
  try
  {
    while (worker.followNext())
    {
    }
  }
  catch (const std::runtime_error&)
  {
    return; // the first is lost: there is none to tell
  }
}
}
