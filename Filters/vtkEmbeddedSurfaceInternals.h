/**
 * @file vtkEmbeddedSurfaceInternals.h
 * @brief Private state of vtkEmbeddedSurfaceAlgorithm and its subclasses.
 */
#ifndef vtkEmbeddedSurfaceInternals_h
#define vtkEmbeddedSurfaceInternals_h

#include "vtkEmbeddedSurfaceAlgorithm.h"

#include "Adaptors/ExecutionScope.h"
#include "Preparation/SurfacePreparation.h"

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

class vtkPolyData;

struct vtkEmbeddedSurfaceAlgorithm::vtkInternals
{
  std::vector<std::pair<std::string, double>> CoordinateArrays;

  /** Facts about the last execution. */
  struct Facts
  {
    remesh::IntakeReport Intake;
    remesh::Execution Execution;
    int Dimension = 0;
    int Iterations = 0;
    int Evaluations = 0;
    double Energy = 0.0;
    std::string TopologyReport;
    std::map<std::string, double> Seconds;
  } LastRun;

  /** The normals to use, as the filter's choice and this input say. */
  static remesh::Status FindNormals(
    vtkEmbeddedSurfaceAlgorithm* self, vtkPolyData* input, remesh::PreparationRequest& request);

  /** All arrays that are chosen. */
  static remesh::Status FindArrays(
    vtkEmbeddedSurfaceAlgorithm* self, vtkPolyData* input, remesh::PreparationRequest& request);

  /**
   * Adds the surface, the filter's parameters and chosen arrays to a request, in which the features
   * are; fails for an input without polygons (EmptyInput, InvalidInput as checkForPolygons), and
   * then for arrays that are missing.
   */
  static remesh::Status MakeRequest(vtkEmbeddedSurfaceAlgorithm* self,
    vtkInformationVector** inputVector, remesh::PreparationRequest& request);

  enum class Outcome
  {
    Done,    ///< there is a result to write
    Nothing, ///< empty input or cancelled: the outputs are empty, and RequestData returns 1
    Failed   ///< an error was reported: the outputs are empty, and RequestData returns 0
  };

  /**
   * Checks the parameters, runs `work` in the filter's threads and back-end, and turns the status
   * into VTK's errors.
   * `work` sets LastRun.Intake: an input that has triangles, but none of use, gives a warning.
   * What `work` wrote to the outputs is taken back unless all of it was done.
   */
  static Outcome Execute(vtkEmbeddedSurfaceAlgorithm* self, vtkInformationVector* outputVector,
    const std::function<remesh::Status()>& work);
};

#endif
