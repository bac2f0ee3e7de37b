// Any bytes go through the readers of .mesh, .meshb, .sol and .solb: a surface with ids in their
// range or a refusal in words, never a crash. What the writer makes is read as it was.

#include "FuzzSupport.h"

#include "Failure.h"
#include "MeshReader.h"
#include "MeshWriter.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"

#include <string>

namespace
{
void checkSurface(vtkPolyData* surface)
{
  vtkCellArray* polygons = surface->GetPolys();
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  for (polygons->InitTraversal(); polygons->GetNextCell(size, ids) != 0;)
  {
    for (vtkIdType i = 0; i < size; ++i)
    {
      FUZZ_CHECK(ids[i] >= 0 && ids[i] < surface->GetNumberOfPoints());
    }
  }
  FUZZ_CHECK(surface->GetCellData()->GetArray("Reference")->GetNumberOfTuples() ==
    surface->GetNumberOfPolys());
}

/** The mesh in one file, with the solutions in the other. */
vtkSmartPointer<vtkPolyData> readBoth(
  const std::string& mesh, const std::string& solution, bool isBinary)
{
  vtkSmartPointer<vtkPolyData> surface;
  try
  {
    surface = ReadMesh(mesh, isBinary ? ".meshb" : ".mesh");
    checkSurface(surface);
    AddSolutions(solution, isBinary ? ".solb" : ".sol", surface);
    FUZZ_CHECK(surface->GetPointData()->GetArray("Metric")->GetNumberOfTuples() ==
      surface->GetNumberOfPoints());
    return surface;
  }
  catch (const Failure& failure)
  {
    FUZZ_CHECK(!std::string(failure.what()).empty());
    return nullptr;
  }
}

/** Triangles alone, with a tensor for each point. */
vtkSmartPointer<vtkPolyData> triangles(fuzz::Bytes& bytes)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> metric;
  metric->SetName("Metric");
  metric->SetNumberOfComponents(6);
  const int count = 3 + bytes.below(6);
  for (int i = 0; i < count; ++i)
  {
    points->InsertNextPoint(bytes.fraction(), bytes.fraction(), bytes.fraction());
    const double size = 1.0 + bytes.fraction();
    metric->InsertNextTuple6(size, 2.0, 3.0, bytes.fraction(), 0.25, 0.5);
  }
  vtkNew<vtkCellArray> cells;
  for (int k = bytes.below(6); k >= 0; --k)
  {
    cells->InsertNextCell({ bytes.below(count), bytes.below(count), bytes.below(count) });
  }
  surface->SetPoints(points);
  surface->SetPolys(cells);
  surface->GetPointData()->AddArray(metric);
  return surface;
}

/** Some bytes changed, and a part of the end left out. */
std::string damaged(std::string text, fuzz::Bytes& bytes)
{
  for (int k = bytes.below(4); k > 0; --k)
  {
    const auto place =
      static_cast<std::size_t>(bytes.fraction() * static_cast<double>(text.size()));
    text[place] = static_cast<char>(bytes.below(3) == 0 ? 255 : bytes.byte());
  }
  const auto left = bytes.below(3) == 0 ? bytes.fraction() : 1.0;
  return text.substr(0, static_cast<std::size_t>(left * static_cast<double>(text.size())));
}

/** The bytes of all numbers of the points, the metric and the corners. */
std::string numbersOf(vtkPolyData* surface)
{
  std::string numbers;
  for (vtkDataArray* array :
    { surface->GetPoints()->GetData(), surface->GetPointData()->GetArray("Metric") })
  {
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        const double number = array->GetComponent(i, c);
        numbers.append(reinterpret_cast<const char*>(&number), sizeof(number));
      }
    }
  }
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  vtkCellArray* polygons = surface->GetPolys();
  for (polygons->InitTraversal(); polygons->GetNextCell(size, ids) != 0;)
  {
    for (vtkIdType i = 0; i < size; ++i)
    {
      numbers += std::to_string(ids[i]) + ' ';
    }
  }
  return numbers;
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  // As they are, as text and as a binary file of each version, in both orders of bytes.
  const std::string raw(reinterpret_cast<const char*>(data), size);
  readBoth("MeshVersionFormatted 2 Vertices " + raw, raw, false);
  fuzz::Bytes bytes(data, size);
  const char version = static_cast<char>(1 + bytes.below(4));
  std::string head(8, '\0');
  const bool isSwapped = bytes.below(2) == 0;
  head[isSwapped ? 3 : 0] = 1;
  head[isSwapped ? 7 : 4] = version;
  readBoth(head + raw, head + raw, true);

  const auto surface = triangles(bytes);
  vtkDataArray* metric = surface->GetPointData()->GetArray("Metric");
  for (const MeshFormat format : { MeshFormat::Text, MeshFormat::Binary, MeshFormat::LargeBinary })
  {
    const bool isBinary = format != MeshFormat::Text;
    const std::string mesh = MeshBytes(surface, format);
    const std::string solution = SolutionBytes(metric, "vtk", format);
    const auto again = readBoth(mesh, solution, isBinary);
    FUZZ_CHECK(again && numbersOf(again) == numbersOf(surface));
    readBoth(damaged(mesh, bytes), damaged(solution, bytes), isBinary);
  }
  return 0;
}
