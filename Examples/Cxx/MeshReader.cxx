#include "MeshReader.h"

#include "Corners.h"
#include "Failure.h"
#include "TextLines.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

namespace
{
/** Words and numbers, whatever the lines. */
class Tokens
{
public:
  Tokens(const std::string& text, const char* kind)
    : Lines(text, TextLines::COMMENTS)
    , Kind(kind)
    , Most(static_cast<long long>(text.size()))
  {
  }

  /** Empty at the end of the file. */
  std::string_view Word()
  {
    for (;;)
    {
      const std::string_view word = this->Lines.Word();
      if (!word.empty() || !this->Lines.Next())
      {
        return word;
      }
    }
  }

  /** The next word that is no number, which begins a section. */
  std::string_view Keyword()
  {
    double number = 0.0;
    std::string_view word = this->Word();
    while (!word.empty() && ParseNumber(word, number))
    {
      word = this->Word();
    }
    return word;
  }

  double Number(const char* what)
  {
    double number = 0.0;
    const std::string_view word = this->Word();
    if (!ParseNumber(word, number) || !std::isfinite(number))
    {
      this->Malformed(word, what);
    }
    return number;
  }

  /** From `least` to `most`; below 0: no more than there are bytes. */
  long long Integer(long long least, long long most, const char* what)
  {
    long long number = 0;
    const std::string_view word = this->Word();
    if (!ParseInteger(word, number) || number < least || number > (most < 0 ? this->Most : most))
    {
      this->Malformed(word, what);
    }
    return number;
  }

  [[noreturn]] void Malformed(std::string_view word, const std::string& what) const
  {
    const std::string file = std::string("malformed ") + this->Kind + " file, ";
    throw Failure(word.empty() ? file + "it ends too early"
                               : file + this->Lines.Where() + " has '" +
          std::string(word.substr(0, 40)) + "' for " + what);
  }

private:
  TextLines Lines;
  const char* Kind;
  long long Most;
};

int ReadDimension(Tokens& tokens)
{
  return static_cast<int>(tokens.Integer(2, 3, "the dimension, 2 or 3"));
}

void ReadVertices(Tokens& tokens, int dimension, CornerMesh& mesh)
{
  const long long count = tokens.Integer(0, -1, "the number of vertices");
  for (long long i = 0; i < count; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      mesh.Points.push_back(c < dimension ? tokens.Number("a coordinate") : 0.0);
    }
    tokens.Number("a reference");
  }
}

void ReadFaces(Tokens& tokens, int size, CornerMesh& mesh, vtkIntArray* references)
{
  const auto points = static_cast<long long>(mesh.Points.size() / 3);
  const long long count = tokens.Integer(0, -1, "the number of faces");
  for (long long i = 0; i < count; ++i)
  {
    for (int k = 0; k < size; ++k)
    {
      Corner corner;
      corner.Point = tokens.Integer(1, points, "a corner") - 1;
      mesh.Corners.push_back(corner);
    }
    mesh.Offsets.push_back(static_cast<vtkIdType>(mesh.Corners.size()));
    references->InsertNextValue(static_cast<int>(tokens.Integer(
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

vtkSmartPointer<vtkPolyData> ReadMesh(const std::string& text)
{
  Tokens tokens(text, ".mesh");
  CornerMesh mesh;
  vtkNew<vtkIntArray> references;
  references->SetName("Reference");
  int dimension = 3;
  std::string word(tokens.Word());
  if (word != "MeshVersionFormatted")
  {
    tokens.Malformed(word, "its first word, which is 'MeshVersionFormatted' in text files");
  }
  for (; !word.empty() && word != "End"; word = std::string(tokens.Keyword()))
  {
    if (word == "Dimension")
    {
      dimension = ReadDimension(tokens);
    }
    else if (word == "Vertices")
    {
      ReadVertices(tokens, dimension, mesh);
    }
    else if (word == "Triangles" || word == "Quadrilaterals")
    {
      ReadFaces(tokens, word == "Triangles" ? 3 : 4, mesh, references);
    }
  }
  auto surface = MakeSurface(mesh);
  surface->GetCellData()->AddArray(references);
  return surface;
}

void AddSolutions(const std::string& text, vtkPolyData* surface)
{
  Tokens tokens(text, ".sol");
  int dimension = 3;
  std::string word(tokens.Keyword());
  for (; word != "SolAtVertices"; word = std::string(tokens.Keyword()))
  {
    if (word.empty() || word == "End")
    {
      throw Failure("the .sol file beside it has no solution at the vertices");
    }
    if (word == "Dimension")
    {
      dimension = ReadDimension(tokens);
    }
  }
  const vtkIdType points = surface->GetNumberOfPoints();
  tokens.Integer(points, points, "the number of vertices, not that of the mesh");
  const auto count = static_cast<int>(tokens.Integer(1, 100, "the number of solutions"));
  std::vector<vtkSmartPointer<vtkDoubleArray>> arrays;
  std::vector<std::vector<int>> places;
  for (int k = 0; k < count; ++k)
  {
    places.push_back(PlacesOf(static_cast<int>(tokens.Integer(1, 3, "a type")), dimension));
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
        arrays[k]->SetComponent(i, place, tokens.Number("a number"));
      }
    }
  }
}
