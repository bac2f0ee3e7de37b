#include "PlyCoordinates.h"

#include <vtkNew.h>
#include <vtkPLY.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <cstddef>
#include <cstdlib>
#include <cstring>

namespace
{
struct Vertex
{
  double X[3];
};

/** x, y or z as a double, to where Vertex has it. */
PlyProperty Coordinate(const char* name, int index)
{
  const std::size_t offset = offsetof(Vertex, X) + static_cast<std::size_t>(index) * sizeof(double);
  return { name, PLY_DOUBLE, PLY_DOUBLE, static_cast<int>(offset), 0, 0, 0, 0 };
}

/** Whether the element has a property of that name in double precision. */
bool IsDouble(const PlyElement* element, const char* name)
{
  for (int p = 0; p < element->nprops; ++p)
  {
    const PlyProperty* property = element->props[p];
    if (std::strcmp(property->name, name) == 0)
    {
      return property->external_type == PLY_DOUBLE || property->external_type == PLY_FLOAT64;
    }
  }
  return false;
}
}

void RestorePlyCoordinates(const std::string& path, vtkPolyData* surface)
{
  int elements = 0;
  char** names = nullptr;
  PlyFile* file = vtkPLY::ply_open_for_reading(path.c_str(), &elements, &names);
  if (file == nullptr)
  {
    return;
  }
  // Elements come one after the other: only a file that starts with its vertices can be read so.
  const PlyElement* first = file->nelems > 0 ? file->elems[0] : nullptr;
  if (first != nullptr && std::strcmp(first->name, "vertex") == 0 &&
    first->num == surface->GetNumberOfPoints() && IsDouble(first, "x") && IsDouble(first, "y") &&
    IsDouble(first, "z"))
  {
    PlyProperty x = Coordinate("x", 0);
    PlyProperty y = Coordinate("y", 1);
    PlyProperty z = Coordinate("z", 2);
    vtkPLY::ply_get_property(file, "vertex", &x);
    vtkPLY::ply_get_property(file, "vertex", &y);
    vtkPLY::ply_get_property(file, "vertex", &z);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(first->num);
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      Vertex vertex{};
      vtkPLY::ply_get_element(file, &vertex);
      points->SetPoint(i, vertex.X);
    }
    surface->SetPoints(points);
  }
  for (int e = 0; e < elements; ++e)
  {
    std::free(names[e]);
  }
  std::free(names);
  vtkPLY::ply_close(file);
}
