/**
 * @file SurfacePreparation.h
 * @brief From a filter's input and parameters to the embedded surface.
 */
#ifndef remesh_SurfacePreparation_h
#define remesh_SurfacePreparation_h

#include "Embedding/Embedding.h"
#include "Mesh/Intake.h"

#include <string>
#include <utility>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace remesh
{
struct PreparationRequest
{
  bool gaussMap = true;
  double anisotropy = 0.04;          ///< fraction of the bounding-box diagonal
  int normalSmoothingPasses = -1;    ///< negative: automatic
  double mergeTolerance = 0.0;       ///< fraction of the bounding-box diagonal
  vtkDataArray* normals = nullptr;   ///< of the points; nullptr: estimate
  bool normalsRequired = false;      ///< whether unusable normals are an error
  vtkDataArray* embedding = nullptr; ///< of the points; replaces all others
  std::vector<std::pair<vtkDataArray*, double>> coordinates; ///< appended, each times its scale
};

struct PreparedSurface
{
  SurfaceMesh mesh;
  IntakeReport intake;
  std::vector<Point3> normals;   ///< C, unit
  CornerCoordinates coordinates; ///< C x d, the caller's units
  EmbeddedSurface surface;
  std::vector<std::string> warnings;
};

Status prepareSurface(vtkPolyData* input, const PreparationRequest& request,
  const RunControl& control, PreparedSurface& prepared);
}

#endif
