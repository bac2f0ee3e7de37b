/**
 * remesh_surface: vtkAnisotropicRemesher on the command line.
 *
 * 1. Read the command line and try whether all outputs can be written.
 * 2. Read the surface.
 * 3. Run the filter.
 * 4. Write all outputs under temporary names, then rename them.
 *
 * Whatever fails throws a Failure; main() prints its sentence, and no file is left.
 */
#include "CommandLine.h"
#include "Failure.h"
#include "Interruption.h"
#include "Messages.h"
#include "OutputFiles.h"
#include "ProgramMemory.h"
#include "ProgressBar.h"
#include "Report.h"
#include "SurfaceFiles.h"

#include <vtkAnisotropicRemesher.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkGaussMapEmbedding.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkVersion.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <new>

namespace
{
class Stopwatch
{
public:
  double GetSeconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
  }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

/** What all steps of a run share. */
struct Run
{
  explicit Run(const Options& options)
    : Parameters(options)
    , Log(Messages::Install())
  {
    this->Progress->SetVisible(!options.Quiet);
  }
  ~Run() { this->Progress->Clear(); }

  const Options& Parameters;
  Stopwatch Watch;
  Seconds Times;
  vtkSmartPointer<Messages> Log;
  vtkNew<ProgressBar> Progress;
  vtkSmartPointer<vtkPolyData> Surface;
  vtkNew<vtkAnisotropicRemesher> Remesher;
  vtkNew<vtkGaussMapEmbedding> Embedding; // runs only if its output is asked for
};

/** A file to write, and how. */
struct Output
{
  std::string Path;
  std::function<void(const std::string& temporary)> Write;
};

void CheckOutputNames(const Options& options)
{
  CheckSurfaceName(options.Output);
  for (const std::string& path :
    { options.Cells, options.Sites, options.Edges, options.EmbeddedSurface })
  {
    if (!path.empty())
    {
      CheckArrayFileName(path);
    }
  }
}

/** Throws Failure unless `surface` has a point array `name`, of 3 components if `normals`. */
void CheckArray(vtkPolyData* surface, const std::string& name, bool normals)
{
  vtkDataArray* array = surface->GetPointData()->GetArray(name.c_str());
  if (array == nullptr)
  {
    throw Failure("the surface has no point array '" + name + "'");
  }
  if (normals && array->GetNumberOfComponents() != 3)
  {
    throw Failure("the point array '" + name + "' has " +
      std::to_string(array->GetNumberOfComponents()) + " components, normals have 3");
  }
}

void ReadInput(Run& run)
{
  const Options& options = run.Parameters;
  const Stopwatch watch;
  run.Surface = ReadSurface(options.Input, run.Log, run.Progress);
  if (run.Surface->GetNumberOfPolys() == 0 && run.Surface->GetNumberOfStrips() == 0)
  {
    throw Failure("'" + options.Input + "' has no polygons");
  }
  if (options.Normals == "none")
  {
    run.Surface->GetPointData()->SetActiveAttribute(-1, vtkDataSetAttributes::NORMALS);
  }
  else if (!options.Normals.empty())
  {
    CheckArray(run.Surface, options.Normals, true);
  }
  if (!options.EmbeddingArray.empty())
  {
    CheckArray(run.Surface, options.EmbeddingArray, false);
  }
  for (const CoordinateArray& coordinates : options.Coordinates)
  {
    CheckArray(run.Surface, coordinates.Name, false);
  }
  if (!options.Density.empty())
  {
    CheckArray(run.Surface, options.Density, false);
  }
  if (!options.Labels.empty() &&
    run.Surface->GetCellData()->GetAbstractArray(options.Labels.c_str()) == nullptr)
  {
    throw Failure("the surface has no cell array '" + options.Labels + "'");
  }
  if (!options.InitialSites.empty())
  {
    run.Remesher->SetInitialSitesData(ReadSites(options.InitialSites, run.Log, run.Progress));
  }
  run.Times.Read = watch.GetSeconds();
}

int BackendNumber(const std::string& name)
{
  return name == "sequential" ? vtkEmbeddedSurfaceAlgorithm::SMP_SEQUENTIAL
    : name == "stdthread"     ? vtkEmbeddedSurfaceAlgorithm::SMP_STDTHREAD
    : name == "tbb"           ? vtkEmbeddedSurfaceAlgorithm::SMP_TBB
                              : vtkEmbeddedSurfaceAlgorithm::SMP_AUTOMATIC;
}

int PlacementNumber(const std::string& name)
{
  return name == "centroid" ? vtkAnisotropicRemesher::CENTROID
    : name == "surface"     ? vtkAnisotropicRemesher::SURFACE_POINT
    : name == "quadric"     ? vtkAnisotropicRemesher::QUADRIC
                            : vtkAnisotropicRemesher::FIT;
}

/** The parameters that the remesher and the embedding have in common. */
void SetEmbedding(vtkEmbeddedSurfaceAlgorithm* filter, const Options& options)
{
  filter->SetEmbeddingMode(options.Dimension == 3 ? vtkEmbeddedSurfaceAlgorithm::POSITION
                                                  : vtkEmbeddedSurfaceAlgorithm::GAUSS_MAP);
  filter->SetAnisotropy(options.Anisotropy);
  filter->SetNormalSmoothingPasses(options.NormalSmoothingPasses);
  filter->SetMergeTolerance(options.MergeTolerance);
  if (!options.Normals.empty() && options.Normals != "none")
  {
    filter->SetInputArrayToProcess(
      0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, options.Normals.c_str());
  }
  if (!options.EmbeddingArray.empty())
  {
    filter->SetEmbeddingArray(options.EmbeddingArray.c_str());
  }
  for (const CoordinateArray& coordinates : options.Coordinates)
  {
    filter->AddCoordinateArray(coordinates.Name.c_str(), coordinates.Scale);
  }
  filter->SetSMPBackend(BackendNumber(options.Backend));
  filter->SetNumberOfThreads(options.Threads);
}

void Execute(vtkEmbeddedSurfaceAlgorithm* filter, Run& run)
{
  SetEmbedding(filter, run.Parameters);
  filter->SetInputData(run.Surface);
  filter->AddObserver(vtkCommand::ProgressEvent, run.Progress);
  vtkNew<MemoryReturn> memoryReturn;
  filter->AddObserver(vtkCommand::ProgressEvent, memoryReturn);
  filter->Update();
  StopIfInterrupted();
  run.Log->ThrowIfError("cannot remesh '" + run.Parameters.Input + "'");
}

void Remesh(Run& run)
{
  const Options& options = run.Parameters;
  vtkAnisotropicRemesher* remesher = run.Remesher;
  remesher->SetNumberOfPoints(options.NumberOfPoints);
  remesher->SetDistanceTolerance(options.Tolerance);
  remesher->SetMaximumNumberOfPoints(options.MaximumPoints);
  remesher->SetPreserveFeatures(options.PreserveFeatures);
  remesher->SetMaximumNumberOfExtraPoints(options.MaximumExtraPoints);
  remesher->SetFeatureAngle(options.FeatureAngle);
  if (!options.Labels.empty())
  {
    remesher->SetFeatureLabelArray(options.Labels.c_str());
  }
  if (!options.Density.empty())
  {
    remesher->SetDensityArray(options.Density.c_str());
  }
  remesher->SetNumberOfLloydIterations(options.LloydIterations);
  remesher->SetNumberOfNewtonIterations(options.NewtonIterations);
  remesher->SetSeed(options.Seed);
  remesher->SetSamplingMethod(options.Sampling == "random" ? vtkAnisotropicRemesher::RANDOM
                                                           : vtkAnisotropicRemesher::STRATIFIED);
  remesher->SetVertexPlacement(PlacementNumber(options.Placement));
  remesher->SetCoarseStart(options.CoarseStart);
  remesher->SetMeasureDistance(options.MeasureDistance);
  remesher->SetGenerateVoronoiCells(!options.Cells.empty());
  remesher->SetGenerateEdges(!options.Edges.empty());
  const std::size_t earlier = run.Log->GetWarnings().size();
  Execute(remesher, run);
  if (remesher->GetOutput()->GetNumberOfPoints() == 0)
  {
    const std::vector<std::string> warnings = run.Log->GetWarnings();
    const std::string reason = warnings.size() > earlier ? ": " + warnings[earlier] : "";
    throw Failure("cannot remesh '" + options.Input + "': the result is empty" + reason);
  }
  if (!options.EmbeddedSurface.empty())
  {
    vtkPointSet* sites = vtkPointSet::SafeDownCast(remesher->GetInputDataObject(1, 0));
    run.Embedding->SetNumberOfPoints(
      std::max<vtkIdType>(1, sites ? sites->GetNumberOfPoints() : options.NumberOfPoints));
    vtkFieldData* facts = remesher->GetOutput()->GetFieldData();
    vtkDataArray* radius = facts->GetArray("NormalSmoothingRadius");
    run.Embedding->SetNormalSmoothingRadius(radius ? radius->GetComponent(0, 0) : -1.0);
    Execute(run.Embedding, run);
  }
}

/** The files asked for; the report comes last, it tells how long the others took. */
std::vector<Output> ListOutputs(Run& run)
{
  using Writer = std::function<void(const std::string&)>;
  std::vector<Output> outputs;
  const auto add = [&outputs](const std::string& path, const Writer& write)
  {
    if (!path.empty())
    {
      outputs.push_back({ path, write });
    }
  };
  const auto addSurface = [&](const std::string& path, vtkAlgorithm* filter, int port)
  {
    add(path,
      [&run, &path, filter, port](const std::string& temporary)
      {
        auto* surface = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(port));
        WriteSurface(surface, path, temporary, run.Log, run.Progress);
      });
  };
  const Options& options = run.Parameters;
  addSurface(options.Output, run.Remesher, vtkAnisotropicRemesher::SURFACE);
  addSurface(options.Cells, run.Remesher, vtkAnisotropicRemesher::VORONOI_CELLS);
  addSurface(options.Sites, run.Remesher, vtkAnisotropicRemesher::SITES);
  addSurface(options.Edges, run.Remesher, vtkAnisotropicRemesher::EDGES);
  addSurface(options.EmbeddedSurface, run.Embedding, 0);
  add(options.Convergence,
    [&run](const std::string& temporary)
    { WriteBytes(temporary, TableText(run.Remesher->GetConvergenceOutput())); });
  add(options.Report,
    [&run](const std::string& temporary)
    {
      run.Times.Total = run.Watch.GetSeconds();
      WriteBytes(temporary,
        ReportText(run.Parameters, run.Surface, run.Remesher, run.Times, run.Log->GetWarnings()));
    });
  return outputs;
}

