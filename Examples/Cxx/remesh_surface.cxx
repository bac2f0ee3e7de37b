/**
 * remesh_surface: vtkAnisotropicRemesher on the command line.
 *
 * For each input:
 * 1. Try whether all outputs can be written.
 * 2. Read the surface, and the one to compare with.
 * 3. Run the filter.
 * 4. Write all outputs under temporary names, then rename them.
 * 5. Tell what came out.
 *
 * Whatever fails throws a Failure, of which one sentence is printed; no file of that input is left,
 * and the next input has its turn.
 */
#include "Comparison.h"
#include "Completion.h"
#include "ComputedFields.h"
#include "Failure.h"
#include "Interruption.h"
#include "Jobs.h"
#include "Messages.h"
#include "OutputFiles.h"
#include "ProgramMemory.h"
#include "ProgressBar.h"
#include "RemesherSetup.h"
#include "Report.h"
#include "SurfaceFiles.h"
#include "SurfaceWriter.h"
#include "Terminal.h"

#include <vtkAnisotropicRemesher.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkGaussMapEmbedding.h>
#include <vtkNew.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkSurfaceFieldAlgorithm.h>
#include <vtkSurfaceMeshComparison.h>
#include <vtkTable.h>
#include <vtkVersion.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <new>
#include <unistd.h>

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
  std::string Format;                     // that Surface was read from: ".ply"
  vtkSmartPointer<vtkPolyData> Reference; // to compare with; null: none
  vtkNew<vtkAnisotropicRemesher> Remesher;
  vtkNew<vtkGaussMapEmbedding> Embedding; // runs only if its output is asked for
  vtkNew<vtkSurfaceMeshComparison> Comparison;
};

/** A file to write, and how. */
struct Output
{
  std::string Path; // "-": standard output
  std::function<void(const std::string& temporary)> Write;
};

vtkSmartPointer<vtkPolyData> ReadPolygons(
  const std::string& path, Run& run, std::string* format = nullptr)
{
  auto surface = ReadSurface(path, run.Log, run.Progress, format);
  if (surface->GetNumberOfPolys() == 0 && surface->GetNumberOfStrips() == 0)
  {
    throw Failure("'" + path + "' has no polygons");
  }
  return surface;
}

void ReadInput(Run& run)
{
  const Options& options = run.Parameters;
  const Stopwatch watch;
  run.Surface = ReadPolygons(options.Input, run, &run.Format);
  if (!options.Compare.empty())
  {
    run.Reference =
      options.Compare == options.Input ? run.Surface : ReadPolygons(options.Compare, run);
  }
  if (!options.Output.empty())
  {
    CheckArrays(run.Surface, options);
  }
  if (!options.InitialSites.empty())
  {
    run.Remesher->SetInitialSitesData(ReadSites(options.InitialSites, run.Log, run.Progress));
  }
  run.Times.Read = watch.GetSeconds();
}

void Execute(vtkPolyDataAlgorithm* filter, Run& run)
{
  filter->SetInputData(run.Surface);
  filter->AddObserver(vtkCommand::ProgressEvent, run.Progress);
  vtkNew<MemoryReturn> memoryReturn;
  filter->AddObserver(vtkCommand::ProgressEvent, memoryReturn);
  filter->Update();
  StopIfInterrupted();
  run.Log->ThrowIfError("cannot remesh '" + run.Parameters.Input + "'");
}

/** Adds the arrays that are computed from the surface. */
void AddComputedFields(Run& run)
{
  for (const auto& filter :
    { MetricForSolutions(run.Parameters), EigenfunctionsFor(run.Parameters) })
  {
    if (filter)
    {
      Execute(filter, run);
      run.Surface = filter->GetOutput();
    }
  }
}

void Remesh(Run& run)
{
  const Options& options = run.Parameters;
  vtkAnisotropicRemesher* remesher = run.Remesher;
  AddComputedFields(run);
  const Options embedding = WithComputedFields(options);
  SetRemeshing(remesher, options);
  SetEmbedding(remesher, embedding);
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
    SetEmbedding(run.Embedding, embedding);
    Execute(run.Embedding, run);
  }
}

/** Compares the mesh, or the input if there is none, with the reference if there is one. */
void Compare(Run& run)
{
  const Options& options = run.Parameters;
  if (run.Reference == nullptr)
  {
    return;
  }
  run.Comparison->SetInputData(
    options.Output.empty() ? run.Surface.Get() : run.Remesher->GetOutput());
  run.Comparison->SetReferenceData(run.Reference);
  run.Comparison->SetNumberOfThreads(options.Threads);
  run.Comparison->AddObserver(vtkCommand::ProgressEvent, run.Progress);
  run.Progress->SetPhase("Comparing");
  run.Comparison->Update();
  StopIfInterrupted();
  run.Log->ThrowIfError("cannot compare with '" + options.Compare + "'");
}

std::string MakeReport(Run& run)
{
  run.Times.Total = run.Watch.GetSeconds();
  vtkTable* comparison = run.Reference ? run.Comparison->GetSummaryOutput() : nullptr;
  return run.Parameters.Output.empty() ? ComparisonReportText(run.Parameters, comparison)
                                       : ReportText(run.Parameters, run.Surface, run.Remesher,
                                           comparison, run.Times, run.Log->GetWarnings());
}

