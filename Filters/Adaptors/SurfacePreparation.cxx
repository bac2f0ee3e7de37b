#include "Adaptors/SurfacePreparation.h"

#include "Adaptors/CornerArrays.h"
#include "Adaptors/FacetLabels.h"
#include "Adaptors/SurfaceIntake.h"
#include "Embedding/Wrinkles.h"
#include "Features/FeatureGraph.h"
#include "Mesh/Extent.h"
#include "Mesh/NormalFlow.h"

#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

namespace remesh
{
namespace
{
/** Share of wrinkles (Wrinkles.h) up to which bends are kept as they are. */
constexpr double mostWrinkles = 0.05;

Status takeIn(
  vtkPolyData* input, double mergeTolerance, const RunControl& control, PreparedSurface& prepared)
{
  TriangleSoup soup;
  std::string warning;
  if (Status status = readTriangleSoup(input, soup, &warning); !status.ok())
  {
    return status;
  }
  if (!warning.empty())
  {
    prepared.warnings.push_back(warning);
  }
  IntakeOptions options;
  if (mergeTolerance > 0.0)
  {
    vtkBoundingBox box;
    for (const auto& triangle : soup.triangles)
    {
      for (const Offset point : triangle)
      {
        box.AddPoint(soup.points[point].data());
      }
    }
    options.mergeDistance = box.IsValid() ? mergeTolerance * box.GetDiagonalLength() : 0.0;
  }
  return buildSurfaceMesh(soup, options, control, prepared.mesh, prepared.intake);
}

/** Cuts the mesh open along its features. */
Status takeFeatures(vtkPolyData* input, const PreparationRequest& request,
  const RunControl& control, PreparedSurface& prepared)
{
  if (!request.preserveFeatures)
  {
    return Status::success();
  }
  FeatureOptions options;
  if (Status status = readFeatureOptions(input, request, prepared.mesh, options); !status.ok())
  {
    return status;
  }
  Features features = findFeatures(prepared.mesh, options, control, &prepared.borrowedNormals);
  if (control.cancelled())
  {
    return Status::cancelled();
  }
  prepared.droppedCreases = features.droppedEdges;
  if (features.any() || features.numberOfPatches > 1)
  {
    prepared.features = std::move(features);
  }
  return Status::success();
}

Status findNormals(vtkPolyData* input, const PreparationRequest& request, const RunControl& control,
  PreparedSurface& prepared, bool& estimated)
{
  estimated = false;
  if (request.normals)
  {
    std::vector<Point3> given;
    Status status = readNormals(request.normals, input->GetNumberOfPoints(), given);
    if (status.ok())
    {
      status = givenCornerNormals(prepared.mesh, given, prepared.normals);
    }
    if (status.ok() || request.normalsRequired)
    {
      return status;
    }
    prepared.warnings.push_back(status.message + " The normals are estimated instead.");
  }
  estimated = true;
  const int passes =
    request.smoothingRadius >= 0.0 ? 0 : std::max(0, request.normalSmoothingPasses);
  prepared.normals =
    estimateCornerNormals(prepared.mesh, passes, control, prepared.borrowedNormals);
  return Status::success();
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
    wrinkledShare(prepared.mesh, prepared.normals, smoothed, s, control.silent()) <= mostWrinkles)
  {
    prepared.smoothingRadius = 0.0;
    smoothed = prepared.normals;
  }
  return smoothed;
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
  const PreparationRequest& request, std::vector<std::pair<vtkDataArray*, double>>& arrays)
{
  arrays = request.coordinates;
  if (!request.embedding)
  {
    return Status::success();
  }
  if (request.embedding->GetNumberOfComponents() < 2)
  {
    const char* name = request.embedding->GetName(); // an active array may have none
    return Status::invalid(std::string("The embedding array \"") + (name ? name : "") +
      "\" has 1 component; an embedding has at least 2.");
  }
  arrays.assign(1, { request.embedding, 1.0 });
  return Status::success();
}

Status makeCoordinates(vtkPolyData* input, const PreparationRequest& request, bool estimated,
  const RunControl& control, PreparedSurface& prepared)
{
  std::vector<std::pair<vtkDataArray*, double>> arrays;
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
  const Offset points = input->GetNumberOfPoints();
  // What is done along features works on held coordinates, and patches are moved apart.
  if (request.mayLend && !prepared.features &&
    lendCornerArrays(prepared.mesh, arrays, points, manyDimensions, prepared.coordinates))
  {
    return Status::success();
  }
  for (const auto& [array, scale] : arrays)
  {
    if (Status status =
          appendCornerArray(prepared.mesh, array, scale, points, prepared.coordinates);
        !status.ok())
    {
      return status;
    }
  }
  return Status::success();
}

/** The surface in R^d, from the coordinates, with its density, and patches moved apart. */
Status embed(vtkPolyData* input, const PreparationRequest& request, const RunControl& control,
  PreparedSurface& prepared)
{
  CornerCoordinates& made = prepared.coordinates;
  const bool keep = made.isLent() || made.dimension <= request.mostKeptDimensions;
  CornerCoordinates coordinates = keep ? made : std::exchange(made, CornerCoordinates());
  Status status = embedSurface(prepared.mesh, std::move(coordinates), control, prepared.surface);
  if (status.ok() && request.density)
  {
    std::vector<double> densities;
    status =
      readFacetDensities(prepared.mesh, request.density, input->GetNumberOfPoints(), densities);
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

void tellIntake(const IntakeReport& intake, std::vector<std::string>& warnings)
{
  if (!intake.orientable)
  {
    warnings.push_back("The surface is not orientable: the mesh cannot be oriented consistently.");
  }
  if (intake.nearBorderPoints > 0)
  {
    warnings.push_back("Points on the border are other ones there but for rounding: " +
      std::to_string(intake.nearBorderPoints) +
      ". A MergeTolerance, of 1e-12 say, makes them one and closes the slit between them.");
  }
}
}

Status readFeatureOptions(vtkPolyData* input, const PreparationRequest& request,
  const SurfaceMesh& mesh, FeatureOptions& options)
{
  options.angleDegrees = request.featureAngle;
  options.spacing = meanSpacing(
    mesh, request.sitesForFeatures > 0 ? request.sitesForFeatures : request.numberOfSites);
  if (request.labels)
  {
    if (Status status =
          readFacetLabels(mesh, request.labels, input->GetNumberOfCells(), options.facetLabels);
        !status.ok())
    {
      return status;
    }
  }
  addRegions(mesh, input, options.facetLabels);
  return Status::success();
}

Status prepareSurface(vtkPolyData* input, const PreparationRequest& request,
  const RunControl& control, PreparedSurface& prepared)
{
  prepared = PreparedSurface{};
  for (vtkDataArray* array : { request.normals, request.embedding })
  {
    if (array)
    {
      prepared.usedArrays.push_back(array);
    }
  }
  RunControl progress = control;
  progress.enterPhase("Intake", 0.0, 0.7);
  if (Status status = takeIn(input, request.mergeTolerance, progress, prepared); !status.ok())
  {
    return status;
  }
  tellIntake(prepared.intake, prepared.warnings);
  if (Status status = takeFeatures(input, request, progress, prepared); !status.ok())
  {
    return status;
  }
  progress.enterPhase("Embedding", 0.7, 1.0);
  bool estimated = false;
  Status status = findNormals(input, request, progress.step(0, 3), prepared, estimated);
  if (status.ok())
  {
    status = makeCoordinates(input, request, estimated, progress.step(1, 3), prepared);
  }
  return status.ok() ? embed(input, request, progress.step(2, 3), prepared) : status;
}
}
