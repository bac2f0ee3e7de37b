/**
 * @class   vtkEmbeddedSurfaceAlgorithm
 * @brief   What all filters on embedded surfaces share: intake, embedding and threads.
 *
 * The input is a surface of polygons or triangle strips, also of several blocks or as a grid (see
 * vtkWholeSurfaceAlgorithm). Intake cuts polygons into triangles (quadrilaterals along the shorter
 * diagonal), merges coincident points, drops degenerate and duplicate triangles, ignores unused
 * points, vertices and lines, and makes the orientation consistent where the surface is orientable.
 * Non-manifold edges, open borders and several components are accepted.
 *
 * The surface is then embedded in R^d:
 * - `GAUSS_MAP` (d = 6): position and normal times `Anisotropy` times the bounding-box diagonal
 *   ([Levy12], section 3.2); with `Anisotropy` 0 or mode `POSITION`, position alone (d = 3);
 * - each coordinate array appends its components, times its scale, to that;
 * - an embedding array (input array 1) replaces all of it (any d from 2);
 * - so does a metric (`MetricArray`), from which an embedding is computed.
 *
 * Input arrays to process: 0, the point normals (default, or by the name "Automatic": those that
 * are active when the filter runs, used as they are; if there are none, normals are estimated,
 * weighted by angle, and smoothed as `NormalSmoothingPasses` tells); 1, the embedding array
 * (default: none). Each can be chosen by name ("" or "None": none) or as the active array of an
 * attribute type; a choice that the input lacks is an error when the filter runs, but for active
 * normals.
 *
 * Setters keep what they are given. A value out of the range that a property's text names, or NaN,
 * is an error when the filter runs.
 *
 * @par Reference:
 * B. Levy, N. Bonneel: Variational Anisotropic Surface Meshing with Voronoi Parallel Linear
 * Enumeration. 21st International Meshing Roundtable, 2012. "[Levy12]"
 */
#ifndef vtkEmbeddedSurfaceAlgorithm_h
#define vtkEmbeddedSurfaceAlgorithm_h

#include "vtkFiltersAnisotropicRemeshingModule.h" // For export macro
#include "vtkWholeSurfaceAlgorithm.h"

#include <memory> // For std::unique_ptr

namespace remesh
{
struct Status;
}