/** A name that tells the format: as wished, else that of the input if it can be written. */
std::string StandardOutputName(const Run& run)
{
  const std::string& wish = run.Parameters.Format;
  const bool known = ExtensionFault("x" + run.Format, writableExtensions).empty();
  return "standard output" + (!wish.empty() ? "." + wish : known ? run.Format : ".vtp");
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
        const std::string name = path == "-" ? StandardOutputName(run) : path;
        WriteSurface(surface, name, temporary, run.Log, run.Progress);
        const std::string warning = ForeignSolutionWarning(path, MetricNameFor(run.Parameters));
        if (!warning.empty())
        {
          run.Log->DisplayWarningText(warning.c_str());
        }
      });
  };
  const Options& options = run.Parameters;
  addSurface(options.Output, run.Remesher, vtkAnisotropicRemesher::SURFACE);
  add(MetricNameFor(options),
    [&run](const std::string& temporary)
    { WriteBytes(temporary, MetricBytes(run.Remesher->GetOutput(), run.Parameters)); });
  addSurface(options.Cells, run.Remesher, vtkAnisotropicRemesher::VORONOI_CELLS);
  addSurface(options.Sites, run.Remesher, vtkAnisotropicRemesher::SITES);
  addSurface(options.Edges, run.Remesher, vtkAnisotropicRemesher::EDGES);
  addSurface(options.EmbeddedSurface, run.Embedding, 0);
  add(options.Convergence,
    [&run](const std::string& temporary)
    { WriteBytes(temporary, TableText(run.Remesher->GetConvergenceOutput())); });
  const Writer report = [&run](const std::string& temporary)
  { WriteBytes(temporary, MakeReport(run)); };
  add(options.Report, report);
  add(options.Json ? "-" : "", report);
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

/** Announces all outputs, so that what cannot be written is known before the long run. */
void Announce(const std::vector<Output>& outputs, OutputFiles& files, const Options& options)
{
  for (const std::string& input : options.Files)
  {
    files.Protect(input);
    files.Protect(SolutionFileOf(input));
  }
  files.Protect(options.InitialSites);
  files.Protect(options.Compare);
  for (const Output& output : outputs)
  {
    if (output.Path == "-")
    {
      files.AddStandardOutput();
    }
    else
    {
      files.Add(output.Path);
    }
  }
}

void TellResult(Run& run)
{
  const Options& options = run.Parameters;
  run.Progress->Clear();
  for (const std::string& warning : run.Log->GetWarnings())
  {
    if (!options.Quiet)
    {
      PrintWarning((options.IsOneOfMany ? options.Input + ": " : "") + warning);
    }
  }
  const bool isData = options.Output == "-" || options.Json;
  if (run.Reference != nullptr && !options.Json)
  {
    const std::string mesh = options.Output.empty() ? options.Input : options.Output;
    (isData ? std::cerr : std::cout)
      << ComparisonText(run.Comparison->GetSummaryOutput(), mesh, options.Compare);
  }
  if (!options.Quiet && !isData && !options.Output.empty())
  {
    std::cout << Colored(options.Output + ":", Color::Bold, STDOUT_FILENO) << ' '
              << ResultText(
                   run.Remesher->GetOutput(), run.Surface->GetLength(), run.Watch.GetSeconds())
              << std::endl;
  }
}

void RemeshSurface(const Options& options)
{
  Run run(options);
  const std::vector<Output> outputs = ListOutputs(run);
  OutputFiles files;
  Announce(outputs, files, options);
  ReadInput(run);
  StopIfInterrupted();
  if (!options.Output.empty())
  {
    Remesh(run);
  }
  Compare(run);
  WriteOutputs(outputs, files, run);
  TellResult(run);
}

/** One after the other; returns the exit status. */
int RemeshAll(const std::vector<Options>& jobs)
{
  int status = EXIT_SUCCESS;
  for (const Options& job : jobs)
  {
    try
    {
      RemeshSurface(job);
    }
    catch (const Failure& failure)
    {
      // A reader that was stopped may have complained.
      PrintError(Interrupted() ? "interrupted" : failure.what());
      status = std::max<int>(status, failure.Status);
    }
    if (Interrupted())
    {
      return EXIT_CANNOT;
    }
  }
  return status;
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
    std::cout << "remesh_surface " << ANISOTROPIC_REMESHING_VERSION << " (VTK "
              << vtkVersion::GetVTKVersion() << ")\n";
  }
  else if (!options.Completion.empty())
  {
    std::cout << CompletionText(options.Completion);
  }
  else
  {
    const std::vector<Options> jobs = ListJobs(options);
    CatchInterruptions();
    return RemeshAll(jobs);
  }
  return EXIT_SUCCESS;
}

} // namespace

int main(int argc, char* argv[])
{
  KeepFreedMemory();
  int status = EXIT_CANNOT;
  try
  {
    status = Main(std::vector<std::string>(argv + 1, argv + argc));
  }
  catch (const Failure& failure)
  {
    PrintError(failure.what());
    status = failure.Status;
  }
  catch (const std::bad_alloc&)
  {
    PrintError("not enough memory");
  }
  catch (const std::exception& error)
  {
    PrintError(error.what());
  }
  DieIfInterrupted();
  return status;
}
