/**
 * @file TestHelpers.h
 * @brief What tests of the filters share: surfaces as vtkPolyData, messages, bytes, measures.
 */
#ifndef TestHelpers_h
#define TestHelpers_h

#include "../Core/TestChecks.h"
#include "../Core/TestSurfaces.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <Eigen/Geometry>

#include <cstring>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace remesh::test
{
/** Double precision points and triangles. */
inline vtkSmartPointer<vtkPolyData> polyDataOf(const TriangleSoup& soup)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point3& point : soup.points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> polygons;
  for (const auto& [a, b, c] : soup.triangles)
  {
    polygons->InsertNextCell({ a, b, c });
  }
  data->SetPoints(points);
  data->SetPolys(polygons);
  return data;
}

/** Half-axes and centre of `ellipsoid()`: nothing is round, nothing is at the origin. */
inline Point3 ellipsoidAxes()
{
  return { 1.0, 0.7, 0.4 };
}
inline Point3 ellipsoidCenter()
{
  return { 3.1, -2.3, 5.7 };
}

/** 20 4^levels triangles, outward. */
inline TriangleSoup ellipsoid(int levels)
{
  TriangleSoup soup = icosphere(levels);
  for (Point3& point : soup.points)
  {
    point = point.cwiseProduct(ellipsoidAxes()) + ellipsoidCenter();
  }
  return soup;
}

/** Points only, as given sites. */
inline vtkSmartPointer<vtkPolyData> pointsOnly(const std::vector<Point3>& places)
{
  TriangleSoup soup;
  soup.points = places;
  return polyDataOf(soup);
}

/** Adds a point array whose tuple is `value(point, component)`. */
template <class Array, class Value>
vtkSmartPointer<Array> addPointArray(
  vtkPolyData* data, const char* name, int components, const Value& value)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double p[3];
    data->GetPoint(i, p);
    for (int c = 0; c < components; ++c)
    {
      array->SetComponent(i, c, value(Point3(p[0], p[1], p[2]), c));
    }
  }
  data->GetPointData()->AddArray(array);
  return array;
}

/** Counts the errors and warnings of an algorithm, and keeps its executive quiet. */
class Messages
{
public:
  explicit Messages(vtkAlgorithm* algorithm)
  {
    this->Observe(algorithm, vtkCommand::ErrorEvent, this->Errors);
    this->Observe(algorithm, vtkCommand::WarningEvent, this->Warnings);
    this->Observe(algorithm->GetExecutive(), vtkCommand::ErrorEvent, this->ExecutiveErrors);
  }
  Messages(const Messages&) = delete;
  void operator=(const Messages&) = delete;

  const std::vector<std::string>& errors() const { return this->Errors; }
  const std::vector<std::string>& warnings() const { return this->Warnings; }
  const std::vector<std::string>& executiveErrors() const { return this->ExecutiveErrors; }
  void clear()
  {
    this->Errors.clear();
    this->Warnings.clear();
    this->ExecutiveErrors.clear();
  }

private:
  void Observe(vtkObject* object, unsigned long event, std::vector<std::string>& list)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(&list);
    command->SetCallback(
      [](vtkObject*, unsigned long, void* texts, void* text)
      {
        static_cast<std::vector<std::string>*>(texts)->emplace_back(
          text ? static_cast<const char*>(text) : "");
      });
    object->AddObserver(event, command);
  }

  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
  std::vector<std::string> ExecutiveErrors;
};

/** No point, no cell, no array, no row, on any port. */
inline bool outputsAreEmpty(vtkAlgorithm* filter)
{
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = filter->GetOutputDataObject(port);
    for (int type = 0; type < vtkDataObject::NUMBER_OF_ATTRIBUTE_TYPES; ++type)
    {
      if (output->GetNumberOfElements(type) != 0 ||
        (output->GetAttributesAsFieldData(type) &&
          output->GetAttributesAsFieldData(type)->GetNumberOfArrays() != 0))
      {
        return false;
      }
    }
  }
  return true;
}