void WriteOutputs(const std::vector<Output>& outputs, OutputFiles& files, Run& run)
{
  const Stopwatch watch;
  for (std::size_t i = 0; i < outputs.size(); ++i)
  {
    try
    {
      run.Times.Write = watch.GetSeconds();
      outputs[i].Write(files.GetTemporaryName(i));
    }
    catch (const Failure& failure)
    {
      throw Failure("cannot write '" + outputs[i].Path + "': " + failure.what());
    }
    StopIfInterrupted();
  }
  files.Commit();
}

void RemeshSurface(const Options& options)
{
  CheckOutputNames(options);
  const bool needsNumber = options.InitialSites.empty() && !(options.Tolerance > 0.0);
  if (needsNumber && options.NumberOfPoints < 4)
  {
    throw Failure("a mesh needs at least 4 points, not " + std::to_string(options.NumberOfPoints));
  }
  Run run(options);
  const std::vector<Output> outputs = ListOutputs(run);
  OutputFiles files;
  files.Protect(options.Input);
  files.Protect(options.InitialSites);
  for (const Output& output : outputs)
  {
    files.Add(output.Path);
  }
  ReadInput(run);
  StopIfInterrupted();
  Remesh(run);
  WriteOutputs(outputs, files, run);
  run.Progress->Clear();
  for (const std::string& warning : run.Log->GetWarnings())
  {
    if (!options.Quiet)
    {
      std::cerr << "remesh_surface: warning: " << warning << '\n';
    }
  }
}

void PrintVersion()
{
  std::cout << "remesh_surface " << ANISOTROPIC_REMESHING_VERSION << " (VTK "
            << vtkVersion::GetVTKVersion() << ")\n";
}

int Main(const std::vector<std::string>& arguments)
{
  const Options options = ParseCommandLine(arguments);
  if (options.Help)
  {
    std::cout << HelpText();
  }
  else if (options.Version)
  {
    PrintVersion();
  }
  else
  {
    CatchInterruptions();
    RemeshSurface(options);
  }
  return EXIT_SUCCESS;
}

int GiveUp(const std::string& sentence, int status)
{
  std::cerr << "remesh_surface: " << sentence << '\n';
  return status;
}
} // namespace

int main(int argc, char* argv[])
{
  KeepFreedMemory();
  try
  {
    return Main(std::vector<std::string>(argv + 1, argv + argc));
  }
  catch (const Failure& failure)
  {
    return GiveUp(failure.what(), failure.Status);
  }
  catch (const std::bad_alloc&)
  {
    return GiveUp("not enough memory", EXIT_CANNOT);
  }
  catch (const std::exception& error)
  {
    return GiveUp(error.what(), EXIT_CANNOT);
  }
}
