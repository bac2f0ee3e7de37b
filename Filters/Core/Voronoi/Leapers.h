/**
 * @file Leapers.h
 * @brief The few sites that moved much farther than the others, and how near they are now.
 */
#ifndef remesh_Leapers_h
#define remesh_Leapers_h

#include "Embedding/EmbeddedSurface.h"
#include "Voronoi/SiteDistances.h"

#include <vector>

namespace remesh
{
class Leapers
{
public:
  /** From now on there are none. */
  void clear() { m_sites.clear(); }

  /**
   * Finds those that moved farthest: at most 32, and one site of 256. O(n).
   *
   * @param displacements of all sites. @return the largest of the others.
   */
  double find(const Sites& sites, const std::vector<double>& displacements);

  /** No leaper but itself is nearer to a site than this; infinity where there are none. */
  float nearestTo(const Sites& sites, Index site) const;

private:
  std::vector<Index> m_sites;
  std::vector<double> m_coordinates; ///< of these, see SiteDistances
  SiteDistanceEvaluation m_evaluate = siteDistanceEvaluation(widestInstructionSet());
};
}

#endif
