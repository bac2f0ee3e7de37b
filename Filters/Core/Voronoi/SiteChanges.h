/**
 * @file SiteChanges.h
 * @brief What became of the sites of one state in another.
 */
#ifndef remesh_SiteChanges_h
#define remesh_SiteChanges_h

#include "Embedding/EmbeddedSurface.h"

namespace remesh
{
/** Those with equal coordinates are the same; one that has moved is gone, and another added. */
struct SiteChanges
{
  std::vector<Index> later;   ///< n, of each earlier site; noIndex for one that is gone
  std::vector<Index> added;   ///< later sites that were not there, ascending
  std::vector<double> places; ///< m x d, of those that are gone and of those that were added
};

/** O(n) where most are in the same order, and at most O(n log n). */
SiteChanges compareSites(const Sites& earlier, const Sites& later);
}

#endif
