#include "Measure.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkQuadricDecimation.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace remesh::benchmark
{
namespace
{
constexpr int calibrations = 5;

/** One word of a POSIX shell's command line. */
std::string quoted(const std::string& word)
{
  std::string text = "'";
  for (const char letter : word)
  {
    text += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  }
  return text + "'";
}

double seconds(const timeval& time)
{
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

double megabytes(const rusage& usage)
{
#ifdef __APPLE__
  return 1e-6 * static_cast<double>(usage.ru_maxrss);
#else
  return 1e-6 * 1024.0 * static_cast<double>(usage.ru_maxrss);
#endif
}
}

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double calibrate(vtkPolyData* surface, int points)
{
  std::vector<double> runs;
  for (int k = 0; k < calibrations; ++k)
  {
    vtkNew<vtkQuadricDecimation> decimation;
    decimation->SetInputData(surface);
    decimation->SetTargetReduction(
      1.0 - static_cast<double>(points) / static_cast<double>(surface->GetNumberOfPoints()));
    runs.push_back(timed([&]() { decimation->Update(); }).processor);
  }
  return median(runs);
}

std::string commandLine(const std::vector<std::string>& words)
{
  std::string line = "exec";
  for (const std::string& word : words)
  {
    line += ' ' + quoted(word);
  }
  return line;
}

double peakMegabytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return megabytes(usage);
}

Cost costOf(const std::string& self, const std::vector<std::string>& command)
{
  std::vector<std::string> words = { self, "--cost-of" };
  words.insert(words.end(), command.begin(), command.end());
  const std::string line = commandLine(words);
  FILE* const answer = popen(line.c_str(), "r");
  if (!answer)
  {
    throw std::runtime_error("cannot start a shell");
  }
  Cost cost;
  const int values = std::fscanf(
    answer, "%lf %lf %lf", &cost.elapsed.wall, &cost.elapsed.processor, &cost.megabytes);
  if (pclose(answer) != 0 || values != 3)
  {
    throw std::runtime_error("the command failed: " + line);
  }
  return cost;
}

int printCost(const std::vector<std::string>& command)
{
  std::vector<char*> words;
  for (const std::string& word : command)
  {
    words.push_back(const_cast<char*>(word.c_str())); // execvp does not change it
  }
  words.push_back(nullptr);
  rusage usage{};
  int status = 0;
  const Elapsed elapsed = timed(
    [&]()
    {
      const pid_t child = fork();
      if (child == 0)
      {
        execvp(words.front(), words.data());
        _exit(127);
      }
      status = child < 0 || wait4(child, &status, 0, &usage) != child ? -1 : status;
    });
  if (status != 0)
  {
    return EXIT_FAILURE;
  }
  std::printf("%.9g %.9g %.9g\n", elapsed.wall, seconds(usage.ru_utime) + seconds(usage.ru_stime),
    megabytes(usage));
  return EXIT_SUCCESS;
}
}
