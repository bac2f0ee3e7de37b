#include "Corners.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace
{
/** The points of the surface: which corner each stands for. */
class CornerPoints
{
public:
  explicit CornerPoints(std::size_t count)
    : Sources(count)
    , Used(count, false)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Sources[i].Point = static_cast<vtkIdType>(i);
    }
  }

  vtkIdType IdOf(const Corner& corner)
  {
    Corner& source = this->Sources[static_cast<std::size_t>(corner.Point)];
    if (!this->Used[static_cast<std::size_t>(corner.Point)])
    {
      this->Used[static_cast<std::size_t>(corner.Point)] = true;
      source = corner;
    }
    if (source.Texture == corner.Texture && source.Normal == corner.Normal)
    {
      return corner.Point;
    }
    const auto next = static_cast<vtkIdType>(this->Sources.size());
    const auto [known, isNew] =
      this->Further.insert({ { corner.Point, corner.Texture, corner.Normal }, next });
    if (isNew)
    {
      this->Sources.push_back(corner);
    }
    return known->second;
  }

  const std::vector<Corner>& GetSources() const { return this->Sources; }

private:
  std::vector<Corner> Sources;
  std::vector<bool> Used;
  std::map<std::tuple<vtkIdType, vtkIdType, vtkIdType>, vtkIdType> Further;
};

/** The values that `member` of the points' corners refers to; 0 where there is none. */
vtkSmartPointer<vtkDoubleArray> Gather(const std::vector<Corner>& sources,
  vtkIdType Corner::*member, const std::vector<double>& values, int components, const char* name)
{
  const auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(sources.size()));
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      const vtkIdType id = sources[i].*member;
      array->SetTypedComponent(static_cast<vtkIdType>(i), c,
        id < 0 ? 0.0 : values[static_cast<std::size_t>(id * components + c)]);
    }
  }
  return array;
}
} // namespace

vtkSmartPointer<vtkPolyData> MakeSurface(const CornerMesh& mesh)
{
  const auto& corners = mesh.Corners;
  const bool textures = std::all_of(
    corners.begin(), corners.end(), [](const Corner& corner) { return corner.Texture >= 0; });
  const bool normals = std::all_of(
    corners.begin(), corners.end(), [](const Corner& corner) { return corner.Normal >= 0; });
  CornerPoints points(mesh.Points.size() / 3);
  vtkNew<vtkCellArray> polygons;
  for (std::size_t i = 0; i + 1 < mesh.Offsets.size(); ++i)
  {
    polygons->InsertNextCell(static_cast<int>(mesh.Offsets[i + 1] - mesh.Offsets[i]));
    for (vtkIdType c = mesh.Offsets[i]; c < mesh.Offsets[i + 1]; ++c)
    {
      Corner corner = corners[static_cast<std::size_t>(c)];
      corner.Texture = textures ? corner.Texture : -1;
      corner.Normal = normals ? corner.Normal : -1;
      polygons->InsertCellPoint(points.IdOf(corner));
    }
  }
  const std::vector<Corner>& sources = points.GetSources();
  const auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> coordinates;
  coordinates->SetData(Gather(sources, &Corner::Point, mesh.Points, 3, "Points"));
  surface->SetPoints(coordinates);
  surface->SetPolys(polygons);
  if (textures && !corners.empty())
  {
    surface->GetPointData()->SetTCoords(
      Gather(sources, &Corner::Texture, mesh.Textures, 2, "TCoords"));
  }
  if (normals && !corners.empty())
  {
    surface->GetPointData()->SetNormals(
      Gather(sources, &Corner::Normal, mesh.Normals, 3, "Normals"));
  }
  return surface;
}
