#include "Voronoi/RankWork.h"

#include "Embedding/SurfacePart.h"
#include "Voronoi/RestrictedVoronoi.h"

#include <exception>
#include <memory>
#include <new>

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
}

void workForFirst(Ranks& ranks)
{
  std::unique_ptr<PartIntegration> part;
  std::vector<BlockSums> blocks;
  Packet answer; // both are kept for their memory
  for (;;)
  {
    bool leaves = false;
    bool answered = false;
    const auto follow = [&]
    {
      Packet packet = ranks.receive(Ranks::first);
      RankOrder order = RankOrder::Leave;
      packet.take(order);
      leaves = order == RankOrder::Leave;
      if (order == RankOrder::TakeSurface)
      {
        part.reset(); // before there is another
        part = std::make_unique<PartIntegration>(packet);
      }
      if (order != RankOrder::Integrate)
      {
        return Status::success();
      }
      if (!part)
      {
        return Status::invalid("There is no surface.");
      }
      if (Status status = part->integrate(packet, blocks); !status.ok())
      {
        return status;
      }
      begin(Status::success(), answer);
      addBlocks(blocks, answer);
      answered = true;
      return Status::success();
    };
    const Status status = tryTo(follow);
    if (leaves)
    {
      return;
    }
    if (!answered)
    {
      begin(status, answer);
    }
    ranks.send(Ranks::first, answer);
  }
}

void dismissOthers(Ranks& ranks)
{
  Packet packet;
  packet.add(RankOrder::Leave);
  for (int rank = 1; rank < ranks.count(); ++rank)
  {
    ranks.send(rank, packet);
  }
}
}
