// Runs a fuzz driver without libFuzzer.
//   Driver [-runs=N] [-seed=S] [-seconds=T]   random inputs S, S + 1, ..., for at most T seconds
//   Driver file...                            these inputs, as libFuzzer writes them

#include "FuzzSupport.h"

#include "Support/Random.h"

#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

namespace
{
volatile unsigned long current = 0;

/** Says which input it was, then lets the signal do its work. */
void tellInput(int signal)
{
  std::fprintf(stderr, "The input was -runs=1 -seed=%lu\n", current);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

std::vector<std::uint8_t> randomBytes(unsigned long seed)
{
  const auto size = static_cast<std::size_t>(remesh::uniform01(seed, 0, 1) * 600.0);
  std::vector<std::uint8_t> bytes(size);
  for (std::size_t k = 0; k < size; ++k)
  {
    bytes[k] = static_cast<std::uint8_t>(remesh::uniform01(seed, k, 2) * 256.0);
  }
  return bytes;
}
}

int main(int argc, char* argv[])
{
  unsigned long runs = 1000;
  unsigned long seed = 0;
  double seconds = std::numeric_limits<double>::infinity();
  bool files = false;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    const std::string value = argument.substr(argument.find('=') + 1);
    if (argument.rfind("-runs=", 0) == 0)
    {
      runs = std::stoul(value);
    }
    else if (argument.rfind("-seed=", 0) == 0)
    {
      seed = std::stoul(value);
    }
    else if (argument.rfind("-seconds=", 0) == 0)
    {
      seconds = std::stod(value);
    }
    else
    {
      files = true;
      std::ifstream file(argument, std::ios::binary);
      const std::vector<char> bytes{ std::istreambuf_iterator<char>(file), {} };
      LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    }
  }
  if (files)
  {
    return EXIT_SUCCESS;
  }
  std::signal(SIGABRT, tellInput);
  std::signal(SIGSEGV, tellInput);
  std::signal(SIGFPE, tellInput);
  std::signal(SIGTERM, tellInput); // a time limit
  const auto start = std::chrono::steady_clock::now();
  unsigned long done = 0;
  for (; done < runs; ++done)
  {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    if (elapsed.count() > seconds)
    {
      break;
    }
    current = seed + done;
    const std::vector<std::uint8_t> bytes = randomBytes(current);
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
  std::printf("%lu inputs from seed %lu\n", done, seed);
  if (fuzz::cases() > 0)
  {
    std::printf("%lu cases\n", fuzz::cases());
  }
  return EXIT_SUCCESS;
}
