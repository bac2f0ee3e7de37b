/**
 * @file RankTree.h
 * @brief What the first rank tells all others, handed on from rank to rank.
 *
 * The ranks are a binomial tree: rank r hears from r without its lowest bit, and hands on to r + 1,
 * r + 2, r + 4... as far as these are below that bit. So for p ranks the first sends a packet
 * ceil(log2 p) times, no rank sends it more often, and after as many sendings all have it.
 */
#ifndef remesh_RankTree_h
#define remesh_RankTree_h

#include "Support/Ranks.h"

namespace remesh
{
/** The ranks that hear from a rank; those who have most to hand on come first. */
std::vector<int> hearersOf(int rank, int count);

/**
 * Sends a packet to the ranks that hear from this one. Called by the first rank, it reaches all, as
 * each hands on what it hears.
 *
 * Where one cannot be reached, the others are told all the same; then it throws runtime_error.
 */
void handOn(Ranks& ranks, const Packet& packet);

/**
 * Waits for what the first rank tells all, and hands it on; not for the first rank itself. Throws
 * runtime_error; bad_alloc where there is no room for it, which is lost. Then an empty packet is
 * handed on: no rank waits in vain. A rank that it cannot be handed on to is no failure here: the
 * first gets no answer from that one.
 */
Packet hear(Ranks& ranks);
}

#endif
