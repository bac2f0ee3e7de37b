/**
 * @class   vtkRestrictedVoronoiDiagram
 * @brief   The restricted Voronoi diagram and Delaunay triangulation of given sites.
 *
 * Input port 0: the surface; input port 1: the sites, any point set with at least 1 point. Their
 * point array `Embedding`, if it has d components, is their place in R^d, else each is put at the
 * surface's point closest to it. Sites are not moved and none is dropped: one with an empty cell
 * has `CellArea` 0 and no point on port 0. `SiteId` is the id of the input point.
 *
 * Output ports: see vtkRestrictedVoronoiAlgorithm. Port 3 has one row.
 */
#ifndef vtkRestrictedVoronoiDiagram_h
#define vtkRestrictedVoronoiDiagram_h

#include "vtkRestrictedVoronoiAlgorithm.h"

class VTKFILTERSANISOTROPICREMESHING_EXPORT vtkRestrictedVoronoiDiagram
  : public vtkRestrictedVoronoiAlgorithm
{
public:
  static vtkRestrictedVoronoiDiagram* New();
  vtkTypeMacro(vtkRestrictedVoronoiDiagram, vtkRestrictedVoronoiAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The sites, input port 1. */
  void SetSitesConnection(vtkAlgorithmOutput* port);
  void SetSitesData(vtkDataObject* sites);
  ///@}

protected:
  vtkRestrictedVoronoiDiagram();
  ~vtkRestrictedVoronoiDiagram() override;

  int RequestWhole(vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkRestrictedVoronoiDiagram(const vtkRestrictedVoronoiDiagram&) = delete;
  void operator=(const vtkRestrictedVoronoiDiagram&) = delete;
};

#endif
