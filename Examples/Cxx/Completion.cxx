#include "Completion.h"

#include "OptionTable.h"

namespace
{
std::string Joined(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : " ") + word;
  }
  return text;
}

/** "-n" and "--points". */
std::vector<std::string> NamesOf(const CLI::Option* option)
{
  std::vector<std::string> names;
  for (const std::string& letter : option->get_snames())
  {
    names.push_back("-" + letter);
  }
  names.push_back("--" + option->get_lnames().front());
  return names;
}

bool TakesValue(const CLI::Option* option)
{
  return !option->get_type_name().empty();
}

bool TakesFile(const CLI::Option* option)
{
  const std::string value = option->get_type_name();
  return value == "REFERENCE" || value == "F" || value.rfind("F.", 0) == 0;
}

/** The first sentence, with a backslash before each of `special`, and `quote` for "'". */
std::string Summary(const CLI::Option* option, const std::string& special, const std::string& quote)
{
  std::string text = option->get_description() + " ";
  text = text.substr(0, text.find(". "));
  text = text.substr(0, text.find_first_of(":;"));
  std::string quoted;
  for (const char c : text)
  {
    quoted += special.find(c) != std::string::npos ? "\\" : "";
    quoted += c == '\'' ? quote : std::string(1, c);
  }
  return quoted;
}

std::string Bash(const OptionTable& table)
{
  std::string all;
  std::string cases;
  for (const CLI::Option* option : table.GetOptions())
  {
    const std::vector<std::string> names = NamesOf(option);
    all += (all.empty() ? "" : " ") + Joined(names);
    if (TakesValue(option) && !TakesFile(option))
    {
      cases += "    " + names.front() + (names.size() > 1 ? " | " + names[1] : "") +
        ") compopt +o default; COMPREPLY=($(compgen -W '" + Joined(table.GetChoices(option)) +
        "' -- \"$current\")); return ;;\n";
    }
  }
  return "_remesh_surface()\n{\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}\n"
         "  # Of --option=value, bash makes three words.\n"
         "  if [ \"$current\" = = ]; then current=; fi\n"
         "  if [ \"$previous\" = = ]; then previous=${COMP_WORDS[COMP_CWORD - 2]}; fi\n"
         "  COMPREPLY=()\n"
         "  case $previous in\n" +
    cases +
    "  esac\n"
    "  case $current in\n"
    "    -*) COMPREPLY=($(compgen -W '" +
    all +
    "' -- \"$current\")) ;;\n"
    "  esac\n"
    "}\n"
    "# Without an answer: files, which bash itself completes, with blanks and quotes.\n"
    "complete -o default -F _remesh_surface remesh_surface\n";
}

std::string Zsh(const OptionTable& table)
{
  std::string text = "#compdef remesh_surface\n_arguments -s \\\n";
  for (const CLI::Option* option : table.GetOptions())
  {
    std::string action;
    if (TakesValue(option))
    {
      const std::string choices = Joined(table.GetChoices(option));
      action = ":" + option->get_type_name() + ":" +
        (TakesFile(option)    ? "_files"
            : choices.empty() ? " "
                              : "(" + choices + ")");
    }
    const std::vector<std::string> names = NamesOf(option);
    for (const std::string& name : names)
    {
      const bool repeats = name == "--coordinates";
      text += "  '" + (repeats ? "*" : "(" + Joined(names) + ")") + name +
        (TakesValue(option) ? (name.size() == 2 ? "+" : "=") : "") + "[" +
        Summary(option, "[]:\\", "'\\''") + "]" + action + "' \\\n";
    }
  }
  return text + "  '*:file:_files'\n";
}

std::string Fish(const OptionTable& table)
{
  std::string text;
  for (const CLI::Option* option : table.GetOptions())
  {
    text += "complete -c remesh_surface -l " + option->get_lnames().front();
    for (const std::string& letter : option->get_snames())
    {
      text += " -s " + letter;
    }
    const std::string choices = Joined(table.GetChoices(option));
    text += !TakesValue(option) ? ""
      : TakesFile(option)       ? " -r"
      : choices.empty()         ? " -x"
                                : " -x -a '" + choices + "'";
    text += " -d '" + Summary(option, "\\", "\\'") + "'\n";
  }
  return text;
}
} // namespace

std::string CompletionText(const std::string& shell)
{
  Options options;
  const OptionTable table(options);
  return shell == "bash" ? Bash(table) : shell == "zsh" ? Zsh(table) : Fish(table);
}
