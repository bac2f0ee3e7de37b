#include "SurfaceFiles.h"

#include "CrashGuard.h"
#include "Failure.h"
#include "InputBytes.h"
#include "MeshReader.h"
#include "MeshSections.h"
#include "Messages.h"
#include "ObjReader.h"
#include "OffReader.h"
#include "PlyReader.h"
#include "ProgressBar.h"
#include "StlReader.h"
#include "TextLines.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCompositeDataIterator.h>
#include <vtkDataArray.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkGLTFReader.h>
#include <vtkGenericCell.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <set>

namespace
{
/** What standard input holds. */
std::string ExtensionOf(const std::string& bytes)
{
  const std::string start = bytes.substr(0, 1000);
  const std::string word = LowerCase(start.substr(0, start.find_first_of(" \t\r\n")));
  const auto has = [&start](const char* text) { return start.find(text) != std::string::npos; };
  return word == "ply"                                              ? ".ply"
    : has("<VTKFile") && has("\"PolyData\"")                        ? ".vtp"
    : has("<VTKFile") && has("\"UnstructuredGrid\"")                ? ".vtu"
    : start.rfind("# vtk DataFile", 0) == 0                         ? ".vtk"
    : word.size() <= 6 && !word.empty() && has("OFF")               ? ".off"
    : word == "meshversionformatted"                                ? ".mesh"
    : IsBinaryMesh(bytes)                                           ? ".meshb"
    : word == "solid"                                               ? ".stl"
    : word == "v" || word == "#" || word == "o" || word == "mtllib" ? ".obj"
                                                                    : "";
}

class Source
{
public:
  Source(const std::string& path, Messages* messages, ProgressBar* progress)
    : Path(path)
    , Log(messages)
    , Progress(progress)
  {
  }

  vtkSmartPointer<vtkPolyData> Read();

  /** Of the format that was read. */
  const std::string& GetExtension() const { return this->Extension; }

private:
  vtkSmartPointer<vtkPolyData> ReadVtp();
  vtkSmartPointer<vtkPolyData> ReadVtk();
  vtkSmartPointer<vtkPolyData> ReadVtu();
  vtkSmartPointer<vtkPolyData> ReadGltf();
  vtkSmartPointer<vtkPolyData> ReadMeshAndSolution();
  void Update(vtkAlgorithm* reader);

  std::string Path;
  std::string Extension;
  std::string Bytes;
  Messages* Log;
  ProgressBar* Progress;
};

void Source::Update(vtkAlgorithm* reader)
{
  this->Progress->SetPhase("Reading");
  reader->AddObserver(vtkCommand::ProgressEvent, this->Progress);
  {
    const CrashGuard guard(this->Path);
    reader->Update();
  }
  this->Log->ThrowIfError("VTK says");
  this->Log->ThrowIfWarning("Error reading", "VTK says");
}

vtkSmartPointer<vtkPolyData> Source::ReadVtp()
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(this->Bytes);
  this->Update(reader);
  return reader->GetOutput();
}

vtkSmartPointer<vtkPolyData> Source::ReadVtk()
{
  if (this->Bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
  {
    throw Failure("it has more than 2 GB: .vtp can be larger");
  }
  vtkNew<vtkPolyDataReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetBinaryInputString(this->Bytes.data(), static_cast<int>(this->Bytes.size()));
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllTensorsOn();
  reader->ReadAllTCoordsOn();
  reader->ReadAllFieldsOn();
  this->Update(reader);
  return reader->GetOutput();
}

/** The surface cells of an unstructured grid, which may have no others but lines and points. */
vtkSmartPointer<vtkPolyData> Source::ReadVtu()
{
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(this->Bytes);
  this->Update(reader);
  vtkUnstructuredGrid* grid = reader->GetOutput();
  std::set<int> types;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    types.insert(grid->GetCellType(i));
  }
  vtkNew<vtkGenericCell> cell;
  for (const int type : types)
  {
    cell->SetCellType(type);
    if (cell->GetCellDimension() == 3)
    {
      throw Failure("it has volume cells: extract their surface first (ParaView: Extract Surface)");
    }
  }
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(grid);
  this->Update(surface);
  return surface->GetOutput();
}

