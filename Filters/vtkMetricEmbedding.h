/**
 * @class   vtkMetricEmbedding
 * @brief   Embeds a surface in R^d so that lengths along it there are those of a given metric.
 *
 * A metric is a tensor M at each point: an edge e has the length sqrt(e' M e) in it. The point
 * array `Embedding` is a place in R^d for each point. Distances along the surface between those
 * places are the metric's, as far as that goes. Even triangles there are the triangles that the
 * metric asks for.
 *
 * vtkAnisotropicRemesher does the same inside for a `MetricArray`.
 *
 * 1. The surface's triangles are split where they are longer than half of an edge of the mesh
 *    that the embedding is for, or the metric changes a lot along them (`Refine`).
 * 2. The metric is limited to what straight edges can follow (`LimitMetric`, `MetricGrowth`).
 * 3. Start, on a coarser surface of the same lengths: the smoothest functions there, eigenfunctions
 *    of the metric's Laplacian.
 * 4. Steps in turn: the nearest isometry of each triangle, in closed form; then the places that are
 *    nearest to all of these, by one sparse factor. They end where they gain little.
 * 5. A few such steps on the surface itself, by conjugate gradients.
 *
 * @par When to use it:
 * - To see where a metric cannot be met, and how it is limited, before a mesh is made.
 * - To remesh several times in one metric, or in an embedding that you change.
 *
 * @par Outputs and arrays:
 * Output: the surface in triangles, with the input's arrays. Its first points are those of the
 * input, with the same ids; the new ones of split triangles follow. Vertices and lines are left
 * out, and so are triangles that intake drops. Added are
 * - point arrays `Embedding` (double, `Dimension` components) and `LimitedMetric` (double, 6
 *   components XX YY ZZ XY YZ XZ, VTK's order): the metric that was embedded;
 * - cell arrays `LeastStretch` and `LargestStretch` (float): lengths in R^d over those in the
 *   limited metric, along the directions where that is least and largest; 1 where it is met;
 * - field data: `MetricUnit`, the length in the metric of the edges that it is for; `MetricPoints`,
 *   the points of a mesh with such edges; `MetricLimit`, the largest factor by which a size was
 *   made smaller; `MetricShare`, the share of the area, in the metric, where it is met within a
 *   factor of sqrt 2; `StretchQuantiles` (double, 3 components): shares of the area, and what the
 *   least and the largest stretch are below there.
 *
 * Give the output to vtkAnisotropicRemesher with `SetEmbeddingArray("Embedding")` and the same
 * `NumberOfPoints`.
 *
 * @par What is guaranteed:
 * Input arrays on new points are interpolated; labels, and all other whole numbers, take the value
 * of the nearest point of the input. The output does not depend on the threads or the back-end.
 *
 * @par Limits:
 * A tensor that is not symmetric, not finite or not positive definite along the surface is an error
 * that names the first such point. Where the metric cannot be met on a tenth of the surface, a
 * warning says so. Across creases, borders of labels and non-manifold edges the metric is that of
 * both sides. A surface need not be orientable. Points that no polygon uses have zeros.
 *
 * Takes 0.03 ms of a processor for each point of the split surface. (Measured: 100 000 points, split
 * to 205 000.)
 *
 * @par Reference:
 * O. Sorkine, M. Alexa: As-rigid-as-possible surface modeling. Symposium on Geometry Processing,
 * 2007. J. Nash: C1 isometric imbeddings. Annals of Mathematics 60, 1954.
 */
#ifndef vtkMetricEmbedding_h
#define vtkMetricEmbedding_h

#include "vtkFiltersAnisotropicRemeshingModule.h" // For export macro
#include "vtkSurfaceFieldAlgorithm.h"

