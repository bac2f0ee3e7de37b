/**
 * @class   vtkSolutionMetric
 * @brief   Computes the metric in which a mesh has the least interpolation error of given data.
 *
 * Makes from point arrays, as a solver's results, the point array `Metric` for the `MetricArray` of
 * vtkAnisotropicRemesher: where the data bends, edges become short, and long along the direction in
 * which it does not.
 *
 * 1. Second derivatives of each array along the surface, by local fits of quadratic functions which
 *    do not look across creases. Of several components: the root of the sum of squares.
 * 2. Of each array the metric for which linear interpolation has the least error in the norm
 *    (`ErrorNorm`).
 * 3. The intersection of all: what asks for the shorter edges counts, in each direction. Arrays
 *    count alike, whatever their units: each alone would get the same number of points.
 * 4. Intersected with these: the surface's own curvature (`ChordTolerance`), given metrics, and
 *    sizes that grow with a distance.
 *
 * @par Outputs and arrays:
 * Output: the input with the point array `Metric` (double, 6 components XX YY ZZ XY YZ XZ: VTK's
 * order). An edge e has the length sqrt(e' M e) in it, and 1 is meant. Field data: `MetricPoints`,
 * the number of points of a mesh with such edges.
 *
 * @par When to use it:
 * - To adapt a mesh to a solution: solve, make the metric, remesh, carry the solution over, and
 *   again. Five rounds do as a rule.
 * - To combine sizes: curvature, a distance, another program's metric.
 *
 * @par What is guaranteed:
 * Points, cells and arrays of the input are passed on as they are; one array is added. The metric
 * is positive definite. The output does not depend on the threads or the back-end.
 *
 * @par Limits:
 * Unusable input is an error, as for vtkAnisotropicRemesher, and the output is empty. Derivatives
 * are no better than the mesh that the data is on. Points that no polygon uses get the largest
 * size.
 *
 * @par Reference:
 * A. Loseille, F. Alauzet: Continuous mesh framework part I: well-posed continuous interpolation
 * error. SIAM Journal on Numerical Analysis 49, 2011.
 */
#ifndef vtkSolutionMetric_h
#define vtkSolutionMetric_h

#include "vtkFiltersAnisotropicRemeshingModule.h" // For export macro
#include "vtkSurfaceFieldAlgorithm.h"

#include <memory> // For std::unique_ptr

