#include "StlReader.h"

#include "Failure.h"
#include "TextLines.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace
{
constexpr std::size_t headerSize = 84;
constexpr std::size_t triangleSize = 50;

/** A binary file has the size that its number of triangles asks for, whatever its header says. */
std::uint32_t AnnouncedTriangles(const std::string& bytes)
{
  std::uint32_t count = 0;
  for (int i = 3; i >= 0 && bytes.size() >= headerSize; --i)
  {
    count = count << 8 | static_cast<unsigned char>(bytes[80 + static_cast<std::size_t>(i)]);
  }
  return count;
}

vtkSmartPointer<vtkPolyData> SurfaceOf(vtkPoints* points)
{
  const auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType i = 0; i + 2 < points->GetNumberOfPoints(); i += 3)
  {
    triangles->InsertNextCell({ i, i + 1, i + 2 });
  }
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  return surface;
}

vtkSmartPointer<vtkPolyData> ReadBinary(const std::string& bytes)
{
  vtkNew<vtkPoints> points;
  for (std::size_t start = headerSize; start < bytes.size(); start += triangleSize)
  {
    for (std::size_t corner = 1; corner < 4; ++corner) // the normal comes first
    {
      float x[3];
      for (std::size_t c = 0; c < 3; ++c)
      {
        std::uint32_t bits = 0;
        for (std::size_t i = 4; i-- > 0;)
        {
          bits = bits << 8 | static_cast<unsigned char>(bytes[start + 12 * corner + 4 * c + i]);
        }
        std::memcpy(&x[c], &bits, sizeof(bits));
      }
      points->InsertNextPoint(x);
    }
  }
  return SurfaceOf(points);
}

/** The words of a text file, which may stand on lines as they like. */
class TextReader
{
public:
  explicit TextReader(const std::string& text)
    : Lines(text)
  {
    this->Points->SetDataTypeToDouble();
    this->Solids->SetName("SolidIds");
  }

  vtkSmartPointer<vtkPolyData> Read();

private:
  std::string Next();
  void Expect(const char* word);
  void ReadFacet();
  void ReadNumbers(double numbers[3]);

  TextLines Lines;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkIntArray> Solids;
  int Solid = -1;
};

/** The next word in lower case. */
std::string TextReader::Next()
{
  std::string_view word = this->Lines.Word();
  while (word.empty())
  {
    if (!this->Lines.Next())
    {
      throw Failure("malformed STL file, it ends before its last solid does");
    }
    word = this->Lines.Word();
  }
  return LowerCase(word);
}

void TextReader::Expect(const char* word)
{
  const std::string found = this->Next();
  if (found != word)
  {
    throw Failure("malformed STL file, " + this->Lines.Where() + " has '" + found.substr(0, 40) +
      "' instead of '" + word + "'");
  }
}

void TextReader::ReadNumbers(double numbers[3])
{
  for (int i = 0; i < 3; ++i)
  {
    if (!ParseNumber(this->Next(), numbers[i]) || !std::isfinite(numbers[i]))
    {
      throw Failure(
        "malformed STL file, " + this->Lines.Where() + " has no three finite coordinates");
    }
  }
}

/** What follows the word "facet". Its normal is that of the points, as a rule, or none. */
void TextReader::ReadFacet()
{
  this->Expect("normal");
  for (int i = 0; i < 3; ++i)
  {
    this->Next();
  }
  this->Expect("outer");
  this->Expect("loop");
  for (int i = 0; i < 3; ++i)
  {
    double x[3];
    this->Expect("vertex");
    this->ReadNumbers(x);
    this->Points->InsertNextPoint(x);
  }
  this->Expect("endloop");
  this->Expect("endfacet");
  this->Solids->InsertNextValue(this->Solid);
}

vtkSmartPointer<vtkPolyData> TextReader::Read()
{
  while (this->Lines.Next())
  {
    const std::string_view word = this->Lines.Word();
    if (word.empty())
    {
      continue;
    }
    if (LowerCase(word) != "solid")
    {
      throw Failure("malformed STL file, " + this->Lines.Where() + " does not start a solid");
    }
    ++this->Solid;
    this->Lines.Next(); // the rest of the line is a name
    std::string next = this->Next();
    for (; next == "facet"; next = this->Next())
    {
      this->ReadFacet();
    }
    if (next != "endsolid" && next != "end") // "end solid" is found, too
    {
      throw Failure("malformed STL file, " + this->Lines.Where() + " has '" + next.substr(0, 40) +
        "' instead of 'facet' or 'endsolid'");
    }
  }
  const auto surface = SurfaceOf(this->Points);
  if (this->Solid > 0)
  {
    surface->GetCellData()->AddArray(this->Solids);
  }
  return surface;
}
} // namespace

vtkSmartPointer<vtkPolyData> ReadStl(const std::string& bytes)
{
  const std::uint32_t announced = AnnouncedTriangles(bytes);
  if (bytes.size() == headerSize + triangleSize * announced)
  {
    return ReadBinary(bytes);
  }
  const std::size_t start = bytes.find_first_not_of(" \t\r\n");
  if (start == std::string::npos || LowerCase(bytes.substr(start, 5)) != "solid" ||
    bytes.find('\0') != std::string::npos)
  {
    throw Failure("malformed STL file, it is no text that starts with 'solid', and its size does "
                  "not fit a binary file of " +
      std::to_string(announced) + " triangles");
  }
  return TextReader(bytes).Read();
}
