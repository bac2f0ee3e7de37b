/**
 * @file SharedInputs.h
 * @brief Brings the inputs of a filter up to date on all processes that share its work, or on none.
 *
 * Where the input fails, VTK's executive ends without a call of the filter. Were that so on one
 * process alone, the others would wait for it in SurfaceGathering, for ever.
 */
#ifndef remesh_SharedInputs_h
#define remesh_SharedInputs_h

#include "vtkType.h"

class vtkAlgorithm;
class vtkInformation;

namespace remesh
{
class SharedInputs
{
public:
  /**
   * For vtkAlgorithm::ModifyRequest, before REQUEST_DATA is forwarded: does what the executive is
   * about to do, which then finds all done. Input that has failed counts as failed until it, or the
   * time that is asked for, is another: VTK takes it for up to date, and would go on with an empty
   * piece.
   *
   * @return whether the execution goes on: the same on all processes. If not, the first of them has
   * told an error, once for each failure. Cost: nothing where the process is alone; its executive
   * does all.
   */
  bool update(vtkAlgorithm* filter, vtkInformation* request);

private:
  struct State
  {
    vtkMTimeType age = 0; ///< of the pipeline
    double time = 0.0;
    bool operator==(const State& other) const { return age == other.age && time == other.time; }
  };

  static State stateOf(vtkAlgorithm* filter);
  static bool forward(vtkAlgorithm* filter, vtkInformation* request);

  State Failed; ///< on this process
  State Told;   ///< of failures on any
};
}

#endif
