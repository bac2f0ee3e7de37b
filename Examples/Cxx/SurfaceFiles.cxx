#include "SurfaceFiles.h"

#include "CrashGuard.h"
#include "Failure.h"
#include "Messages.h"
#include "OutputFiles.h"
#include "PlyCheck.h"
#include "PlyCoordinates.h"
#include "ProgressBar.h"
#include "VtpWriter.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPLYWriter.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkPolyDataWriter.h>
#include <vtkSTLReader.h>
#include <vtkSTLWriter.h>
#include <vtkTable.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>

namespace fs = std::filesystem;

namespace
{
void CheckExtension(const std::string& path, const std::vector<std::string>& known)
{
  if (std::find(known.begin(), known.end(), LowerCaseExtension(path)) == known.end())
  {
    std::string sentence = "the name '" + path + "' must end in";
    for (const std::string& extension : known)
    {
      const bool first = &extension == &known.front();
      const bool last = &extension == &known.back();
      sentence += (first ? " " : last ? " or " : ", ") + extension;
    }
    throw Failure(sentence);
  }
}

/** A missing, unreadable or empty file, or a directory, has its own sentence. */
void CheckReadable(const std::string& path)
{
  std::error_code error;
  if (fs::is_directory(path, error))
  {
    throw Failure("it is a directory");
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    throw Failure(errno != 0 ? std::strerror(errno) : "it cannot be opened");
  }
  if (file.peek() == std::ifstream::traits_type::eof())
  {
    throw Failure("it is empty");
  }
}

/** Whether the text starts with "solid" in any case, perhaps after white space. */
bool StartsWithSolid(const std::string& text)
{
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  std::string word = start == std::string::npos ? "" : text.substr(start, 5);
  std::transform(word.begin(), word.end(), word.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word == "solid" && text.find('\0') == std::string::npos;
}

/**
 * vtkSTLReader takes whatever is there as triangles. A binary file has the size that its number of
 * triangles asks for, whatever its header says; another is text, of which VTK finds the errors.
 */
void CheckStl(const std::string& path)
{
  constexpr std::uint64_t headerSize = 84;
  constexpr std::uint64_t triangleSize = 50;
  std::ifstream file(path, std::ios::binary);
  std::string start(headerSize, '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(file.gcount()));
  std::uint64_t announced = 0;
  for (int i = 0; i < 4 && start.size() == headerSize; ++i)
  {
    announced |= static_cast<std::uint64_t>(static_cast<unsigned char>(start[80 + i])) << (8 * i);
  }
  if (start.size() == headerSize && fs::file_size(path) == headerSize + triangleSize * announced)
  {
    if (announced == 0)
    {
      throw Failure("it has no polygons");
    }
    return;
  }
  if (!StartsWithSolid(start))
  {
    throw Failure("malformed STL file, it is no text that starts with 'solid', and its size does "
                  "not fit a binary file of " +
      std::to_string(announced) + " triangles");
  }
}

/** vtkOBJReader takes what is no finite number for 0. */
void CheckObj(const std::string& path)
{
  std::ifstream file(path);
  std::string line;
  for (long number = 1; std::getline(file, line); ++number)
  {
    const std::size_t start = line.find_first_not_of(" \t");
    if (start == std::string::npos || line.compare(start, 1, "v") != 0 ||
      line.find_first_of(" \t", start) != start + 1)
    {
      continue;
    }
    const char* rest = line.c_str() + start + 1;
    for (int c = 0; c < 3; ++c)
    {
      char* end = nullptr;
      const double value = std::strtod(rest, &end);
      if (end == rest || !std::isfinite(value))
      {
        throw Failure("line " + std::to_string(number) + " has no three finite coordinates");
      }
      rest = end;
    }
  }
}

vtkSmartPointer<vtkAlgorithm> MakeReader(const std::string& path)
{
  const std::string extension = LowerCaseExtension(path);
  if (extension == ".vtp")
  {
    auto reader = vtkSmartPointer<vtkXMLPolyDataReader>::New();
    reader->SetFileName(path.c_str());
    return reader;
  }
  if (extension == ".vtk")
  {
    auto reader = vtkSmartPointer<vtkPolyDataReader>::New();
    reader->SetFileName(path.c_str());
    reader->ReadAllScalarsOn();
    reader->ReadAllVectorsOn();
    reader->ReadAllNormalsOn();
    reader->ReadAllTensorsOn();
    reader->ReadAllTCoordsOn();
    reader->ReadAllFieldsOn();
    return reader;
  }
  if (extension == ".ply")
  {
    CheckPly(path);
    auto reader = vtkSmartPointer<vtkPLYReader>::New();
    reader->SetFileName(path.c_str());
    return reader;
  }
  if (extension == ".stl")
  {
    CheckStl(path);
    auto reader = vtkSmartPointer<vtkSTLReader>::New();
    reader->SetFileName(path.c_str());
    reader->MergingOff(); // the filter merges
    return reader;
  }
  CheckObj(path);
  auto reader = vtkSmartPointer<vtkOBJReader>::New();
  reader->SetFileName(path.c_str());
  return reader;
}

/** No reader makes sure that polygons refer to points that exist. */
void CheckCells(vtkPolyData* surface)
{
  for (vtkCellArray* cells :
    { surface->GetVerts(), surface->GetLines(), surface->GetPolys(), surface->GetStrips() })
  {
    double range[2] = { 0, -1 };
    if (cells == nullptr || cells->GetNumberOfConnectivityIds() == 0)
    {
      continue;
    }
    if (!cells->IsValid())
    {
      throw Failure("its cells are inconsistent");
    }
    cells->GetConnectivityArray()->GetRange(range, 0);
    if (range[0] < 0 || range[1] >= static_cast<double>(surface->GetNumberOfPoints()))
    {
      throw Failure("a cell refers to point " +
        std::to_string(static_cast<long long>(range[0] < 0 ? range[0] : range[1])) +
        ", but there are " + std::to_string(surface->GetNumberOfPoints()) + " points");
    }
  }
}

/** One point for all with the same coordinates, in the order of the first of each. */
vtkSmartPointer<vtkPoints> MergePoints(vtkPolyData* surface)
{
  const auto merged = vtkSmartPointer<vtkPoints>::New();
  std::set<std::array<double, 3>> seen;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> point;
    surface->GetPoint(i, point.data());
    const bool isFinite = std::all_of(
      point.begin(), point.end(), [](double coordinate) { return std::isfinite(coordinate); });
    if (!isFinite || seen.insert(point).second) // the filter tells what is not finite
    {
      merged->InsertNextPoint(point.data());
    }
  }
  return merged;
}

/** Wavefront OBJ. vtkOBJWriter does not notice a full disk. */
std::string ObjText(vtkPolyData* surface)
{
  std::string text;
  char line[96];
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double x[3];
    surface->GetPoint(i, x);
    std::snprintf(line, sizeof(line), "v %.17g %.17g %.17g\n", x[0], x[1], x[2]);
    text += line;
  }
  vtkCellArray* polygons = surface->GetPolys();
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  for (polygons->InitTraversal(); polygons->GetNextCell(size, ids) != 0;)
  {
    text += 'f';
    for (vtkIdType i = 0; i < size; ++i)
    {
      text += ' ' + std::to_string(ids[i] + 1);
    }
    text += '\n';
  }
  return text;
}

/** vtkPLYWriter does not notice a full disk; what it wrote is read to find out. */
void WritePly(vtkPolyData* surface, const std::string& path)
{
  vtkNew<vtkPolyData> geometry; // newer writers warn of normals in double precision
  geometry->CopyStructure(surface);
  vtkNew<vtkPLYWriter> writer;
  writer->SetInputData(geometry);
  writer->SetFileName(path.c_str());
  writer->SetFileTypeToBinary();
  writer->Write();
  try
  {
    CheckPly(path);
  }
  catch (const Failure&)
  {
    throw Failure("the file is not complete, perhaps the disk is full");
  }
}

vtkSmartPointer<vtkAlgorithm> MakeVtkWriter(
  vtkPolyData* surface, const std::string& extension, const std::string& path)
{
  if (extension == ".vtk")
  {
    auto writer = vtkSmartPointer<vtkPolyDataWriter>::New();
    writer->SetInputData(surface);
    writer->SetFileName(path.c_str());
    writer->SetFileTypeToBinary();
    return writer;
  }
  auto writer = vtkSmartPointer<vtkSTLWriter>::New();
  writer->SetInputData(surface);
  writer->SetFileName(path.c_str());
  writer->SetFileTypeToBinary();
  return writer;
}
} // namespace

