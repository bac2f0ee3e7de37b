#include "RankRun.h"

#include "Measure.h"
#include "Optimization/Sampling.h"
#include "Run/MeshDistance.h"
#include "Run/RankWork.h"
#include "RunParts.h"
#include "Surfaces.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <type_traits>

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace remesh::benchmark
{
namespace
{
constexpr int mostRanks = 4;

/** What a process took for its part of a run. */
struct RankCost
{
  double processor = 0.0;
  double megabytes = 0.0; ///< peak
  double sent = 0.0;      ///< bytes: of the first to all, of others to it
};

/** Processes that are joined by sockets. */
class SocketRanks : public Ranks
{
public:
  /** @param sockets to each rank; -1 to itself. */
  SocketRanks(int own, std::vector<int> sockets)
    : m_own(own)
    , m_sockets(std::move(sockets))
    , m_sent(m_sockets.size(), 0.0)
  {
  }

  int count() const override { return static_cast<int>(m_sockets.size()); }
  int own() const override { return m_own; }

  void send(int rank, const Packet& packet) override
  {
    const std::size_t size = packet.bytes().size();
    this->move(rank, ::write, &size, sizeof(size));
    this->move(rank, ::write, packet.bytes().data(), size);
    m_sent[static_cast<std::size_t>(rank)] += static_cast<double>(sizeof(size) + size);
  }

  Packet receive(int rank) override
  {
    std::size_t size = 0;
    this->move(rank, ::read, &size, sizeof(size));
    std::vector<char> bytes(size);
    this->move(rank, ::read, bytes.data(), size);
    return Packet(std::move(bytes));
  }

  /** Bytes so far. */
  double sentTo(int rank) const { return m_sent[static_cast<std::size_t>(rank)]; }
  double sentToAll() const { return std::accumulate(m_sent.begin(), m_sent.end(), 0.0); }

private:
  /** Reads or writes all of it. */
  template <class Transfer, class Bytes>
  void move(int rank, const Transfer& transfer, Bytes* bytes, std::size_t size) const
  {
    using Byte = std::conditional_t<std::is_const_v<Bytes>, const char, char>;
    for (auto* next = reinterpret_cast<Byte*>(bytes); size > 0;)
    {
      const ssize_t moved = transfer(m_sockets[rank], next, size);
      if (moved <= 0)
      {
        throw std::runtime_error("process " + std::to_string(rank) + " is gone");
      }
      next += moved;
      size -= static_cast<std::size_t>(moved);
    }
  }

  int m_own;
  std::vector<int> m_sockets;
  std::vector<double> m_sent;
};

/** What is divided, one after the other; others are dismissed after each. */
constexpr const char* stages[] = { "", "distance_" };

/** Works until it is dismissed, and tells what that took. Returns an exit status. */
int beOther(SocketRanks& ranks, const Settings& settings)
{
  try
  {
    for ([[maybe_unused]] const char* stage : stages)
    {
      RankCost cost;
      cost.sent = -ranks.sentTo(Ranks::first);
      inScope(
        settings, [&]() { cost.processor = timed([&]() { workForFirst(ranks); }).processor; });
      cost.megabytes = peakMegabytes();
      cost.sent += ranks.sentTo(Ranks::first);
      Packet packet;
      packet.add(cost);
      ranks.send(Ranks::first, packet);
    }
    return EXIT_SUCCESS;
  }
  catch (const std::exception&)
  {
    return EXIT_FAILURE; // the first finds it gone
  }
}

/** A socket from each rank to each other one; -1 to itself. */
std::vector<std::vector<int>> joinAll(int ranks)
{
  const auto count = static_cast<std::size_t>(ranks);
  std::vector<std::vector<int>> sockets(count, std::vector<int>(count, -1));
  for (std::size_t rank = 0; rank < count; ++rank)
  {
    for (std::size_t other = 0; other < rank; ++other)
    {
      int ends[2];
      if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) != 0)
      {
        throw std::runtime_error("cannot make a socket");
      }
      sockets[rank][other] = ends[0];
      sockets[other][rank] = ends[1];
    }
  }
  return sockets;
}

/** One's own sockets; closes the others, so that a process that ends is missed. */
SocketRanks keepOwn(int own, const std::vector<std::vector<int>>& sockets)
{
  for (std::size_t rank = 0; rank < sockets.size(); ++rank)
  {
    for (const int socket : sockets[rank])
    {
      if (static_cast<int>(rank) != own && socket >= 0)
      {
        close(socket);
      }
    }
  }
  return SocketRanks(own, sockets[static_cast<std::size_t>(own)]);
}

