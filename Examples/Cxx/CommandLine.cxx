#include "CommandLine.h"

#include "Failure.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <sstream>

namespace
{
struct Option
{
  std::string Name;  // with its dashes
  std::string Value; // what stands for the value in --help; "": the option takes none
  std::string Text;
  std::function<void(Options&, const std::string& value)> Set;
};

[[noreturn]] void UsageError(const std::string& sentence)
{
  throw Failure(sentence + " (see --help)", EXIT_USAGE);
}

/** A finite number in [low, high] that takes up the whole of `text`. */
double ParseNumber(const std::string& name, const std::string& text, double low, double high)
{
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  const bool blank = text.empty() || std::isspace(static_cast<unsigned char>(text[0])) != 0;
  if (blank || *end != '\0' || !std::isfinite(number))
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

long long ParseInteger(
  const std::string& name, const std::string& text, long long low, long long high)
{
  const std::size_t digits = text.find_first_not_of("+-");
  const bool wellFormed = digits != std::string::npos && digits <= 1 &&
    text.find_first_not_of("0123456789", digits) == std::string::npos;
  if (!wellFormed)
  {
    UsageError(name + " needs an integer, not '" + text + "'");
  }
  errno = 0;
  const long long number = std::strtoll(text.c_str(), nullptr, 10);
  if (errno == ERANGE || number < low || number > high)
  {
    UsageError(name + " must be from " + std::to_string(low) + " to " + std::to_string(high) +
      ", not " + text);
  }
  return number;
}

std::string ParseChoice(
  const std::string& name, std::string text, const std::vector<std::string>& choices)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (std::find(choices.begin(), choices.end(), text) == choices.end())
  {
    std::string sentence = name + " must be one of";
    for (const std::string& choice : choices)
    {
      sentence += " " + choice;
    }
    UsageError(sentence + ", not '" + text + "'");
  }
  return text;
}

/** NAME=SCALE; the name may hold further equality signs. */
CoordinateArray ParseCoordinates(const std::string& name, const std::string& text)
{
  const std::size_t sign = text.rfind('=');
  if (sign == std::string::npos || sign == 0)
  {
    UsageError(name + " needs NAME=SCALE, not '" + text + "'");
  }
  const double limit = std::numeric_limits<double>::max();
  return { text.substr(0, sign), ParseNumber(name, text.substr(sign + 1), -limit, limit) };
}

// Makers of the table's setters.
using Setter = std::function<void(Options&, const std::string&)>;

Setter Text(const char* name, std::string Options::*member)
{
  return [=](Options& options, const std::string& value)
  {
    if (value.empty())
    {
      UsageError(std::string(name) + " needs a value that is not empty");
    }
    options.*member = value;
  };
}

Setter Integer(const char* name, int Options::*member, int low, int high)
{
  return [=](Options& options, const std::string& value)
  { options.*member = static_cast<int>(ParseInteger(name, value, low, high)); };
}

Setter Number(const char* name, double Options::*member, double low, double high)
{
  return [=](Options& options, const std::string& value)
  { options.*member = ParseNumber(name, value, low, high); };
}

Setter Choice(const char* name, std::string Options::*member, std::vector<std::string> choices)
{
  return [=](Options& options, const std::string& value)
  { options.*member = ParseChoice(name, value, choices); };
}

Setter Flag(bool Options::*member, bool value = true)
{
  return [=](Options& options, const std::string&) { options.*member = value; };
}

void SetDimension(Options& options, const std::string& value)
{
  options.Dimension = ParseChoice("--dimension", value, { "3", "6" }) == "3" ? 3 : 6;
}

void SetPoints(Options& options, const std::string& value)
{
  // Too few points are no matter of usage: RemeshSurface() says what is wrong with them.
  using Limits = std::numeric_limits<long long>;
  options.NumberOfPoints = ParseInteger("--points", value, Limits::min(), Limits::max());
}

void SetMaximumPoints(Options& options, const std::string& value)
{
  options.MaximumPoints =
    ParseInteger("--max-points", value, 4, std::numeric_limits<long long>::max());
}

void AddCoordinates(Options& options, const std::string& value)
{
  options.Coordinates.push_back(ParseCoordinates("--coordinates", value));
}

std::vector<Option> MakeTable()
{
  using Limits = std::numeric_limits<int>;
  return {
    { "--points", "N",
      "Number of points of the new mesh, at least 4, those on features among them. Default 10000.",
      SetPoints },
    { "--tolerance", "T",
      "Instead of --points: as many as keep mesh and surface within this distance of each other, a "
      "fraction of the bounding-box diagonal, 0 to 1. Not with --initial-sites. Default 0: off.",
      Number("--tolerance", &Options::Tolerance, 0.0, 1.0) },
    { "--max-points", "N", "The most points that --tolerance may take, from 4. Default 1000000.",
      SetMaximumPoints },
    { "--anisotropy", "S",
      "How much the normals count, as a fraction of the bounding-box diagonal, 0 to 1. "
      "Default 0.04; usual are 0.02 to 0.1; 0 is isotropic.",
      Number("--anisotropy", &Options::Anisotropy, 0.0, 1.0) },
    { "--no-features", "", "Do not keep creases, corners, borders and non-manifold edges.",
      Flag(&Options::PreserveFeatures, false) },
    { "--feature-angle", "DEG",
      "Creases are edges whose facets' normals differ by more than this angle in degrees, "
      "0 to 180. Default 35.",
      Number("--feature-angle", &Options::FeatureAngle, 0.0, 180.0) },
    { "--labels", "ARRAY",
      "Also keep the edges between different values of this cell array, but for --no-features.",
      Text("--labels", &Options::Labels) },
    { "--density", "ARRAY",
      "Point array of numbers above 0: the spacing of the points follows its power of -1/4.",
      Text("--density", &Options::Density) },
    { "--max-extra-points", "K",
      "How many more points the mesh may have where it cannot be like the surface otherwise; 0: "
      "none, -1: unlimited. Default -2: one percent of the points.",
      Integer("--max-extra-points", &Options::MaximumExtraPoints, -2, Limits::max()) },
    { "--lloyd", "K", "Lloyd iterations, 0 to 100000. Default 5.",
      Integer("--lloyd", &Options::LloydIterations, 0, 100000) },
    { "--newton", "K", "Quasi-Newton iterations after them, 0 to 100000. Default 30.",
      Integer("--newton", &Options::NewtonIterations, 0, 100000) },
    { "--seed", "I", "Seed of the random numbers. Default 0.",
      Integer("--seed", &Options::Seed, Limits::min(), Limits::max()) },
    { "--threads", "T", "Threads, 0 to 1024. Default 0: all. The result does not depend on it.",
      Integer("--threads", &Options::Threads, 0, 1024) },
    { "--backend", "B",
      "sequential, stdthread, tbb or automatic (default). The result does not depend on it.",
      Choice("--backend", &Options::Backend, { "sequential", "stdthread", "tbb", "automatic" }) },
    { "--dimension", "D", "6: position and normal (default); 3: position alone, isotropic.",
      SetDimension },
    { "--normals", "ARRAY",
      "Point array with the normals; 'none': estimate them. Default: the active normals, else "
      "estimated.",
      Text("--normals", &Options::Normals) },
    { "--normal-smoothing", "K",
      "Smoothing passes over estimated normals, -1 to 10000. Default -1: over 1.5 times "
      "the mean spacing of the new points, farther where the anisotropy is too high for them, not "
      "at all where there are few bends but along one direction.",
      Integer("--normal-smoothing", &Options::NormalSmoothingPasses, -1, 10000) },
    { "--embedding-array", "NAME",
      "Point array that replaces position and normal: the place of each point in R^d.",
      Text("--embedding-array", &Options::EmbeddingArray) },
    { "--coordinates", "NAME=SCALE",
      "Append a point array, times a scale, to position and normal. Can be repeated.",
      AddCoordinates },
    { "--initial-sites", "F",
      "Start from the points of this file; their number replaces --points. Features are not kept.",
      Text("--initial-sites", &Options::InitialSites) },
    { "--merge-tolerance", "T",
      "Merge input points closer than this fraction of the bounding-box diagonal, 0 to 0.1. "
      "Default 0: equal points, and ends of sides that are nothing but rounding.",
      Number("--merge-tolerance", &Options::MergeTolerance, 0.0, 0.1) },
    { "--sampling", "M", "How the first sites are drawn: random or stratified (default).",
      Choice("--sampling", &Options::Sampling, { "random", "stratified" }) },
    { "--no-coarse-start", "",
      "Do not grow the first sites from a quarter as many that take a few iterations first.",
      Flag(&Options::CoarseStart, false) },
    { "--placement", "P",
      "Where the points are put: centroid of their cells, surface (the point closest to that), "
      "quadric (where the planes of the cell's triangles are closest), or fit (default): where all "
      "triangles together are closest to the surface.",
      Choice("--placement", &Options::Placement, { "centroid", "surface", "quadric", "fit" }) },
    { "--no-distance", "",
      "Do not measure how far mesh and surface are from each other, which the report tells else.",
      Flag(&Options::MeasureDistance, false) },
    { "--cells", "F.vtp", "Write the restricted Voronoi cells.", Text("--cells", &Options::Cells) },
    { "--sites", "F.vtp", "Write the sites.", Text("--sites", &Options::Sites) },
    { "--edges", "F.vtp",
      "Write the borders of cells and surface, creases that are kept and non-manifold edges.",
      Text("--edges", &Options::Edges) },
    { "--embedded-surface", "F.vtp",
      "Write the input with its embedding, the point array Embedding: what the mesh is made on, "
      "but for creases that are kept, which have a normal for each side there.",
      Text("--embedded-surface", &Options::EmbeddedSurface) },
    { "--convergence", "F.csv", "Write energy, gradient, step length and time of each iteration.",
      Text("--convergence", &Options::Convergence) },
    { "--report", "F.json",
      "Write parameters, sizes, faults, distances, energy, times, memory and warnings.",
      Text("--report", &Options::Report) },
    { "--quiet", "", "No progress bar, no warnings.", Flag(&Options::Quiet) },
    { "--version", "", "Print the version and stop.", Flag(&Options::Version) },
    { "--help", "", "Print this text and stop; also -h.", Flag(&Options::Help) },
  };
}

const std::vector<Option>& Table()
{
  static const std::vector<Option> table = MakeTable();
  return table;
}

const Option& FindOption(const std::string& name)
{
  for (const Option& option : Table())
  {
    if (option.Name == name)
    {
      return option;
    }
  }
  UsageError("unknown option '" + name + "'");
}

void SetFiles(Options& options, const std::vector<std::string>& files)
{
  if (files.size() < 2)
  {
    UsageError("needs an input file and an output file");
  }
  if (files.size() > 2)
  {
    UsageError("takes one input file and one output file, '" + files[2] + "' is too much");
  }
  options.Input = files[0];
  options.Output = files[1];
}

/** `text` from column 30 on, broken before column 90. */
void AppendWrapped(std::string& help, const std::string& text)
{
  constexpr std::size_t indent = 30;
  constexpr std::size_t width = 90;
  std::istringstream words(text);
  std::size_t column = indent;
  for (std::string word; words >> word; column += word.size() + 1)
  {
    if (column + word.size() > width)
    {
      help.back() = '\n';
      help.append(indent, ' ');
      column = indent;
    }
    help += word + ' ';
  }
  help.back() = '\n';
}
} // namespace

