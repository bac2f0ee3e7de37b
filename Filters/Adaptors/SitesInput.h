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
 * @return InvalidInput for no points, too many, or a value that is not finite.
 * Cost: O(n d), or a search in a cell locator for each.
 */
Status readSites(vtkPointSet* input, const PreparedSurface& prepared, GivenSites& given);
}

#endif
