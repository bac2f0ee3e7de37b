/**
 * @file FieldSurface.h
 * @brief From a filter's input to the surface that a field is computed on, and back to its points.
 */
#ifndef remesh_FieldSurface_h
#define remesh_FieldSurface_h

#include "Mesh/Intake.h"
#include "Preparation/MetricInput.h"

#include "vtkPolyData.h"

#include <functional>
#include <string>
#include <vector>

namespace remesh
{
struct FieldSurface
{
  vtkPolyData* input = nullptr;
  vtkPolyData* output = nullptr;
  RunControl control;
  std::vector<std::string> warnings;
  SurfaceMesh mesh;
  IntakeReport intake;
  /** V, of each of the mesh's points the lowest of the input's. */
  std::vector<Offset> inputPoints;
  /** P, of each of the input's points the mesh's; noIndex where no polygon uses it. */
  std::vector<Index> meshPoints;
};

/** Reads the input, and makes the output a shallow copy. @return as SurfaceIntake.h, Intake.h. */
Status takeFieldSurface(FieldSurface& surface);

/**
 * The point array of a name.
 *
 * @param role how messages call it, as "a solution".
 * @return InvalidInput where it is not there, is not numeric, or has not a tuple for each point.
 */
Status findNamedArray(
  const FieldSurface& surface, const std::string& name, const char* role, vtkDataArray*& array);

/**
 * Calls `write(mesh point, component, value)` for all values at the mesh's points.
 *
 * @return InvalidInput with the first of the input's points where a value is not finite.
 */
Status readValues(const FieldSurface& surface, vtkDataArray* array,
  const std::function<void(Index, int, double)>& write);

/** Adds a double array; `fill(mesh point, tuple)`, the point being noIndex where there is none. */
void addPointField(const FieldSurface& surface, const char* name, int components,
  const std::function<void(Index, double*)>& fill);

/** Adds one number to the output's field data. */
void addFact(const FieldSurface& surface, const char* name, double value);
}

#endif