class VTKFILTERSANISOTROPICREMESHING_EXPORT vtkMetricEmbedding : public vtkSurfaceFieldAlgorithm
{
public:
  static vtkMetricEmbedding* New();
  vtkTypeMacro(vtkMetricEmbedding, vtkSurfaceFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum MetricOrders
  {
    METRIC_VTK = 0,
    METRIC_ROWS = 1,
    METRIC_SOL = 2
  };

  ///@{
  /**
   * The point array of tensors, as vtkAnisotropicRemesher's `MetricArray`: 9 components, row by
   * row; 6, in the order of `MetricOrder`; 3, for a surface in a plane of equal z; or 1, a size.
   * nullptr (default), "", "None", or one that the input lacks is an error when the filter runs.
   */
  vtkSetStringMacro(MetricArray);
  vtkGetStringMacro(MetricArray);
  ///@}

  ///@{
  /**
   * What 6 (or 3) components are: METRIC_VTK (default) XX YY ZZ XY YZ XZ or XX YY XY, METRIC_ROWS
   * XX XY XZ YY YZ ZZ or XX XY YY, METRIC_SOL XX XY YY XZ YZ ZZ or XX XY YY.
   */
  vtkSetMacro(MetricOrder, int);
  vtkGetMacro(MetricOrder, int);
  ///@}

  ///@{
  /**
   * Points of the mesh that the embedding is for, at least 1, default 10000. Their spacing is the
   * unit of the refinement and of the limits. Not used with `UnitEdges`.
   */
  vtkSetMacro(NumberOfPoints, vtkIdType);
  vtkGetMacro(NumberOfPoints, vtkIdType);
  ///@}

  ///@{
  /**
   * Whether it is for a mesh whose edges have the length 1 in the metric. Default off. The field
   * data tell how many points that needs (`MetricPoints`).
   */
  vtkSetMacro(UnitEdges, bool);
  vtkGetMacro(UnitEdges, bool);
  vtkBooleanMacro(UnitEdges, bool);
  ///@}

  ///@{
  /**
   * With `UnitEdges`, the area that the metric is scaled to, as it is given, in squares of unit
   * lengths; from 0, default 0: it is not scaled.
   */
  vtkSetMacro(MetricComplexity, double);
  vtkGetMacro(MetricComplexity, double);
  ///@}

  ///@{
  /**
   * Dimension d of the space, 3 to 16, default 6. In 3 there is not always room; more than 6 gain
   * nothing as a rule.
   */
  vtkSetMacro(Dimension, int);
  vtkGetMacro(Dimension, int);
  ///@}

  ///@{
  /**
   * Whether triangles are split where they are too large for the metric. Default on. Off, the
   * output has the points of the input and no others, and where its triangles are longer than edges
   * should be, the metric is not met.
   */
  vtkSetMacro(Refine, bool);
  vtkGetMacro(Refine, bool);
  vtkBooleanMacro(Refine, bool);
  ///@}

  ///@{
  /**
   * Whether the metric is limited to what straight edges can follow, as by vtkAnisotropicRemesher.
   * Default on.
   */
  vtkSetMacro(LimitMetric, bool);
  vtkGetMacro(LimitMetric, bool);
  vtkBooleanMacro(LimitMetric, bool);
  ///@}

  ///@{
  /**
   * The largest factor between sizes at the ends of an edge, in any direction, 1.01 to 1000,
   * default 5. Only with `LimitMetric`.
   */
  vtkSetMacro(MetricGrowth, double);
  vtkGetMacro(MetricGrowth, double);
  ///@}

  ///@{
  /**
   * Steps at most, 0 to 100000, default 200. 0: the start alone. Far more crumple the surface where
   * no smooth one has the metric, which makes worse meshes.
   */
  vtkSetMacro(NumberOfIterations, int);
  vtkGetMacro(NumberOfIterations, int);
  ///@}

  ///@{
  /**
   * The steps end where ten of them lower the energy by less than this share of it, 0 to 1, default
   * 0.15. The energy is the mean square of what the triangles' maps lack to an isometry.
   */
  vtkSetMacro(EnergyTolerance, double);
  vtkGetMacro(EnergyTolerance, double);
  ///@}

protected:
  vtkMetricEmbedding();
  ~vtkMetricEmbedding() override;

  bool PassesInput(int outputPort) const override;
  remesh::Status CheckParameters() override;
  remesh::Status AddField(remesh::FieldSurface& surface) override;

private:
  vtkMetricEmbedding(const vtkMetricEmbedding&) = delete;
  void operator=(const vtkMetricEmbedding&) = delete;

  char* MetricArray = nullptr;
  int MetricOrder = METRIC_VTK;
  vtkIdType NumberOfPoints = 10000;
  bool UnitEdges = false;
  double MetricComplexity = 0.0;
  int Dimension = 6;
  bool Refine = true;
  bool LimitMetric = true;
  double MetricGrowth = 5.0;
  int NumberOfIterations = 200;
  double EnergyTolerance = 0.15;
};

#endif
