#include "OptionTable.h"

#include "SurfaceFiles.h"
#include "SurfaceWriter.h"
#include "TextLines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace
{
/** A finite number in [low, high] that takes up the whole of `text`. */
double NumberOf(const std::string& name, const std::string& text, double low, double high)
{
  double number = 0.0;
  if (!ParseNumber(text, number) || !std::isfinite(number))
  {
    UsageError(name + " needs a number, not '" + text + "'");
  }
  if (number < low || number > high)
  {
    std::ostringstream sentence;
    sentence << name << " must be from " << low << " to " << high << ", not " << text;
    UsageError(sentence.str());
  }
  return number;
}

long long IntegerOf(const std::string& name, const std::string& text, long long low, long long high)
{
  const std::size_t sign = text.empty() || (text[0] != '-' && text[0] != '+') ? 0 : 1;
  if (text.size() == sign || text.find_first_not_of("0123456789", sign) != std::string::npos)
  {
    UsageError(name + " needs an integer, not '" + text + "'");
  }
  long long number = 0;
  if (!ParseInteger(text, number) || number < low || number > high)
  {
    const bool open = high == std::numeric_limits<long long>::max();
    UsageError(name + " must be from " + std::to_string(low) +
      (open ? " up" : " to " + std::to_string(high)) + ", not " + text);
  }
  return number;
}

std::string ListOf(const std::vector<std::string>& words)
{
  std::string list;
  for (const std::string& word : words)
  {
    list += " " + word;
  }
  return list;
}

using Setter = std::function<void(Options&, const std::string&, const std::string&)>;

Setter Text(std::string Options::*member)
{
  return [=](Options& options, const std::string&, const std::string& value)
  { options.*member = value; };
}

template <typename Integer>
Setter Whole(Integer Options::*member, long long low, long long high)
{
  return [=](Options& options, const std::string& name, const std::string& value)
  { options.*member = static_cast<Integer>(IntegerOf(name, value, low, high)); };
}

Setter Real(double Options::*member, double low, double high)
{
  return [=](Options& options, const std::string& name, const std::string& value)
  { options.*member = NumberOf(name, value, low, high); };
}

void SetTolerance(Options& options, const std::string& name, const std::string& value)
{
  options.Tolerance = NumberOf(name, value, 0.0, 1.0);
  if (options.Tolerance > 0.0 && options.Tolerance < 1e-7)
  {
    UsageError(name + " must be 0 or at least 1e-7, not " + value);
  }
}

/** NAME=SCALE; the name may hold further equality signs. */
CoordinateArray CoordinatesOf(const std::string& name, const std::string& text)
{
  const std::size_t sign = text.rfind('=');
  if (sign == std::string::npos || sign == 0)
  {
    UsageError(name + " needs NAME=SCALE, not '" + text + "'");
  }
  const double limit = std::numeric_limits<double>::max();
  return { text.substr(0, sign), NumberOf(name, text.substr(sign + 1), -limit, limit) };
}
} // namespace

void OptionTable::Add(
  const std::string& names, const std::string& value, const std::string& text, const Setter& set)
{
  const std::string name = names.substr(names.find("--"));
  const auto callback = [this, name, set](const std::string& found)
  {
    if (found.empty() || found.rfind("--", 0) == 0)
    {
      UsageError(name + " needs a value" + (found.empty() ? " that is not empty" : ""));
    }
    set(this->Result, name, found);
  };
  this->App.add_option_function<std::string>(names, callback, text)
    ->type_name(value)
    ->group(this->Group)
    ->take_last();
}

void OptionTable::AddFlag(
  const std::string& names, bool Options::*member, bool value, const std::string& text)
{
  this->App
    .add_flag_callback(
      names, [this, member, value] { this->Result.*member = value; }, text)
    ->disable_flag_override()
    ->group(this->Group)
    ->take_last();
}

void OptionTable::AddChoice(const std::string& names, const std::string& value,
  std::string Options::*member, const std::vector<std::string>& choices, const std::string& text)
{
  this->Add(names, value, text,
    [=](Options& options, const std::string& name, const std::string& found)
    {
      options.*member = LowerCase(found);
      if (std::find(choices.begin(), choices.end(), options.*member) == choices.end())
      {
        UsageError(name + " must be one of" + ListOf(choices) + ", not '" + found + "'");
      }
    });
  this->Choices[this->App.get_options().back()] = choices;
}

