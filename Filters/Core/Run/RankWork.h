/**
 * @file RankWork.h
 * @brief What ranks do for the first one while it runs.
 */
#ifndef remesh_RankWork_h
#define remesh_RankWork_h

#include "Support/RankOrders.h"

namespace remesh
{
/**
 * Does what the first rank asks for, until it is told to leave, or a rank is lost that it hears
 * from. What fails here is told to the first. Its run ends with it, unless there was no room to
 * measure a distance: then the first does it by itself.
 *
 * Memory: the part of the surface, and the sites, with the neighbour lists that it asks for; later,
 * instead of these, the mesh whose distance is measured, and a tree over it.
 */
void workForFirst(Ranks& ranks);
}

#endif
