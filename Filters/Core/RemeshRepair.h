/**
 * @file RemeshRepair.h
 * @brief Changes sites where their dual is not what it should be.
 */
#ifndef remesh_RemeshRepair_h
#define remesh_RemeshRepair_h

#include "Placement/FlipRepair.h"
#include "RemeshTask.h"

#include <limits>
#include <memory>
#include <tuple>

namespace remesh
{
/** What repairs have done to a state of the sites. */
struct RepairCounts
{
  Index addedSites = 0; ///< about the last ones there are
  Offset extraPoints = 0;
  Offset flips = 0; ///< flipped triangles; 0 as long as the topology is being repaired
};

/** A copy of all sites, held once for all that need it. */
using SharedSites = std::shared_ptr<const Sites>;

/** What a state of the sites is made of. */
struct SiteState
{
  SharedSites sites;
  Stations stations;
  FeatureSites featureSites;
  SharedSites settled;
  RepairCounts counts;
};

/** How the topology is repaired, one after the other. */
enum class RepairStage
{
  Refine,       ///< add sites, take away others
  CutTips,      ///< now and then leave thin tips to the cells around them
  BeyondNumber, ///< add sites
  GivenUp
};

/**
 * How many vertices there are too many or too few, whether the certificate fails, how many vertices
 * more than asked for features and parts of cells take, and how many failures and flipped triangles
 * there are; lower is better. The number goes before the failures: as long as there are any, more
 * points that do not mend all of them are of no use.
 */
using Score = std::tuple<Offset, bool, Offset, Offset>;

const Score worstScore{ std::numeric_limits<Offset>::max(), true, 0, 0 };

/** What was mended how often, each with its own bound, and the best state so far. */
struct Repair
{
  bool othersStay = false; ///< only sites touched may change, from the first on
  int refinements = 0;
  int adjustments = 0;
  RepairStage stage = RepairStage::Refine;
  int rounds = 0;     ///< in this stage
  int idleRounds = 0; ///< in this stage, since one that came nearer than all before
  Offset fewestFailures = std::numeric_limits<Offset>::max();
  /** Of the cells that failed when it last came nearer, at first, while they were few. */
  double failingMass = std::numeric_limits<double>::infinity();
  int flipRounds = 0;
  std::vector<Offset> flipsBefore; ///< of these rounds, flipped triangles

  SharedSites atHand;  ///< the last ones that were shared
  SharedSites settled; ///< before the first change that no Lloyd's steps followed; none as yet
  RepairCounts counts;
  SiteState best;
  Score scoreOfBest = worstScore;
};

/** The result's sites as they are now. */
SharedSites shareSites(const RemeshResult& result, Repair& repair);

/** Remembers the result's sites, whether or not they are the best so far. */
void keepState(const RemeshResult& result, Repair& repair);
void restoreState(Repair& repair, RemeshResult& result);

Score scoreOf(const RemeshOptions& options, const RemeshResult& result, const Repair& repair);

/**
 * The flipped triangles of the cells' centroids that these steps do not turn back: the dual's where
 * no edges turn. Those without a height are not among them: turned edges mend them.
 */
std::vector<Index> flippedTriangles(
  const Task& task, FlipSteps steps, const RunControl& control, const RemeshResult& result);

/**
 * Mends the first of these that is wrong: cells that reach a curve between its sites, the topology,
 * the number of vertices, flipped triangles.
 *
 * @param result with the diagram and dual of its sites, which change.
 * @return the number of sites touched; 0 if there is nothing to mend that can be.
 */
Index mend(const Task& task, const RunControl& control, Repair& repair, RemeshResult& result);

/** Whether the last sites touched are to be the only ones that change. */
bool othersMustStay(const Repair& repair);

/** Whether those around them are to be settled in the end instead. */
bool leavesUnsettled(const Repair& repair);
}

#endif
