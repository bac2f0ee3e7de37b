#include "Voronoi/RankWork.h"

#include "Embedding/SurfacePart.h"
#include "Support/RankTree.h"
#include "Voronoi/RestrictedVoronoi.h"

#include <exception>
#include <memory>
#include <new>
#include <stdexcept>

namespace remesh
{
namespace
{
/** A part of the surface and its diagram. */
class PartIntegration
{
public:
  explicit PartIntegration(Packet& packet)
    : m_blockLength(take<Offset>(packet))
    , m_share(take<double>(packet))
    , m_surface(takeSurface(packet))
    , m_voronoi(m_surface)
  {
    m_voronoi.beShare(m_share);
  }

  Status integrate(Packet& packet, std::vector<BlockSums>& blocks)
  {
    packet.take(m_sites.dimension);
    packet.take(m_sites.fixed);
    packet.take(m_sites.coordinates);
    return m_voronoi.integrateBlocks(m_sites, m_blockLength, RunControl(), blocks);
  }

private:
  template <class T>
  static T take(Packet& packet)
  {
    T value = 0;
    packet.take(value);
    return value;
  }

  Offset m_blockLength;
  double m_share;
  EmbeddedSurface m_surface;
  Sites m_sites;
  RestrictedVoronoi m_voronoi;
};

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

void begin(const Status& status, Packet& answer)
{
  answer.clear();
  answer.add(status.code);
  answer.add(status.message);
}

void addBlocks(const std::vector<BlockSums>& blocks, Packet& packet)
{
  packet.add(blocks.size());
  for (const BlockSums& block : blocks)
  {
    packet.add(block.sites);
    packet.add(block.values);
  }
}

class Worker
{
public:
  explicit Worker(Ranks& ranks)
    : m_ranks(ranks)
  {
  }

  /** False: there is no other. */
  bool followNext()
  {
    Packet packet;
    Status status = tryTo(
      [&]
      {
        packet = hear(m_ranks);
        return Status::success();
      });
    // Without a word from others there is none to come. What there was no room for was an order.
    bool stays = status.code != StatusCode::InvalidInput;
    begin(status, m_answer);
    if (status.ok())
    {
      status = tryTo([&] { return this->follow(packet, stays); });
      if (!status.ok())
      {
        begin(status, m_answer);
      }
      else if (!stays)
      {
        return false;
      }
    }
    m_ranks.send(Ranks::first, m_answer);
    return stays;
  }

private:
  /** Adds to the answer. */
  Status follow(Packet& packet, bool& stays)
  {
    RankOrder order = RankOrder::Leave;
    packet.take(order);
    stays = order != RankOrder::Leave;
    if (order == RankOrder::TakeSurface)
    {
      m_part.reset(); // before there is another
      Packet part = m_ranks.receive(Ranks::first);
      m_part = std::make_unique<PartIntegration>(part);
    }
    return order == RankOrder::Integrate ? this->integrate(packet) : Status::success();
  }

  Status integrate(Packet& sites)
  {
    if (!m_part)
    {
      return Status::invalid("There is no surface.");
    }
    Status status = m_part->integrate(sites, m_blocks);
    if (status.ok())
    {
      addBlocks(m_blocks, m_answer);
    }
    return status;
  }

  Ranks& m_ranks;
  std::unique_ptr<PartIntegration> m_part;
  std::vector<BlockSums> m_blocks; // this and the next are kept for their memory
  Packet m_answer;
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

void dismissOthers(Ranks& ranks)
{
  handOn(ranks, Packet::of(RankOrder::Leave));
}
}
