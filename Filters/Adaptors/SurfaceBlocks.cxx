#include "Adaptors/SurfaceBlocks.h"

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"

namespace remesh
{
namespace
{
std::string nameOf(vtkInformation* meta)
{
  const char* name = meta ? meta->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name ? name : "";
}

class Walk
{
public:
  explicit Walk(std::vector<SurfaceBlock>& blocks)
    : Blocks(blocks)
  {
  }

  /** @param name of the closest block that has one. */
  void Visit(vtkDataObject* data, const std::string& name)
  {
    if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data))
    {
      for (unsigned int k = 0; k < blocks->GetNumberOfBlocks(); ++k)
      {
        this->Descend(
          k, blocks->GetBlock(k), blocks->HasMetaData(k) ? blocks->GetMetaData(k) : nullptr, name);
      }
    }
    else if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
    {
      for (unsigned int k = 0; k < collection->GetNumberOfPartitionedDataSets(); ++k)
      {
        this->Descend(k, collection->GetPartitionedDataSet(k),
          collection->HasMetaData(k) ? collection->GetMetaData(k) : nullptr, name);
      }
    }
    else if (auto* partitions = vtkPartitionedDataSet::SafeDownCast(data))
    {
      const int region = this->Regions++;
      for (unsigned int k = 0; k < partitions->GetNumberOfPartitions(); ++k)
      {
        this->Path.push_back(k);
        this->Add(partitions->GetPartitionAsDataObject(k), name, region);
        this->Path.pop_back();
      }
    }
    else
    {
      this->Add(data, name, this->Regions++);
    }
  }

private:
  void Descend(
    unsigned int index, vtkDataObject* child, vtkInformation* meta, const std::string& parent)
  {
    const std::string name = nameOf(meta);
    this->Path.push_back(index);
    this->Visit(child, name.empty() ? parent : name);
    this->Path.pop_back();
  }

  void Add(vtkDataObject* leaf, const std::string& name, int region)
  {
    std::string numbers;
    for (const unsigned int index : this->Path)
    {
      numbers += (numbers.empty() ? "" : "/") + std::to_string(index);
    }
    const std::string subject =
      name.empty() ? "Block " + numbers : "Block \"" + name + "\" (" + numbers + ")";
    this->Blocks.push_back({ this->Path, subject + " of the input", region, leaf });
  }

  std::vector<SurfaceBlock>& Blocks;
  std::vector<unsigned int> Path;
  int Regions = 0;
};

vtkDataObject* childOf(vtkDataObject* parent, unsigned int index)
{
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(parent))
  {
    return blocks->GetBlock(index);
  }
  auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(parent);
  return collection ? collection->GetPartitionedDataSet(index) : nullptr;
}
}

bool hasBlocks(vtkDataObject* data)
{
  return vtkMultiBlockDataSet::SafeDownCast(data) ||
    vtkPartitionedDataSetCollection::SafeDownCast(data) ||
    vtkPartitionedDataSet::SafeDownCast(data);
}

std::vector<SurfaceBlock> findBlocks(vtkDataObject* root)
{
  std::vector<SurfaceBlock> blocks;
  Walk(blocks).Visit(root, "");
  return blocks;
}

void setBlock(vtkDataObject* root, const SurfaceBlock& block, vtkDataObject* leaf)
{
  vtkDataObject* parent = root;
  for (std::size_t k = 0; k + 1 < block.path.size(); ++k)
  {
    parent = childOf(parent, block.path[k]);
  }
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(parent))
  {
    blocks->SetBlock(block.path.back(), leaf);
  }
  else if (auto* partitions = vtkPartitionedDataSet::SafeDownCast(parent))
  {
    partitions->SetPartition(block.path.back(), leaf);
  }
}
}