/** The meshes of all nodes, each at its place. */
vtkSmartPointer<vtkPolyData> Source::ReadGltf()
{
  vtkNew<vtkGLTFReader> reader;
  reader->SetFileName(this->Path.c_str());
  this->Update(reader);
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  vtkNew<vtkAppendPolyData> append;
  vtkSmartPointer<vtkCompositeDataIterator> iterator;
  iterator.TakeReference(blocks->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    append->AddInputData(vtkPolyData::SafeDownCast(iterator->GetCurrentDataObject()));
  }
  if (append->GetNumberOfInputConnections(0) == 0)
  {
    throw Failure("it has no polygons");
  }
  append->Update();
  return append->GetOutput();
}

/** The mesh, with the solutions beside it, if there are any. */
vtkSmartPointer<vtkPolyData> Source::ReadMeshAndSolution()
{
  auto surface = ReadMesh(this->Bytes, this->Extension);
  const std::string solution = SolutionFileOf(this->Path);
  if (!solution.empty())
  {
    AddSolutions(ReadBytes(solution), LowerCaseExtension(solution), surface);
  }
  return surface;
}

vtkSmartPointer<vtkPolyData> Source::Read()
{
  this->Bytes = ReadBytes(this->Path);
  this->Extension = this->Path == "-" ? ExtensionOf(this->Bytes) : LowerCaseExtension(this->Path);
  const std::string& extension = this->Extension;
  if (extension == ".glb" || extension == ".gltf")
  {
    return this->ReadGltf();
  }
  if (extension == ".vtp" || extension == ".vtk" || extension == ".vtu")
  {
    return extension == ".vtp" ? this->ReadVtp()
      : extension == ".vtk"    ? this->ReadVtk()
                               : this->ReadVtu();
  }
  if (extension == ".obj")
  {
    std::vector<std::string> warnings;
    auto surface = ReadObj(this->Bytes, warnings);
    for (const std::string& warning : warnings)
    {
      this->Log->DisplayWarningText(warning.c_str());
    }
    return surface;
  }
  if (extension == ".mesh" || extension == ".meshb")
  {
    return this->ReadMeshAndSolution();
  }
  return extension == ".ply" ? ReadPly(this->Bytes)
    : extension == ".stl"    ? ReadStl(this->Bytes)
    : extension == ".off"
    ? ReadOff(this->Bytes)
    : throw Failure("it is none of the formats that can be read from standard input");
}

/** No reader of VTK makes sure that polygons refer to points that exist. */
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
  merged->SetDataType(surface->GetPoints()->GetDataType());
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
} // namespace

std::string SolutionFileOf(const std::string& path)
{
  const std::string extension = LowerCaseExtension(path);
  if (extension != ".mesh" && extension != ".meshb")
  {
    return "";
  }
  const std::string stem = WithoutExtension(path);
  const std::string own = extension == ".mesh" ? ".sol" : ".solb";
  const std::string other = extension == ".mesh" ? ".solb" : ".sol";
  return std::ifstream(stem + own).good() ? stem + own
    : std::ifstream(stem + other).good()  ? stem + other
                                          : "";
}

std::string ForeignSolutionWarning(const std::string& path, const std::string& written)
{
  const std::string found = SolutionFileOf(path);
  return found.empty() || found == written
    ? ""
    : "'" + found + "' was there before, and does not belong to '" + path +
      "', but will be read with it. Remove or rename it.";
}

std::string ExtensionFault(const std::string& path, const std::vector<std::string>& known)
{
  if (path == "-" || std::find(known.begin(), known.end(), LowerCaseExtension(path)) != known.end())
  {
    return "";
  }
  std::string sentence = "must end in";
  for (const std::string& extension : known)
  {
    const bool first = &extension == &known.front();
    const bool last = &extension == &known.back();
    sentence += (first ? " " : last ? " or " : ", ") + extension;
  }
  return sentence;
}

vtkSmartPointer<vtkPolyData> ReadSurface(
  const std::string& path, Messages* messages, ProgressBar* progress, std::string* format)
{
  try
  {
    const std::string fault = ExtensionFault(path,
      { ".vtp", ".vtk", ".ply", ".stl", ".obj", ".off", ".mesh", ".meshb", ".vtu", ".glb",
        ".gltf" });
    if (!fault.empty())
    {
      ReadBytes(path); // a file that is not there has its own sentence
      throw Failure("the name " + fault);
    }
    Source source(path, messages, progress);
    const vtkSmartPointer<vtkPolyData> surface = source.Read();
    if (format != nullptr)
    {
      *format = source.GetExtension();
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
