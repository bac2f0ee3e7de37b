/**
 * @class   vtkRestrictedVoronoiAlgorithm
 * @brief   Output ports of the filters that compute a restricted Voronoi diagram.
 *
 * - Port 0 `Surface`: triangles, the restricted Delaunay triangulation, with one point per
 *   connected component of a restricted cell, placed by `VertexPlacement`. Point arrays: `SiteId`,
 *   `ComponentId`, `CellColor`, `CellArea`, `CellMass`, `CellEnergy`, `Embedding`, `Normals`, and
 * the input's; cell arrays: the input's.
 * - Port 1 `VoronoiCells`: convex polygons, one per facet and site (no points or lines that ties
 *   leave). Cell arrays: `SiteId`, `MergedSiteId`, `ComponentId`, `PatchId`, `InputCellId`,
 *   `CellColor` (the active scalars), `CellArea`, `CellMass`, `CellEnergy` (of the site's whole
 * cell); point array: `Embedding`.
 * - Port 2 `Sites`: one vertex per site. Point arrays: `SiteId`, `MergedSiteId`, `PatchId`,
 *   `CellColor`, `Weight`, `Embedding`, `CellArea`, `CellMass`, `CellEnergy`, `Centroid`,
 * `NumberOfNeighbors`.
 * - Port 3 `Convergence`: vtkTable with `Iteration`, `Energy`, `GradientNorm`, `StepLength`,
 *   `Seconds` (since the start).
 * - Port 4 `Edges`: lines. Cell arrays: `EdgeType` (0 between two cells, 1 feature, 2 boundary, 3
 *   non-manifold), `SiteId` (2 components, -1 for none).
 *
 * A site on a feature of the surface (see vtkAnisotropicRemesher) has a copy in each patch and fan
 * around it, so that the mesh has one point for several sites: `MergedSiteId` is the lowest
 * `SiteId` among them, and the `SiteId` of port 0. `PatchId` numbers the parts of the surface that
 * features enclose. Such points lie on the feature, whatever `VertexPlacement` says. `Weight` is
 * that of a power diagram's site, 0: the cells are those of nearest sites.
 *
 * `CellColor` is a small number to colour cells by: those of cells that touch differ (0 to 5 on a
 * sphere), and so do those of points joined by an edge of the mesh, but for edges that were turned.
 *
 * `CellArea` is measured in R^3, `CellMass` in R^d, `CellEnergy` is the integral of the squared
 * distance to the site in R^d.
 *
 * Field data of port 0:
 * - `NumberOfFlippedTriangles`: their normals make more than 90 degrees with the closest part of
 * the surface that their points' cells meet, or their corners are all but collinear;
 * - `NumberOfStrayTriangles`: others that make more than 90 degrees with another part of the
 * surface, which is closer to their centres. So it is where two sheets are closer than a chord to
 * its arc;
 * - `NumberOfSelfIntersections`: pairs of triangles that go through each other, though the surface
 * does not there; counted to one more than a twentieth of the triangles, or 50 and a hundredth of
 * them, if that is less;
 * - `NumberOfNonManifoldEdges`, `EulerCharacteristic`, `TopologyPreserved`, `Seed`;
 * - `NumberOfExtraPoints`: points beyond those asked for; below 0: fewer. Where sites are given,
 *   features are not preserved or there is a distance tolerance: beyond the number of sites;
 * - `MaximumDistance`, with MeasureDistance: the largest found from mesh to surface or back; with a
 *   distance tolerance, a bound that no point passes. In the unit of the points;
 * - `RMSDistance`, likewise: the root of the mean of both mean squares;
 * - `NormalSmoothingRadius`: the distance over which estimated normals were smoothed, 0 if they
 * were not. Absent where none are estimated, none count, or passes were asked for.
 * - with a metric `MetricUnit`: the length in it that edges have, for that many points;
 *   `MetricLimit`: the largest factor by which a size was made smaller, 1: none;
 *   `MetricShare`: the share of the area where edges can have the metric's lengths to a factor of
 *   sqrt 2.
 *
 * `TopologyPreserved` is 1 only where it is proven that the mesh is homeomorphic to the surface:
 * from the diagram, whose cells must be disks that meet in segments and points (the closed ball
 * property of Edelsbrunner and Shah), and from the mesh itself. It is 0 where that is not so, and
 * always for a surface that is no manifold; GetTopologyReport() tells why.
 *
 * The input's arrays on port 0 keep names, types, component names and roles (active scalars and so
 * on), and field data is passed:
 * - point arrays are read at the vertex's place on the input: floating-point arrays are
 *   interpolated (active normals are unit vectors again), and so are colours (unsigned char, 3 or 4
 *   components); integers, ids, bits and strings may be labels and take the value of the nearest
 *   corner there;
 * - of cell arrays each triangle takes the value that covers most of it, cells of equal values
 *   together; values are never mixed;
 * - not carried over: global ids and ghost marks; with a warning, arrays of the wrong length and
 *   those named like the mesh's own, also like those that only other runs have (`CellWeightedMass`,
 *   field data such as `MaximumDistance`); without one where the input is such a mesh itself.
 *
 * `Normals` are those of the surface there, given or estimated. Cells that a ghost array marks as
 * duplicate, refined or hidden are no part of the surface.
 *
 * Same input, parameters and seed give the same bytes on all ports but for the column `Seconds`,
 * whatever the number of threads and the back-end.
 */
