/**
 * @file RankOrders.h
 * @brief What the first rank asks the others for, and what they answer.
 *
 * An order is a word that is told to all, handed on from rank to rank (RankTree.h). What goes with
 * it may be large: a packet for all, handed on likewise, and for each rank a part of its own, from
 * the first rank itself. Each rank takes what is on its way, and answers each order, to the first
 * rank itself, by a status and what was asked for. So where memory is short for a packet or a part,
 * or where the work fails, no rank waits for ever, and nothing is left on the way.
 *
 * A rank that gets no word, as its teller is lost or there is no room even for that, says so and
 * leaves for good, and so do those that hear from it. What is sent to them after that stays on the
 * way; where sending waits for the receiver, it must fail once that has left, or the sender waits
 * for ever.
 */
#ifndef remesh_RankOrders_h
#define remesh_RankOrders_h

#include "Support/Ranks.h"
#include "Support/Status.h"

#include <functional>

namespace remesh
{
/** All but the first kind are answered. */
enum class RankOrder : int
{
  Leave,          ///< there is nothing more to do
  TakeSurface,    ///< a part of the embedded surface (PartIntegration.h)
  Integrate,      ///< for all: the sites; the sums of the part's blocks are sent back
  MeasureDistance ///< for all: a mesh; a part of a surface, of which the distances are sent back
                  ///< (SharedDistance.h)
};

/** Whether a packet for all goes with an order. */
inline bool isForAll(RankOrder order)
{
  return order == RankOrder::Integrate || order == RankOrder::MeasureDistance;
}

/** Whether parts go with it. */
inline bool hasParts(RankOrder order)
{
  return order == RankOrder::TakeSurface || order == RankOrder::MeasureDistance;
}

/** The first rank's word that there is nothing more to do. */
void dismissOthers(Ranks& ranks);

/** Clears an answer, and lets it begin with a status. */
void beginAnswer(const Status& status, Packet& answer);

/** All ranks but the first, for this one. The destructor takes answers that nobody took. */
class OtherRanks
{
public:
  explicit OtherRanks(Ranks& ranks)
    : m_ranks(ranks)
    , m_next(ranks.count())
  {
  }
  ~OtherRanks();
  OtherRanks(const OtherRanks&) = delete;
  OtherRanks& operator=(const OtherRanks&) = delete;

  int count() const { return m_ranks.count(); } ///< of all ranks, the first one, too

  /**
   * Gives an order, that all will answer. Throws runtime_error where one cannot be reached.
   *
   * @param forAll, partFor a rank: empty where they do not go with the order. Where `partFor`
   *        throws, that rank gets an empty packet, the others their parts, and then it is thrown
   *        again.
   */
  void tell(RankOrder order, const Packet& forAll, const std::function<Packet(int)>& partFor);

  /** Whether there are answers to wait for. */
  bool moreAnswers() const { return m_next < m_ranks.count(); }

  /** Waits for the next answer, in the order of the ranks, and takes its status. */
  Packet takeAnswer(Status& status);

private:
  Ranks& m_ranks;
  int m_next; ///< the rank that is to answer next; their number: none
};
}

#endif
