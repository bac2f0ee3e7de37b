/**
 * @class   vtkSurfaceMeshComparison
 * @brief   Measures how good a surface mesh is, alone and against a reference surface.
 *
 * Of a mesh alone: how well shaped its triangles are, its borders, components and faults. Against a
 * reference, as the surface that the mesh was made from: how far both are from each other, both
 * ways, and how their normals differ.
 *
 * Input port 0: the mesh to judge; port 1, optional: the reference surface. Both are any
 * vtkPolyData with polygons or triangle strips, which are cut into triangles as
 * vtkAnisotropicRemesher does. Nothing is merged, dropped or turned round: the mesh is judged
 * as it is. Vertices, lines and ghost cells are ignored, points that no triangle uses take no part
 * in the surfaces.
 *
 * @par When to use it:
 * - To see how far a mesh is from the surface it was made from, and where: colour `Mesh` by
 *   `Distance`.
 * - To judge a mesh alone, before a simulation: smallest angles, non-manifold edges, duplicate
 *   points, orientation.
 * - To compare several meshes of one surface by the numbers of `Summary`.
 *
 * @par Outputs and arrays:
 * - 0 `Mesh`: the mesh with all its arrays but those named like the filter's own (other cells than
 *   triangles replaced by triangles, with their cell arrays; then without cell arrays that have not
 *   one tuple for each cell and, where cells are cut, without global ids).
 *   Cell arrays: `Quality` (1 / RadiusRatio: 1 for equilateral triangles, 0 for those without
 *   area), `MinimumAngle` (degrees), `RadiusRatio` (circumradius over twice the inradius, >= 1) and
 *   `EdgeRatio` (longest over shortest edge, >= 1), both 1e30 where they are infinite, all by the
 *   definitions of vtkMeshQuality.
 *   With a reference: cell arrays `NormalDeviation` (degrees, 0 to 180, between the triangle's
 *   normal and that of the reference's triangle closest to its centroid; of several that are
 *   equally close, the one that faces most alike; NaN for a triangle without area), `Flipped` (1
 *   where that is above 90), and point arrays `Distance` to the reference and `SignedDistance`
 *   (negative behind the reference, against its normals). What vtkAnisotropicRemesher tells as
 *   flipped or stray triangles is `Flipped`, as a rule.
 * - 1 `Reference`: the reference with the point arrays `Distance` to the mesh and `SignedDistance`,
 *   and unlike port 0 with all its cells as they are, also those that take no part, as ghost cells
 *   and their marks; empty without a reference.
 * - 2 `Summary`: a table of one row. With a reference, in its unit of length and, as columns with
 *   the prefix `Relative`, as a fraction of its bounding box's diagonal (`ReferenceDiagonal`):
 *   `RMSDistance` (root of the mean of the mean squares of both directions), `MaximumDistance`,
 *   `MaximumDistanceBound`, and of each direction `MeanDistanceToReference`,
 *   `RMSDistanceToReference`, `MaximumDistanceToReference` and the same `FromReference`; further
 *   `Area`, `ReferenceArea`, `NumberOfFlippedTriangles`, `MeanNormalDeviation` (by area) and
 *   `MaximumNormalDeviation`.
 *   Always: `MinimumQuality`, `MeanQuality`, `LeastMinimumAngle`, `MeanMinimumAngle`,
 *   `MaximumEdgeRatio`, `NumberOfPoints` (used ones), `NumberOfTriangles`, `NumberOfEdges`,
 *   `EulerCharacteristic`, `NumberOfComponents` (joined by points), `NumberOfBoundaryLoops`,
 *   `NumberOfBoundaryEdges`, `NumberOfNonManifoldEdges` (of more than two triangles),
 *   `NumberOfNonManifoldPoints` (where triangles form more than one fan), `NumberOfDuplicatePoints`
 *   (at the coordinates of another), `NumberOfDuplicateTriangles`, `NumberOfDegenerateTriangles`
 *   and `IsConsistentlyOriented`; with a reference, those from `NumberOfPoints` on of it, too, with
 *   the prefix `Reference`, after points with equal coordinates were merged.
 * - 3 `Histograms`: a table of `NumberOfBins` rows. `Quality` (0 to 1), `MinimumAngle` (0 to 60)
 *   and, with a reference, `NormalDeviation` (0 to 180) are the middles of the bins,
 *   `QualityTriangles`, `MinimumAngleTriangles` and `NormalDeviationTriangles` the counts.
 *
 * @par What is guaranteed:
 * The output does not depend on the threads or the back-end.
 *
 * Distances are between all points of the surfaces, not between vertices: means are integrals over
 * the area, by quadrature, or on triangles with fewer than six places by their mean, at about
 * `NumberOfSamples` fixed places on each surface. `MaximumDistance`
 * is the largest distance found, so the true (Hausdorff) distance is not less; it is not more than
 * `MaximumDistanceBound` (but for rounding). The bound is refined until it is at most 1 % above the
 * maximum or a millionth of the diagonal; on surfaces that are very close to each other for their
 * sampling, the effort may not suffice and the bound is larger.
 *
 * @par Limits:
 * `SignedDistance` is absent where the other surface is not consistently oriented (after points
 * with equal coordinates were merged). On a closed surface the sign tells inside from outside; near
 * a border, the side that the closest place faces.
 *
 * `NormalDeviation` and `Flipped` go by the order of the points of the triangles of both: they mean
 * something on a consistently oriented reference only (`ReferenceIsConsistentlyOriented`).
 *
 * Both surfaces must be whole: where they are distributed over processes, a warning tells so.
 *
 * An input that cannot be used is an error; an empty mesh gives empty outputs; an empty reference
 * is as none, with a warning.
 *
 * Cost: a search, logarithmic in the number of triangles, for each sample, point and triangle, and
 * for at most 5 `NumberOfSamples` parts of triangles for the bound, each way.
 */
