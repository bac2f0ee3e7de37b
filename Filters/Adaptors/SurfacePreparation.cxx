#include "Adaptors/SurfacePreparation.h"

#include "Adaptors/CornerArrays.h"
#include "Adaptors/SurfaceIntake.h"
#include "Mesh/Normals.h"

#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"

namespace remesh
{
namespace
{
Status takeIn(
  vtkPolyData* input, double mergeTolerance, const RunControl& control, PreparedSurface& prepared)
{
  TriangleSoup soup;
  if (Status status = readTriangleSoup(input, soup); !status.ok())
  {
    return status;
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

Status findNormals(vtkPolyData* input, const PreparationRequest& request, const RunControl& control,
  PreparedSurface& prepared)
{
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
  prepared.normals = estimateCornerNormals(prepared.mesh, request.normalSmoothingPasses, control);
  return Status::success();
}

Status makeCoordinates(
  vtkPolyData* input, const PreparationRequest& request, PreparedSurface& prepared)
{
  const Offset points = input->GetNumberOfPoints();
  if (request.embedding)
  {
    if (request.embedding->GetNumberOfComponents() < 2)
    {
      return Status::invalid(std::string("The embedding array \"") + request.embedding->GetName() +
        "\" has 1 component; an embedding has at least 2.");
    }
    return readCornerArray(prepared.mesh, request.embedding, points, prepared.coordinates);
  }
  const double s = request.anisotropy * boundingBoxDiagonal(prepared.mesh);
  prepared.coordinates = request.gaussMap && s > 0.0
    ? gaussMapCoordinates(prepared.mesh, prepared.normals, s)
    : positionCoordinates(prepared.mesh);
  for (const auto& [array, scale] : request.coordinates)
  {
    CornerCoordinates more;
    if (Status status = readCornerArray(prepared.mesh, array, points, more); !status.ok())
    {
      return status;
    }
    appendCoordinates(prepared.coordinates, more, scale);
  }
  return Status::success();
}
}

Status prepareSurface(vtkPolyData* input, const PreparationRequest& request,
  const RunControl& control, PreparedSurface& prepared)
{
  prepared = PreparedSurface{};
  RunControl progress = control;
  progress.enterPhase("Intake", 0.0, 0.7);
  if (Status status = takeIn(input, request.mergeTolerance, progress, prepared); !status.ok())
  {
    return status;
  }
  if (!prepared.intake.orientable)
  {
    prepared.warnings.push_back(
      "The surface is not orientable: the mesh cannot be oriented consistently.");
  }
  progress.enterPhase("Embedding", 0.7, 1.0);
  if (Status status = findNormals(input, request, progress.step(0, 2), prepared); !status.ok())
  {
    return status;
  }
  if (Status status = makeCoordinates(input, request, prepared); !status.ok())
  {
    return status;
  }
  return embedSurface(prepared.mesh, prepared.coordinates, progress.step(1, 2), prepared.surface);
}
}
