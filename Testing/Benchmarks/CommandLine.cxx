#include "CommandLine.h"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace remesh::benchmark
{
namespace
{
/** The words of a command line, one after the other. */
class Words
{
public:
  explicit Words(const std::vector<std::string>& words)
    : m_words(words)
  {
  }

  bool more() const { return m_next < m_words.size(); }
  std::string next() { return m_words[m_next++]; }
  bool moreValues() const { return this->more() && m_words[m_next].rfind("--", 0) != 0; }

  std::string valueOf(const std::string& option)
  {
    if (!this->more())
    {
      throw std::invalid_argument(option + " needs a value");
    }
    return this->next();
  }

  double numberOf(const std::string& option, double least, double most)
  {
    const std::string text = this->valueOf(option);
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    if (text.empty() || *end || !(number >= least && number <= most))
    {
      throw std::invalid_argument(option + " cannot be '" + text + "'");
    }
    return number;
  }

  int countOf(const std::string& option, int least, int most)
  {
    const double number = this->numberOf(option, least, most);
    if (number != std::floor(number))
    {
      throw std::invalid_argument(option + " needs a whole number");
    }
    return static_cast<int>(number);
  }

private:
  const std::vector<std::string>& m_words;
  std::size_t m_next = 0;
};

void parseSetting(const std::string& option, Words& words, Settings& settings)
{
  if (option == "--quick")
  {
    settings.shrink = 100.0;
    settings.repetitions = 1;
  }
  else if (option == "--threads")
  {
    settings.threads = words.countOf(option, 1, 1024);
  }
  else if (option == "--repetitions")
  {
    settings.repetitions = words.countOf(option, 1, 1000);
  }
  else if (option == "--shrink")
  {
    settings.shrink = words.numberOf(option, 1.0, 1e3);
  }
  else if (option == "--lloyd")
  {
    settings.lloydIterations = words.countOf(option, 0, 1000000);
  }
  else if (option == "--newton")
  {
    settings.newtonIterations = words.countOf(option, 0, 1000000);
  }
  else if (option == "--data")
  {
    settings.data = words.valueOf(option);
  }
  else if (option == "--program")
  {
    settings.program = words.valueOf(option);
  }
  else
  {
    throw std::invalid_argument("there is no option " + option);
  }
}
}

CommandLine parseCommandLine(const std::vector<std::string>& arguments, const Settings& defaults)
{
  CommandLine line;
  line.settings = defaults;
  Words words(arguments);
  while (words.more())
  {
    const std::string option = words.next();
    if (option == "--help" || option == "--list")
    {
      (option == "--help" ? line.help : line.list) = true;
    }
    else if (option == "--json")
    {
      line.output = words.valueOf(option);
    }
    else if (option == "--case")
    {
      do
      {
        line.cases.push_back(words.valueOf(option));
      } while (words.moreValues());
    }
    else if (option == "--cost-of")
    {
      do
      {
        line.command.push_back(words.valueOf(option));
      } while (words.more());
    }
    else if (option == "--wide-run")
    {
      line.wide.triangles = words.countOf(option, 1, 1000000000);
      line.wide.points = words.countOf(option, 1, 1000000000);
      line.wide.dimension = words.countOf(option, 4, 1000000);
    }
    else if (option == "--metric-run" || option == "--bent-run")
    {
      line.metric.isBent = option == "--bent-run";
      line.metric.surfacePoints = words.countOf(option, 1, 1000000000);
      line.metric.points = words.countOf(option, 1, 1000000000);
    }
    else if (option == "--rank-run")
    {
      line.ranks.ranks = words.countOf(option, 1, 1024);
      line.ranks.triangles = words.countOf(option, 1, 1000000000);
      line.ranks.points = words.countOf(option, 1, 1000000000);
    }
    else
    {
      parseSetting(option, words, line.settings);
    }
  }
  return line;
}

std::string helpText(const Settings& defaults)
{
  return "remesh_benchmark [OPTION...]: measures the library; results go out as JSON.\n"
         "  --case NAME...    these cases alone; a NAME that ends with * stands for all it begins\n"
         "  --list            prints the cases\n"
         "  --json FILE       writes there, after each case, instead of to the standard output\n"
         "  --threads N       of all but scaling-threads (1)\n"
         "  --repetitions N   of which the medians are taken (3)\n"
         "  --lloyd N, --newton N   iterations (5, 30)\n"
         "  --shrink F        divides all sizes by F, on generated surfaces (1)\n"
         "  --quick           as --shrink 100 --repetitions 1: shows that it runs, not how fast\n"
         "  --data FOLDER     of armadillo.ply; without it, surfaces are generated (" +
    defaults.data +
    ")\n"
    "  --program FILE    remesh_surface (" +
    defaults.program + ")\n";
}
}