void CheckSurfaceName(const std::string& path)
{
  CheckExtension(path, { ".vtp", ".vtk", ".ply", ".stl", ".obj" });
}

void CheckArrayFileName(const std::string& path)
{
  CheckExtension(path, { ".vtp", ".vtk" });
}

vtkSmartPointer<vtkPolyData> ReadSurface(
  const std::string& path, Messages* messages, ProgressBar* progress)
{
  try
  {
    CheckReadable(path);
    CheckSurfaceName(path);
    const vtkSmartPointer<vtkAlgorithm> reader = MakeReader(path);
    progress->SetPhase("Reading");
    reader->AddObserver(vtkCommand::ProgressEvent, progress);
    {
      const CrashGuard guard(path);
      reader->Update();
    }
    auto* surface = vtkPolyData::SafeDownCast(reader->GetOutputDataObject(0));
    messages->ThrowIfError("VTK says");
    messages->ThrowIfWarning("Error reading", "VTK says");
    if (surface == nullptr)
    {
      throw Failure("it holds no polygonal data");
    }
    if (LowerCaseExtension(path) == ".ply")
    {
      RestorePlyCoordinates(path, surface);
    }
    CheckCells(surface);
    if (surface->GetNumberOfPolys() > 0)
    {
      surface->GetPolys()->ConvertToSmallestStorage(); // readers give ids of 64 bits
    }
    return surface;
  }
  catch (const Failure& failure)
  {
    throw Failure("cannot read '" + path + "': " + failure.what());
  }
}

