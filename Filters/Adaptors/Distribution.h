/**
 * @file Distribution.h
 * @brief Whether a filter that needs the whole surface is asked for a piece of it.
 */
#ifndef remesh_Distribution_h
#define remesh_Distribution_h

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <string>

namespace remesh
{
/**
 * A sentence for the user where a piece other than the first has polygons or strips, else nothing.
 * What is not distributed is all in the first piece, which therefore has nothing to tell.
 *
 * @param connections of one input port; it may have none.
 */
inline std::string describeDistribution(vtkInformationVector* connections)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  // The request has come to the inputs, whichever output it was for.
  vtkInformation* port = connections->GetInformationObject(0);
  vtkPolyData* input = port ? vtkPolyData::GetData(port) : nullptr;
  const bool isFirst = !port || !port->Has(Pipeline::UPDATE_PIECE_NUMBER()) ||
    port->Get(Pipeline::UPDATE_PIECE_NUMBER()) <= 0;
  if (isFirst || !input || input->GetNumberOfPolys() + input->GetNumberOfStrips() == 0)
  {
    return {};
  }
  return "The surface is distributed over " +
    std::to_string(port->Get(Pipeline::UPDATE_NUMBER_OF_PIECES())) +
    " processes: each works on its own piece as if that were the whole surface, and the results do "
    "not fit together. Gather the surface on one process first.";
}
}

#endif
