#include "Preparation/SurfacePreparation.h"

#include "Embedding/Wrinkles.h"
#include "Features/FeatureGraph.h"
#include "Mesh/Extent.h"
#include "Mesh/FacetGeometry.h"
#include "Mesh/NormalFlow.h"
#include "Preparation/CornerArrays.h"
#include "Preparation/IntakeWarnings.h"
#include "Preparation/SeamCharts.h"
#include "Refinement/NormalVariation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace remesh
{
namespace
{
/** Share of wrinkles (Wrinkles.h) up to which bends are kept as they are. */
constexpr double maxWrinkles = 0.05;

/** The diagonal of the box around the points that triangles use. */
double diagonalOf(const TriangleSoup& soup)
{
  double sum = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    double low = DBL_MAX; // not a number is neither below nor above
    double high = -DBL_MAX;
    for (const auto& triangle : soup.triangles)
    {
      for (const Offset point : triangle)
      {
        low = std::min(low, soup.points[point][c]);
        high = std::max(high, soup.points[point][c]);
      }
    }
    sum += high >= low ? (high - low) * (high - low) : 0.0;
  }
  return std::sqrt(sum);
}

Status takeIn(
  const PreparationRequest& request, const RunControl& control, PreparedSurface& prepared)
{
  TriangleSoup soup;
  std::string warning;
  if (Status status = request.source.read(soup, warning); !status.ok())
  {
    return status;
  }
  if (!warning.empty())
  {
    prepared.warnings.push_back(warning);
  }
  IntakeOptions options;
  if (request.mergeTolerance > 0.0)
  {
    options.mergeDistance = request.mergeTolerance * diagonalOf(soup);
  }
  return buildSurfaceMesh(soup, options, control, prepared.mesh, prepared.intake);
}

/** Cuts the mesh open along its features. */
Status takeFeatures(
  const PreparationRequest& request, const RunControl& control, PreparedSurface& prepared)
{
  if (!request.preserveFeatures)
  {
    return Status::success();
  }
  FeatureOptions options = featureOptions(request, prepared.mesh);
  Features features = findFeatures(prepared.mesh, options, control, &prepared.borrowedNormals);
  if (control.cancelled())
  {
    return Status::cancelled();
  }
  prepared.charts = std::move(options.cornerCharts);
  prepared.dropped = features.dropped;
  if (features.any() || features.numberOfPatches > 1)
  {
    prepared.features = std::move(features);
  }
  return Status::success();
}

/** Where the normals of the corners come from. */
struct NormalSource
{
  bool estimated = false;
  std::vector<Point3> given; ///< P, of the caller's points; none where estimated
};

Status findNormals(const PreparationRequest& request, const RunControl& control,
  PreparedSurface& prepared, NormalSource& source)
{
  if (request.normals)
  {
    Status status = readNormals(*request.normals, request.source.numberOfPoints, source.given);
    if (status.ok())
    {
      status = givenCornerNormals(prepared.mesh, source.given, prepared.normals);
    }
    if (status.ok() || request.normalsRequired)
    {
      return status;
    }
    prepared.warnings.push_back(status.message + " The normals are estimated instead.");
  }
  source = { true, {} };
  prepared.normals = estimateCornerNormals(
    prepared.mesh, request.passesOfSmoothing(), control, prepared.borrowedNormals);
  return Status::success();
}

/** Splits facets that are too large for the Gauss map. Normals smoothed by passes are kept. */
void refineSurface(const PreparationRequest& request, const NormalSource& source,
  const RunControl& control, PreparedSurface& prepared)
{
  const bool hasPasses = source.estimated && request.passesOfSmoothing() > 0;
  if (!request.mayRefine || !request.gaussMap || request.embedding || request.metric || hasPasses)
  {
    return;
  }
  const OwnNormals own(prepared.mesh, prepared.borrowedNormals, prepared.normals,
    source.estimated ? nullptr : &source.given);
  const double s = request.anisotropy * boundingBoxDiagonal(prepared.mesh);
  RefinedSurface refined;
  std::vector<Point3> normals;
  if (!refineForNormals(
        own, prepared.featuresOrNone(), s, request.numberOfSites, control, refined, normals))
  {
    return;
  }
  prepared.input = InputSurface{ std::move(prepared.mesh), std::move(prepared.features),
    FacetOrigins(refined.origins) };
  prepared.mesh = std::move(refined.mesh);
  prepared.features = std::move(refined.features);
  prepared.normals = std::move(normals);
}

/** Estimated normals, smoothed at the scale of the sites or over the radius that is asked for. */
std::vector<Point3> smoothNormals(
  const PreparationRequest& request, double s, const RunControl& control, PreparedSurface& prepared)
{
  const bool isGiven = request.smoothingRadius >= 0.0;
  prepared.smoothingRadius = isGiven
    ? request.smoothingRadius
    : request.smoothing * smoothingRadius(prepared.mesh, request.numberOfSites);
  std::vector<Point3> smoothed = prepared.normals;
  smoothNormalsOver(prepared.mesh, *prepared.smoothingRadius, control, smoothed);
  if (!isGiven && request.mayStaySharp &&
    wrinkledShare(prepared.mesh, prepared.normals, smoothed, s, control.silent()) <= maxWrinkles)
  {
    prepared.smoothingRadius = 0.0;
    smoothed = prepared.normals;
  }
  return smoothed;
}

/** Appends an array, each value times `scale`, at the corners of the surface. */
Status appendArray(const PointArray& array, double scale, Offset points, PreparedSurface& prepared)
{
  if (!prepared.input)
  {
    return appendCornerArray(prepared.mesh, array, scale, points, prepared.coordinates);
  }
  CornerCoordinates read;
  const Status status = appendCornerArray(prepared.input->mesh, array, scale, points, read);
  if (status.ok())
  {
    appendCoordinates(prepared.coordinates,
      interpolateCorners(prepared.input->mesh, prepared.mesh, prepared.input->origins, read), 1.0);
  }
  return status;
}

/** Position and normal; estimated normals at the scale of the sites, if no passes were asked for.
 */
CornerCoordinates makeGaussMap(const PreparationRequest& request, double s, bool estimated,
  const RunControl& control, PreparedSurface& prepared)
{
  const bool asTheyAre =
    !estimated || (request.normalSmoothingPasses >= 0 && !(request.smoothingRadius >= 0.0));
  return asTheyAre
    ? gaussMapCoordinates(prepared.mesh, prepared.normals, s)
    : gaussMapCoordinates(prepared.mesh, smoothNormals(request, s, control, prepared), s);
}

/** The arrays of the embedding, each with its scale, or an error. */
Status arraysOf(
  const PreparationRequest& request, std::vector<std::pair<PointArray, double>>& arrays)
{
  arrays = request.coordinates;
  if (!request.embedding)
  {
    return Status::success();
  }
  if (request.embedding->dimension < 2)
  {
    return Status::invalid("The embedding array \"" + request.embedding->name +
      "\" has 1 component; an embedding has at least 2.");
  }
  arrays.assign(1, { *request.embedding, 1.0 });
  return Status::success();
}

/** Goes on with a refined surface, whose normals are linear on the facets. */
void takeRefined(RefinedSurface refined, PreparedSurface& prepared)
{
  CornerCoordinates normals;
  normals.dimension = 3;
  for (const Point3& normal : prepared.normals)
  {
    normals.values.insert(normals.values.end(), normal.data(), normal.data() + 3);
  }
  FacetOrigins origins(refined.origins);
  normals = interpolateCorners(prepared.mesh, refined.mesh, origins, normals);
  prepared.normals.resize(refined.mesh.cornerPoints.size());
  for (std::size_t c = 0; c < prepared.normals.size(); ++c)
  {
    prepared.normals[c] = Point3(&normals.values[3 * c]).stableNormalized();
  }
  prepared.input =
    InputSurface{ std::move(prepared.mesh), std::move(prepared.features), std::move(origins) };
  prepared.mesh = std::move(refined.mesh);
  prepared.features = std::move(refined.features);
}

MetricOptions metricOptionsOf(const PreparationRequest& request)
{
  MetricOptions options;
  options.dimension = request.metricDimension;
  options.sites = request.numberOfSites;
  options.unit = request.metricUnit;
  options.isLimited = request.limitMetric;
  options.growth = request.metricGrowth;
  options.mayRefine = request.mayRefine;
  return options;
}

/** The places of the corners in an embedding of the metric. */
Status embedMetric(
  const PreparationRequest& request, const RunControl& control, PreparedSurface& prepared)
{
  MetricField metric;
  Status status = readMetric(
    prepared.mesh, *request.metric, request.metricOrder, request.source.numberOfPoints, metric);
  if (!status.ok())
  {
    return status;
  }
  const MetricOptions options = metricOptionsOf(request);
  MetricSurface surface;
  status = embedMetric(prepared.mesh, prepared.features ? &*prepared.features : nullptr, metric,
    options, control, surface);
  if (!status.ok())
  {
    return status;
  }
  if (surface.refined)
  {
    takeRefined(std::move(*surface.refined), prepared);
  }
  const MetricFit& fit = prepared.metricFit.emplace(fitOf(surface));
  prepared.coordinates = metricCoordinates(prepared.mesh, surface);
  prepared.metric = std::move(surface.shapeMetric);
  tellFit(fit, prepared.warnings);
  return status;
}

Status makeCoordinates(const PreparationRequest& request, bool estimated, const RunControl& control,
  PreparedSurface& prepared)
{
  if (request.metric)
  {
    return embedMetric(request, control, prepared);
  }
  std::vector<std::pair<PointArray, double>> arrays;
  if (Status status = arraysOf(request, arrays); !status.ok())
  {
    return status;
  }
  if (!request.embedding)
  {
    const double s = request.anisotropy * boundingBoxDiagonal(prepared.mesh);
    prepared.coordinates = request.gaussMap && s > 0.0
      ? makeGaussMap(request, s, estimated, control, prepared)
      : positionCoordinates(prepared.mesh);
  }
  const Offset points = request.source.numberOfPoints;
  // What is done along features works on held coordinates, and patches are moved apart.
  if (request.mayLend && !prepared.features && !prepared.input &&
    lendCornerArrays(prepared.mesh, arrays, points, manyDimensions, prepared.coordinates))
  {
    return Status::success();
  }
  for (const auto& [array, scale] : arrays)
  {
    if (Status status = appendArray(array, scale, points, prepared); !status.ok())
    {
      return status;
    }
  }
  return Status::success();
}

/** The surface in R^d, from the coordinates, with its density, and patches moved apart. */
Status embed(
  const PreparationRequest& request, const RunControl& control, PreparedSurface& prepared)
{
  CornerCoordinates& made = prepared.coordinates;
  const bool keep = made.isLent() || made.dimension <= request.maxKeptDimensions;
  CornerCoordinates coordinates = keep ? made : std::exchange(made, CornerCoordinates());
  Status status = embedSurface(prepared.mesh, std::move(coordinates), control, prepared.surface);
  if (status.ok() && request.density)
  {
    std::vector<double> densities;
    status = readFacetDensities(
      prepared.inputMesh(), *request.density, request.source.numberOfPoints, densities);
    if (status.ok() && prepared.input)
    {
      densities = densitiesOf(prepared.input->mesh, prepared.input->origins, *request.density);
    }
    if (status.ok())
    {
      weightByDensity(densities, prepared.surface);
    }
  }
  if (status.ok() && prepared.features && prepared.features->numberOfPatches > 1)
  {
    separatePatches(
      prepared.features->facetPatches, prepared.features->numberOfPatches, prepared.surface);
  }
  return status;
}
}

