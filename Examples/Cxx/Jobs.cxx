#include "Jobs.h"

#include "ComputedFields.h"
#include "Failure.h"
#include "InputBytes.h"
#include "SurfaceFiles.h"
#include "SurfaceWriter.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

namespace fs = std::filesystem;

namespace
{
std::string TextOf(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

/** "part" for "folder/part.ply.gz". */
std::string StemOf(const std::string& path)
{
  return path == "-" ? "stdin" : fs::path(WithoutGz(path)).stem().string();
}

/** The pattern with a value for each name in braces. */
std::string Fill(const std::string& pattern, const Options& job)
{
  const std::pair<std::string, std::string> values[] = { { "stem", StemOf(job.Input) },
    { "points", std::to_string(job.NumberOfPoints) }, { "anisotropy", TextOf(job.Anisotropy) },
    { "tolerance", TextOf(job.Tolerance) }, { "seed", std::to_string(job.Seed) } };
  std::string text;
  for (std::size_t start = 0; start < pattern.size();)
  {
    const std::size_t open = std::min(pattern.find('{', start), pattern.size());
    text += pattern.substr(start, open - start);
    const std::size_t close = pattern.find('}', open);
    if (open == pattern.size())
    {
      break;
    }
    const std::string name = pattern.substr(open + 1, close - open - 1);
    const auto* found = std::find_if(std::begin(values), std::end(values),
      [&name](const auto& value) { return value.first == name; });
    if (close == std::string::npos || found == std::end(values))
    {
      UsageError("'" + pattern +
        "' has braces around something else than stem, points, anisotropy, tolerance or seed");
    }
    text += found->second;
    start = close + 1;
  }
  return text;
}

bool IsFolder(const std::string& path)
{
  std::error_code error;
  const bool hasExtension = ExtensionFault(path, writableExtensions).empty();
  return path.back() == '/' || (fs::is_directory(path, error) && !hasExtension);
}

/** The extension in a folder: as wished, else as the input, else .vtp. */
std::string ExtensionFor(const Options& options, const std::string& input)
{
  const std::string own = LowerCaseExtension(input);
  const bool known = input != "-" && ExtensionFault(input, writableExtensions).empty();
  return !options.Format.empty() ? "." + options.Format : known ? own : ".vtp";
}

void CheckJob(const Options& job)
{
  CheckEmbeddings(job);
  const std::string fault = ExtensionFault(job.Output, writableExtensions);
  if (!job.Output.empty() && !fault.empty())
  {
    UsageError("the name '" + job.Output + "' " + fault);
  }
  if (job.Output.empty() &&
    !(job.Cells + job.Sites + job.Edges + job.EmbeddedSurface + job.Convergence + job.Report)
       .empty())
  {
    UsageError("needs an output file: a comparison alone has nothing to write");
  }
  const bool needsNumber =
    !job.Output.empty() && job.InitialSites.empty() && !(job.Tolerance > 0.0);
  if (needsNumber && job.NumberOfPoints < 4)
  {
    UsageError(
      "--points: a mesh needs at least 4 points, not " + std::to_string(job.NumberOfPoints));
  }
  const int standardInputs = (job.Input == "-" ? 1 : 0) + (job.InitialSites == "-" ? 1 : 0) +
    (job.Compare == "-" && job.Input != "-" ? 1 : 0);
  if (standardInputs > 1)
  {
    UsageError("standard input can be read only once");
  }
}
/** What two runs would write to one file, they would write over each other. */
void CheckDifferentOutputs(const std::vector<Options>& jobs)
{
  std::set<std::string> names;
  for (const Options& job : jobs)
  {
    for (const std::string& name : { job.Output, job.Cells, job.Sites, job.Edges,
           job.EmbeddedSurface, job.Convergence, job.Report })
    {
      if (jobs.size() > 1 && !name.empty() &&
        !names.insert(fs::path(name).lexically_normal()).second)
      {
        UsageError("several inputs would be written to '" + name + "': put {stem} into the name");
      }
    }
  }
}

/** The names of the further outputs, and of the first one if there is a pattern for it. */
void FillNames(Options& job)
{
  job.Output = job.OutputPattern.empty() ? job.Output : Fill(job.OutputPattern, job);
  for (auto name : { &Options::Cells, &Options::Sites, &Options::Edges, &Options::EmbeddedSurface,
         &Options::Convergence, &Options::Report })
  {
    job.*name = Fill(job.*name, job);
  }
}
/** Takes the output from the end of the files; empty if there is none, or a pattern for it. */
std::string TakeOutput(std::vector<std::string>& files, const Options& options)
{
  std::string output;
  const bool onlyCompares = !options.Compare.empty() && files.size() == 1;
  if (std::find(files.begin(), files.end(), "") != files.end())
  {
    UsageError("a file needs a name that is not empty");
  }
  if (options.OutputPattern.empty() && !onlyCompares && !files.empty())
  {
    output = files.back();
    files.pop_back();
  }
  if (files.empty())
  {
    UsageError("needs an input file and an output file");
  }
  if (files.size() > 1 && !output.empty() && !IsFolder(output))
  {
    UsageError("takes one input file and one output file, or a folder behind several inputs; '" +
      output + "' is too much, or no folder");
  }
  return output;
}
} // namespace

std::vector<Options> ListJobs(const Options& options)
{
  std::vector<std::string> inputs = options.Files;
  const std::string output = TakeOutput(inputs, options);
  const bool isFolder = !output.empty() && IsFolder(output);
  std::vector<Options> jobs;
  for (const std::string& input : inputs)
  {
    Options job = options;
    job.Files = inputs;
    job.Input = input;
    job.IsOneOfMany = inputs.size() > 1;
    job.Output = output;
    if (isFolder)
    {
      job.Output = fs::path(output) / (StemOf(input) + ExtensionFor(options, input));
    }
    if (isFolder || !options.OutputPattern.empty())
    {
      FillNames(job);
    }
    CheckJob(job);
    jobs.push_back(job);
  }
  CheckDifferentOutputs(jobs);
  return jobs;
}