#ifndef vtkRestrictedVoronoiAlgorithm_h
#define vtkRestrictedVoronoiAlgorithm_h

#include "vtkEmbeddedSurfaceAlgorithm.h"

class vtkPointSet;
class vtkTable;

namespace remesh
{
struct DiagramSource;
struct RunOutcome;
struct RunRequest;
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

  enum VertexPlacements
  {
    CENTROID = 0,
    SURFACE_POINT = 1,
    QUADRIC = 2,
    FIT = 3
  };

  ///@{
  /**
   * Where the points of port 0 are put:
   * - CENTROID: at the centroids of their cells, which lie inside of a bent surface;
   * - SURFACE_POINT: at the surface's points closest to those;
   * - QUADRIC: where the cell's facets, as planes, are closest;
   * - FIT (default): where all triangles together are closest to the surface, by least squares that
   *   weigh their shapes in the embedding, too, as far as no triangle turns over or collapses. The
   *   distance to the surface is about a third of that of CENTROID. An embedding array
   *   holds points: edges and triangles stay as even in it as they are, but for 1 %. With a metric
   *   points slide to where triangles are even in it, and then move across the surface alone. With
   *   a density, dense ones slide on flat parts, up to a fifth of them to where it bends.
   *
   * In all cases, points are put elsewhere where a triangle would face against the surface: first
   * one by one, then together with those around, then nearer to the centroids. Only where that
   * does not help, edges are turned over: these triangles are not the dual of the cells. The field
   * arrays `NumberOfFlippedTriangles`, `NumberOfStrayTriangles` and `NumberOfSelfIntersections`
   * tell what is left.
   */
  vtkSetMacro(VertexPlacement, int);
  vtkGetMacro(VertexPlacement, int);
  ///@}