FeatureOptions featureOptions(const PreparationRequest& request, const SurfaceMesh& mesh)
{
  FeatureOptions options;
  options.angleDegrees = request.featureAngle;
  options.spacing = meanSpacing(
    mesh, request.sitesForFeatures > 0 ? request.sitesForFeatures : request.numberOfSites);
  if (!request.cellLabels.empty())
  {
    for (const Offset cell : mesh.facetInputCells)
    {
      options.facetLabels.push_back(request.cellLabels[cell]);
    }
  }
  options.cornerCharts = findKeptSeams(mesh, request, RunControl());
  return options;
}

Status findUnitNumber(const PreparationRequest& request, double complexity,
  const RunControl& control, Offset& number, double& unit)
{
  if (!request.metric)
  {
    return Status::invalid("UnitEdges needs a metric: choose a MetricArray.");
  }
  PreparedSurface prepared;
  MetricField metric;
  MetricSize size;
  Status status = takeIn(request, control.silent(), prepared);
  if (status.ok())
  {
    status = readMetric(
      prepared.mesh, *request.metric, request.metricOrder, request.source.numberOfPoints, metric);
  }
  MetricOptions options = metricOptionsOf(request);
  if (status.ok())
  {
    status = findComplexityUnit(prepared.mesh, metric, complexity, control.silent(), options.unit);
  }
  if (status.ok())
  {
    status = measureMetric(prepared.mesh, metric, options, control.silent(), size);
  }
  unit = options.unit;
  const double points = std::min(size.points(unit), static_cast<double>(maximumIndex));
  number = std::max(Offset(4), static_cast<Offset>(std::llround(points)));
  return status;
}