vtkSmartPointer<vtkPolyData> ReadSites(
  const std::string& path, Messages* messages, ProgressBar* progress)
{
  vtkSmartPointer<vtkPolyData> sites = ReadSurface(path, messages, progress);
  if (LowerCaseExtension(path) == ".stl")
  {
    const vtkSmartPointer<vtkPoints> points = MergePoints(sites);
    sites = vtkSmartPointer<vtkPolyData>::New();
    sites->SetPoints(points);
  }
  return sites;
}

void WriteSurface(vtkPolyData* surface, const std::string& path, const std::string& temporary,
  Messages* messages, ProgressBar* progress)
{
  const std::string extension = LowerCaseExtension(path);
  if (extension == ".ply")
  {
    WritePly(surface, temporary);
    return;
  }
  if (extension == ".vtp")
  {
    WriteVtp(surface, temporary, progress);
    return;
  }
  if (extension == ".obj")
  {
    WriteBytes(temporary, ObjText(surface));
    return;
  }
  // These writers of VTK find out when they cannot write.
  const vtkSmartPointer<vtkAlgorithm> writer = MakeVtkWriter(surface, extension, temporary);
  progress->SetPhase("Writing");
  writer->AddObserver(vtkCommand::ProgressEvent, progress);
  writer->Update();
  messages->ThrowIfError("VTK says");
  if (writer->GetErrorCode() != 0)
  {
    throw Failure(vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode()));
  }
}

std::string TableText(vtkTable* table)
{
  // vtkDelimitedTextWriter has six digits.
  std::string text;
  const vtkIdType columns = table->GetNumberOfColumns();
  for (vtkIdType column = 0; column < columns; ++column)
  {
    text += (column > 0 ? "," : "") + std::string(table->GetColumnName(column));
  }
  text += '\n';
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    for (vtkIdType column = 0; column < columns; ++column)
    {
      char number[32];
      std::snprintf(number, sizeof(number), "%.17g", table->GetValue(row, column).ToDouble());
      text += (column > 0 ? "," : "") + std::string(number);
    }
    text += '\n';
  }
  return text;
}