/** Raw memory of an array, or the strings of a string array. */
inline std::string bytesOf(vtkAbstractArray* array)
{
  std::string bytes = std::string(array->GetClassName()) + " " +
    std::to_string(array->GetNumberOfComponents()) + "x" +
    std::to_string(array->GetNumberOfTuples()) + ":";
  if (auto* strings = vtkStringArray::SafeDownCast(array))
  {
    for (vtkIdType i = 0; i < strings->GetNumberOfValues(); ++i)
    {
      bytes += strings->GetValue(i) + '\0';
    }
    return bytes;
  }
  const auto size = static_cast<std::size_t>(array->GetNumberOfValues()) *
    static_cast<std::size_t>(array->GetDataTypeSize());
  if (size > 0)
  {
    bytes.append(static_cast<const char*>(array->GetVoidPointer(0)), size);
  }
  return bytes;
}

using Content = std::map<std::string, std::string>;

/** All that a vtkPolyData or vtkTable holds, by name, but columns called `Time`. */
inline Content contentOf(vtkDataObject* data)
{
  Content content;
  const auto addArrays = [&](const char* prefix, vtkFieldData* arrays)
  {
    for (int k = 0; arrays && k < arrays->GetNumberOfArrays(); ++k)
    {
      vtkAbstractArray* array = arrays->GetAbstractArray(k);
      const std::string name = array->GetName() ? array->GetName() : "";
      if (name != "Time")
      {
        content[prefix + name] = bytesOf(array);
      }
    }
  };
  addArrays("field ", data->GetFieldData());
  addArrays("row ", data->GetAttributesAsFieldData(vtkDataObject::ROW));
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    addArrays("point ", surface->GetPointData());
    addArrays("cell ", surface->GetCellData());
    content["points"] = surface->GetPoints() ? bytesOf(surface->GetPoints()->GetData()) : "";
    const auto addCells = [&](const char* name, vtkCellArray* cells)
    {
      content[name] = bytesOf(cells->GetOffsetsArray()) + bytesOf(cells->GetConnectivityArray());
    };
    addCells("verts", surface->GetVerts());
    addCells("lines", surface->GetLines());
    addCells("polys", surface->GetPolys());
    addCells("strips", surface->GetStrips());
  }
  return content;
}

/** The content of every output port. */
inline std::vector<Content> contentsOf(vtkAlgorithm* filter)
{
  std::vector<Content> contents;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    contents.push_back(contentOf(filter->GetOutputDataObject(port)));
  }
  return contents;
}

/** Whether the contents agree to the byte; says what differs, and in which case. */
inline void checkSame(const Content& content, const Content& expected, const std::string& where)
{
  std::set<std::string> names;
  for (const Content* each : { &content, &expected })
  {
    for (const auto& entry : *each)
    {
      names.insert(entry.first);
    }
  }
  for (const std::string& name : names)
  {
    const auto a = content.find(name);
    const auto b = expected.find(name);
    check(a != content.end() && b != expected.end() && a->second == b->second, __FILE__, __LINE__,
      where + ": " + name + " differs");
  }
}

inline void checkSame(const std::vector<Content>& contents, const std::vector<Content>& expected,
  const std::string& where)
{
  CHECK_EQUAL(contents.size(), expected.size());
  for (std::size_t port = 0; port < std::min(contents.size(), expected.size()); ++port)
  {
    checkSame(contents[port], expected[port], where + ", port " + std::to_string(port));
  }
}

/** The point array; a missing one is a failure, and an empty one is returned. */
inline vtkSmartPointer<vtkDataArray> arrayOf(vtkFieldData* data, const char* name)
{
  vtkSmartPointer<vtkDataArray> array = data->GetArray(name);
  check(array != nullptr, __FILE__, __LINE__, std::string("there is no array ") + name);
  if (!array)
  {
    array = vtkSmartPointer<vtkDoubleArray>::New();
  }
  return array;
}