Options ParseCommandLine(const std::vector<std::string>& arguments)
{
  Options options;
  std::vector<std::string> files;
  bool onlyFiles = false;
  for (std::size_t i = 0; i < arguments.size() && !options.Help && !options.Version; ++i)
  {
    const std::string& argument = arguments[i];
    if (onlyFiles || argument.size() < 2 || argument[0] != '-')
    {
      files.push_back(argument);
      continue;
    }
    if (argument == "--")
    {
      onlyFiles = true;
      continue;
    }
    const std::size_t sign = argument.find('=');
    const bool attached = sign != std::string::npos;
    const std::string name = argument == "-h" ? "--help" : argument.substr(0, sign);
    const Option& option = FindOption(name);
    std::string value = attached ? argument.substr(sign + 1) : std::string();
    if (option.Value.empty() && attached)
    {
      UsageError(option.Name + " takes no value");
    }
    if (!option.Value.empty() && !attached)
    {
      const bool missing = i + 1 == arguments.size() || arguments[i + 1].rfind("--", 0) == 0;
      if (missing)
      {
        UsageError(option.Name + " needs a value");
      }
      value = arguments[++i];
    }
    option.Set(options, value);
  }
  if (!options.Help && !options.Version)
  {
    SetFiles(options, files);
  }
  return options;
}

std::string HelpText()
{
  std::string help = "Usage: remesh_surface INPUT OUTPUT [options]\n\n"
                     "Remeshes a surface with a given number of points, adapted to its curvature.\n"
                     "Reads and writes .vtp, .vtk, .ply, .stl and .obj.\n\n";
  for (const Option& option : Table())
  {
    std::string left = "  " + option.Name + (option.Value.empty() ? "" : " " + option.Value);
    left.resize(std::max<std::size_t>(left.size(), 29), ' ');
    help += left + ' ';
    AppendWrapped(help, option.Text);
  }
  help += "\nExit status: 0 done, 1 not possible (one sentence says why, and no file is left), "
          "2 wrong usage.\n";
  return help;
}