/** A file that keeps arrays. */
void OptionTable::AddFile(const std::string& names, const std::string& value,
  std::string Options::*member, const std::string& text)
{
  this->Add(names, value, text,
    [=](Options& options, const std::string& name, const std::string& found)
    {
      const std::string fault =
        found == "-" ? "cannot be standard output" : ExtensionFault(found, arrayExtensions);
      if (!fault.empty())
      {
        UsageError(name + ": '" + found + "' " + fault);
      }
      options.*member = found;
    });
}

void OptionTable::AddRemeshing()
{
  using Limits = std::numeric_limits<long long>;
  this->Group = "Remeshing";
  this->Add("-n,--points", "N",
    "Number of points of the new mesh, at least 4, those on features among them. Default 10000.",
    Whole(&Options::NumberOfPoints, Limits::min(), Limits::max()));
  this->Add("-t,--tolerance", "T",
    "Distance tolerance instead of --points: as many as keep mesh and surface within this distance "
    "of each other, a "
    "fraction of the bounding-box diagonal, 1e-7 to 1. Not with --initial-sites. Default 0: off.",
    SetTolerance);
  this->Add("--max-points", "N",
    "The most points that --tolerance may take, from 4. Default 1000000.",
    Whole(&Options::MaximumPoints, 4, Limits::max()));
  this->Add("-a,--anisotropy", "S",
    "How much the normals count, as a fraction of the bounding-box diagonal, 0 to 1. "
    "Default 0.04; usual are 0.02 to 0.1; 0 is isotropic.",
    Real(&Options::Anisotropy, 0.0, 1.0));
  this->AddFlag("--no-features", &Options::PreserveFeatures, false,
    "Do not keep creases, corners, borders and non-manifold edges.");
  this->Add("--feature-angle", "DEG",
    "Creases are edges whose facets' normals differ by more than this angle in degrees, "
    "0 to 180. Default 35.",
    Real(&Options::FeatureAngle, 0.0, 180.0));
  this->Add("--labels", "ARRAY",
    "Also keep the edges between different values of this cell array, but for --no-features.",
    Text(&Options::Labels));
  this->Add("--seams", "ARRAY",
    "Also keep the edges across which this point array jumps, with a point for each side; 'none': "
    "no such. Default: the texture coordinates. Not with --no-features.",
    Text(&Options::Seams));
  this->Add("--density", "ARRAY",
    "Point array of numbers above 0: the spacing of the points follows its power of -1/4.",
    Text(&Options::Density));
  this->Add("--max-extra-points", "K",
    "How many more points the mesh may have where it cannot be like the surface otherwise; 0: "
    "none, -1: unlimited. Default -2: one percent of the points.",
    Whole(&Options::MaximumExtraPoints, -2, std::numeric_limits<int>::max()));
}

void OptionTable::AddOptimization()
{
  this->Add("--lloyd", "K", "Lloyd iterations, 0 to 100000. Default 5.",
    Whole(&Options::LloydIterations, 0, 100000));
  this->Add("--newton", "K", "Quasi-Newton iterations after them, 0 to 100000. Default 30.",
    Whole(&Options::NewtonIterations, 0, 100000));
  this->Add("--energy-tolerance", "T",
    "They end where one lowers the energy by at most this fraction of it, 0 to 1. Default 5e-06: "
    "after some 60 to 160. 0: where it cannot be lowered any more.",
    Real(&Options::EnergyTolerance, 0.0, 1.0));
  this->Add("--seed", "I", "Seed of the random numbers. Default 0.",
    Whole(&Options::Seed, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()));
  this->AddChoice("--sampling", "M", &Options::Sampling, { "random", "stratified" },
    "How the first sites are drawn: random or stratified (default).");
  this->AddFlag("--no-coarse-start", &Options::CoarseStart, false,
    "Do not grow the first sites from a quarter as many that take a few iterations first.");
  this->Add("--initial-sites", "F",
    "Start from the points of this file; their number replaces --points. Features are not kept.",
    Text(&Options::InitialSites));
  this->AddChoice("--placement", "P", &Options::Placement,
    { "centroid", "surface", "quadric", "fit" },
    "Where the points are put: centroid of their cells, surface (the point closest to that), "
    "quadric (where the planes of the cell's triangles are closest), or fit (default): where all "
    "triangles together are closest to the surface.");
  this->AddFlag("--no-distance", &Options::MeasureDistance, false,
    "Do not measure how far mesh and surface are from each other, which the report tells else.");
}