/** Sum with a running compensation: what is compared is the filter's rounding, not the test's. */
class ExactSum
{
public:
  void add(double value)
  {
    const double sum = m_sum + value;
    m_rest += std::abs(m_sum) >= std::abs(value) ? (m_sum - sum) + value : (value - sum) + m_sum;
    m_sum = sum;
  }
  double value() const { return m_sum + m_rest; }

private:
  double m_sum = 0.0;
  double m_rest = 0.0;
};

inline double sumOf(vtkDataArray* array)
{
  ExactSum sum;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    sum.add(array->GetComponent(i, 0));
  }
  return sum.value();
}

inline Point3 pointOf(vtkPolyData* data, vtkIdType id)
{
  Point3 point;
  data->GetPoint(id, point.data());
  return point;
}

/** Calls `visit(cell, ids)` for each polygon; the cell is counted from 0 among the polygons. */
template <class Visit>
void forEachPolygon(vtkPolyData* data, const Visit& visit)
{
  auto cells = vtk::TakeSmartPointer(data->GetPolys()->NewIterator());
  vtkIdType cell = 0;
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell(), ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    visit(cell, std::vector<vtkIdType>(ids, ids + size));
  }
}

/** Area of a planar, convex polygon. */
inline double polygonArea(vtkPolyData* data, const std::vector<vtkIdType>& ids)
{
  double area = 0.0;
  const Point3 first = pointOf(data, ids[0]);
  for (std::size_t k = 1; k + 1 < ids.size(); ++k)
  {
    const Point3 a = pointOf(data, ids[k]) - first;
    const Point3 b = pointOf(data, ids[k + 1]) - first;
    area += 0.5 * a.cross(b).norm();
  }
  return area;
}

inline double areaOf(vtkPolyData* data)
{
  ExactSum sum;
  forEachPolygon(data,
    [&](vtkIdType, const std::vector<vtkIdType>& ids) { sum.add(polygonArea(data, ids)); });
  return sum.value();
}

/** Number of triangles along each directed edge of a triangle mesh. */
inline std::map<std::pair<vtkIdType, vtkIdType>, int> directedEdgesOf(vtkPolyData* mesh)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges;
  forEachPolygon(mesh,
    [&](vtkIdType, const std::vector<vtkIdType>& ids)
    {
      for (std::size_t k = 0; k < ids.size(); ++k)
      {
        ++edges[{ ids[k], ids[(k + 1) % ids.size()] }];
      }
    });
  return edges;
}

/** Used points - edges + triangles. */
inline vtkIdType eulerCharacteristicOf(vtkPolyData* mesh)
{
  const auto directed = directedEdgesOf(mesh);
  std::set<vtkIdType> points;
  vtkIdType edges = 0;
  for (const auto& [ends, count] : directed)
  {
    points.insert({ ends.first, ends.second });
    edges += ends.first < ends.second || !directed.count({ ends.second, ends.first });
  }
  return static_cast<vtkIdType>(points.size()) - edges + mesh->GetNumberOfPolys();
}

/** Closed, manifold and consistently oriented: each directed edge once, with its opposite. */
inline bool isClosedManifold(vtkPolyData* mesh)
{
  const auto directed = directedEdgesOf(mesh);
  for (const auto& [ends, count] : directed)
  {
    if (count != 1 || !directed.count({ ends.second, ends.first }))
    {
      return false;
    }
  }
  return !directed.empty();
}

/** Positive if a closed mesh faces outward. */
inline double volumeOf(vtkPolyData* mesh)
{
  double volume = 0.0;
  forEachPolygon(mesh,
    [&](vtkIdType, const std::vector<vtkIdType>& ids)
    {
      volume += pointOf(mesh, ids[0]).dot(pointOf(mesh, ids[1]).cross(pointOf(mesh, ids[2]))) / 6.0;
    });
  return volume;
}
}

#endif
