/**
 * @file GivenSites.h
 * @brief Sites that the caller gives.
 */
#ifndef remesh_GivenSites_h
#define remesh_GivenSites_h

#include "Preparation/SurfacePreparation.h"

namespace remesh
{
struct GivenSites
{
  PointArray places;                   ///< n x 3
  std::optional<PointArray> embedding; ///< n x d, the caller's units; none: `places` alone
};

struct PlacedSites
{
  Sites sites;                ///< n x d, scaled units
  std::vector<Point3> places; ///< n, as given, in R^3
};

/**
 * The sites of a prepared surface: where their embedding says, if it has d components, else each at
 * the closest point of the surface.
 *
 * @param prepared gets a warning where the embedding has other components.
 * @return InvalidInput for no points, too many, or a value that is not finite or too far away.
 * Cost: O(n d), or O(n log facets) in parallel, with a tree over the facets, which takes as long
 * as a few thousand searches.
 */
Status placeSites(const GivenSites& given, const RunControl& control, PreparedSurface& prepared,
  PlacedSites& placed);
}

#endif