void OptionTable::AddEmbedding()
{
  this->Group = "Embedding";
  this->Add("--dimension", "D",
    "Of the embedding. 6: position and normal (default); 3: position alone, isotropic.",
    [](Options& options, const std::string& name, const std::string& value)
    {
      if (value != "3" && value != "6")
      {
        UsageError(name + " must be one of 3 6, not '" + value + "'");
      }
      options.Dimension = value == "3" ? 3 : 6;
    });
  this->Choices[this->App.get_options().back()] = { "3", "6" };
  this->Add("--normals", "ARRAY",
    "Point array with the normals; 'none': estimate them. Default: the active normals, else "
    "estimated.",
    Text(&Options::Normals));
  this->Add("--normal-smoothing", "K",
    "Smoothing passes over estimated normals, -1 to 10000. Default -1: over 1.5 times "
    "the mean spacing of the new points, farther where the anisotropy is too high for them, not "
    "at all where there are few bends but along one direction.",
    Whole(&Options::NormalSmoothingPasses, -1, 10000));
  this->Add("--embedding-array", "NAME",
    "Point array that replaces position and normal: the place of each point in R^d.",
    Text(&Options::EmbeddingArray));
  this->Add("--metric", "ARRAY",
    "Point array of tensors (9, 6 or 3 components) or sizes (1): edges get the lengths that this "
    "metric asks for, all times one number. It replaces position and normal. "
    "A .mesh gets it as a .sol beside it.",
    Text(&Options::Metric));
  this->AddChoice("--metric-order", "O", &Options::MetricOrder, { "vtk", "rows", "sol" },
    "What 6 components of a metric are: 'vtk': XX YY ZZ XY YZ XZ; 'rows': XX XY XZ YY YZ ZZ; "
    "'sol': XX XY YY XZ YZ ZZ. Default vtk.");
  this->AddFlag("--unit", &Options::Unit, true,
    "With --metric: as many points as make edges of mean length 1 in it, instead of --points.");
  this->Add("--complexity", "A",
    "As --unit, with the metric scaled so that its area is A: about 1.15 times as many points. "
    "Default 0: off.",
    Real(&Options::Complexity, 0.0, std::numeric_limits<double>::max()));
  this->Add("--metric-growth", "F",
    "The largest factor between sizes of a metric at the ends of an edge, 1.01 to 1000. Default 5.",
    Real(&Options::MetricGrowth, 1.01, 1000.0));
  this->AddFlag("--no-metric-limit", &Options::LimitMetric, false,
    "Take a metric as it is, also where straight edges cannot follow it.");
  this->AddComputedFields();
  this->AddCoordinates();
  this->Add("--merge-tolerance", "T",
    "Merge input points closer than this fraction of the bounding-box diagonal, 0 to 0.1. "
    "Default 0: equal points, and ends of sides that are nothing but rounding.",
    Real(&Options::MergeTolerance, 0.0, 0.1));
}

void OptionTable::AddComputedFields()
{
  this->App
    .add_option_function<std::vector<std::string>>(
      "--solution",
      [this](const std::vector<std::string>& names)
      {
        auto& solutions = this->Result.Solutions;
        solutions.insert(solutions.end(), names.begin(), names.end());
      },
      "Point array whose interpolation error is to be small: the mesh is made in the metric that "
      "is best for it and so many points. Can be repeated. Instead of --metric.")
    ->type_name("ARRAY")
    ->group(this->Group)
    ->allow_extra_args(false);
  this->AddChoice("--error-norm", "L", &Options::ErrorNorm, { "l1", "l2", "l4", "maximum" },
    "Of the error of --solution: l1, l2 (default), l4 or maximum.");
  this->Add("--min-size", "H", "The shortest edges that --solution asks for. Default 0: no limit.",
    Real(&Options::MinimumSize, 0.0, std::numeric_limits<double>::max()));
  this->Add("--max-size", "H",
    "The longest edges that --solution asks for. Default 0: the bounding-box diagonal.",
    Real(&Options::MaximumSize, 0.0, std::numeric_limits<double>::max()));
  this->Add("--eigenfunctions", "D",
    "Embed by the first D eigenfunctions of the surface's Laplacian, 2 to 100000, instead of "
    "position and normal. Default: off.",
    Whole(&Options::Eigenfunctions, 2, 100000));
  this->AddChoice("--eigenfunction-scaling", "K", &Options::EigenfunctionScaling,
    { "none", "commute_time", "diffusion", "biharmonic" },
    "How they count: none, commute_time (default), diffusion or biharmonic.");
  this->Add("--diffusion-time", "T",
    "Of the scaling diffusion, in squares of the points' unit. Default 0.",
    Real(&Options::DiffusionTime, 0.0, std::numeric_limits<double>::max()));
}

