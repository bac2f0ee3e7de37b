#include "MeshReader.h"

#include "Corners.h"
#include "Failure.h"
#include "MeshSections.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <limits>
#include <vector>

namespace
{
int ReadDimension(MeshSections& file)
{
  return static_cast<int>(file.ShortInteger(2, 3, "the dimension, 2 or 3"));
}

void ReadVertices(MeshSections& file, int dimension, CornerMesh& mesh)
{
  const long long count = file.Count("the number of vertices");
  for (long long i = 0; i < count; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      mesh.Points.push_back(c < dimension ? file.Number("a coordinate") : 0.0);
    }
    file.Integer(
      std::numeric_limits<long long>::min(), std::numeric_limits<long long>::max(), "a reference");
  }
}

void ReadFaces(MeshSections& file, int size, CornerMesh& mesh, vtkIntArray* references)
{
  const auto points = static_cast<long long>(mesh.Points.size() / 3);
  const long long count = file.Count("the number of faces");
  for (long long i = 0; i < count; ++i)
  {
    for (int k = 0; k < size; ++k)
    {
      Corner corner;
      corner.Point = file.Integer(1, points, "a corner") - 1;
      mesh.Corners.push_back(corner);
    }
    mesh.Offsets.push_back(static_cast<vtkIdType>(mesh.Corners.size()));
    references->InsertNextValue(static_cast<int>(file.Integer(
      std::numeric_limits<int>::min(), std::numeric_limits<int>::max(), "a reference")));
  }
}

/** For components as the file has them, where they come in VTK's order. */
std::vector<int> PlacesOf(int type, int dimension)
{
  if (type == 3)
  {
    return dimension == 3 ? std::vector<int>{ 0, 3, 1, 5, 4, 2 } : std::vector<int>{ 0, 2, 1 };
  }
  return type == 1   ? std::vector<int>{ 0 }
    : dimension == 3 ? std::vector<int>{ 0, 1, 2 }
                     : std::vector<int>{ 0, 1 };
}
} // namespace

vtkSmartPointer<vtkPolyData> ReadMesh(const std::string& bytes, const std::string& extension)
{
  const auto file = OpenMeshSections(bytes, extension);
  CornerMesh mesh;
  vtkNew<vtkIntArray> references;
  references->SetName("Reference");
  int dimension = 3;
  for (std::string name = file->Next(); !name.empty(); name = file->Next())
  {
    if (name == "Dimension")
    {
      dimension = ReadDimension(*file);
    }
    else if (name == "Vertices")
    {
      ReadVertices(*file, dimension, mesh);
    }
    else if (name == "Triangles" || name == "Quadrilaterals")
    {
      ReadFaces(*file, name == "Triangles" ? 3 : 4, mesh, references);
    }
  }
  auto surface = MakeSurface(mesh);
  surface->GetCellData()->AddArray(references);
  return surface;
}

void AddSolutions(const std::string& bytes, const std::string& extension, vtkPolyData* surface)
{
  const auto file = OpenMeshSections(bytes, extension);
  int dimension = 3;
  for (std::string name = file->Next(); name != "SolAtVertices"; name = file->Next())
  {
    if (name.empty())
    {
      throw Failure("the " + extension + " file beside it has no solution at the vertices");
    }
    if (name == "Dimension")
    {
      dimension = ReadDimension(*file);
    }
  }
  const vtkIdType points = surface->GetNumberOfPoints();
  file->Integer(points, points, "the number of vertices, not that of the mesh");
  const auto count = static_cast<int>(file->ShortInteger(1, 100, "the number of solutions"));
  std::vector<vtkSmartPointer<vtkDoubleArray>> arrays;
  std::vector<std::vector<int>> places;
  for (int k = 0; k < count; ++k)
  {
    places.push_back(PlacesOf(static_cast<int>(file->ShortInteger(1, 3, "a type")), dimension));
    arrays.push_back(vtkSmartPointer<vtkDoubleArray>::New());
    arrays[k]->SetName(k == 0 ? "Metric" : ("Solution" + std::to_string(k)).c_str());
    arrays[k]->SetNumberOfComponents(static_cast<int>(places[k].size()));
    arrays[k]->SetNumberOfTuples(points);
    surface->GetPointData()->AddArray(arrays[k]);
  }
  for (vtkIdType i = 0; i < points; ++i)
  {
    for (int k = 0; k < count; ++k)
    {
      for (const int place : places[k])
      {
        arrays[k]->SetComponent(i, place, file->Number("a number"));
      }
    }
  }
}