#ifndef vtkSurfaceMeshComparison_h
#define vtkSurfaceMeshComparison_h

#include "vtkFiltersAnisotropicRemeshingModule.h" // For export macro
#include "vtkWholeSurfaceAlgorithm.h"

class vtkTable;

class VTKFILTERSANISOTROPICREMESHING_EXPORT vtkSurfaceMeshComparison : public vtkWholeSurfaceAlgorithm
{
public:
  static vtkSurfaceMeshComparison* New();
  vtkTypeMacro(vtkSurfaceMeshComparison, vtkWholeSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum OutputPorts
  {
    MESH = 0,
    REFERENCE = 1,
    SUMMARY = 2,
    HISTOGRAMS = 3
  };

  enum SMPBackends
  {
    SMP_AUTOMATIC = 0,
    SMP_SEQUENTIAL = 1,
    SMP_STDTHREAD = 2,
    SMP_TBB = 3
  };

  ///@{
  /** The reference surface, input port 1; nullptr: none. */
  void SetReferenceConnection(vtkAlgorithmOutput* port);
  void SetReferenceData(vtkDataObject* reference);
  ///@}

  ///@{
  /** The outputs but the first. */
  vtkPolyData* GetReferenceOutput();
  vtkTable* GetSummaryOutput();
  vtkTable* GetHistogramsOutput();
  ///@}

  ///@{
  /**
   * About how many places of each surface distances are measured at, spread by area; each triangle
   * has at least one. 1 to 1 000 000 000, default 200 000.
   */
  vtkSetMacro(NumberOfSamples, vtkIdType);
  vtkGetMacro(NumberOfSamples, vtkIdType);
  ///@}

  ///@{
  /**
   * Whether to seek `MaximumDistanceBound`, and a larger `MaximumDistance` on the way. Default on;
   * off, the column is absent and about half the time is saved.
   */
  vtkSetMacro(BoundMaximumDistance, bool);
  vtkGetMacro(BoundMaximumDistance, bool);
  vtkBooleanMacro(BoundMaximumDistance, bool);
  ///@}

  ///@{
  /** Rows of the histograms, 1 to 10000, default 30. */
  vtkSetMacro(NumberOfBins, int);
  vtkGetMacro(NumberOfBins, int);
  ///@}

  ///@{
  /**
   * Threads to use, 0 to 1024, at most as many as there are processors; default 0: as many as the
   * back-end offers. The output does not depend on it.
   */
  vtkSetMacro(NumberOfThreads, int);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * The vtkSMPTools back-end of this filter alone. Automatic (default) takes VTK's current one, or
   * STDThread where that is Sequential, as in ParaView. One that this VTK lacks gives a warning
   * and the automatic choice. The output does not depend on it.
   */
  vtkSetMacro(SMPBackend, int);
  vtkGetMacro(SMPBackend, int);
  ///@}

protected:
  vtkSurfaceMeshComparison();
  ~vtkSurfaceMeshComparison() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int GetStructurePort(int outputPort) const override;
  bool PassesInput(int outputPort) const override;
  int RequestWhole(vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSurfaceMeshComparison(const vtkSurfaceMeshComparison&) = delete;
  void operator=(const vtkSurfaceMeshComparison&) = delete;

  vtkIdType NumberOfSamples = 200000;
  bool BoundMaximumDistance = true;
  int NumberOfBins = 30;
  int NumberOfThreads = 0;
  int SMPBackend = SMP_AUTOMATIC;
};

#endif