class VTKFILTERSANISOTROPICREMESHING_EXPORT vtkEmbeddedSurfaceAlgorithm
  : public vtkWholeSurfaceAlgorithm
{
public:
  vtkTypeMacro(vtkEmbeddedSurfaceAlgorithm, vtkWholeSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum EmbeddingModes
  {
    POSITION = 0,
    GAUSS_MAP = 1
  };

  enum MetricOrders
  {
    METRIC_VTK = 0,
    METRIC_ROWS = 1,
    METRIC_SOL = 2
  };

  enum SMPBackends
  {
    SMP_AUTOMATIC = 0,
    SMP_SEQUENTIAL = 1,
    SMP_STDTHREAD = 2,
    SMP_TBB = 3
  };

  ///@{
  /**
   * The embedding: POSITION (d = 3, isotropic) or GAUSS_MAP (d = 6, default). Not used when an
   * embedding array is chosen.
   */
  vtkSetMacro(EmbeddingMode, int);
  vtkGetMacro(EmbeddingMode, int);
  ///@}

  ///@{
  /**
   * How much the normals count: the length given to a unit normal, as a fraction of the
   * bounding-box diagonal. 0 to 1, default 0.04; usual values are 0.02 to 0.1; 0 is isotropic.
   */
  vtkSetMacro(Anisotropy, double);
  vtkGetMacro(Anisotropy, double);
  ///@}

  ///@{
  /**
   * Whether normals are estimated even where the input has some. Default off: input array 0 tells
   * which are used.
   */
  vtkSetMacro(EstimateNormals, bool);
  vtkGetMacro(EstimateNormals, bool);
  vtkBooleanMacro(EstimateNormals, bool);
  ///@}

  ///@{
  /**
   * Passes of 1-ring averaging over estimated normals, 0 to 10000. Default -1: the normals are
   * smoothed over 1.5 times the mean spacing of the new points, sqrt(area / points), whatever the
   * sizes of the triangles, as bends finer than that cannot be meshed. They are left as they are
   * where that would hardly flatten anything but bends along one direction, which long triangles
   * can follow, as on most parts designed on a computer: where the area that normals cover, scaled
   * by the anisotropy, falls by at most 5 % of the area in R^6 with smoothed normals. If
   * vtkAnisotropicRemesher's mesh has faults then, it makes one with smoothed normals, too, and
   * keeps the better one. Where the normals count for so much that this leaves more bends than
   * points (cells fall into more than 1.1 parts each), it smooths them over twice or four times
   * that. All of this takes up to five times as long; it does neither where it starts from given
   * sites, does no iterations, or has coordinate arrays. (The outputs' normals are not smoothed.)
   * Given normals never are.
   */
  vtkSetMacro(NormalSmoothingPasses, int);
  vtkGetMacro(NormalSmoothingPasses, int);
  ///@}

  ///@{
  /**
   * Root mean square distance over which estimated normals are smoothed, in the unit of the points;
   * 0: they are not. From -1; below 0, default -1: as `NormalSmoothingPasses` tells, which a radius
   * overrides. The field data of vtkAnisotropicRemesher's mesh tells which it took
   * (`NormalSmoothingRadius`): with that, other filters work on the same surface in R^d, but for
   * features, along which it alone cuts, and needles, whose normals it alone leaves out.
   */
  vtkSetMacro(NormalSmoothingRadius, double);
  vtkGetMacro(NormalSmoothingRadius, double);
  ///@}

  ///@{
  /**
   * Input points closer than this fraction of the bounding-box diagonal become one point.
   * 0 to 0.1; default 0: only points with equal coordinates, and the ends of sides that are nothing
   * but rounding, shorter than 1e-12 of the diagonal. Where points on the border are others but for
   * rounding, a warning says so.
   */
  vtkSetMacro(MergeTolerance, double);
  vtkGetMacro(MergeTolerance, double);
  ///@}

  ///@{
  /**
   * Point arrays whose components, times a scale (length per array unit), are appended to position
   * and normal. An array that the input lacks is an error when the filter runs.
   */
  void AddCoordinateArray(const char* name, double scale);
  void ClearCoordinateArrays();
  int GetNumberOfCoordinateArrays() const;
  const char* GetCoordinateArrayName(int index) const;
  double GetCoordinateArrayScale(int index) const;
  ///@}

  /**
   * The point array that replaces the embedding: input array to process 1. nullptr, "" or "None":
   * none. Shape: one tuple of d >= 2 finite components per input point, in any unit.
   */
  void SetEmbeddingArray(const char* name);

  /**
   * A point array of tensors, a metric: input array to process 5. nullptr, "" or "None": none
   * (default). An edge e is to have the length sqrt(e' M e), so where a metric's eigenvalue is
   * 1/h^2, edges along its eigenvector are to have the length h, or all edges h times one number:
   * the number of points decides. The surface is embedded in R^d (`MetricDimension`) so that
   * lengths along it there are those in the metric; that replaces the embedding, and cannot be
   * combined with an embedding array or coordinate arrays.
   *
   * 9 components, row by row; 6, in the order of `MetricOrder`; 3, for a surface in a plane of
   * equal z; or 1, a size h. The part along the surface counts alone, and must be finite, symmetric
   * and positive definite at all points that polygons use, else an error names the first point.
   * Between points its logarithm is linear. vtkAnisotropicRemesher splits the triangles of the
   * surface where they are longer than half of the edges that are asked for; but where the metric
   * changes a lot from one point to the next, more points are needed to tell what it is between
   * them. Where it is not met on a tenth of the surface, a warning says so.
   *
   * 100 000 points took 6 s of processor time, 2.6 times what the remeshing of that surface to 10 000
   * points takes without a metric.
   */
  void SetMetricArray(const char* name);

  ///@{
  /**
   * What the components of a metric array of 6 (or 3) are:
   * - METRIC_VTK (default): XX YY ZZ XY YZ XZ, or XX YY XY;
   * - METRIC_ROWS: XX XY XZ YY YZ ZZ, or XX XY YY;
   * - METRIC_SOL: XX XY YY XZ YZ ZZ, as in .sol files, or XX XY YY.
   */
  vtkSetMacro(MetricOrder, int);
  vtkGetMacro(MetricOrder, int);
  ///@}

  ///@{
  /**
   * Dimension of the space that a metric is embedded in, 3 to 16, default 6. In 3 there is not
   * always room; more than 6 gain nothing as a rule.
   */
  vtkSetMacro(MetricDimension, int);
  vtkGetMacro(MetricDimension, int);
  ///@}

  ///@{
  /**
   * Whether a metric is limited to what straight edges can follow. Default on. Where it turns,
   * grows or bends within the length of an edge, as a thin layer that is curved, edges get the
   * lengths that they have on average along them: a chord of a layer leaves it by its sagitta, and
   * is shortened until it is as long as it should be. Then `MetricGrowth` limits it, too. The field
   * data of the mesh tell by how much sizes were made smaller (`MetricLimit`).
   */
  vtkSetMacro(LimitMetric, bool);
  vtkGetMacro(LimitMetric, bool);
  vtkBooleanMacro(LimitMetric, bool);
  ///@}

  ///@{
  /**
   * The gradation of a metric: the largest factor between sizes at the ends of an edge, in any
   * direction, 1.01 to 1000, default 5. Where a metric grows or turns faster, sizes become smaller.
   * Only with `LimitMetric`.
   */
  vtkSetMacro(MetricGrowth, double);
  vtkGetMacro(MetricGrowth, double);
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

  ///@{
  /** Facts about the last execution's intake. 0 before the first. */
  vtkIdType GetNumberOfInputComponents() const;
  vtkIdType GetNumberOfDroppedTriangles() const;
  vtkIdType GetNumberOfMergedPoints() const;
  ///@}

  ///@{
  /** Back-end and threads of the last execution. "" and 0 before the first. */
  const char* GetUsedBackend() const;
  int GetNumberOfUsedThreads() const;
  ///@}

protected:
  vtkEmbeddedSurfaceAlgorithm();
  ~vtkEmbeddedSurfaceAlgorithm() override;

  void ForgetLastRun() override;

  /** The first parameter that is out of its range, as an error; asked before each execution. */
  virtual remesh::Status CheckParameters();

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;

private:
  vtkEmbeddedSurfaceAlgorithm(const vtkEmbeddedSurfaceAlgorithm&) = delete;
  void operator=(const vtkEmbeddedSurfaceAlgorithm&) = delete;

  int EmbeddingMode = GAUSS_MAP;
  double Anisotropy = 0.04;
  bool EstimateNormals = false;
  int NormalSmoothingPasses = -1;
  double NormalSmoothingRadius = -1.0;
  double MergeTolerance = 0.0;
  int MetricOrder = METRIC_VTK;
  int MetricDimension = 6;
  bool LimitMetric = true;
  double MetricGrowth = 5.0;
  int NumberOfThreads = 0;
  int SMPBackend = SMP_AUTOMATIC;
};

#endif
