#include "Adaptors/WholeData.h"

namespace remesh
{
Status gatherInputs(vtkAlgorithm*, const Status& status, WholeData&)
{
  return status;
}

int spreadOutputs(vtkAlgorithm*, int done, WholeData&)
{
  return done;
}
}
