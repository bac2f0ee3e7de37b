/**
 * @class   vtkRestrictedVoronoiDiagram
 * @brief   Cuts a surface into the Voronoi cells of given sites, and joins the sites to triangles.
 *
 * Each place of the surface belongs to the site that is nearest to it in the embedding (see
 * vtkEmbeddedSurfaceAlgorithm): these parts are the cells. Sites whose cells meet are joined to
 * triangles, the restricted Delaunay triangulation.
 *
 * Input port 0: the surface; input port 1: the sites, any point set with at least 1 point. Their
 * point array `Embedding`, if it has d components, is their place in R^d, else each is put at the
 * surface's point closest to it. Sites are not moved and none is dropped: one with an empty cell
 * has `CellArea` 0 and no point on port 0. `SiteId` is the id of the input point.
 *
 * Output ports: see vtkRestrictedVoronoiAlgorithm. Port 3 has one row.
 *
 * @par When to use it:
 * - To part a surface among points of your own, such as sensors or seeds: each piece of the surface
 *   goes to the point nearest to it. `Anisotropy` 0 measures in space alone.
 * - To see the diagram that a mesh of vtkAnisotropicRemesher comes from, or to mesh sites that you
 *   have moved or chosen yourself.
 *
 * To have the sites moved to where they make good triangles, take vtkAnisotropicRemesher.
 *
 * @par What is guaranteed:
 * The cells cover the surface and do not overlap: their areas sum to its area. Each point of a cell
 * is as close to the cell's site, in the embedding, as to any other.
 *
 * @par Limits:
 * - Features are not kept: a cell, and the mesh, may reach across a crease.
 * - A site may own several separate pieces of the surface; the mesh then has a point for each.
 * - The mesh has the topology of the surface only where the sites are dense enough; the field array
 *   `TopologyPreserved` tells.
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
