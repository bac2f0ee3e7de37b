/**
 * @file RankWork.h
 * @brief What ranks do for the first one while it runs.
 */
#ifndef remesh_RankWork_h
#define remesh_RankWork_h

#include "Support/Ranks.h"

namespace remesh
{
/**
 * What a packet to all ranks begins with, which is handed on (RankTree.h). All but the first kind
 * are answered, to the first rank itself.
 */
enum class RankOrder : int
{
  Leave, ///< there is nothing more to do
  /**
   * From the first rank itself comes the length of blocks, and a part of the surface: how much it
   * is, and itself.
   */
  TakeSurface,
  Integrate ///< sites, for which the sums of that part's blocks are sent back
};

/**
 * Does what the first rank asks for, until it is told to leave, or a rank is lost that it hears
 * from. What fails here is told to the first, whose run ends with it.
 *
 * Memory: the part of the surface, and the sites, with the neighbour lists that it asks for.
 */
void workForFirst(Ranks& ranks);

/** The first rank's word that there is nothing more to do. */
void dismissOthers(Ranks& ranks);
}

#endif
