#include "ObjReader.h"

#include "Corners.h"
#include "Failure.h"
#include "TextLines.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <cctype>
#include <cmath>
#include <map>
#include <string_view>

namespace
{
[[noreturn]] void Malformed(const TextLines& lines, const std::string& what)
{
  throw Failure(lines.Where() + " " + what);
}

/** The parts of one kind, and which one each polygon is in. */
struct Labels
{
  std::string Kind; // "Object"
  std::vector<std::string> Names;
  std::map<std::string, int> Numbers;
  std::vector<int> OfPolygons;
  std::string Current;

  void AddPolygon()
  {
    const auto [known, isNew] = this->Numbers.insert({ this->Current, int(this->Names.size()) });
    if (isNew)
    {
      this->Names.push_back(this->Current);
    }
    this->OfPolygons.push_back(known->second);
  }

  void AddTo(vtkPolyData* surface) const
  {
    if (this->Names.size() < 2)
    {
      return;
    }
    vtkNew<vtkIntArray> ids;
    ids->SetName((this->Kind + "Ids").c_str());
    for (const int number : this->OfPolygons)
    {
      ids->InsertNextValue(number);
    }
    surface->GetCellData()->AddArray(ids);
    vtkNew<vtkStringArray> names;
    names->SetName((this->Kind + "Names").c_str());
    for (const std::string& name : this->Names)
    {
      names->InsertNextValue(name);
    }
    surface->GetFieldData()->AddArray(names);
  }
};

class Reader
{
public:
  explicit Reader(const std::string& text)
    : Lines(text, TextLines::COMMENTS)
  {
  }

  vtkSmartPointer<vtkPolyData> Read(std::vector<std::string>& warnings);

private:
  void ReadStatement(std::string_view keyword);
  void ReadNumbers(std::vector<double>& values, int count, const char* what);
  void ReadName(Labels& labels);
  void ReadFace();
  vtkIdType ReadIndex(std::string_view text, std::size_t count, bool required) const;
  void Resolve(std::vector<std::string>& warnings);

