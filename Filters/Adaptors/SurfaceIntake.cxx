/**
 * @file SurfaceIntake.cxx
 *
 * 1. Copy the points.
 * 2. Polygons: if all are triangles, copy the connectivity; else go through the cells.
 * 3. Strips: every second triangle turns the other way round.
 * Point ids are checked cell by cell, before anything reads the points.
 */
#include "Adaptors/SurfaceIntake.h"

#include "vtkArrayDispatch.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <string>

namespace remesh
{
namespace
{
struct CopyPoints
{
  template <class ArrayType>
  void operator()(ArrayType* array, std::vector<Point3>& points) const
  {
    const auto tuples = vtk::DataArrayTupleRange<3>(array);
    auto point = points.begin();
    for (const auto tuple : tuples)
    {
      *point++ = Point3(static_cast<double>(tuple[0]), static_cast<double>(tuple[1]),
        static_cast<double>(tuple[2]));
    }
  }
};

void copyPoints(vtkPolyData* input, std::vector<Point3>& points)
{
  points.resize(input->GetNumberOfPoints());
  if (points.empty())
  {
    return;
  }
  vtkDataArray* array = input->GetPoints()->GetData();
  using Dispatcher = vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Reals>;
  if (!Dispatcher::Execute(array, CopyPoints{}, points))
  {
    CopyPoints{}(array, points);
  }
}

/** The polygons and strips of one input, cell by cell. */
class CellReader
{
public:
  CellReader(vtkPolyData* input, TriangleSoup& soup);

  Status ReadPolygons();
  Status ReadStrips();

private:
  bool CopyTriangles();
  template <class ArrayType>
  bool CopyTriangles(ArrayType* connectivity);

  void AddTriangle(Offset a, Offset b, Offset c);
  void AddPolygon(vtkIdType size, const vtkIdType* ids);
  void AddQuadrilateral();
  bool TriangulateLoop();
  void AddLargePolygon();
  void AddStrip(vtkIdType size, const vtkIdType* ids);

  Status CheckIds(vtkIdType size, const vtkIdType* ids) const;
  const Point3& At(std::size_t corner) const { return this->Soup.points[this->Loop[corner]]; }

  vtkCellArray* Polygons;
  vtkCellArray* Strips;
  Offset FirstPolygon;
  Offset FirstStrip;
  TriangleSoup& Soup;

