/**
 * @file FacetLabels.h
 * @brief A cell array of the caller's data as labels of the facets.
 */
#ifndef remesh_FacetLabels_h
#define remesh_FacetLabels_h

#include "Mesh/SurfaceMesh.h"
#include "Support/Status.h"

class vtkAbstractArray;
class vtkPolyData;

namespace remesh
{
/**
 * One number per facet, equal where the tuples of their cells are: numbers of any type and number
 * of components, or strings, compared as CellOrder.h tells.
 *
 * @return InvalidInput, with the array's name, for a wrong number of tuples or another type.
 */
Status readFacetLabels(const SurfaceMesh& mesh, vtkAbstractArray* array, Offset numberOfInputCells,
  std::vector<Index>& labels);

/**
 * Where the input has several regions (BlockNames.h), parts labels by them, too: facets keep equal
 * labels only in the same region. Facets without labels get those of their regions.
 */
void addRegions(const SurfaceMesh& mesh, vtkPolyData* input, std::vector<Index>& labels);
}

#endif
