#include "Adaptors/InputOrder.h"

#include "Adaptors/ArrayHelpers.h"
#include "Adaptors/BlockNames.h"
#include "Adaptors/CellOrder.h"
#include "Adaptors/SurfacePieces.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace remesh
{
namespace
{
bool givesPieces(vtkAlgorithm* source, int port)
{
  vtkInformation* info = source->GetOutputInformation(port);
  return !vtkTrivialProducer::SafeDownCast(source) && // which says so of all data
    (info->Get(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST()) ||
      info->Get(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT()));
}

bool comesInPieces(vtkAlgorithm* algorithm, int port, std::set<vtkAlgorithm*>& seen)
{
  for (int k = 0; k < algorithm->GetNumberOfInputConnections(port); ++k)
  {
    vtkAlgorithmOutput* connection = algorithm->GetInputConnection(port, k);
    vtkAlgorithm* producer = connection->GetProducer();
    if (!seen.insert(producer).second)
    {
      continue;
    }
    bool isSource = true;
    for (int input = 0; input < producer->GetNumberOfInputPorts(); ++input)
    {
      isSource = isSource && producer->GetNumberOfInputConnections(input) == 0;
      if (comesInPieces(producer, input, seen))
      {
        return true;
      }
    }
    if (isSource && givesPieces(producer, connection->GetIndex()))
    {
      return true;
    }
  }
  return false;
}

/** The arrays of points or cells by name, so that the order of arrays does not count. */
class Values
{
public:
  explicit Values(vtkDataSetAttributes* data)
  {
    std::map<std::string, vtkAbstractArray*> byName;
    for (int k = 0; k < data->GetNumberOfArrays(); ++k)
    {
      vtkAbstractArray* array = data->GetAbstractArray(k);
      const std::string name = array->GetName() ? array->GetName() : "";
      if (name != blockCellName)
      {
        byName[name] = array;
      }
    }
    for (const auto& [name, array] : byName)
    {
      this->Arrays.push_back(array);
    }
  }

  int compareTuples(vtkIdType a, vtkIdType b) const
  {
    int result = 0;
    for (std::size_t k = 0; result == 0 && k < this->Arrays.size(); ++k)
    {
      vtkAbstractArray* array = this->Arrays[k];
      const int size = array->GetNumberOfComponents();
      auto* numbers = vtkDataArray::SafeDownCast(array);
      auto* texts = vtkStringArray::SafeDownCast(array);
      for (int c = 0; result == 0 && c < size; ++c)
      {
        result = numbers ? compareTotally(numbers->GetComponent(a, c), numbers->GetComponent(b, c))
          : texts ? compareTotally(texts->GetValue(a * size + c), texts->GetValue(b * size + c))
                  : 0;
      }
    }
    return result;
  }

private:
  std::vector<vtkAbstractArray*> Arrays;
};

/** Which points are left, in their order, and the number of each that was there. */
struct PointOrder
{
  vtkNew<vtkIdList> left;
  std::vector<vtkIdType> numbers;

  explicit PointOrder(vtkPolyData* surface)
    : numbers(static_cast<std::size_t>(surface->GetNumberOfPoints()))
  {
    std::vector<std::array<double, 3>> places(this->numbers.size());
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      surface->GetPoint(static_cast<vtkIdType>(k), places[k].data());
    }
    const Values values(surface->GetPointData());
    const auto order = [&](vtkIdType a, vtkIdType b)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        if (const int result = compareTotally(places[a][axis], places[b][axis]))
        {
          return result;
        }
      }
      return values.compareTuples(a, b);
    };
    std::vector<vtkIdType> sorted(this->numbers.size());
    std::iota(sorted.begin(), sorted.end(), 0);
    std::sort(
      sorted.begin(), sorted.end(), [&](vtkIdType a, vtkIdType b) { return order(a, b) < 0; });
    vtkIdType last = -1;
    for (const vtkIdType id : sorted)
    {
      const bool isNew = last < 0 || order(last, id) != 0;
      this->numbers[id] = isNew ? this->left->InsertNextId(id) : this->numbers[last];
      last = id;
    }
  }
};

/** The points of a polygon from that with the least number on; of several such, the least row. */
void startWithLeast(std::vector<vtkIdType>& ids)
{
  std::vector<vtkIdType> turned = ids;
  std::vector<vtkIdType> least = ids;
  const vtkIdType first = *std::min_element(ids.begin(), ids.end());
  for (std::size_t k = 0; k < ids.size(); ++k)
  {
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    if (turned.front() == first)
    {
      least = std::min(least, turned);
    }
  }
  ids = least;
}

