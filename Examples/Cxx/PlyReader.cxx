#include "PlyReader.h"

#include "Corners.h"
#include "Failure.h"
#include "PlyElements.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace
{
using Names = std::vector<std::string>;

/** An array of the properties' type with one component for each; null unless all are there. */
vtkSmartPointer<vtkDataArray> Join(const PlyElement& element, const Names& names, const char* name)
{
  std::vector<const PlyProperty*> parts;
  for (const std::string& part : names)
  {
    parts.push_back(element.Find(part));
    if (parts.back() == nullptr || parts.back()->IsList)
    {
      return nullptr;
    }
  }
  const bool sameType = std::all_of(parts.begin(), parts.end(),
    [&](const PlyProperty* part) { return part->Item.VtkType == parts[0]->Item.VtkType; });
  vtkSmartPointer<vtkDataArray> array;
  array.TakeReference(
    vtkDataArray::CreateDataArray(sameType ? parts[0]->Item.VtkType : VTK_DOUBLE));
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(parts.size()));
  array->SetNumberOfTuples(element.Count);
  for (std::size_t c = 0; c < parts.size(); ++c)
  {
    for (vtkIdType i = 0; i < element.Count; ++i)
    {
      array->SetComponent(i, static_cast<int>(c), parts[c]->Values[static_cast<std::size_t>(i)]);
    }
  }
  return array;
}

/** All that is not read under another name. */
void AddArrays(const PlyElement& element, vtkDataSetAttributes* data, Names used)
{
  auto colors = Join(element, { "red", "green", "blue", "alpha" }, "RGBA");
  colors = colors ? colors : Join(element, { "red", "green", "blue" }, "RGB");
  if (colors)
  {
    data->AddArray(colors);
    data->SetActiveScalars(colors->GetName());
    used.insert(used.end(), { "red", "green", "blue", "alpha" });
  }
  for (const PlyProperty& property : element.Properties)
  {
    if (!property.IsList && std::find(used.begin(), used.end(), property.Name) == used.end())
    {
      data->AddArray(Join(element, { property.Name }, property.Name.c_str()));
    }
  }
}

vtkSmartPointer<vtkPolyData> ReadPoints(const PlyElement& element)
{
  auto coordinates = Join(element, { "x", "y", "z" }, "Points");
  if (!coordinates)
  {
    MalformedPly("a vertex needs x, y and z");
  }
  const int type = coordinates->GetDataType();
  vtkNew<vtkPoints> points;
  points->SetDataType(type == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE);
  points->GetData()->DeepCopy(coordinates);
  const auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(points);
  vtkPointData* data = surface->GetPointData();
  Names used = { "x", "y", "z" };
  if (auto normals = Join(element, { "nx", "ny", "nz" }, "Normals"))
  {
    data->SetNormals(normals);
    used.insert(used.end(), { "nx", "ny", "nz" });
  }
  for (const Names& names : { Names{ "u", "v" }, Names{ "s", "t" },
         Names{ "texture_u", "texture_v" }, Names{ "texture_s", "texture_t" } })
  {
    auto textures = Join(element, names, "TCoords");
    if (textures && data->GetTCoords() == nullptr)
    {
      data->SetTCoords(textures);
      used.insert(used.end(), names.begin(), names.end());
    }
  }
  AddArrays(element, data, used);
  return surface;
}

vtkIdType PointOf(double number, vtkIdType pointCount, const char* what, std::size_t row)
{
  if (!(number >= 0 && number < static_cast<double>(pointCount)) || number != std::floor(number))
  {
    MalformedPly(std::string(what) + " " + std::to_string(row) + " refers to point " +
      std::to_string(static_cast<long long>(number)) + ", but there are " +
      std::to_string(pointCount));
  }
  return static_cast<vtkIdType>(number);
}

const PlyProperty& CornersOf(const PlyElement& element)
{
  const PlyProperty* corners = element.Find("vertex_indices");
  corners = corners != nullptr ? corners : element.Find("vertex_index");
  if (corners == nullptr || !corners->IsList || corners->Item.IsFloat)
  {
    MalformedPly("a face needs one list 'vertex_indices' of integers");
  }
  return *corners;
}