void OptionTable::AddCoordinates()
{
  this->App
    .add_option_function<std::vector<std::string>>(
      "--coordinates",
      [this](const std::vector<std::string>& values)
      {
        for (const std::string& value : values)
        {
          this->Result.Coordinates.push_back(CoordinatesOf("--coordinates", value));
        }
      },
      "Append a point array, times a scale, to position and normal. Can be repeated.")
    ->type_name("NAME=SCALE")
    ->group(this->Group)
    ->allow_extra_args(false);
}

void OptionTable::AddComputation()
{
  this->Group = "Computation";
  this->Add("-j,--threads", "T",
    "Threads, 0 to 1024. Default 0: all. The result does not depend on it.",
    Whole(&Options::Threads, 0, 1024));
  this->AddChoice("--backend", "B", &Options::Backend,
    { "sequential", "stdthread", "tbb", "automatic" },
    "sequential, stdthread, tbb or automatic (default). The result does not depend on it.");
}

void OptionTable::AddFiles()
{
  this->Group = "Files";
  this->Add("-o,--output-pattern", "P",
    "Name of each input's output, if all files are inputs: {stem} stands for the input's name "
    "without folder and extension; also {points}, {anisotropy}, {tolerance} and {seed}.",
    Text(&Options::OutputPattern));
  this->AddChoice("-f,--format", "EXT", &Options::Format,
    { "vtp", "vtk", "ply", "stl", "obj", "off", "mesh", "meshb" },
    "Format of standard output and of files in a folder: vtp, vtk, ply, stl, obj, off, mesh or "
    "meshb. Default: that of the input, vtp where that cannot be written.");
  this->AddFile("--cells", "F.vtp", &Options::Cells, "Write the restricted Voronoi cells.");
  this->AddFile("--sites", "F.vtp", &Options::Sites, "Write the sites.");
  this->AddFile("--edges", "F.vtp", &Options::Edges,
    "Write the borders of cells and surface, creases that are kept and non-manifold edges.");
  this->AddFile("--embedded-surface", "F.vtp", &Options::EmbeddedSurface,
    "Write the input with its embedding, the point array Embedding: what the mesh is made on, "
    "but for creases that are kept, which have a normal for each side there.");
  this->Add("--convergence", "F.csv",
    "Write energy, gradient, step length and time of each iteration.", Text(&Options::Convergence));
  this->Add("-r,--report", "F.json",
    "Write parameters, sizes, faults, distances, energy, times, memory and warnings.",
    Text(&Options::Report));
}

void OptionTable::AddOther()
{
  this->Group = "Other";
  this->Add("-c,--compare", "REFERENCE",
    "Print how good the mesh is and how far it is from this surface. With one file and nothing "
    "to write, that file is compared as it is.",
    Text(&Options::Compare));
  this->AddFlag("--json", &Options::Json, true,
    "Print the report on standard output, one line for each of several inputs.");
  this->AddFlag("-q,--quiet", &Options::Quiet, true, "No progress bar, no warnings, no last line.");
  this->AddChoice("--completion", "SHELL", &Options::Completion, { "bash", "zsh", "fish" },
    "Print the completion of a shell, bash, zsh or fish, and stop.");
  this->AddFlag("-V,--version", &Options::Version, true, "Print the version and stop.");
  this->AddFlag("-h,--help", &Options::Help, true, "Print this text and stop.");
}

OptionTable::OptionTable(Options& options)
  : Result(options)
  , App("", "remesh_surface")
{
  this->App.set_help_flag();
  this->App.allow_extras();
  this->App.add_option("files", options.Files)->group("");
  this->AddRemeshing();
  this->AddOptimization();
  this->AddEmbedding();
  this->AddFiles();
  this->AddComputation();
  this->AddOther();
}

std::vector<const CLI::Option*> OptionTable::GetOptions() const
{
  return this->App.get_options(
    [](const CLI::Option* option) { return !option->get_group().empty(); });
}

std::vector<std::string> OptionTable::GetChoices(const CLI::Option* option) const
{
  const auto found = this->Choices.find(option);
  return found != this->Choices.end() ? found->second : std::vector<std::string>();
}
