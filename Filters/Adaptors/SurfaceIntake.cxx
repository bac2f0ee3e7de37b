/**
 * @file SurfaceIntake.cxx
 *
 * 1. Copy the points.
 * 2. Polygons: if all are triangles, copy the connectivity; else go through the cells.
 * 3. Strips: every second triangle turns the other way round.
 * Point ids are checked cell by cell, before anything reads the points.
 */
#include "Adaptors/SurfaceIntake.h"

#include "Adaptors/EarClipping.h"

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

  Offset NumberOfUncutPolygons() const { return this->Uncut; }

private:
  bool CopyTriangles();
  template <class ArrayType>
  bool CopyTriangles(ArrayType* connectivity);

  void AddTriangle(Offset a, Offset b, Offset c);
  void AddPolygon(vtkIdType size, const vtkIdType* ids);
  void AddQuadrilateral();
  bool ScaleLoop();
  bool TriangulateLoop();
  void AddFan();
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
  Offset Uncut = 0;         ///< polygons so far whose triangles overlap
  std::vector<Offset> Loop; ///< its points, without consecutive repetitions
  std::vector<Point3> Scaled;
  std::vector<std::array<Offset, 3>> Triangulation;
  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkIdList> PolygonIds;
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

/**
 * The loop's points multiplied by a power of two, which does not round, so that differences are
 * about 1 in size, and squares of areas stay in range. False for points that are not finite, or all
 * in one place.
 */
bool CellReader::ScaleLoop()
{
  double extent = 0.0;
  for (std::size_t i = 0; i < this->Loop.size(); ++i)
  {
    const Point3 difference = this->At(i) - this->At(0);
    if (!difference.allFinite()) // the intake will say so
    {
      return false;
    }
    extent = std::max(extent, difference.cwiseAbs().maxCoeff());
  }
  int exponent = 0;
  std::frexp(extent, &exponent);
  this->Scaled.clear();
  for (std::size_t i = 0; i < this->Loop.size(); ++i)
  {
    this->Scaled.push_back(
      this->At(i).unaryExpr([exponent](double x) { return std::ldexp(x, -exponent); }));
  }
  return extent > 0.0;
}

/** Cuts the four points of the loop into two triangles. */
void CellReader::AddQuadrilateral()
{
  if (!this->ScaleLoop())
  {
    this->AddFan();
    return;
  }
  const std::vector<Point3>& p = this->Scaled;
  // Whether the diagonal from corner k cuts off two triangles that face the same way.
  const auto isInside = [&p](int k)
  {
    constexpr double noShare = 1e-12; // of the larger triangle: a corner on a straight line
    const Point3 diagonal = p[(k + 2) % 4] - p[k];
    const Point3 first = (p[(k + 1) % 4] - p[k]).cross(diagonal);
    const Point3 second = diagonal.cross(p[(k + 3) % 4] - p[k]);
    const double larger = std::max(first.squaredNorm(), second.squaredNorm());
    return first.dot(second) > noShare * larger;
  };
  const double first = (p[0] - p[2]).squaredNorm();
  const double second = (p[1] - p[3]).squaredNorm();
  const int shorter = first <= second ? 0 : 1;
  const int cut = !isInside(shorter) && isInside(1 - shorter) ? 1 - shorter : shorter;
  const std::vector<Offset>& q = this->Loop;
  if (cut == 0)
  {
    this->AddFan();
  }
  else
  {
    this->AddTriangle(q[0], q[1], q[3]);
    this->AddTriangle(q[1], q[2], q[3]);
  }
}

/** The loop's triangles, by its corners, from its scaled points; false where there are none. */
bool CellReader::TriangulateLoop()
{
  const auto size = static_cast<vtkIdType>(this->Loop.size());
  this->Polygon->Points->SetNumberOfPoints(size);
  this->Polygon->PointIds->SetNumberOfIds(size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    const Point3 point = this->Scaled[i] - this->Scaled[0];
    this->Polygon->Points->SetPoint(i, point.data());
    this->Polygon->PointIds->SetId(i, i);
  }
  this->PolygonIds->Reset();
  if (this->Polygon->Triangulate(this->PolygonIds) == 0 ||
    this->PolygonIds->GetNumberOfIds() != 3 * (size - 2))
  {
    return clipEars(this->Scaled, this->Triangulation);
  }
  this->Triangulation.clear();
  for (vtkIdType t = 0; t < size - 2; ++t)
  {
    const vtkIdType* ids = this->PolygonIds->GetPointer(3 * t);
    this->Triangulation.push_back({ ids[0], ids[1], ids[2] });
  }
  return true;
}

void CellReader::AddFan()
{
  for (std::size_t k = 1; k + 1 < this->Loop.size(); ++k)
  {
    this->AddTriangle(this->Loop[0], this->Loop[k], this->Loop[k + 1]);
  }
}

/** Cuts a loop of five points or more. */
void CellReader::AddLargePolygon()
{
  const bool isScaled = this->ScaleLoop();
  if (isScaled && this->TriangulateLoop())
  {
    for (const auto& [a, b, c] : this->Triangulation)
    {
      this->AddTriangle(this->Loop[a], this->Loop[b], this->Loop[c]);
    }
    return;
  }
  this->AddFan();
  bool hasArea = false;
  for (std::size_t k = 1; isScaled && k + 1 < this->Loop.size(); ++k)
  {
    const Point3 first = this->Scaled[k] - this->Scaled[0];
    hasArea = hasArea || first.cross(this->Scaled[k + 1] - this->Scaled[0]).norm() > 1e-12;
  }
  this->Uncut += hasArea ? 1 : 0;
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

Status readTriangleSoup(vtkPolyData* input, TriangleSoup& soup, std::string* warning)
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
  if (warning && reader.NumberOfUncutPolygons() > 0)
  {
    *warning = std::to_string(reader.NumberOfUncutPolygons()) +
      " polygons cross themselves: their triangles overlap.";
  }
  removeGhosts(input, soup);
  return soup.triangles.empty() && input->GetCellGhostArray()
    ? Status::empty("All cells of the surface are ghosts.")
    : Status::success();
}
}
