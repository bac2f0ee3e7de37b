/**
 * @file SitesInput.h
 * @brief Sites that the caller gives.
 */
#ifndef remesh_SitesInput_h
#define remesh_SitesInput_h

#include "Adaptors/SurfacePreparation.h"

class vtkPointSet;

namespace remesh
{
struct GivenSites
{
  Sites sites;                ///< n x d, scaled units
  std::vector<Point3> places; ///< n, as given, in R^3
  std::string warning;        ///< what was not as it should be, or empty
};

/**
 * Reads the points of a data set as sites of a prepared surface: by their point array `Embedding`
 * if it has d components, else each at the closest point of the surface.
 *
 * @return InvalidInput for no points, too many, or a value that is not finite or too far away.
 * Cost: O(n d), or O(n log facets) in parallel, with a tree over the facets, which takes as long
 * as a few thousand searches.
 */
Status readSites(vtkPointSet* input, const PreparedSurface& prepared, const RunControl& control,
  GivenSites& given);
}

#endif