/** Starts the other processes. */
SocketRanks startOthers(const RankRun& run, const Settings& settings)
{
  const std::vector<std::vector<int>> sockets = joinAll(run.ranks);
  for (int rank = 1; rank < run.ranks; ++rank)
  {
    const pid_t child = fork();
    if (child < 0)
    {
      throw std::runtime_error("cannot start a process");
    }
    if (child == 0)
    {
      SocketRanks ranks = keepOwn(rank, sockets);
      _exit(beOther(ranks, settings));
    }
  }
  return keepOwn(Ranks::first, sockets);
}

/** A number that tells one sequence of bytes from another (FNV-1a). */
std::uint64_t digestOf(const std::vector<double>& values)
{
  const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
  return std::accumulate(bytes, bytes + values.size() * sizeof(double), 0xcbf29ce484222325ULL,
    [](std::uint64_t digest, unsigned char byte) { return (digest ^ byte) * 0x100000001b3ULL; });
}

/** What a stage of a run printed. */
struct RankReport
{
  unsigned long long digest = 0; ///< of what it made
  int sharings = 0;              ///< evaluations or the like, of which bytes are told on average
  double wall = 0.0;
  std::vector<RankCost> costs; ///< of each rank
};

/** Takes it from what was printed. */
bool takeReport(FILE* answer, int ranks, RankReport& report)
{
  bool complete =
    std::fscanf(answer, "%llu %d %lf", &report.digest, &report.sharings, &report.wall) == 3;
  for (int rank = 0; rank < ranks; ++rank)
  {
    RankCost cost;
    complete = complete &&
      std::fscanf(answer, "%lf %lf %lf", &cost.processor, &cost.megabytes, &cost.sent) == 3;
    report.costs.push_back(cost);
  }
  return complete;
}

/** Of each stage. */
std::vector<RankReport> reportsOf(const RankRun& run, const Settings& settings)
{
  const std::string line = commandLine({ settings.self, "--threads",
    std::to_string(settings.threads), "--lloyd", std::to_string(settings.lloydIterations),
    "--newton", std::to_string(settings.newtonIterations), "--rank-run", std::to_string(run.ranks),
    std::to_string(run.triangles), std::to_string(run.points) });
  FILE* const answer = popen(line.c_str(), "r");
  if (!answer)
  {
    throw std::runtime_error("cannot start a shell");
  }
  std::vector<RankReport> reports(std::size(stages));
  bool complete = true;
  for (RankReport& report : reports)
  {
    complete = complete && takeReport(answer, run.ranks, report);
  }
  if (pclose(answer) != 0 || !complete)
  {
    throw std::runtime_error("the command failed: " + line);
  }
  return reports;
}

double largestOfOthers(const RankReport& report, double RankCost::*entry)
{
  double largest = 0.0;
  for (std::size_t rank = 1; rank < report.costs.size(); ++rank)
  {
    largest = std::max(largest, report.costs[rank].*entry);
  }
  return largest;
}

/** With the stage before their names, and the number of ranks behind them. */
Figures figuresOf(const std::string& stage, const RankReport& report)
{
  const std::size_t count = report.costs.size();
  Figures figures;
  const auto add = [&](const char* name, double value, const char* unit) {
    figures.push_back({ stage + name + "_" + std::to_string(count), value, unit });
  };
  add("wall", report.wall, "s");
  add("first", report.costs[0].processor, "s");
  add("memory", report.costs[0].megabytes, "MB");
  if (count > 1)
  {
    const double back = std::accumulate(report.costs.begin() + 1, report.costs.end(), 0.0,
      [](double sum, const RankCost& cost) { return sum + cost.sent; });
    add("other", largestOfOthers(report, &RankCost::processor), "s");
    add("memory_other", largestOfOthers(report, &RankCost::megabytes), "MB");
    add("sent", 1e-6 * report.costs[0].sent / report.sharings, "MB");
    add("back", 1e-6 * back / report.sharings, "MB");
  }
  return figures;
}

Figures rankRunsOnce(RankRun run, const Settings& settings)
{
  Figures figures;
  std::vector<RankReport> alone;
  for (run.ranks = 1; run.ranks <= mostRanks; run.ranks *= 2)
  {
    const std::vector<RankReport> reports = reportsOf(run, settings);
    alone = run.ranks == 1 ? reports : alone;
    for (std::size_t k = 0; k < reports.size(); ++k)
    {
      if (reports[k].digest != alone[k].digest)
      {
        throw std::runtime_error(
          std::to_string(run.ranks) + " processes make other bytes than one");
      }
      const Figures some = figuresOf(stages[k], reports[k]);
      figures.insert(figures.end(), some.begin(), some.end());
    }
  }
  return figures;
}
}

