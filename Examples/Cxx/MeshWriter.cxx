#include "MeshWriter.h"

#include "Failure.h"
#include "InputBytes.h"
#include "MeshSections.h"
#include "Polygons.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIntArray.h>
#include <vtkPolyData.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <vector>

namespace
{
/** Rows of numbers in sections, one after the other. */
class Sink
{
public:
  Sink() = default;
  Sink(const Sink&) = delete;
  Sink& operator=(const Sink&) = delete;
  virtual ~Sink() = default;

  virtual void Begin(const std::string& section, vtkIdType rows) = 0;
  virtual void Number(double number) = 0;
  virtual void Integer(vtkIdType number) = 0;
  virtual void EndRow() {}
  /** No more sections: all bytes. */
  virtual std::string Finish() = 0;
};

class TextSink : public Sink
{
public:
  void Begin(const std::string& section, vtkIdType rows) override
  {
    this->Text += '\n' + section + '\n' + std::to_string(rows) + '\n';
  }
  void Number(double number) override
  {
    char word[32];
    std::snprintf(word, sizeof(word), "%.17g ", number);
    this->Text += word;
  }
  void Integer(vtkIdType number) override { this->Text += std::to_string(number) + ' '; }
  void EndRow() override { this->Text.back() = '\n'; }
  std::string Finish() override { return this->Text + "\nEnd\n"; }

private:
  std::string Text = "MeshVersionFormatted 2\n\nDimension 3\n";
};

class BinarySink : public Sink
{
public:
  explicit BinarySink(bool isLarge)
    : IsLarge(isLarge)
  {
    this->Integer(1);
    this->Integer(isLarge ? 3 : 2);
    this->BeginSection("Dimension");
    this->Integer(3);
  }
  void Begin(const std::string& section, vtkIdType rows) override
  {
    this->BeginSection(section);
    this->Integer(rows);
  }
  void Number(double number) override { this->Append(number); }
  void Integer(vtkIdType number) override { this->Append(static_cast<std::int32_t>(number)); }
  std::string Finish() override
  {
    this->BeginSection("End"); // after which nothing follows: its place stays 0
    return this->Bytes;
  }

private:
  template <typename Value>
  void Append(Value value)
  {
    this->Bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  }

  /** Tells the section before where this one is, and leaves room for where the next one will be. */
  void BeginSection(const std::string& section)
  {
    const auto here = static_cast<std::int64_t>(this->Bytes.size());
    const auto shortHere = static_cast<std::int32_t>(here);
    if (this->Place > 0 && this->IsLarge)
    {
      std::memcpy(this->Bytes.data() + this->Place, &here, sizeof(here));
    }
    else if (this->Place > 0)
    {
      std::memcpy(this->Bytes.data() + this->Place, &shortHere, sizeof(shortHere));
    }
    this->Integer(SectionCode(section));
    this->Place = this->Bytes.size();
    this->Bytes.append(this->IsLarge ? sizeof(here) : sizeof(shortHere), '\0');
  }

  bool IsLarge;
  std::string Bytes;
  std::size_t Place = 0; // of what the last section tells; 0: none yet
};

std::unique_ptr<Sink> MakeSink(MeshFormat format)
{
  if (format == MeshFormat::Text)
  {
    return std::make_unique<TextSink>();
  }
  return std::make_unique<BinarySink>(format == MeshFormat::LargeBinary);
}

void WriteVertices(vtkPolyData* surface, Sink& sink)
{
  sink.Begin("Vertices", surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double x[3];
    surface->GetPoint(i, x);
    for (const double coordinate : x)
    {
      sink.Number(coordinate);
    }
    sink.Integer(0);
    sink.EndRow();
  }
}

void WriteTriangles(vtkPolyData* surface, Sink& sink)
{
  sink.Begin("Triangles", surface->GetNumberOfPolys());
  auto* references = vtkIntArray::SafeDownCast(surface->GetCellData()->GetArray("Reference"));
  vtkIdType cell = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  ForEachPolygon(surface,
    [&](vtkIdType size, const vtkIdType* ids)
    {
      for (vtkIdType i = 0; i < size; ++i)
      {
        sink.Integer(ids[i] + 1);
      }
      sink.Integer(references != nullptr ? references->GetValue(cell) : 0);
      sink.EndRow();
      ++cell;
    });
}

/** Where the components 11 12 22, or 11 12 22 13 23 33, are among those of an array. */
std::vector<int> ComponentsOf(int components, const std::string& order)
{
  if (components == 3)
  {
    return order == "vtk" ? std::vector<int>{ 0, 2, 1 } : std::vector<int>{ 0, 1, 2 };
  }
  if (components == 9)
  {
    return { 0, 1, 4, 2, 5, 8 };
  }
  return order == "vtk" ? std::vector<int>{ 0, 3, 1, 5, 4, 2 }
    : order == "rows"   ? std::vector<int>{ 0, 1, 3, 2, 4, 5 }
                        : std::vector<int>{ 0, 1, 2, 3, 4, 5 };
}

std::array<double, 6> TensorAt(vtkDataArray* metric, vtkIdType i, const std::vector<int>& places)
{
  std::array<double, 6> tensor{};
  for (std::size_t k = 0; k < places.size(); ++k)
  {
    tensor[k] = metric->GetComponent(i, places[k]);
  }
  if (places.size() == 3)
  {
    tensor[5] = std::sqrt(tensor[0] * tensor[2] - tensor[1] * tensor[1]);
  }
  return tensor;
}
} // namespace

MeshFormat MeshFormatFor(const std::string& extension, long long rows)
{
  constexpr long long rowBytes = 48; // of a tensor; a vertex has 28, a triangle 16
  constexpr long long others = 100;
  const bool isBinary = extension == ".meshb" || extension == ".solb";
  const bool isLarge = rows > (std::numeric_limits<std::int32_t>::max() - others) / rowBytes;
  return !isBinary ? MeshFormat::Text : isLarge ? MeshFormat::LargeBinary : MeshFormat::Binary;
}

std::string MeshBytes(vtkPolyData* surface, MeshFormat format)
{
  const auto sink = MakeSink(format);
  WriteVertices(surface, *sink);
  WriteTriangles(surface, *sink);
  return sink->Finish();
}

std::string SolutionBytes(vtkDataArray* metric, const std::string& order, MeshFormat format)
{
  const auto sink = MakeSink(format);
  const bool isSize = metric->GetNumberOfComponents() == 1;
  sink->Begin("SolAtVertices", metric->GetNumberOfTuples());
  sink->Integer(1); // solution
  sink->Integer(isSize ? 1 : 3);
  sink->EndRow();
  const std::vector<int> places = ComponentsOf(metric->GetNumberOfComponents(), order);
  for (vtkIdType i = 0; i < metric->GetNumberOfTuples(); ++i)
  {
    if (isSize)
    {
      sink->Number(metric->GetComponent(i, 0));
    }
    else
    {
      for (const double component : TensorAt(metric, i, places))
      {
        sink->Number(component);
      }
    }
    sink->EndRow();
  }
  return sink->Finish();
}

std::string SolutionNameFor(const std::string& path)
{
  const std::string extension = LowerCaseExtension(path);
  const std::string stem = WithoutExtension(path);
  return extension == ".mesh" ? stem + ".sol" : extension == ".meshb" ? stem + ".solb" : "";
}
