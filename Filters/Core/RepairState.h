/**
 * @file RepairState.h
 * @brief What repairs of sites have tried and reached, and which state of the sites is the best.
 */
#ifndef remesh_RepairState_h
#define remesh_RepairState_h

#include "Delaunay/SitePruning.h"
#include "Remesh.h"

#include <limits>
#include <memory>
#include <tuple>
#include <vector>

namespace remesh
{
/** What repairs have done to a state of the sites. */
struct RepairCounts
{
  Index addedSites = 0; ///< about the last ones there are
  Offset extraPoints = 0;
  Offset flips = 0;  ///< flipped triangles; 0 as long as the topology is being repaired
  Offset strays = 0; ///< StrayTriangles.h; 0 as long as there are flipped ones to be repaired
};

/** A copy of all sites, held once for all that need it. */
using SharedSites = std::shared_ptr<const Sites>;

/** What a state of the sites is made of. */
struct SiteState
{
  SharedSites sites;
  FeatureSites featureSites;
  SharedSites settled;
  RepairCounts counts;
};

/** How the topology is repaired, one after the other. */
enum class RepairStage
{
  Refine,       ///< add sites, take away others
  CutTips,      ///< now and then leave thin tips to the cells around them
  Persist,      ///< add sites again, as long as what fails becomes smaller
  BeyondNumber, ///< add sites
  GivenUp
};

/**
 * How many vertices there are too many or too few, whether the certificate fails, how many vertices
 * more than asked for features and parts of cells take, how many failures and flipped triangles
 * there are, and how many strays; lower is better. The number goes before the failures: as long as
 * there are any, more points that do not mend all of them are of no use.
 */
using Score = std::tuple<Offset, bool, Offset, Offset, Offset>;

constexpr int mostFlipRounds = 8; ///< in which sites, or places on curves, go to flipped triangles
constexpr int settledAdjustments = 4; ///< of the number; later ones change only what they must

const Score worstScore{ std::numeric_limits<Offset>::max(), true, 0, 0, 0 };

/** What was mended how often, each with its own bound, and the best state so far. */
struct Repair
{
  bool othersStay = false; ///< only sites touched may change, from the first on
  Offset leastFree = 0;    ///< free sites that stay, whatever the number of vertices
  int refinements = 0;
  int adjustments = 0;
  RepairStage stage = RepairStage::Refine;
  int rounds = 0;     ///< in this stage
  int idleRounds = 0; ///< in this stage, since one that came nearer than all before
  Offset fewestFailures = std::numeric_limits<Offset>::max();
  /** In this stage, of the cells that failed when it last came nearer. */
  double failingMass = std::numeric_limits<double>::infinity();
  /** Failures over components, the least in this stage. */
  double failingShare = std::numeric_limits<double>::infinity();
  int flipRounds = 0;               ///< for flipped triangles and for strays; to mostFlipRounds
  std::vector<Offset> flipsBefore;  ///< of those with sites for them, flipped triangles
  std::vector<Offset> straysBefore; ///< likewise
  SitePruning pruning;              ///< of added sites, once the topology is right
  std::size_t intrusions = 0;       ///< of curves, before its trial

  bool wentBack = false; ///< to the best state, by the last change

  SharedSites atHand;  ///< the last ones that were shared
  SharedSites settled; ///< before the first change that no Lloyd's steps followed; none as yet
  RepairCounts counts;
  SiteState best;
  Score scoreOfBest = worstScore;
};

/** The number of vertices may be adjusted again, and the sites around settle. */
void allowSettling(Repair& repair);

/** The result's sites as they are now. */
SharedSites shareSites(const RemeshResult& result, Repair& repair);

/** Remembers the result's sites, whether or not they are the best so far. */
void keepState(const RemeshResult& result, Repair& repair);
void restoreState(Repair& repair, RemeshResult& result);

/**
 * Vertices that are not of free sites: on features, and one more for each further part of a cell.
 */
Offset leastVertices(const RemeshResult& result);

/**
 * As many as there shall be: those asked for if they can be reached without too few free sites, and
 * those added beyond.
 */
Offset wantedVertices(
  const RemeshOptions& options, const RemeshResult& result, const Repair& repair);

Score scoreOf(const RemeshOptions& options, const RemeshResult& result, const Repair& repair);

/** Keeps the state if it is the best so far. */
void keepIfBest(const RemeshOptions& options, const RemeshResult& result, Repair& repair);

/** The same, and sees whether repairs come nearer to their end. */
void keepBest(const RemeshOptions& options, const RemeshResult& result, Repair& repair);

/** Where the certificate fails; ascending. */
std::vector<Index> failingComponents(const Certificate& certificate);
}

#endif
