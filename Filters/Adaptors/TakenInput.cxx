#include "Adaptors/TakenInput.h"

#include "Adaptors/LeafSurface.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

namespace remesh
{
Status takeInput(
  vtkDataObject* input, const std::string& subject, bool takesPoints, TakenInput& taken)
{
  auto& [whole, blocks, report] = taken;
  whole = input;
  const bool isPlain = takesPoints ? vtkPointSet::SafeDownCast(input) != nullptr
                                   : vtkPolyData::SafeDownCast(input) != nullptr;
  if (!input || isPlain)
  {
    return Status::success();
  }
  auto joined = vtkSmartPointer<vtkPolyData>::New();
  whole = joined;
  if (hasBlocks(input))
  {
    blocks = findBlocks(input);
    Status status = takesPoints ? joinPoints(blocks, joined) : joinBlocks(blocks, joined, report);
    joined->GetFieldData()->PassData(input->GetFieldData());
    return status;
  }
  if (takesPoints)
  {
    return Status::invalid(
      std::string("The sites are a ") + input->GetClassName() + ", which has no points for sites.");
  }
  LeafSurface leaf;
  if (Status status = readLeaf(input, subject, leaf); !status.ok())
  {
    return status;
  }
  if (leaf.cellIds)
  {
    joinLeaf(leaf, joined, report);
    joined->GetFieldData()->PassData(input->GetFieldData());
    return Status::success();
  }
  leaf.surface->GetCellData()->ShallowCopy(leaf.cellData);
  whole = leaf.surface;
  return Status::success();
}
}
