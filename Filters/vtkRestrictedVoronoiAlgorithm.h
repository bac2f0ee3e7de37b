/**
 * @class   vtkRestrictedVoronoiAlgorithm
 * @brief   Output ports of the filters that compute a restricted Voronoi diagram.
 *
 * | port | data | arrays |
 * |---|---|---|
 * | 0 `Surface` | triangles, the restricted Delaunay triangulation: one point per connected component of a restricted cell, at the cell's centroid | point: `SiteId`, `ComponentId`, `CellArea`, `CellMass`, `CellEnergy`, `Embedding`, `Normals`, the input's point arrays, interpolated |
 * | 1 `VoronoiCells` | convex polygons, one per facet and site | cell: `SiteId`, `MergedSiteId`, `ComponentId`, `PatchId`, `InputCellId`, `CellArea`, `CellMass`, `CellEnergy` (of the site's whole cell); point: `Embedding` |
 * | 2 `Sites` | one vertex per site | point: `SiteId`, `MergedSiteId`, `PatchId`, `Weight`, `Embedding`, `CellArea`, `CellMass`, `CellEnergy`, `Centroid`, `NumberOfNeighbors` |
 * | 3 `Convergence` | vtkTable | `Iteration`, `Energy`, `GradientNorm`, `StepLength`, `Time` (s) |
 * | 4 `Edges` | lines | cell: `EdgeType` (0 between two cells, 2 boundary, 3 non-manifold), `SiteId` (2 components, -1 for none) |
 *
 * `CellArea` is measured in R^3, `CellMass` in R^d, `CellEnergy` is the integral of the squared
 * distance to the site in R^d. Field data of port 0: `NumberOfNonManifoldEdges`,
 * `EulerCharacteristic`, `NumberOfExtraPoints` (components beyond the number of sites), `Seed`.
 *
 * Same input, parameters and seed give the same bytes on all ports but for the column `Time`,
 * whatever the number of threads and the back-end.
 */
#ifndef vtkRestrictedVoronoiAlgorithm_h
#define vtkRestrictedVoronoiAlgorithm_h

#include "vtkEmbeddedSurfaceAlgorithm.h"

class vtkPointSet;
class vtkTable;

namespace remesh
{
struct RemeshOptions;
}

class VTKFILTERSANISOTROPICREMESHING_EXPORT vtkRestrictedVoronoiAlgorithm
  : public vtkEmbeddedSurfaceAlgorithm
{
public:
  vtkTypeMacro(vtkRestrictedVoronoiAlgorithm, vtkEmbeddedSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum OutputPorts
  {
    SURFACE = 0,
    VORONOI_CELLS = 1,
    SITES = 2,
    CONVERGENCE = 3,
    EDGES = 4
  };

  ///@{
  /** Whether to fill port 1 (default on). Off saves memory and time. */
  vtkSetMacro(GenerateVoronoiCells, bool);
  vtkGetMacro(GenerateVoronoiCells, bool);
  vtkBooleanMacro(GenerateVoronoiCells, bool);
  ///@}

  ///@{
  /** Whether to fill port 4 (default on). */
  vtkSetMacro(GenerateEdges, bool);
  vtkGetMacro(GenerateEdges, bool);
  vtkBooleanMacro(GenerateEdges, bool);
  ///@}

  ///@{
  /**
   * The largest d for which the points of port 1 carry `Embedding`, 0 to 100000; default 16.
   */
  vtkSetClampMacro(MaximumCellEmbeddingDimension, int, 0, 100000);
  vtkGetMacro(MaximumCellEmbeddingDimension, int);
  ///@}

  ///@{
  /** The outputs by name; port 0 is GetOutput(). */
  vtkPolyData* GetVoronoiCellsOutput();
  vtkPolyData* GetSitesOutput();
  vtkTable* GetConvergenceOutput();
  vtkPolyData* GetEdgesOutput();
  ///@}

  ///@{
  /**
   * Facts about the last execution: dimension of the embedding, steps of the optimiser, restricted
   * Voronoi diagrams computed, CVT energy reached. 0 before the first.
   */
  int GetDimension() const;
  int GetNumberOfIterations() const;
  int GetNumberOfEvaluations() const;
  double GetEnergy() const;
  ///@}

  /**
   * Wall time in seconds of a phase of the last execution: "intake" (with the embedding),
   * "sampling", "lloyd", "newton", "repair" (moving sites to where the mesh is no manifold),
   * "diagram" (diagram, dual and output arrays). 0 for other names.
   */
  double GetPhaseSeconds(const char* phase) const;

protected:
  vtkRestrictedVoronoiAlgorithm();
  ~vtkRestrictedVoronoiAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;

  /**
   * The whole of a diagram filter's RequestData: prepares the surface of input port 0, runs the
   * core with these options (and sites, if not nullptr) and fills the outputs. Returns 1, or 0
   * after an error, with empty outputs.
   */
  int ComputeDiagram(vtkInformationVector** inputVector, vtkInformationVector* outputVector,
    remesh::RemeshOptions& options, vtkPointSet* sites, int seed);

private:
  vtkRestrictedVoronoiAlgorithm(const vtkRestrictedVoronoiAlgorithm&) = delete;
  void operator=(const vtkRestrictedVoronoiAlgorithm&) = delete;

  bool GenerateVoronoiCells = true;
  bool GenerateEdges = true;
  int MaximumCellEmbeddingDimension = 16;
};

#endif