  Offset Cell = 0;          ///< the cell being read
  std::vector<Offset> Loop; ///< its points, without consecutive repetitions
  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkIdList> Triangulation;
};

CellReader::CellReader(vtkPolyData* input, TriangleSoup& soup)
  : Polygons(input->GetPolys())
  , Strips(input->GetStrips())
  , FirstPolygon(input->GetNumberOfVerts() + input->GetNumberOfLines())
  , FirstStrip(FirstPolygon + input->GetNumberOfPolys())
  , Soup(soup)
{
  this->Polygon->Points->SetDataTypeToDouble();
}

Status CellReader::CheckIds(vtkIdType size, const vtkIdType* ids) const
{
  const auto numberOfPoints = static_cast<vtkIdType>(this->Soup.points.size());
  for (vtkIdType i = 0; i < size; ++i)
  {
    if (ids[i] < 0 || ids[i] >= numberOfPoints)
    {
      return Status::invalid("Cell " + std::to_string(this->Cell) + " refers to point " +
        std::to_string(ids[i]) + ", but the surface has " + std::to_string(numberOfPoints) +
        " points.");
    }
  }
  return Status::success();
}

void CellReader::AddTriangle(Offset a, Offset b, Offset c)
{
  this->Soup.triangles.push_back({ a, b, c });
  this->Soup.inputCells.push_back(this->Cell);
}

/** Cuts the four points of the loop into two triangles. */
void CellReader::AddQuadrilateral()
{
  // Whether the diagonal from corner k cuts off two triangles that face the same way.
  const auto isInside = [this](int k)
  {
    constexpr double noShare = 1e-12; // of the larger triangle: a corner on a straight line
    const Point3 diagonal = this->At((k + 2) % 4) - this->At(k);
    const Point3 first = (this->At((k + 1) % 4) - this->At(k)).cross(diagonal);
    const Point3 second = diagonal.cross(this->At((k + 3) % 4) - this->At(k));
    const double larger = std::max(first.squaredNorm(), second.squaredNorm());
    return first.dot(second) > noShare * larger;
  };
  const double first = (this->At(0) - this->At(2)).squaredNorm();
  const double second = (this->At(1) - this->At(3)).squaredNorm();
  const int shorter = first <= second ? 0 : 1;
  const int cut = !isInside(shorter) && isInside(1 - shorter) ? 1 - shorter : shorter;
  const std::vector<Offset>& q = this->Loop;
  if (cut == 0)
  {
    this->AddTriangle(q[0], q[1], q[2]);
    this->AddTriangle(q[0], q[2], q[3]);
  }
  else
  {
    this->AddTriangle(q[0], q[1], q[3]);
    this->AddTriangle(q[1], q[2], q[3]);
  }
}

/**
 * Fills the polygon and its triangulation from the loop; false if vtkPolygon gives up. Its
 * tolerances are lengths: the polygon is moved and scaled to be about 1 in size.
 */
bool CellReader::TriangulateLoop()
{
  const auto size = static_cast<vtkIdType>(this->Loop.size());
  this->Polygon->Points->SetNumberOfPoints(size);
  this->Polygon->PointIds->SetNumberOfIds(size);
  double extent = 0.0;
  for (vtkIdType i = 0; i < size; ++i)
  {
    if (!this->At(i).allFinite()) // the intake will say so
    {
      return false;
    }
    extent = std::max(extent, (this->At(i) - this->At(0)).cwiseAbs().maxCoeff());
  }
  if (!(extent > 0.0) || !std::isfinite(extent))
  {
    return false;
  }
  for (vtkIdType i = 0; i < size; ++i)
  {
    const Point3 scaled = (this->At(i) - this->At(0)) / extent;
    this->Polygon->Points->SetPoint(i, scaled.data());
    this->Polygon->PointIds->SetId(i, i);
  }
  this->Triangulation->Reset();
  return this->Polygon->Triangulate(this->Triangulation) != 0 &&
    this->Triangulation->GetNumberOfIds() == 3 * (size - 2);
}

/** Cuts a loop of five points or more. */
void CellReader::AddLargePolygon()
{
  const bool done = this->TriangulateLoop();
  const auto count = static_cast<vtkIdType>(this->Loop.size()) - 2;
  for (vtkIdType t = 0; t < count; ++t)
  {
    if (done)
    {
      const vtkIdType* ids = this->Triangulation->GetPointer(3 * t);
      this->AddTriangle(this->Loop[ids[0]], this->Loop[ids[1]], this->Loop[ids[2]]);
    }
    else
    {
      this->AddTriangle(this->Loop[0], this->Loop[t + 1], this->Loop[t + 2]);
    }
  }
}

void CellReader::AddPolygon(vtkIdType size, const vtkIdType* ids)
{
  this->Loop.assign(ids, ids + size);
  this->Loop.erase(std::unique(this->Loop.begin(), this->Loop.end()), this->Loop.end());
  while (this->Loop.size() > 1 && this->Loop.front() == this->Loop.back())
  {
    this->Loop.pop_back();
  }
  switch (this->Loop.size())
  {
    case 0:
      break;
    case 1:
    case 2:
      this->AddTriangle(this->Loop.front(), this->Loop.back(), this->Loop.back());
      break;
    case 3:
      this->AddTriangle(this->Loop[0], this->Loop[1], this->Loop[2]);
      break;
    case 4:
      this->AddQuadrilateral();
      break;
    default:
      this->AddLargePolygon();
  }
}

void CellReader::AddStrip(vtkIdType size, const vtkIdType* ids)
{
  for (vtkIdType i = 0; i + 2 < size; ++i)
  {
    const vtkIdType odd = i % 2;
    this->AddTriangle(ids[i], ids[i + 1 + odd], ids[i + 2 - odd]);
  }
}

/** False if a point id is out of range; then nothing of use was copied. */
template <class ArrayType>
bool CellReader::CopyTriangles(ArrayType* connectivity)
{
  const auto numberOfPoints = static_cast<Offset>(this->Soup.points.size());
  const auto ids = vtk::DataArrayValueRange<1>(connectivity);
  const auto count = static_cast<std::size_t>(this->Polygons->GetNumberOfCells());
  this->Soup.triangles.resize(count);
  this->Soup.inputCells.resize(count);
  auto id = ids.begin();
  for (std::size_t t = 0; t < count; ++t)
  {
    for (Offset& point : this->Soup.triangles[t])
    {
      point = static_cast<Offset>(*id++);
      if (point < 0 || point >= numberOfPoints)
      {
        return false;
      }
    }
    this->Soup.inputCells[t] = this->FirstPolygon + static_cast<Offset>(t);
  }
  return true;
}

/** False if the polygons are not all triangles, or not all sound. */
bool CellReader::CopyTriangles()
{
  if (this->Polygons->IsHomogeneous() != 3)
  {
    return false;
  }
  vtkDataArray* connectivity = this->Polygons->GetConnectivityArray();
  if (auto* ids64 = vtkCellArray::ArrayType64::FastDownCast(connectivity))
  {
    return this->CopyTriangles(ids64);
  }
  auto* ids32 = vtkCellArray::ArrayType32::FastDownCast(connectivity);
  return ids32 != nullptr && this->CopyTriangles(ids32);
}

Status CellReader::ReadPolygons()
{
  if (!this->Polygons->IsValid())
  {
    return Status::invalid("The polygons' offsets and connectivity contradict each other.");
  }
  if (this->CopyTriangles())
  {
    return Status::success();
  }
  this->Soup.triangles.clear();
  this->Soup.inputCells.clear();
  this->Cell = this->FirstPolygon;
  auto cells = vtk::TakeSmartPointer(this->Polygons->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell(), ++this->Cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    if (Status status = this->CheckIds(size, ids); !status.ok())
    {
      return status;
    }
    this->AddPolygon(size, ids);
  }
  return Status::success();
}

Status CellReader::ReadStrips()
{
  if (!this->Strips->IsValid())
  {
    return Status::invalid("The strips' offsets and connectivity contradict each other.");
  }
  this->Cell = this->FirstStrip;
  auto cells = vtk::TakeSmartPointer(this->Strips->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell(), ++this->Cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    if (Status status = this->CheckIds(size, ids); !status.ok())
    {
      return status;
    }
    this->AddStrip(size, ids);
  }
  return Status::success();
}

/**
 * Leaves out the triangles of ghost cells: what is hidden, and what another process has as its own
 * (as VTK's filters that measure or draw surfaces do).
 */
void removeGhosts(vtkPolyData* input, TriangleSoup& soup)
{
  vtkUnsignedCharArray* ghosts = input->GetCellGhostArray();
  if (!ghosts || ghosts->GetNumberOfTuples() != input->GetNumberOfCells() ||
    ghosts->GetNumberOfComponents() != 1)
  {
    return;
  }
  constexpr int left = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::REFINEDCELL |
    vtkDataSetAttributes::HIDDENCELL;
  std::size_t kept = 0;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
  {
    if ((ghosts->GetValue(soup.inputCells[t]) & left) == 0)
    {
      soup.triangles[kept] = soup.triangles[t];
      soup.inputCells[kept++] = soup.inputCells[t];
    }
  }
  soup.triangles.resize(kept);
  soup.inputCells.resize(kept);
}
}

Status checkForPolygons(vtkPolyData* input)
{
  if (input == nullptr)
  {
    return Status::invalid("There is no input surface.");
  }
  if (input->GetNumberOfPoints() == 0 && input->GetNumberOfCells() == 0)
  {
    return Status::empty("The surface has no points and no cells.");
  }
  if (input->GetNumberOfPolys() == 0 && input->GetNumberOfStrips() == 0)
  {
    return Status::invalid("The input has no polygons and no triangle strips, only " +
      std::to_string(input->GetNumberOfPoints()) + " points, " +
      std::to_string(input->GetNumberOfVerts()) + " vertices and " +
      std::to_string(input->GetNumberOfLines()) + " lines.");
  }
  return Status::success();
}

Status readTriangleSoup(vtkPolyData* input, TriangleSoup& soup)
{
  soup = TriangleSoup();
  if (Status found = checkForPolygons(input); !found.ok())
  {
    return found;
  }
  copyPoints(input, soup.points);
  CellReader reader(input, soup);
  Status status = input->GetNumberOfPolys() > 0 ? reader.ReadPolygons() : Status::success();
  if (status.ok() && input->GetNumberOfStrips() > 0)
  {
    status = reader.ReadStrips();
  }
  if (!status.ok())
  {
    soup = TriangleSoup();
    return status;
  }
  removeGhosts(input, soup);
  return soup.triangles.empty() && input->GetCellGhostArray()
    ? Status::empty("All cells of the surface are ghosts.")
    : Status::success();
}
}