Figures rankRuns(const RankRun& run, const Settings& settings, Figures& scaled)
{
  const Figures figures = repeated(settings, [&]() { return rankRunsOnce(run, settings); });
  for (const std::string stage : stages)
  {
    for (int count = 2; count <= mostRanks; count *= 2)
    {
      const std::string ranks = "_" + std::to_string(count);
      const double busiest =
        std::max(value(figures, stage + "first" + ranks), value(figures, stage + "other" + ranks));
      scaled.push_back(
        { stage + "processor" + ranks, value(figures, stage + "first_1") / busiest, "1" });
      if (count <= static_cast<int>(std::thread::hardware_concurrency()))
      {
        scaled.push_back({ stage + "wall" + ranks,
          value(figures, stage + "wall_1") / value(figures, stage + "wall" + ranks), "1" });
      }
    }
  }
  return figures;
}

namespace
{
/** Prints a stage (see takeReport), with what the others tell of it when they are dismissed. */
void printStage(SocketRanks& ranks, const std::vector<double>& made, int sharings,
  const Elapsed& elapsed, double sent)
{
  dismissOthers(ranks);
  std::printf("%llu %d %.9g\n%.9g %.9g %.9g\n", static_cast<unsigned long long>(digestOf(made)),
    sharings, elapsed.wall, elapsed.processor, peakMegabytes(), sent);
  for (int rank = 1; rank < ranks.count(); ++rank)
  {
    Packet packet = ranks.receive(rank);
    RankCost cost;
    packet.take(cost);
    std::printf("%.9g %.9g %.9g\n", cost.processor, cost.megabytes, cost.sent);
  }
}

void optimizeOnRanks(const RankRun& run, const Settings& settings, SocketRanks& ranks)
{
  const EmbeddedSurface surface = gaussMapped(bumpyTorus(run.triangles).data);
  Optimization optimization(surface);
  optimization.voronoi.divideAmong(&ranks);
  orThrow(
    sampleSurface(surface, run.points, { SamplingMethod::Stratified, 0 }, optimization.sites));
  Elapsed elapsed;
  double sent = 0.0;
  inScope(settings,
    [&]()
    {
      orThrow(optimization.voronoi.integrate(optimization.sites, RunControl(), optimization.sums));
      sent -= ranks.sentToAll(); // the surface, once
      elapsed = timed(
        [&]() { optimization.run(surface, settings.lloydIterations, settings.newtonIterations); });
      sent += ranks.sentToAll();
    });
  const int evaluations = optimization.voronoi.evaluations();
  sent *= evaluations / (evaluations - 1.0); // as for the first one, too
  printStage(ranks, optimization.sites.coordinates, evaluations, elapsed, sent);
}

/** As far as distances need it. */
SurfaceMesh meshOf(vtkPolyData* data)
{
  SurfaceMesh mesh;
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    mesh.points.emplace_back(data->GetPoint(point));
  }
  std::vector<Triple> facets;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    data->GetCellPoints(cell, size, ids);
    facets.push_back(
      { static_cast<Index>(ids[0]), static_cast<Index>(ids[1]), static_cast<Index>(ids[2]) });
  }
  mesh.facetPoints = std::move(facets);
  return mesh;
}

/** The mesh that is compared is the same torus with as many points as there are sites. */
void compareOnRanks(const RankRun& run, const Settings& settings, SocketRanks& ranks)
{
  const SurfaceMesh surface = meshOf(bumpyTorus(run.triangles).data);
  const SurfaceMesh made = meshOf(bumpyTorus(2.0 * run.points).data);
  RemeshResult result;
  result.placement.positions = made.points;
  result.dual.triangles = made.facetPoints;
  Elapsed elapsed;
  double sent = -ranks.sentToAll();
  inScope(settings,
    [&]()
    {
      elapsed = timed([&]() { orThrow(findDistance(surface, &ranks, RunControl(), result)); });
      sent += ranks.sentToAll();
    });
  const TwoSidedDistance& distance = result.distance.value();
  std::vector<double> found;
  for (const OneSidedDistance& side : { distance.forward, distance.backward })
  {
    found.insert(found.end(), { side.area, side.mean, side.rms, side.maximum });
  }
  printStage(ranks, found, 1, elapsed, sent);
}
}

void runOnRanks(const RankRun& run, const Settings& settings)
{
  SocketRanks ranks = startOthers(run, settings); // while there is little that they would copy
  optimizeOnRanks(run, settings, ranks);
  compareOnRanks(run, settings, ranks);
  for (int rank = 1; rank < run.ranks; ++rank)
  {
    wait(nullptr);
  }
}
}
