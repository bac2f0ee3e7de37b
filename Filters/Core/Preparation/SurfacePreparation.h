/**
 * @file SurfacePreparation.h
 * @brief Makes the surface in R^d, from the caller's triangles, arrays and parameters.
 *
 * 1. Intake: triangles to a clean mesh (Mesh/Intake.h).
 * 2. Features: the mesh is cut open along them.
 * 3. Normals, given or estimated; large facets are split for them.
 * 4. Coordinates: positions and normals, an array, or an embedding of a metric; further arrays.
 * 5. The surface in R^d, with its density; its patches are moved apart.
 */
#ifndef remesh_SurfacePreparation_h
#define remesh_SurfacePreparation_h

#include "Embedding/Embedding.h"
#include "Features/FeatureEdges.h"
#include "Mesh/Intake.h"
#include "Mesh/Normals.h"
#include "Preparation/MetricInput.h"
#include "Refinement/RefinedSurface.h"

#include <algorithm>
#include <cfloat>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace remesh
{
/** The caller's surface. It is read anew for each preparation, so that no copy of it is held. */
struct SurfaceSource
{
  /** Replaces `soup` by the caller's triangles. `warning` is a sentence, or "". */
  std::function<Status(TriangleSoup& soup, std::string& warning)> read;
  Offset numberOfPoints = 0;      ///< P, rows of point arrays
  double precision = DBL_EPSILON; ///< of the coordinates, relative
};

struct PreparationRequest
{
  SurfaceSource source;
  bool gaussMap = true;           ///< whether normals are coordinates; false: positions alone
  double anisotropy = 0.04;       ///< length of a unit normal, as a fraction of the diagonal
  int normalSmoothingPasses = -1; ///< negative: normals are smoothed over a radius instead
  double smoothing = 1.0;         ///< factor of that radius, which follows from `numberOfSites`
  bool mayStaySharp = true;       ///< whether normals with few wrinkles are left as they are
  double smoothingRadius = -1.0;  ///< 0 or more: the radius, whatever the three fields above are
  Offset numberOfSites = 10000;   ///< that the surface is prepared for
  Offset sitesForFeatures = 0;    ///< their spacing tells features from noise; 0: `numberOfSites`
  double mergeTolerance = 0.0;    ///< fraction of the bounding-box diagonal
  std::optional<PointArray> normals;   ///< none: they are estimated
  bool normalsRequired = false;        ///< whether unusable normals are an error
  std::optional<PointArray> embedding; ///< instead of positions, normals and `coordinates`
  std::optional<PointArray> metric;    ///< instead of all of these
  TensorOrder metricOrder = TensorOrder::Vtk;
  int metricDimension = 6;   ///< of the space that the metric is embedded in
  bool limitMetric = true;   ///< to what straight edges can follow, and by its growth
  double metricGrowth = 5.0; ///< of sizes over the length of an edge, at most
  double metricUnit = 0.0;   ///< length of edges in the metric; 0: what the number of sites gives
  std::optional<PointArray> density;                      ///< none: the same everywhere
  std::vector<std::pair<PointArray, double>> coordinates; ///< appended, each times its scale

  bool preserveFeatures = false;
  double featureAngle = 35.0;      ///< degrees
  std::vector<Index> cellLabels;   ///< of the caller's cells: features where they change; or empty
  std::optional<PointArray> seams; ///< features where its values jump
  std::vector<PointArray> carried; ///< arrays for the mesh; if they jump beside seams, it is told

  /**
   * Whether arrays may be read in place where the embedding has many dimensions, instead of being
   * copied. Then they must outlive the surface.
   */
  bool mayLend = false;
  /** `coordinates` are kept for up to that many dimensions, and where they cost nothing. */
  int maxKeptDimensions = std::numeric_limits<int>::max();
  bool mayRefine = false; ///< whether facets that are large against the spacing may be split

  /** Passes over the corners around each one, if they are asked for and no radius is; else 0. */
  int passesOfSmoothing() const
  {
    return this->smoothingRadius >= 0.0 ? 0 : std::max(0, this->normalSmoothingPasses);
  }
};

/** The surface as the input has it, where it was refined for the embedding. */
struct InputSurface
{
  SurfaceMesh mesh;
  std::optional<Features> features;
  FacetOrigins origins; ///< of the refined surface's facets, on this one
};

struct PreparedSurface
{
  SurfaceMesh mesh;                  ///< refined, if it had to be (NormalVariation.h)
  std::optional<InputSurface> input; ///< where `mesh` is refined; use `inputMesh`
  IntakeReport intake;
  std::vector<FacetNormal> borrowedNormals; ///< of facets that have none of their own
  std::vector<Point3> normals;              ///< C, unit; before the smoothing over the spacing
  /** Of that smoothing, in the unit of the points; 0: none. Where estimated normals count. */
  std::optional<double> smoothingRadius;
  CornerCoordinates coordinates; ///< C x d, the caller's units; empty where not to be kept
  EmbeddedSurface surface;
  bool isEmbeddingGiven = false; ///< by an array, or a metric: not made from positions and normals
  std::optional<MetricFit> metricFit; ///< where there is a metric
  std::optional<MetricField> metric;  ///< V, for `mesh`: MetricSurface::shapeMetric
  /** Along which the mesh was cut open, if there are any; its patches are apart in `surface`. */
  std::optional<Features> features;
  std::vector<Triple> charts; ///< F x 3, see FeatureOptions; empty: there are no seams among them
  DroppedCreases dropped;     ///< too small for the sites, sides of needles, and steps
  std::vector<std::string> usedArrays; ///< names of those given as normals, embedding or metric
  std::vector<std::string> warnings;

  /** In which triangles are to be even; nullptr: none, or a density is to make them uneven. */
  const MetricField* metricOrNone() const
  {
    return this->metric && !this->surface.hasDensity() ? &*this->metric : nullptr;
  }
  /** Those of `mesh`, or nullptr. */
  const Features* featuresOrNone() const { return this->features ? &*this->features : nullptr; }
  /** The surface after intake, whose facets are the caller's. */
  const SurfaceMesh& inputMesh() const { return this->input ? this->input->mesh : this->mesh; }
  const std::optional<Features>& inputFeatures() const
  {
    return this->input ? this->input->features : this->features;
  }
  /** The facet of `inputMesh` that a facet is a part of, and the place there of one on it. */
  Index inputFacet(Index facet) const
  {
    return this->input ? this->input->origins[facet].facet : facet;
  }
  std::array<double, 3> inputPlace(Index facet, const double b[3]) const
  {
    return this->input ? this->input->origins[facet].place(b)
                       : std::array<double, 3>{ b[0], b[1], b[2] };
  }
};

/** Which features count for so many sites. */
FeatureOptions featureOptions(const PreparationRequest& request, const SurfaceMesh& mesh);

/**
 * As many points as give edges of unit length in the request's metric, as limited: 2/sqrt 3 of its
 * area, and half of its border's length, in units.
 *
 * @param complexity the area that the metric is scaled to, in squares of units; 0: as it is.
 * @param unit receives the unit: 1, or what scales the metric.
 * Takes as long as preparing the surface, but for the embedding.
 */
Status findUnitNumber(const PreparationRequest& request, double complexity,
  const RunControl& control, Offset& number, double& unit);

/**
 * @param prepared is replaced; its `intake` tells, after an error, too, what was dropped.
 * @return what the source returns; EmptyInput and InvalidInput of the intake; InvalidInput, with
 *         the array's name, for arrays that cannot be used; Cancelled.
 */
Status prepareSurface(
  const PreparationRequest& request, const RunControl& control, PreparedSurface& prepared);
}

#endif
