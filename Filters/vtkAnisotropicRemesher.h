/**
 * @class   vtkAnisotropicRemesher
 * @brief   Remeshes a surface with a given number of points, adapted to its curvature.
 *
 * Makes new triangles for a surface: with as many points as are asked for, long along flat
 * directions and small where the surface bends, and with edges along its creases and borders.
 *
 * The surface is embedded in R^d (see vtkEmbeddedSurfaceAlgorithm), and sampled with
 * `NumberOfPoints` sites. Lloyd's iterations, and then a quasi-Newton method (L-BFGS), move these
 * towards a centroidal Voronoi tessellation restricted to it ([Levy12], Algorithms 2 to 4 and
 * section 4.2). The dual of the restricted Voronoi diagram is the new mesh:
 * its triangles are isotropic in R^d, and so anisotropic in R^3.
 *
 * Features of the surface are kept unless `PreserveFeatures` is off: see there.
 *
 * Input port 0: the surface. Input port 1 (optional): initial sites. Their number replaces
 * `NumberOfPoints`; their point array `Embedding`, if it has d components, is their place in R^d,
 * else each is put at the surface's point closest to it.
 * Output ports: see vtkRestrictedVoronoiAlgorithm.
 *
 * @par When to use it:
 * For a surface with too many triangles, or badly shaped ones: a scan, an isosurface, a part from a
 * CAD program.
 * - Few triangles that keep the shape, to look at, send or store: leave `Anisotropy` at its default
 *   and set `NumberOfPoints`. Along flat directions one long triangle stands for many even ones.
 * - A mesh that is never farther from the surface than a length: set `DistanceTolerance`.
 * - Triangles of equal size, near to equilateral, for a simulation: set `Anisotropy` to 0.
 * - Triangles that follow data, too: give a density (`DensityArray`) or `CoordinateArrays`.
 *
 * To cut a surface into the Voronoi cells of points that stay where they are, take
 * vtkRestrictedVoronoiDiagram. To see how good a mesh is, take vtkSurfaceMeshComparison.
 *
 * @par What is guaranteed:
 * - With `PreserveFeatures` the mesh has the number of points that was asked for, a few more where
 *   its topology needs them (`MaximumNumberOfExtraPoints`), or a warning says why not.
 * - Borders, corners and creases of the surface are then edges and points of the mesh, but for
 *   those that `PreserveFeatures` names as too small.
 * - With `DistanceTolerance`, no point of either surface is farther from the other than that, or a
 *   warning says so.
 * - The field array `TopologyPreserved` is 1 only where the topology of the surface is proven to be
 *   kept.
 * - Triangles that face the wrong way or go through each other are counted in the field data of
 *   `Surface` (`NumberOfFlippedTriangles` and the two after it), and a warning tells of them.
 * - Same input, parameters and seed give the same output: see vtkRestrictedVoronoiAlgorithm.
 *
 * @par Limits:
 * The mesh may not be proven to have the topology of the surface (see `TopologyPreserved`), as on
 * thin parts and at tips. Then sites are added, and those that matter least are taken away, until
 * it is proven or nothing helps any more. After that the mesh may have more points
 * (`MaximumNumberOfExtraPoints`). If even that fails, the best of these meshes is given back, with
 * a warning. Likewise, sites are sent to triangles that face against the surface, and to strays, if
 * they are few; a warning tells of those that are left. All this is no part of the optimisation:
 * `Convergence` ends before it, and nothing is changed when both numbers of iterations are 0.
 *
 * There is a warning, too, where the RMS distance is above a tenth of the points' mean spacing,
 * unless `MeasureDistance` is off, a tolerance is set, or initial sites are given: the mesh then
 * misses parts of the surface, whatever else holds of it.
 *
 * Empty input gives empty outputs, whatever arrays are chosen, and so, with a warning, does one
 * whose polygons have no area.
 * Unusable input (no polygons, non-finite coordinates, fewer than 4 points asked for, wrong arrays)
 * is an error, and all outputs are empty. An aborted run leaves them empty, and is no error.
 *
 * Cost: about proportional to facets + sites for each iteration; memory proportional to
 * (facets + sites) d.
 */