void AddFaces(const PlyElement& element, vtkIdType pointCount, vtkCellArray* polygons)
{
  const PlyProperty& corners = CornersOf(element);
  std::vector<vtkIdType> ids;
  for (std::size_t row = 0; row + 1 < corners.Offsets.size(); ++row)
  {
    ids.clear();
    for (std::size_t c = corners.Offsets[row]; c < corners.Offsets[row + 1]; ++c)
    {
      ids.push_back(PointOf(corners.Values[c], pointCount, "face", row));
    }
    if (ids.size() < 3)
    {
      MalformedPly("face " + std::to_string(row) + " has fewer than three corners");
    }
    polygons->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
}

/**
 * Each point makes a triangle with the two before it, every second one turned round; -1 starts a
 * new strip, and triangles that have a point twice are there only to go on elsewhere.
 */
void AddStrips(const PlyElement& element, vtkIdType pointCount, vtkCellArray* polygons)
{
  const PlyProperty& corners = CornersOf(element);
  for (std::size_t row = 0; row + 1 < corners.Offsets.size(); ++row)
  {
    std::size_t start = corners.Offsets[row];
    std::vector<vtkIdType> strip;
    for (std::size_t c = start; c < corners.Offsets[row + 1]; ++c)
    {
      if (corners.Values[c] == -1)
      {
        strip.clear();
        continue;
      }
      strip.push_back(PointOf(corners.Values[c], pointCount, "strip", row));
      const std::size_t size = strip.size();
      if (size < 3)
      {
        continue;
      }
      const vtkIdType triangle[3] = { strip[size - 3], strip[size - 2], strip[size - 1] };
      if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
      {
        const bool turned = size % 2 == 0;
        polygons->InsertNextCell(
          { triangle[turned ? 1 : 0], triangle[turned ? 0 : 1], triangle[2] });
      }
    }
  }
}

/** The polygons' corners with the texture coordinates of each. */
CornerMesh TexturedCorners(vtkCellArray* polygons, const PlyProperty& textures)
{
  CornerMesh mesh;
  std::map<std::pair<double, double>, vtkIdType> known;
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  std::size_t row = 0;
  for (polygons->InitTraversal(); polygons->GetNextCell(size, ids) != 0;)
  {
    std::size_t next = textures.Offsets[row];
    if (textures.Offsets[++row] - next != 2 * static_cast<std::size_t>(size))
    {
      MalformedPly("the texture coordinates do not fit the corners");
    }
    for (vtkIdType c = 0; c < size; ++c, next += 2)
    {
      const std::pair<double, double> pair(textures.Values[next], textures.Values[next + 1]);
      const auto [entry, isNew] = known.insert({ pair, static_cast<vtkIdType>(known.size()) });
      if (isNew)
      {
        mesh.Textures.insert(mesh.Textures.end(), { pair.first, pair.second });
      }
      mesh.Corners.push_back({ ids[c], entry->second, -1 });
    }
    mesh.Offsets.push_back(static_cast<vtkIdType>(mesh.Corners.size()));
  }
  return mesh;
}

/** A point is there once for each pair of texture coordinates that corners have there. */
vtkSmartPointer<vtkPolyData> SplitAtSeams(vtkPolyData* surface, const PlyProperty& textures)
{
  CornerMesh mesh = TexturedCorners(surface->GetPolys(), textures);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    // Instead of its place, where each point comes from.
    mesh.Points.insert(mesh.Points.end(), { static_cast<double>(i), 0.0, 0.0 });
  }
  const auto split = MakeSurface(mesh);
  vtkPointData* data = split->GetPointData();
  const vtkIdType count = split->GetNumberOfPoints();
  vtkNew<vtkPoints> points;
  points->SetDataType(surface->GetPoints()->GetDataType());
  points->SetNumberOfPoints(count);
  const vtkSmartPointer<vtkDataArray> coordinates = data->GetTCoords();
  data->Initialize();
  data->CopyAllocate(surface->GetPointData(), count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto source = static_cast<vtkIdType>(split->GetPoint(i)[0]);
    points->SetPoint(i, surface->GetPoint(source));
    data->CopyData(surface->GetPointData(), source, i);
  }
  data->SetTCoords(coordinates);
  split->SetPoints(points);
  return split;
}
const PlyElement* FindElement(const std::vector<PlyElement>& elements, const char* name)
{
  const auto found = std::find_if(elements.begin(), elements.end(),
    [name](const PlyElement& element) { return element.Name == name; });
  return found != elements.end() ? &*found : nullptr;
}
} // namespace

vtkSmartPointer<vtkPolyData> ReadPly(const std::string& bytes)
{
  const std::vector<PlyElement> elements = ReadPlyElements(bytes);
  const PlyElement* vertices = FindElement(elements, "vertex");
  const PlyElement* faces = FindElement(elements, "face");
  const PlyElement* strips = FindElement(elements, "tristrips");
  if (vertices == nullptr)
  {
    MalformedPly("it has no element 'vertex'");
  }
  vtkSmartPointer<vtkPolyData> surface = ReadPoints(*vertices);
  vtkNew<vtkCellArray> polygons;
  surface->SetPolys(polygons);
  const PlyProperty* textures = faces != nullptr ? faces->Find("texcoord") : nullptr;
  if (faces != nullptr)
  {
    AddFaces(*faces, vertices->Count, polygons);
  }
  if (strips != nullptr)
  {
    AddStrips(*strips, vertices->Count, polygons);
    return surface;
  }
  if (textures != nullptr && textures->IsList && faces->Count > 0)
  {
    surface = SplitAtSeams(surface, *textures);
  }
  if (faces != nullptr)
  {
    AddArrays(*faces, surface->GetCellData(), {});
  }
  return surface;
}