class VTKFILTERSANISOTROPICREMESHING_EXPORT vtkSolutionMetric : public vtkSurfaceFieldAlgorithm
{
public:
  static vtkSolutionMetric* New();
  vtkTypeMacro(vtkSolutionMetric, vtkSurfaceFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ErrorNorms
  {
    L1 = 0,
    L2 = 1,
    L4 = 2,
    MAXIMUM = 3
  };

  enum MetricOrders
  {
    METRIC_VTK = 0,
    METRIC_ROWS = 1,
    METRIC_SOL = 2
  };

  ///@{
  /**
   * Point arrays whose interpolation error is to be small, of any number of components. One that
   * the input lacks, or that is not finite, is an error when the filter runs. Default: none; where
   * nothing else is chosen to make a metric from either, the active point scalars.
   */
  void AddSolutionArray(const char* name);
  void ClearSolutionArrays();
  int GetNumberOfSolutionArrays() const;
  const char* GetSolutionArrayName(int index) const;
  ///@}

  ///@{
  /**
   * Point arrays of second derivatives of further solutions, where they are known: symmetric
   * tensors, 9 components, or 6 (for flat surfaces of equal z also 3) in the order of
   * `MetricOrder`. Of a tensor only what is along the surface counts. Default: none.
   */
  void AddHessianArray(const char* name);
  void ClearHessianArrays();
  int GetNumberOfHessianArrays() const;
  const char* GetHessianArrayName(int index) const;
  ///@}

  ///@{
  /**
   * Point arrays of metrics to intersect with, as vtkAnisotropicRemesher's `MetricArray`: 9, 6 or 3
   * components, or 1, a size. They are taken as they are, and not scaled. Default: none.
   */
  void AddMetricArray(const char* name);
  void ClearMetricArrays();
  int GetNumberOfMetricArrays() const;
  const char* GetMetricArrayName(int index) const;
  ///@}

  ///@{
  /**
   * What 6 components of given tensors are: METRIC_VTK (default) XX YY ZZ XY YZ XZ, METRIC_ROWS XX
   * XY XZ YY YZ ZZ, METRIC_SOL XX XY YY XZ YZ ZZ. The output always has the first.
   */
  vtkSetMacro(MetricOrder, int);
  vtkGetMacro(MetricOrder, int);
  ///@}

  ///@{
  /**
   * The norm of the error: the mean of its absolute values (L1), of their squares (L2, default) or
   * fourth powers (L4), or the largest (MAXIMUM). The lower, the more points go to weak bends.
   */
  vtkSetMacro(ErrorNorm, int);
  vtkGetMacro(ErrorNorm, int);
  ///@}

  ///@{
  /**
   * Points that the whole metric asks for, from 1, default 10000: what the solutions ask for is
   * scaled until it does. Where curvature, metrics, sizes and the largest size ask for more without
   * any solution, or the smallest size allows for less, a warning tells. Not used without
   * solutions.
   */
  vtkSetMacro(NumberOfPoints, vtkIdType);
  vtkGetMacro(NumberOfPoints, vtkIdType);
  ///@}

  ///@{
  /** The shortest edges, in the unit of the points, from 0; default 0: no limit. */
  vtkSetMacro(MinimumSize, double);
  vtkGetMacro(MinimumSize, double);
  ///@}

  ///@{
  /** The longest edges, likewise, at least `MinimumSize`; default 0: the bounding box's diagonal.
   */
  vtkSetMacro(MaximumSize, double);
  vtkGetMacro(MaximumSize, double);
  ///@}

  ///@{
  /** How many times as long as across triangles may be along a direction, from 1; default 1000. */
  vtkSetMacro(MaximumRatio, double);
  vtkGetMacro(MaximumRatio, double);
  ///@}

  ///@{
  /**
   * Asks for edges short enough for the surface's curvature: how far the middle of one may be from
   * an arc with its ends, in the unit of the points; from 0, default 0: the curvature does not
   * count.
   */
  vtkSetMacro(ChordTolerance, double);
  vtkGetMacro(ChordTolerance, double);
  ///@}

  ///@{
  /**
   * A point array of one component, a distance: edges get at most the length `DistanceSize` plus
   * `DistanceGrowth` times its absolute value. nullptr, "" or "None": none (default).
   */
  vtkSetStringMacro(DistanceArray);
  vtkGetStringMacro(DistanceArray);
  ///@}

  ///@{
  /** Length of edges at distance 0, above 0 where there is a distance array; default 0. */
  vtkSetMacro(DistanceSize, double);
  vtkGetMacro(DistanceSize, double);
  ///@}

  ///@{
  /** By how much that length grows for each unit of distance, from 0, default 0.2. */
  vtkSetMacro(DistanceGrowth, double);
  vtkGetMacro(DistanceGrowth, double);
  ///@}

protected:
  vtkSolutionMetric();
  ~vtkSolutionMetric() override;

  remesh::Status CheckParameters() override;
  remesh::Status AddField(remesh::FieldSurface& surface) override;

private:
  vtkSolutionMetric(const vtkSolutionMetric&) = delete;
  void operator=(const vtkSolutionMetric&) = delete;

  bool HasDistanceArray() const;
  bool IsAnythingChosen() const;

  struct vtkNames;
  std::unique_ptr<vtkNames> Names;
  int MetricOrder = METRIC_VTK;
  int ErrorNorm = L2;
  vtkIdType NumberOfPoints = 10000;
  double MinimumSize = 0.0;
  double MaximumSize = 0.0;
  double MaximumRatio = 1000.0;
  double ChordTolerance = 0.0;
  char* DistanceArray = nullptr;
  double DistanceSize = 0.0;
  double DistanceGrowth = 0.2;
};

#endif
