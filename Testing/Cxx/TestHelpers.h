/**
 * @file TestHelpers.h
 * @brief What tests of the filters share: surfaces as vtkPolyData, messages, arrays.
 */
#ifndef TestHelpers_h
#define TestHelpers_h

#include "../Core/TestChecks.h"
#include "../Core/TestSurfaces.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <Eigen/Geometry>

#include <string>
#include <utility>
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

/** size x size squares over the unit square, z = height sin(waves x) sin(waves y). */
inline vtkSmartPointer<vtkPolyData> bumpyPlate(int size, double height, double waves)
{
  TriangleSoup soup = gridPatch(size, size);
  for (Point3& p : soup.points)
  {
    p[2] = height * std::sin(waves * p[0]) * std::sin(waves * p[1]);
  }
  return polyDataOf(soup);
}

inline vtkSmartPointer<vtkPolyData> wavyPlate(int n, double angle, double ripples)
{
  return polyDataOf(wavyPatch(n, angle, ripples));
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
  ~Messages()
  {
    for (const auto& [object, tag] : this->Observers)
    {
      object->RemoveObserver(tag);
    }
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
    this->Observers.emplace_back(object, object->AddObserver(event, command));
  }

  std::vector<std::pair<vtkSmartPointer<vtkObject>, unsigned long>> Observers;
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

inline Point3 pointOf(vtkPolyData* data, vtkIdType id)
{
  Point3 point;
  data->GetPoint(id, point.data());
  return point;
}

/** Calls `visit(p, q)` for the ids of each side of each triangle: twice for an edge of two. */
template <class Visit>
void forEachSide(vtkPolyData* mesh, const Visit& visit)
{
  auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    for (int k = 0; k < 3; ++k)
    {
      visit(ids[k], ids[(k + 1) % 3]);
    }
  }
}

/** A tuple of any number of components. */
inline Eigen::VectorXd tupleOf(vtkDataArray* array, vtkIdType id)
{
  Eigen::VectorXd tuple(array->GetNumberOfComponents());
  array->GetTuple(id, tuple.data());
  return tuple;
}
}

#endif