  TextLines Lines;
  CornerMesh Mesh;
  Labels Objects{ "Object", {}, {}, {}, "" };
  Labels Groups{ "Group", {}, {}, {}, "" };
  Labels Materials{ "Material", {}, {}, {}, "" };
  vtkIdType LastPoint = -1; // the largest index of a point,
  std::string LastPlace;    // and where it stands
};

void Reader::ReadNumbers(std::vector<double>& values, int count, const char* what)
{
  for (int i = 0; i < count; ++i)
  {
    double value = 0.0;
    if (!this->Lines.Number(value) || !std::isfinite(value))
    {
      Malformed(this->Lines, std::string("has no ") + what);
    }
    values.push_back(value);
  }
}

/** A number from 1, or from -1 backwards, as an index from 0; -1 for none. */
vtkIdType Reader::ReadIndex(std::string_view text, std::size_t count, bool required) const
{
  long long number = 0;
  const auto most = static_cast<long long>(count);
  const bool missing = text.empty() && !required;
  if (!missing && !ParseInteger(text, number))
  {
    Malformed(this->Lines, "has a face with '" + std::string(text.substr(0, 40)) + "'");
  }
  if (required && (number == 0 || number < -most))
  {
    Malformed(this->Lines, "has a face that refers to point " + std::to_string(number));
  }
  return static_cast<vtkIdType>(number > 0 ? number - 1 : number < 0 ? most + number : -1);
}

void Reader::ReadFace()
{
  for (std::string_view word = this->Lines.Word(); !word.empty(); word = this->Lines.Word())
  {
    std::string_view parts[3];
    int count = 0;
    for (std::size_t start = 0; start != std::string_view::npos && count < 3; ++count)
    {
      const std::size_t slash = word.find('/', start);
      parts[count] = word.substr(start, slash - start);
      start = slash == std::string_view::npos ? slash : slash + 1;
    }
    Corner corner;
    corner.Point = this->ReadIndex(parts[0], this->Mesh.Points.size() / 3, true);
    corner.Texture = this->ReadIndex(parts[1], this->Mesh.Textures.size() / 2, false);
    corner.Normal = this->ReadIndex(parts[2], this->Mesh.Normals.size() / 3, false);
    this->Mesh.Corners.push_back(corner);
    if (corner.Point > this->LastPoint)
    {
      this->LastPoint = corner.Point;
      this->LastPlace = this->Lines.Where();
    }
  }
  const auto end = static_cast<vtkIdType>(this->Mesh.Corners.size());
  if (end < this->Mesh.Offsets.back() + 3)
  {
    Malformed(this->Lines, "has a face with fewer than three corners");
  }
  this->Mesh.Offsets.push_back(end);
  for (Labels* labels : { &this->Objects, &this->Groups, &this->Materials })
  {
    labels->AddPolygon();
  }
}

void Reader::ReadName(Labels& labels)
{
  labels.Current.clear();
  for (std::string_view word = this->Lines.Word(); !word.empty(); word = this->Lines.Word())
  {
    labels.Current += (labels.Current.empty() ? "" : " ") + std::string(word);
  }
}

void Reader::ReadStatement(std::string_view keyword)
{
  if (keyword == "v")
  {
    this->ReadNumbers(this->Mesh.Points, 3, "three finite coordinates");
  }
  else if (keyword == "vt")
  {
    this->ReadNumbers(this->Mesh.Textures, 1, "finite texture coordinate");
    double second = 0.0; // one is allowed
    this->Mesh.Textures.push_back(
      this->Lines.Number(second) && std::isfinite(second) ? second : 0.0);
  }
  else if (keyword == "vn")
  {
    this->ReadNumbers(this->Mesh.Normals, 3, "normal of three finite numbers");
  }
  else if (keyword == "f" || keyword == "fo")
  {
    this->ReadFace();
  }
  else if (keyword == "o" || keyword == "g" || keyword == "usemtl")
  {
    this->ReadName(keyword == "o" ? this->Objects
        : keyword == "g"          ? this->Groups
                                  : this->Materials);
  }
  else if (keyword == "surf")
  {
    Malformed(this->Lines, "has a free-form surface; only polygons can be read");
  }
  else if (std::isalpha(static_cast<unsigned char>(keyword[0])) == 0)
  {
    Malformed(this->Lines, "is no statement of an OBJ file"); // as a face that is cut in two
  }
}

/** Checks the indices, which may refer to what comes later in the file. */
void Reader::Resolve(std::vector<std::string>& warnings)
{
  const auto pointCount = static_cast<vtkIdType>(this->Mesh.Points.size() / 3);
  if (this->LastPoint >= pointCount)
  {
    throw Failure(this->LastPlace + " refers to point " + std::to_string(this->LastPoint + 1) +
      ", but there are " + std::to_string(pointCount) + " points");
  }
  const struct
  {
    vtkIdType Corner::*Index;
    std::size_t Count;
    const char* Name;
  } attributes[] = { { &Corner::Texture, this->Mesh.Textures.size() / 2, "texture coordinates" },
    { &Corner::Normal, this->Mesh.Normals.size() / 3, "normals" } };
  for (const auto& attribute : attributes)
  {
    std::size_t missing = 0;
    for (Corner& corner : this->Mesh.Corners)
    {
      vtkIdType& index = corner.*attribute.Index;
      index = index < static_cast<vtkIdType>(attribute.Count) ? index : -1;
      missing += index < 0 ? 1 : 0;
    }
    if (missing > 0 && attribute.Count > 0)
    {
      warnings.push_back("the " + std::string(attribute.Name) +
        " of the file are not used: " + std::to_string(missing) + " of " +
        std::to_string(this->Mesh.Corners.size()) + " corners of faces have none");
    }
  }
}

vtkSmartPointer<vtkPolyData> Reader::Read(std::vector<std::string>& warnings)
{
  while (this->Lines.Next())
  {
    const std::string_view keyword = this->Lines.Word();
    if (!keyword.empty())
    {
      this->ReadStatement(keyword);
    }
  }
  this->Resolve(warnings);
  auto surface = MakeSurface(this->Mesh);
  for (const Labels* labels : { &this->Objects, &this->Groups, &this->Materials })
  {
    labels->AddTo(surface);
  }
  return surface;
}
} // namespace

vtkSmartPointer<vtkPolyData> ReadObj(const std::string& text, std::vector<std::string>& warnings)
{
  return Reader(text).Read(warnings);
}
