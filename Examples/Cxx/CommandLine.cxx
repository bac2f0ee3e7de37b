#include "CommandLine.h"

#include "Failure.h"
#include "OptionTable.h"

#include <algorithm>
#include <numeric>
#include <sstream>

namespace
{
/** How many letters have to be added, taken or changed, or swapped with their neighbors. */
std::size_t Distance(const std::string& one, const std::string& other)
{
  const std::size_t width = other.size() + 1;
  std::vector<std::size_t> table((one.size() + 1) * width);
  std::iota(table.begin(), table.begin() + static_cast<std::ptrdiff_t>(width), 0);
  for (std::size_t i = 1; i <= one.size(); ++i)
  {
    table[i * width] = i;
    for (std::size_t j = 1; j <= other.size(); ++j)
    {
      const bool same = one[i - 1] == other[j - 1];
      const std::size_t here = i * width + j;
      table[here] = std::min(
        { table[here - width] + 1, table[here - 1] + 1, table[here - width - 1] + (same ? 0 : 1) });
      if (i > 1 && j > 1 && one[i - 1] == other[j - 2] && one[i - 2] == other[j - 1])
      {
        table[here] = std::min(table[here], table[here - 2 * width - 2] + 1);
      }
    }
  }
  return table.back();
}

/** "did you mean", or nothing. */
std::string Suggestion(const OptionTable& table, const std::string& wrong)
{
  std::string best;
  std::size_t least = wrong.size() / 3 + 1;
  for (const CLI::Option* option : table.GetOptions())
  {
    const std::string name = "--" + option->get_lnames().front();
    // A long word that is the start of an option is close to it, too.
    const bool starts = wrong.size() > 4 && name.rfind(wrong, 0) == 0;
    const std::size_t distance = starts ? 1 : Distance(wrong, name);
    if (wrong.size() > 3 && distance < least)
    {
      least = distance;
      best = name;
    }
  }
  return best.empty() ? "" : "; did you mean " + best + "?";
}

[[noreturn]] void UnknownOption(const OptionTable& table, const std::string& argument)
{
  const std::string name = argument.substr(0, argument.find('='));
  UsageError("unknown option '" + name + "'" + Suggestion(table, name));
}

/** `text` from column 31 on, broken before column 98. */
void AppendWrapped(std::string& help, const std::string& text)
{
  constexpr std::size_t indent = 31;
  constexpr std::size_t width = 98;
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

/** "-n, --points N" */
std::string LeftOf(const CLI::Option* option)
{
  const auto& letters = option->get_snames();
  const std::string type = option->get_type_name(); // of a flag, none
  return (letters.empty() ? "      " : "  -" + letters.front() + ", ") + "--" +
    option->get_lnames().front() + (type.empty() ? "" : " " + type);
}

/** Whether one of these words is among the options. */
bool Asks(const std::vector<std::string>& arguments, const std::vector<std::string>& words)
{
  const auto end = std::find(arguments.begin(), arguments.end(), "--");
  return std::find_first_of(arguments.begin(), end, words.begin(), words.end()) != end;
}

/** CLI11 takes the next word for what is empty behind an equality sign. */
void CheckEmptyValues(const std::vector<std::string>& arguments)
{
  const auto end = std::find(arguments.begin(), arguments.end(), "--");
  for (auto argument = arguments.begin(); argument != end; ++argument)
  {
    if (argument->rfind("--", 0) == 0 && argument->find('=') + 1 == argument->size())
    {
      UsageError(argument->substr(0, argument->size() - 1) + " needs a value that is not empty");
    }
  }
}

void Parse(OptionTable& table, std::vector<std::string> arguments)
{
  std::reverse(arguments.begin(), arguments.end()); // as CLI11 wants it
  try
  {
    table.GetApp().parse(arguments);
  }
  catch (const CLI::ArgumentMismatch& error)
  {
    const std::string text = error.what(); // "--points: 1 required", "quiet was given a ... flag"
    const std::string name = text.substr(0, text.find_first_of(": "));
    const bool isFlag = name.rfind("-", 0) != 0;
    UsageError(isFlag ? "--" + name + " takes no value" : name + " needs a value");
  }
  catch (const CLI::ParseError& error)
  {
    UsageError(error.what());
  }
}
} // namespace

void UsageError(const std::string& sentence)
{
  throw Failure(sentence + " (see --help)", EXIT_USAGE);
}

Options ParseCommandLine(const std::vector<std::string>& arguments)
{
  Options options;
  options.Help = Asks(arguments, { "-h", "--help" });
  options.Version = Asks(arguments, { "-V", "--version" });
  if (options.Help || options.Version)
  {
    return options;
  }
  OptionTable table(options);
  CheckEmptyValues(arguments);
  Parse(table, arguments);
  for (const std::string& argument : table.GetApp().remaining())
  {
    if (argument != "--")
    {
      UnknownOption(table, argument);
    }
  }
  return options;
}

std::string HelpText()
{
  std::string help =
    "Usage: remesh_surface INPUT OUTPUT [options]\n"
    "       remesh_surface INPUT... FOLDER [options]\n"
    "       remesh_surface INPUT... --output-pattern '{stem}-{points}.vtp' [options]\n"
    "       remesh_surface MESH --compare REFERENCE\n\n"
    "Remeshes a surface with a given number of points, adapted to its curvature.\n"
    "Reads .vtp, .vtk, .ply, .stl, .obj, .off, .mesh, .meshb, .vtu, .glb and .gltf, writes the\n"
    "first eight; .gz may follow. '-' is standard input or output.\n";
  Options options;
  const OptionTable table(options);
  std::string group;
  for (const CLI::Option* option : table.GetOptions())
  {
    help += option->get_group() == group ? "" : "\n" + option->get_group() + ":\n";
    group = option->get_group();
    std::string left = LeftOf(option);
    left.resize(std::max<std::size_t>(left.size(), 30), ' ');
    help += left + ' ';
    AppendWrapped(help, option->get_description());
  }
  help += "\nExit status: 0 done, 1 not possible (one sentence says why, and no file is left), "
          "2 wrong usage.\n";
  return help;
}