#ifndef vtkAnisotropicRemesher_h
#define vtkAnisotropicRemesher_h

#include "vtkRestrictedVoronoiAlgorithm.h"

namespace remesh
{
struct RemeshOptions;
}

class VTKFILTERSANISOTROPICREMESHING_EXPORT vtkAnisotropicRemesher
  : public vtkRestrictedVoronoiAlgorithm
{
public:
  static vtkAnisotropicRemesher* New();
  vtkTypeMacro(vtkAnisotropicRemesher, vtkRestrictedVoronoiAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SamplingMethods
  {
    RANDOM = 0,
    STRATIFIED = 1
  };

  ///@{
  /**
   * Number of points of the mesh, default 10000. Fewer than 4 is an error when the filter runs.
   * With `PreserveFeatures` it has as many, unless its corners and curves alone need more, or its
   * topology does (see `MaximumNumberOfExtraPoints`), or so many cells reach several sheets of the
   * surface that it has fewer; a warning tells the first and the last. Without, this is the number
   * of sites, and the mesh has more points where restricted cells are not connected (see
   * `NumberOfExtraPoints`).
   */
  vtkSetMacro(NumberOfPoints, vtkIdType);
  vtkGetMacro(NumberOfPoints, vtkIdType);
  ///@}

  ///@{
  /**
   * Whether a metric (`MetricArray`) decides the number of points, too: as many as give edges of
   * the mean length 1 in it, 2/sqrt 3 times its area and half of its border's length. Default off:
   * `NumberOfPoints` as asked for, and edges have the metric's lengths times one number. Without a
   * metric, or with a distance tolerance or initial sites, an error.
   */
  vtkSetMacro(UnitEdges, bool);
  vtkGetMacro(UnitEdges, bool);
  vtkBooleanMacro(UnitEdges, bool);
  ///@}

  ///@{
  /**
   * With `UnitEdges`, the area that the metric is scaled to, as it is given, in squares of unit
   * lengths: 0.87 times about as many points. From 0; default 0: it is not scaled.
   */
  vtkSetMacro(MetricComplexity, double);
  vtkGetMacro(MetricComplexity, double);
  ///@}

  ///@{
  /**
   * How far mesh and surface may be from each other at most, both ways; then as many points are
   * taken as that needs, and `NumberOfPoints` does not count. Fraction of the bounding-box
   * diagonal, 1e-4 to 1e-2 as a rule, or with `DistanceToleranceIsAbsolute` (default off) in the
   * unit of the points; at least 1e-7 of the diagonal, else an error when the filter runs. Default
   * 0: off.
   *
   * The tolerance is proven to hold on all of both surfaces, not only at samples. Where it cannot
   * be kept, because it takes more than `MaximumNumberOfPoints`, or because further points do not
   * help (as at creases with `PreserveFeatures` off), there is a warning, and what was reached
   * comes out. The field arrays `MaximumDistance` and `RMSDistance` tell what was reached.
   *
   * Points are dense where single places need it: after a run with a number of points for which
   * most of the mesh is within the tolerance, points are added where it is not. Creases too small
   * for the spacing are then kept, too, where they take fewer points. There may be
   * ten such rounds or more, each with a diagram and a placement: count on ten times a run with the
   * number of points that come out. Not with given initial sites, which a warning tells.
   */
  vtkSetMacro(DistanceTolerance, double);
  vtkGetMacro(DistanceTolerance, double);
  vtkSetMacro(DistanceToleranceIsAbsolute, bool);
  vtkGetMacro(DistanceToleranceIsAbsolute, bool);
  vtkBooleanMacro(DistanceToleranceIsAbsolute, bool);
  ///@}

  ///@{
  /**
   * The most points that `DistanceTolerance` may take, from 4, default 1000000; some percent more
   * where the last cells are not connected.
   */
  vtkSetMacro(MaximumNumberOfPoints, vtkIdType);
  vtkGetMacro(MaximumNumberOfPoints, vtkIdType);
  ///@}

  ///@{
  /**
   * Whether creases, corners, borders and non-manifold edges of the surface are kept as edges and
   * points of the mesh, default on. Off, the mesh cuts across creases and shrinks from borders, and
   * it has more points than asked for where restricted cells are not connected.
   *
   * Features take points of their own, which count among `NumberOfPoints`. Along a crease or border
   * they are as far apart as those of the mesh beside it, in the embedding, and
   * four fifths as far where it bends. They are nearer where it turns by more than 23 degrees from
   * one to the next, where it rises by more than a twentieth of an edge, and where a distance
   * tolerance asks for it. With an `EmbeddingArray` or a `MetricArray` they follow that alone.
   * Bends get a third of the points at most, if there is room; where corners and bends need more
   * than half, there is a warning. Curves close to each other have their points opposite each other
   * where that takes few more, and get more where these are not enough to keep them apart.
   *
   * The points on creases and borders do not take part in the optimisation. With the vertex
   * placement Fit they go across them to where the edges are closest to the surface's; else they
   * are on them.
   *
   * Creases that are small against the spacing of the points, or that zigzag and branch like noise,
   * are not kept; neither are the sides of needles, triangles that stand out, but are lower than a
   * fiftieth of the spacing, or than a fifth of it and than an eighth of their longest side. Their
   * normals do not count where normals are estimated. Nor are the sides of single triangles, and
   * pairs, kept that lie on their neighbors the wrong way round, nor the low steps of voxels where
   * they bend at more points than are asked for. Where these are between a two hundredth and a
   * quarter of the length of all creases, a warning tells which.
   *
   * Not with given initial sites.
   */
  vtkSetMacro(PreserveFeatures, bool);
  vtkGetMacro(PreserveFeatures, bool);
  vtkBooleanMacro(PreserveFeatures, bool);
  ///@}

  ///@{
  /**
   * Creases are edges whose two facets' normals differ by more than this angle in degrees, 0 to
   * 180, default 35.
   */
  vtkSetMacro(FeatureAngle, double);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  /**
   * A cell array whose values label regions of the surface: edges between different values are
   * features, too. Input array to process 2. nullptr, "" or "None": none (default). Numbers of any
   * number of components, or strings; one that the input lacks is an error when the filter runs,
   * also where features are not preserved.
   */
  void SetFeatureLabelArray(const char* name);

  /**
   * A point array that may jump where points of the surface coincide, as texture coordinates do.
   * Where it does, it has a seam: a feature, too, along which the output has a point for each side,
   * with that side's values. Input array to process 4. nullptr, "" or "Automatic" (default): the
   * active texture coordinates, if there are some. "None": none. Any number of components; values
   * that differ by no more than 1e-4 of the array's range (or 10 times MergeTolerance) are the
   * same. One that the input lacks is an error when the filter runs.
   *
   * Field data tell of the mesh as if each such point were one; what a cell has (`CellArea` and so
   * on) is divided evenly among the points of its vertex. Where the points along all seams would be
   * more than a third of those asked for, no seam is kept. Arrays whose jumps are not kept are
   * interpolated across, with a warning.
   */
  void SetSeamArray(const char* name);

  enum ExtraPoints
  {
    ONE_PERCENT = -2,
    UNLIMITED = -1
  };

  ///@{
  /**
   * By how many points the mesh may exceed `NumberOfPoints` where it cannot have the topology of
   * the surface otherwise: ONE_PERCENT (-2, default) of them, UNLIMITED (-1), or a number; 0
   * forbids. Each component and patch has a few at least; a warning tells of more than allowed.
   * Where features alone take more than `NumberOfPoints`, the extra points count from their number.
   * With a tolerance, ONE_PERCENT is of the number that each run has. The field array
   * `NumberOfExtraPoints` of port 0 tells by how many it does, for whatever reason.
   */
  vtkSetMacro(MaximumNumberOfExtraPoints, vtkIdType);
  vtkGetMacro(MaximumNumberOfExtraPoints, vtkIdType);
  ///@}

  ///@{
  /**
   * How the first sites are drawn: RANDOM ([Levy12], Algorithm 4) or STRATIFIED (default: one site
   * in each of `NumberOfPoints` strata of equal area).
   */
  vtkSetMacro(SamplingMethod, int);
  vtkGetMacro(SamplingMethod, int);
  ///@}

  ///@{
  /**
   * Whether the first sites are grown from a quarter as many, which take a few iterations first,
   * and the middles between these, wherever their cells are about as flat and as large as hexagons.
   * Triangles are more regular, and the energy is lower after as many iterations (about 0.1 % on
   * scans), or as low after two thirds of them. Default on. Costs as much as three to ten
   * iterations. Without effect below 400 free points, where features take more than a twentieth of
   * all, without iterations, and with initial sites.
   */
  vtkSetMacro(CoarseStart, bool);
  vtkGetMacro(CoarseStart, bool);
  vtkBooleanMacro(CoarseStart, bool);
  ///@}

  ///@{
  /** Seed of the random numbers, default 0. */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /** Lloyd's iterations ([Levy12], Algorithm 3), 0 to 100000, default 5. */
  vtkSetMacro(NumberOfLloydIterations, int);
  vtkGetMacro(NumberOfLloydIterations, int);
  ///@}

  ///@{
  /** Quasi-Newton (L-BFGS) iterations after those, 0 to 100000, default 30. */
  vtkSetMacro(NumberOfNewtonIterations, int);
  vtkGetMacro(NumberOfNewtonIterations, int);
  ///@}

  ///@{
  /**
   * Pairs of vectors that the quasi-Newton method keeps, 1 to 100, default 7: each takes 4 bytes
   * per site and dimension. From 64 dimensions on, where a pair is more than 16 MB, no more than 3
   * or what fits into a twelfth of the embedding's own memory are kept.
   */
  vtkSetMacro(HistoryLength, int);
  vtkGetMacro(HistoryLength, int);
  ///@}

  ///@{
  /**
   * The quasi-Newton iterations end where the norm of the energy's gradient is at most this
   * fraction of that of the initial sampling, 0 to 1, default 0 (never).
   */
  vtkSetMacro(GradientTolerance, double);
  vtkGetMacro(GradientTolerance, double);
  ///@}

  ///@{
  /**
   * The quasi-Newton iterations end where one lowers the energy by at most this fraction of it,
   * 0 to 1, default 5e-6: with 500 to 10 000 points after some 60 to 160 iterations, within 0.12 %
   * of the energy after 300; with fewer points sooner, also than after the default 30. 0: only
   * where the energy cannot be lowered any more.
   */
  vtkSetMacro(EnergyTolerance, double);
  vtkGetMacro(EnergyTolerance, double);
  ///@}

  ///@{
  /** The optional initial sites, input port 1. */
  void SetInitialSitesConnection(vtkAlgorithmOutput* port);
  void SetInitialSitesData(vtkDataObject* sites);
  ///@}

protected:
  vtkAnisotropicRemesher();
  ~vtkAnisotropicRemesher() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  remesh::Status CheckParameters() override;
  int RequestWhole(vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkAnisotropicRemesher(const vtkAnisotropicRemesher&) = delete;
  void operator=(const vtkAnisotropicRemesher&) = delete;

  remesh::RemeshOptions MakeOptions() const;

  vtkIdType NumberOfPoints = 10000;
  bool UnitEdges = false;
  double MetricComplexity = 0.0;
  double DistanceTolerance = 0.0;
  bool DistanceToleranceIsAbsolute = false;
  vtkIdType MaximumNumberOfPoints = 1000000;
  bool PreserveFeatures = true;
  double FeatureAngle = 35.0;
  vtkIdType MaximumNumberOfExtraPoints = ONE_PERCENT;
  int SamplingMethod = STRATIFIED;
  bool CoarseStart = true;
  int Seed = 0;
  int NumberOfLloydIterations = 5;
  int NumberOfNewtonIterations = 30;
  int HistoryLength = 7;
  double GradientTolerance = 0.0;
  double EnergyTolerance = 5e-6;
};

#endif