Status prepareSurface(
  const PreparationRequest& request, const RunControl& control, PreparedSurface& prepared)
{
  prepared = PreparedSurface{};
  prepared.isEmbeddingGiven = request.embedding || request.metric;
  for (const std::optional<PointArray>* array :
    { &request.normals, &request.embedding, &request.metric })
  {
    if (*array)
    {
      prepared.usedArrays.push_back((*array)->name);
    }
  }
  RunControl progress = control;
  progress.enterPhase("Intake", 0.0, 0.7);
  if (Status status = takeIn(request, progress, prepared); !status.ok())
  {
    return status;
  }
  tellIntake(prepared.intake, prepared.mesh.numberOfFacets(), prepared.warnings);
  tellRounding(request.source.precision, prepared.mesh, prepared.warnings);
  if (Status status = takeFeatures(request, progress, prepared); !status.ok())
  {
    return status;
  }
  tellJumps(request, progress, prepared);
  progress.enterPhase("Embedding", 0.7, 1.0);
  NormalSource source;
  Status status = findNormals(request, progress.step(0, 3), prepared, source);
  if (status.ok())
  {
    refineSurface(request, source, progress.silent(), prepared);
    status = progress.cancelled()
      ? Status::cancelled()
      : makeCoordinates(request, source.estimated, progress.step(1, 3), prepared);
  }
  return status.ok() ? embed(request, progress.step(2, 3), prepared) : status;
}
}
