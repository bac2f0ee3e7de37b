/**
 * @file TestRankThreads.h
 * @brief Ranks that are threads.
 */
#ifndef remesh_TestRankThreads_h
#define remesh_TestRankThreads_h

#include "Run/RankWork.h"
#include "Support/Ranks.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <functional>
#include <limits>
#include <map>
#include <mutex>
#include <queue>
#include <set>
#include <thread>

namespace remesh::test
{
constexpr std::size_t eachWaits = 0;
/** Words and errors do not wait, as with MPI; parts and packets for all do. */
constexpr std::size_t longOnesWait = 256;

/** What some ranks send each other. */
class Post
{
public:
  /** @param waitFrom a packet of so many bytes is taken before its sending returns. */
  explicit Post(int count, std::size_t waitFrom = std::numeric_limits<std::size_t>::max())
    : m_count(count)
    , m_waitFrom(waitFrom)
  {
  }

  int count() const { return m_count; }

  void send(int from, int to, const Packet& packet)
  {
    std::unique_lock<std::mutex> guard(m_lock);
    const auto checkThere = [&]
    {
      if (m_gone.count(to) != 0)
      {
        throw std::runtime_error("Process " + std::to_string(to) + " cannot be reached.");
      }
    };
    checkThere();
    std::queue<Packet>& box = m_boxes[{ from, to }];
    box.push(packet);
    m_bytes[from] += packet.bytes().size();
    m_changed.notify_all();
    if (packet.bytes().size() >= m_waitFrom)
    {
      m_changed.wait(guard, [&] { return box.empty() || m_gone.count(to) != 0; });
      box.empty() ? void() : checkThere();
    }
  }

  Packet receive(int from, int to)
  {
    std::unique_lock<std::mutex> guard(m_lock);
    std::queue<Packet>& box = m_boxes[{ from, to }];
    m_changed.wait(guard, [&] { return !box.empty() || m_gone.count(from) != 0; });
    if (box.empty())
    {
      throw std::runtime_error("Process " + std::to_string(from) + " does not answer.");
    }
    Packet packet = box.front();
    box.pop();
    m_changed.notify_all();
    return packet;
  }

  /** From now on a rank neither sends nor receives. */
  void close(int rank)
  {
    const std::lock_guard<std::mutex> guard(m_lock);
    m_gone.insert(rank);
    m_changed.notify_all();
  }

  std::size_t bytesFrom(int rank) { return m_bytes[rank]; }
  bool isEmpty() const
  {
    return std::all_of(
      m_boxes.begin(), m_boxes.end(), [](const auto& box) { return box.second.empty(); });
  }

private:
  int m_count;
  std::size_t m_waitFrom;
  std::mutex m_lock;
  std::condition_variable m_changed;
  std::map<std::pair<int, int>, std::queue<Packet>> m_boxes;
  std::map<int, std::size_t> m_bytes;
  std::set<int> m_gone;
};

class ThreadRanks : public Ranks
{
public:
  ThreadRanks(Post& post, int own)
    : m_post(post)
    , m_own(own)
  {
  }
  int count() const override { return m_post.count(); }
  int own() const override { return m_own; }
  void send(int rank, const Packet& packet) override { m_post.send(m_own, rank, packet); }
  Packet receive(int rank) override { return m_post.receive(rank, m_own); }

private:
  Post& m_post;
  int m_own;
};

/** Ranks that fail by an exception when they have received so many packets. */
template <class Failure>
class FailingRanks : public ThreadRanks
{
public:
  FailingRanks(Post& post, int own, int after, const Failure& failure)
    : ThreadRanks(post, own)
    , m_after(after)
    , m_failure(failure)
  {
  }
  Packet receive(int rank) override
  {
    Packet packet = ThreadRanks::receive(rank);
    if (m_after-- == 0)
    {
      throw m_failure;
    }
    return packet;
  }

private:
  int m_after;
  Failure m_failure;
};

/** How often the first of so many ranks sends what it tells all. */
inline int ceilLog2(int number)
{
  return static_cast<int>(std::ceil(std::log2(number)));
}

/** The last of four ranks is lost before the third, from which it hears, gets an order. */
inline void workWithoutLast(Ranks& ranks)
{
  if (ranks.own() == 2)
  {
    try
    {
      ranks.receive(3); // waits until it is lost
    }
    catch (const std::runtime_error&)
    {
      workForFirst(ranks);
    }
  }
  else if (ranks.own() == 1)
  {
    workForFirst(ranks);
  }
}

/** Runs `work` on the first rank while the others work for it. */
inline void runOnRanks(Post& post, const std::function<void(Ranks&)>& work,
  const std::function<void(Ranks&)>& others = workForFirst)
{
  std::vector<std::thread> threads;
  for (int rank = 1; rank < post.count(); ++rank)
  {
    threads.emplace_back(
      [&post, &others, rank]
      {
        ThreadRanks ranks(post, rank);
        others(ranks);
        post.close(rank);
      });
  }
  ThreadRanks first(post, 0);
  work(first);
  try
  {
    dismissOthers(first);
  }
  catch (const std::runtime_error&)
  {
    post.close(0); // a rank is gone: no other may wait for it
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}
}

#endif
