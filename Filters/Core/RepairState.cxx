#include "RepairState.h"

#include "Support/SortUnique.h"

#include <algorithm>
#include <numeric>

namespace remesh
{
namespace
{
constexpr double shrinking = 0.9;     // of the failing cells' mass, too, is to come nearer
constexpr double smallestMass = 1e-4; // of the mean cell's: a hundredth of the sites' spacing
constexpr double fewFailures = 0.03;  // of the vertices, with parts of cells, for that
}

void allowSettling(Repair& repair)
{
  repair.adjustments = std::min(repair.adjustments, settledAdjustments);
}

SharedSites shareSites(const RemeshResult& result, Repair& repair)
{
  const SharedSites& last = repair.atHand;
  if (!last || last->fixed != result.sites.fixed || last->coordinates != result.sites.coordinates)
  {
    repair.atHand = std::make_shared<const Sites>(result.sites);
  }
  return repair.atHand;
}

void keepState(const RemeshResult& result, Repair& repair)
{
  repair.best = { shareSites(result, repair), result.featureSites, repair.settled, repair.counts };
}

void restoreState(Repair& repair, RemeshResult& result)
{
  result.sites = *repair.best.sites;
  result.featureSites = repair.best.featureSites;
  repair.settled = repair.best.settled;
  repair.counts = repair.best.counts;
}

Offset leastVertices(const RemeshResult& result)
{
  return result.components.count() - (result.sites.count() - result.sites.fixed);
}

Offset wantedVertices(
  const RemeshOptions& options, const RemeshResult& result, const Repair& repair)
{
  return options.exactNumber
    ? std::max(options.numberOfSites, leastVertices(result) + repair.leastFree) +
      repair.counts.extraPoints
    : result.components.count();
}

Score scoreOf(const RemeshOptions& options, const RemeshResult& result, const Repair& repair)
{
  const Offset beyond = result.components.count() - options.numberOfSites;
  const Offset tooMany = result.components.count() - wantedVertices(options, result, repair);
  const Certificate& certificate = result.topology.certificate;
  return {
    options.exactNumber ? std::max({ Offset(0), -beyond, tooMany }) : 0,
    !certificate.holds(),
    options.exactNumber ? std::max(Offset(0), beyond - repair.counts.extraPoints) : 0,
    certificate.violations() + repair.counts.flips,
    repair.counts.strays,
  };
}

std::vector<Index> failingComponents(const Certificate& certificate)
{
  std::vector<Index> failing = certificate.cells;
  for (const auto& [a, b] : certificate.edges)
  {
    failing.insert(failing.end(), { a, b });
  }
  for (const Triple& vertex : certificate.vertices)
  {
    failing.insert(failing.end(), vertex.begin(), vertex.end());
  }
  sortUnique(failing);
  return failing;
}

namespace
{
/** Of these cells together. */
double failingMass(const RemeshResult& result)
{
  const std::vector<Index> failing = failingComponents(result.topology.certificate);
  return std::accumulate(failing.begin(), failing.end(), 0.0,
    [&](double sum, Index component) { return sum + result.components.mass[component]; });
}

/**
 * Whether the failures have become fewer than ever, or are closed in on: a handle far smaller than
 * the cells takes many sites before it is seen, but one that is nothing against them is never
 * reached. Where failures are many, that is left to the last stages: the first ones may do with
 * fewer sites. Beyond the number they are to become fewer against the cells: where nothing helps,
 * their cells shrink for ever.
 */
bool comesNearer(const RemeshResult& result, Repair& repair)
{
  const Offset failures = result.topology.certificate.violations();
  const bool areFewer = failures < repair.fewestFailures;
  repair.fewestFailures = std::min(repair.fewestFailures, failures);
  if (repair.stage == RepairStage::BeyondNumber)
  {
    const double share =
      static_cast<double>(failures) / static_cast<double>(result.components.count());
    const bool isLeast = share < repair.failingShare;
    repair.failingShare = std::min(repair.failingShare, share);
    return areFewer || isLeast;
  }
  const Offset parts = result.components.count() - result.numberOfVertexSites();
  const bool areFew = static_cast<double>(failures + parts) <=
    fewFailures * static_cast<double>(result.components.count());
  const bool sizeCounts =
    repair.stage >= RepairStage::Persist || (repair.stage == RepairStage::Refine && areFew);
  if (!sizeCounts)
  {
    return areFewer;
  }
  const double mass = failingMass(result);
  const std::vector<double>& all = result.components.mass;
  const double mean =
    std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
  const bool shrink = mass < shrinking * repair.failingMass && mass > smallestMass * mean;
  repair.failingMass = areFewer || shrink ? mass : repair.failingMass;
  return areFewer || shrink;
}
}

void keepIfBest(const RemeshOptions& options, const RemeshResult& result, Repair& repair)
{
  if (const Score score = scoreOf(options, result, repair); score < repair.scoreOfBest)
  {
    repair.scoreOfBest = score;
    keepState(result, repair);
  }
}

void keepBest(const RemeshOptions& options, const RemeshResult& result, Repair& repair)
{
  repair.idleRounds = comesNearer(result, repair) ? 0 : repair.idleRounds + 1;
  keepIfBest(options, result, repair);
}
}
