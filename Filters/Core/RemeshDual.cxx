#include "RemeshDual.h"

#include "Delaunay/CellColors.h"
#include "Delaunay/SiteRevision.h"
#include "Embedding/Embedding.h"
#include "Features/FeatureGraph.h"
#include "Optimization/FixedSites.h"
#include "Optimization/LocalRelaxation.h"
#include "RemeshFacing.h"
#include "RemeshRepair.h"
#include "Voronoi/RestrictedVoronoi.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace remesh
{
namespace
{
constexpr int mostChanges = 140;         // but for trials of doing without sites
constexpr int settlingSteps = 2;         // of Lloyd, after the first repairs
constexpr int mostSmoothings = 2;        // in the end, if sites were changed without such steps
constexpr double sitesForOneMore = 2e-3; // of all, that were

/** The dual of the diagram, and whether it is proven to be like the surface. */
Status dualize(const Task& task, const EdgeTable& edges, const std::vector<Index>& owners,
  const RunControl& control, RemeshResult& result)
{
  Status status = findComponents(task.mesh, task.surface, result.sites, edges, result.diagram,
    owners, control.step(0, 3), result.components, task.features ? &result.featureSites : nullptr);
  if (status.ok() && task.features)
  {
    result.seams = sewAlongFeatures(
      result.diagram, result.components, task.featured(), result.featureSites, result.sites);
  }
  if (status.ok())
  {
    status = buildDual(result.diagram, result.components, control.step(1, 3), result.dual,
      task.features ? &result.seams : nullptr);
  }
  if (status.ok() && task.features)
  {
    status = dropHangingTriangles(result.components, result.seams, control, result.dual);
    result.components.apexes =
      componentsAt(task.mesh, task.features->apexes, owners, result.diagram, result.components);
  }
  if (status.ok())
  {
    status = certify(task.surface, edges, result.diagram, result.components, result.dual,
      task.features ? &result.seams : nullptr, control.step(2, 3), result.topology.certificate);
  }
  return status;
}

/** What else is told of the cells. */
Status describeCells(const Task& task, const RunControl& control, RemeshResult& result)
{
  if (Status status =
        countNeighbors(result.diagram, result.sites.count(), control, result.numbersOfNeighbors);
      !status.ok())
  {
    return status;
  }
  result.cellColors = colorCells(result.diagram, result.components, result.dual,
    result.sites.count(), task.features ? &result.featureSites : nullptr);
  result.cellAreas = measureCellAreas(task.mesh, result.diagram, result.sites.count());
  return locateOnSurface(task.mesh, result.diagram, result.components, control, result.locations);
}

/** What one diagram leaves to the next. */
struct Carried
{
  EdgeTable edges;           ///< of the surface, as it is cut
  SharedSites sites;         ///< of the result's diagram; none as yet
  std::vector<Index> owners; ///< C, of the corners
};

/** The surface's edges and its topology, if they are not known yet. */
Status knowSurface(
  const Task& task, const RunControl& control, EdgeTable& edges, RemeshResult& result)
{
  if (!edges.facetEdges.empty())
  {
    return Status::success();
  }
  edges = buildCutEdgeTable(task.mesh, task.features, control);
  return control.cancelled()
    ? Status::cancelled()
    : measureConnectivity(task.mesh.facetPoints, task.features ? task.features->edges : edges,
        task.mesh.numberOfPoints(), control, result.topology.surface);
}

/** Whether sites may be changed at all. The surface must be known. */
bool mayRepair(const Task& task, const RemeshResult& result)
{
  return task.options.optimize &&
    task.options.lloydIterations + task.options.quasiNewton.iterations > 0 &&
    (task.features || result.topology.surface.nonManifoldEdges == 0);
}

/** The exact diagram of the sites and its dual. */
Status diagramAndDual(const Task& task, const RunControl& control, Carried& carried, Repair& repair,
  RemeshResult& result)
{
  {
    std::optional<EarlierSites> earlier;
    if (carried.sites && task.surface.dimension < manyDimensions)
    {
      earlier.emplace(EarlierSites{ *carried.sites, carried.owners });
    }
    // The last dual makes room for the diagram, and the diagram's lists and sums for its dual.
    result.components = Components{};
    result.dual = Dual{};
    RestrictedVoronoi voronoi(task.surface);
    if (Status status = voronoi.decompose(result.sites, control.step(0, 2), result.sums,
          result.diagram, earlier ? &*earlier : nullptr);
        !status.ok())
    {
      return status;
    }
    result.emptyCells = countEmptyFree(result.sites, result.sums);
    result.evaluations += voronoi.evaluations();
    carried.owners = voronoi.owners();
  }
  if (Status status = knowSurface(task, control.silent(), carried.edges, result); !status.ok())
  {
    return status;
  }
  const Status status = dualize(task, carried.edges, carried.owners, control.step(1, 2), result);
  if (status.ok() && mayRepair(task, result))
  {
    carried.sites = shareSites(result, repair); // now that the dual's memory is free
  }
  return status;
}

/** A few Lloyd steps for the sites around these places. */
Status settle(const Task& task, const Sites& earlier, const SiteChanges& changes,
  const std::vector<double>& places, const RunControl& control, RemeshResult& result)
{
  Status status = relaxAround(task.surface, result.diagram, earlier, changes, places, settlingSteps,
    task.options.seed, control, result.sites);
  roundToCaller(task.surface, result.sites);
  return status;
}

/** Whether cells fall into so many parts that another surface in R^d is better. */
bool fallsApart(const Task& task, const RemeshResult& result)
{
  return static_cast<double>(result.components.count()) >
    task.options.mostComponents * static_cast<double>(result.numberOfVertexSites());
}

/** After a change of the sites: those around settle, or are remembered as not settled. */
Status settleAfter(const Task& task, const SharedSites& earlier, const RunControl& control,
  Repair& repair, RemeshResult& result)
{
  roundToCaller(task.surface, result.sites);
  if (!othersMustStay(repair))
  {
    const SiteChanges changes = compareSites(*earlier, result.sites);
    return settle(task, *earlier, changes, changes.places, control, result);
  }
  if (!repair.othersStay && leavesUnsettled(repair) && !repair.settled && !repair.wentBack)
  {
    repair.settled = earlier;
  }
  return Status::success();
}

/** To the best state, unless that at hand is as good, or it alone is proven. */
Status returnToBest(const Task& task, const RunControl& control, Carried& carried, Repair& repair,
  RemeshResult& result)
{
  const bool nothingBetter = scoreOf(task.options, result, repair) <= repair.scoreOfBest;
  const bool onlyThisHolds = result.topology.certificate.holds() && std::get<1>(repair.scoreOfBest);
  if (nothingBetter || onlyThisHolds)
  {
    return Status::success();
  }
  Stopwatch watch;
  restoreState(repair, result);
  Status status = diagramAndDual(task, control, carried, repair, result);
  result.seconds.diagram += watch.lap();
  return status;
}

/** Diagram and dual, again and again while there is something to mend. */
Status mendAll(
  const Task& task, RunControl rest, Carried& carried, Repair& repair, RemeshResult& result)
{
  // Each round fills half of the progress that is left.
  int changes = 0;
  for (int round = 0;; ++round, rest = rest.step(1, 2))
  {
    Stopwatch watch;
    Status status = diagramAndDual(task, rest.step(0, 2), carried, repair, result);
    result.seconds.diagram += watch.lap();
    result.fallsApart = status.ok() && round == 0 && fallsApart(task, result);
    if (!status.ok() || result.fallsApart)
    {
      return status;
    }
    const SharedSites earlier = carried.sites;
    const bool wasTrial = repair.pruning.isTrying();
    const bool mayChange = earlier && (changes < mostChanges || wasTrial);
    changes += wasTrial ? 0 : 1;
    const Index moved = mayChange ? mend(task, rest.silent(), repair, result) : 0;
    result.movedSites += moved;
    status =
      moved > 0 ? settleAfter(task, earlier, rest.silent(), repair, result) : Status::success();
    result.seconds.repair += watch.lap();
    if (!status.ok())
    {
      return status;
    }
    if (moved == 0)
    {
      break;
    }
  }
  return returnToBest(task, rest.silent(), carried, repair, result);
}

/** Whether more triangles face the wrong way than were counted. */
bool facesWorse(
  const Task& task, const RepairCounts& counts, const RunControl& control, RemeshResult& result)
{
  const auto [found, flipped] = flippedTriangles(task, FlipSteps::Move, control, result);
  return static_cast<Offset>(flipped.size()) > counts.flips ||
    (counts.flips == 0 &&
      static_cast<Offset>(wrongTriangles(task, found, control, result).size()) > counts.strays);
}

/** Spreads the sites evenly where some came or went, as far as nothing breaks. */
Status smooth(const Task& task, const RunControl& control, Carried& carried, Repair& repair,
  RemeshResult& result)
{
  Stopwatch watch;
  if (!repair.settled)
  {
    return Status::success();
  }
  const std::vector<double> places = compareSites(*repair.settled, result.sites).places;
  bool broken = places.empty() || !result.topology.certificate.holds();
  const bool areFew = static_cast<double>(places.size()) <
    sitesForOneMore * static_cast<double>(result.sites.coordinates.size());
  for (int round = areFew ? 1 : 0; round < mostSmoothings && !broken; ++round)
  {
    const Index count = result.components.count();
    const std::size_t intrusions = result.seams.intrusions.size();
    keepState(result, repair);
    const std::vector<Index> staying = sitesAroundAdded(
      result.components, result.dual, result.sites.count(), repair.counts.addedSites);
    SiteChanges none;
    none.later.resize(static_cast<std::size_t>(result.sites.count()));
    std::iota(none.later.begin(), none.later.end(), 0);
    Status status = settle(task, *repair.best.sites, none, places, control, result);
    if (status.ok())
    {
      for (const Index site : staying)
      {
        std::copy_n(repair.best.sites->site(site), task.surface.dimension, result.sites.site(site));
      }
      status = diagramAndDual(task, control, carried, repair, result);
    }
    broken = !status.ok() || !result.topology.certificate.holds() ||
      result.components.count() != count || result.seams.intrusions.size() > intrusions ||
      facesWorse(task, repair.counts, control, result);
    if (status.ok() && broken)
    {
      restoreState(repair, result);
      status = diagramAndDual(task, control, carried, repair, result);
    }
    if (!status.ok())
    {
      return status;
    }
  }
  result.seconds.repair += watch.lap();
  return Status::success();
}
}

Status findDual(const Task& task, bool othersStay, const RunControl& control, RemeshResult& result)
{
  {
    Repair repair;
    repair.othersStay = othersStay;
    repair.leastFree = task.leastFreeSites(result.shareApart);
    Carried carried;
    Status status = mendAll(task, control, carried, repair, result);
    if (status.ok() && !result.fallsApart && !othersStay)
    {
      status = smooth(task, control.silent(), carried, repair, result);
    }
    if (!status.ok() || result.fallsApart)
    {
      return status;
    }
    result.wantedVertices = task.options.exactNumber
      ? task.options.numberOfSites
      : result.numberOfVertexSites() - result.emptyCells - repair.counts.extraPoints;
  }
  return describeCells(task, control.silent(), result);
}
}