  /**
   * A point array that weights the energy: where it is large, points are dense. Input array to
   * process 3. nullptr, "" or "None": none (default), the same weight everywhere. One component,
   * finite and above 0 at all points that polygons use, and no value 1e40 times another, else an
   * error when the filter runs; only ratios matter. Each triangle of the surface takes the mean of
   * its corners.
   *
   * The minimised energy is the integral of the density times the squared distance to the site: the
   * spacing of the points becomes proportional to density^(-1/4), their number per area to
   * density^(1/2), both in the embedding. For a spacing h give h^(-4). The points that the first
   * sampling draws, and those on features (apart from bends and corners, which get theirs anyway),
   * follow it, too. vtkRestrictedVoronoiDiagram moves no sites: there it changes sums only.
   *
   * `CellWeightedMass`, the integral of the density over the cell, is then added where `CellMass`
   * is; `CellMass`, `CellEnergy` and `Centroid` stay those without density, and the energies and
   * gradients of port 3 are the minimised, weighted ones.
   */
  void SetDensityArray(const char* name);

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
   * Whether to measure how far mesh and surface are from each other (default on): the field arrays
   * `MaximumDistance` and `RMSDistance` of port 0. Looks from 20 000 to 120 000 places of each, on
   * up to 100 000 triangles; a tenth to a fifth of a default run (most for few points). A distance
   * tolerance measures in any case.
   */
  vtkSetMacro(MeasureDistance, bool);
  vtkGetMacro(MeasureDistance, bool);
  vtkBooleanMacro(MeasureDistance, bool);
  ///@}

  ///@{
  /**
   * The largest d for which the points of port 1 carry `Embedding`, 0 to 100000; default 16.
   */
  vtkSetMacro(MaximumCellEmbeddingDimension, int);
  vtkGetMacro(MaximumCellEmbeddingDimension, int);
  ///@}

  ///@{
  /**
   * The outputs by name; port 0 is GetOutput(). nullptr for composite input, but for the table: see
   * GetOutputDataObject().
   */
  vtkPolyData* GetVoronoiCellsOutput();
  vtkPolyData* GetSitesOutput();
  vtkTable* GetConvergenceOutput();
  vtkPolyData* GetEdgesOutput();
  ///@}

  ///@{
  /**
   * Facts about the last execution: dimension of the embedding, steps of the optimiser, restricted
   * Voronoi diagrams computed (of the whole surface; of all runs where it took several), CVT energy
   * reached. 0 before the first.
   */
  int GetDimension() const;
  int GetNumberOfIterations() const;
  int GetNumberOfEvaluations() const;
  double GetEnergy() const;
  ///@}

  /**
   * Why `TopologyPreserved` is 0 after the last execution: one sentence with the numbers of the
   * places that fail. "" where it is 1, and before the first execution.
   */
  const char* GetTopologyReport() const;

  /**
   * Wall time in seconds of a phase of the last execution: "intake" (with the embedding),
   * "sampling", "lloyd", "newton", "repair" (of the mesh's topology),
   * "placement" (of the mesh's points), "distance" (of mesh and surface; 0 with a distance
   * tolerance), "diagram" (diagram, dual and output arrays). 0 for other names, and for what an
   * aborted run did not come to.
   */
  double GetPhaseSeconds(const char* phase) const;

protected:
  vtkRestrictedVoronoiAlgorithm();
  ~vtkRestrictedVoronoiAlgorithm() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  bool TakesPoints(int inputPort) const override;
  bool MayReorder(int inputPort) const override;

  remesh::Status CheckParameters() override;

  /**
   * The whole of a diagram filter's RequestData: prepares the surface of input port 0, runs the
   * core for the request (and the sites of port 1, if there are any) and fills the outputs. Returns
   * 1, or 0 after an error, with empty outputs.
   */
  int ComputeDiagram(vtkInformationVector** inputVector, vtkInformationVector* outputVector,
    remesh::RunRequest request);

private:
  vtkRestrictedVoronoiAlgorithm(const vtkRestrictedVoronoiAlgorithm&) = delete;
  void operator=(const vtkRestrictedVoronoiAlgorithm&) = delete;

  void CompleteRequest(vtkInformationVector** inputVector, remesh::RunRequest& request);
  void KeepFacts(const remesh::DiagramSource& source, const remesh::RunOutcome& outcome);

  int VertexPlacement = FIT;
  bool GenerateVoronoiCells = true;
  bool GenerateEdges = true;
  bool MeasureDistance = true;
  int MaximumCellEmbeddingDimension = 16;
};

#endif