/** Cells of one kind with their points renumbered, in their order. */
class CellSorting
{
public:
  /** @param firstCell the surface's id of the first. */
  CellSorting(vtkCellArray* cells, vtkIdType firstCell, const PointOrder& points, bool arePolygons)
    : FirstCell(firstCell)
  {
    this->Begins.push_back(0);
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      cells->GetCellAtId(cell, size, ids);
      std::vector<vtkIdType> own(static_cast<std::size_t>(size));
      std::transform(
        ids, ids + size, own.begin(), [&](vtkIdType id) { return points.numbers[id]; });
      if (arePolygons && !own.empty())
      {
        startWithLeast(own);
      }
      this->Ids.insert(this->Ids.end(), own.begin(), own.end());
      this->Begins.push_back(this->Ids.size());
    }
  }

  /** Appends the cells' old ids to `order`. */
  vtkSmartPointer<vtkCellArray> run(const Values& values, vtkIdList* order) const
  {
    std::vector<vtkIdType> sorted(this->Begins.size() - 1);
    std::iota(sorted.begin(), sorted.end(), 0);
    std::sort(sorted.begin(), sorted.end(),
      [&](vtkIdType a, vtkIdType b)
      {
        const int byPoints = this->ComparePoints(a, b);
        const int result =
          byPoints ? byPoints : values.compareTuples(this->FirstCell + a, this->FirstCell + b);
        return result < 0;
      });
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->AllocateExact(static_cast<vtkIdType>(sorted.size()), this->Ids.size());
    for (const vtkIdType cell : sorted)
    {
      const std::size_t begin = this->Begins[cell];
      cells->InsertNextCell(
        static_cast<vtkIdType>(this->Begins[cell + 1] - begin), this->Ids.data() + begin);
      order->InsertNextId(this->FirstCell + cell);
    }
    return cells;
  }

private:
  int ComparePoints(vtkIdType a, vtkIdType b) const
  {
    const auto begin = this->Ids.begin();
    const auto endOfA = begin + this->Begins[a + 1];
    const auto endOfB = begin + this->Begins[b + 1];
    const auto [left, right] =
      std::mismatch(begin + this->Begins[a], endOfA, begin + this->Begins[b], endOfB);
    return left == endOfA || right == endOfB
      ? static_cast<int>(left != endOfA) - static_cast<int>(right != endOfB)
      : compareTotally(*left, *right);
  }

  vtkIdType FirstCell;
  std::vector<vtkIdType> Ids;
  std::vector<std::size_t> Begins;
};

void copyRows(vtkDataSetAttributes* from, vtkIdList* ids, vtkDataSetAttributes* to)
{
  to->CopyAllOn();
  to->CopyAllocate(from, ids->GetNumberOfIds());
  to->SetNumberOfTuples(ids->GetNumberOfIds());
  for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
  {
    to->CopyData(from, ids->GetId(k), k);
  }
}

void addOldIds(vtkPolyData* surface, vtkIdList* order, vtkCellData* data)
{
  auto* before =
    vtkIdTypeArray::SafeDownCast(surface->GetCellData()->GetAbstractArray(blockCellName));
  const Columns columns{ data, order->GetNumberOfIds(), {} };
  columns.add<vtkIdTypeArray>(blockCellName,
    [&](Offset cell)
    {
      const vtkIdType old = order->GetId(cell);
      return before ? before->GetValue(old) : old;
    });
}

/** What else is wrong is told by who reads the surface. */
bool isSound(vtkCellArray* cells, vtkIdType numberOfPoints)
{
  bool isIn = cells->IsValid();
  for (vtkIdType cell = 0; isIn && cell < cells->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCellAtId(cell, size, ids);
    isIn =
      std::all_of(ids, ids + size, [&](vtkIdType id) { return id >= 0 && id < numberOfPoints; });
  }
  return isIn;
}
}

bool comesInPieces(vtkAlgorithm* algorithm, int port)
{
  std::set<vtkAlgorithm*> seen;
  return comesInPieces(algorithm, port, seen);
}

vtkSmartPointer<vtkPolyData> inOwnOrder(vtkPolyData* surface)
{
  const vtkIdType count = surface->GetNumberOfPoints();
  if (count == 0 || !isSound(surface->GetPolys(), count) || !isSound(surface->GetStrips(), count))
  {
    return surface;
  }
  auto ordered = vtkSmartPointer<vtkPolyData>::New();
  ordered->GetFieldData()->ShallowCopy(surface->GetFieldData());
  vtkNew<vtkPolyData> rounded;
  rounded->ShallowCopy(surface);
  vtkNew<vtkPoints> places;
  places->SetDataType(surface->GetPoints()->GetDataType()); // which DeepCopy leaves as it is
  places->DeepCopy(surface->GetPoints());
  rounded->SetPoints(places);
  roundToZero(rounded);

  const PointOrder order(rounded);
  vtkNew<vtkPoints> points;
  points->SetDataType(places->GetDataType());
  points->SetNumberOfPoints(order.left->GetNumberOfIds());
  places->GetData()->GetTuples(order.left, points->GetData());
  ordered->SetPoints(points);
  copyRows(surface->GetPointData(), order.left, ordered->GetPointData());

  const Values values(surface->GetCellData());
  const vtkIdType firstPolygon = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  vtkNew<vtkIdList> cells;
  ordered->SetPolys(CellSorting(surface->GetPolys(), firstPolygon, order, true).run(values, cells));
  ordered->SetStrips(
    CellSorting(surface->GetStrips(), firstPolygon + surface->GetNumberOfPolys(), order, false)
      .run(values, cells));
  copyRows(surface->GetCellData(), cells, ordered->GetCellData());
  addOldIds(surface, cells, ordered->GetCellData());
  return ordered;
}
}
