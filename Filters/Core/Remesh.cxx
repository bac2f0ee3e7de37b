#include "Remesh.h"

#include "Delaunay/FeatureRepair.h"
#include "Delaunay/TopologyRepair.h"
#include "Embedding/Embedding.h"
#include "Features/FeatureGraph.h"
#include "Features/PatchSampling.h"
#include "Optimization/FixedSites.h"
#include "Optimization/Lloyd.h"
#include "Voronoi/RestrictedVoronoi.h"

#include <algorithm>

namespace remesh
{
namespace
{
constexpr int mostRepairs = 8;
constexpr int mostRefinements = 10; // rounds in which free sites may join curves
constexpr int mostAdjustments = 6;
constexpr int settledAdjustments = 2; // later ones change nothing but what they must
constexpr int settlingSteps = 2;      // of Lloyd, after each

/** Seconds since the last call. */
class Stopwatch
{
public:
  double lap()
  {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> elapsed = now - m_start;
    m_start = now;
    return elapsed.count();
  }

private:
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

/** What all steps work on. */
struct Task
{
  const SurfaceMesh& mesh;
  const EmbeddedSurface& surface;
  const Features* features; ///< nullptr: none
  const RemeshOptions& options;
};

/** The sites on the features, and then those of each patch. */
Status makeSitesByPatch(const Task& task, const RunControl& control, RemeshResult& result)
{
  const RemeshOptions& options = task.options;
  if (Status status = checkNumberOfSites(options.numberOfSites); !status.ok())
  {
    return status;
  }
  result.stations = sampleCurves(
    task.mesh, task.surface, *task.features, options.numberOfSites, result.neededFeaturePoints);
  result.featureSites = makeFeatureSites(task.mesh, task.surface, *task.features, result.stations);
  result.sites = result.featureSites.sites;
  const std::vector<Offset> counts = shareOutSites(task.mesh, task.surface, *task.features,
    result.featureSites, options.numberOfSites - result.featureSites.numberOfPoints());
  return samplePatches(
    task.surface, *task.features, counts, options.sampling, options.seed, result.sites, control);
}

Status makeSites(const Task& task, const RunControl& control, RemeshResult& result)
{
  const RemeshOptions& options = task.options;
  if (options.initialSites.count() > 0)
  {
    result.sites = options.initialSites;
    return Status::success();
  }
  if (task.features)
  {
    return makeSitesByPatch(task, control, result);
  }
  return sampleSurface(
    task.surface, options.numberOfSites, options.sampling, options.seed, result.sites, control);
}

/** Lloyd's iterations as an opening, then quasi-Newton ones. */
Status optimize(const EmbeddedSurface& surface, const RemeshOptions& options, RunControl control,
  RestrictedVoronoi& voronoi, RemeshResult& result)
{
  Stopwatch watch;
  const double steps = options.lloydIterations + 1 + options.quasiNewton.iterations;
  const double lloydEnds = 0.02 + 0.83 * (options.lloydIterations + 1) / steps;
  control.enterPhase("Lloyd iterations", 0.02, lloydEnds);
  if (Status status = relaxLloyd(voronoi, surface, options.lloydIterations, options.seed, control,
        result.sites, result.sums, result.convergence, result.emptyCells);
      !status.ok())
  {
    return status;
  }
  result.seconds.lloyd = watch.lap();
  control.enterPhase("Quasi-Newton iterations", lloydEnds, 0.85);
  if (Status status = minimizeQuasiNewton(voronoi, surface, options.quasiNewton, options.seed,
        control, result.sites, result.sums, result.convergence, result.emptyCells);
      !status.ok())
  {
    return status;
  }
  result.seconds.newton = watch.lap();
  return Status::success();
}

/** The dual of the diagram and all that hangs on it. */
Status dualize(const Task& task, const std::vector<Index>& owners, const RunControl& control,
  RemeshResult& result)
{
  Status status =
    findComponents(task.mesh, task.surface, result.sites, result.edges, result.diagram, owners,
      control.step(0, 4), result.components, task.features ? &result.featureSites : nullptr);
  if (status.ok() && task.features)
  {
    result.seams = sewAlongFeatures(result.diagram, result.components, task.mesh, task.surface,
      *task.features, result.stations, result.featureSites, result.sites);
  }
  if (status.ok())
  {
    status = buildDual(result.diagram, result.components, control.step(1, 4), result.dual,
      task.features ? &result.seams : nullptr);
  }
  if (status.ok())
  {
    status = countNeighbors(result.diagram, result.components, result.sites.count(),
      control.step(2, 4), result.numbersOfNeighbors);
  }
  if (status.ok() && task.features)
  {
    status = dropHangingTriangles(result.components, result.seams, control, result.dual);
  }
  if (status.ok())
  {
    status = locateOnSurface(
      task.mesh, result.diagram, result.components, control.step(3, 4), result.locations);
  }
  return status;
}

/** The exact diagram of the sites and its dual. */
Status diagramAndDual(const Task& task, const RunControl& control, RemeshResult& result)
{
  std::vector<Index> owners;
  {
    // Begun afresh, the diagram depends on the sites alone, and not on the way they came; ended
    // here, its lists and sums make room for the dual.
    RestrictedVoronoi voronoi(task.surface);
    if (Status status =
          voronoi.decompose(result.sites, control.step(0, 2), result.sums, result.diagram);
        !status.ok())
    {
      return status;
    }
    result.emptyCells = countEmptyFree(result.sites, result.sums);
    result.evaluations += voronoi.evaluations();
    owners = voronoi.owners();
  }
  return dualize(task, owners, control.step(1, 2), result);
}

bool isManifold(const EdgeTable& edges)
{
  for (Index edge = 0; edge < edges.numberOfEdges(); ++edge)
  {
    if (edges.valence(edge) > 2)
    {
      return false;
    }
  }
  return true;
}

/** A few Lloyd steps after sites were moved. */
Status settle(const EmbeddedSurface& surface, std::uint64_t seed, const RunControl& control,
  RemeshResult& result)
{
  RestrictedVoronoi voronoi(surface);
  Convergence apart; // not the optimisation's
  Status status = relaxLloyd(voronoi, surface, settlingSteps, seed, control, result.sites,
    result.sums, apart, result.emptyCells);
  roundToCaller(surface, result.sites);
  result.evaluations += voronoi.evaluations();
  return status;
}

/** How often what was mended; each has its own bound. */
struct Rounds
{
  int refinements = 0;
  int repairs = 0;
  int adjustments = 0;
};

/** What can be mended still, the first of these that finds anything. Returns sites touched. */
Index mend(const Task& task, Rounds& rounds, RemeshResult& result)
{
  Index touched = 0;
  if (task.features && rounds.refinements < mostRefinements)
  {
    touched = refineCurves(task.mesh, task.surface, *task.features, result.seams, result.stations,
      result.featureSites, result.sites);
    rounds.refinements += touched > 0;
  }
  if (touched == 0 && rounds.repairs < mostRepairs)
  {
    touched = moveSitesToDefects(
      task.surface, result.diagram, result.components, result.dual, result.sums, result.sites);
    rounds.repairs += touched > 0;
  }
  if (touched == 0 && task.options.exactNumber && rounds.adjustments < mostAdjustments &&
    result.components.count() != task.options.numberOfSites)
  {
    touched = adjustNumber(task.surface, result.diagram, result.components, result.dual,
      result.sums, task.options.numberOfSites, result.sites);
    rounds.adjustments += touched > 0;
  }
  return touched;
}

/** Diagram and dual, again and again while there is something to mend. */
Status finish(const Task& task, const RunControl& control, RemeshResult& result)
{
  const RemeshOptions& options = task.options;
  result.edges = task.features ? buildCutEdgeTable(task.mesh, *task.features)
                               : buildEdgeTable(task.mesh.facetPoints, control);
  if (control.cancelled())
  {
    return Status::cancelled();
  }
  const bool mayRepair = options.optimize &&
    options.lloydIterations + options.quasiNewton.iterations > 0 && isManifold(result.edges);
  RunControl rest = control; // each round fills half of the progress that is left
  Rounds rounds;
  for (;; rest = rest.step(1, 2))
  {
    Stopwatch watch;
    if (Status status = diagramAndDual(task, rest.step(0, 2), result); !status.ok())
    {
      return status;
    }
    result.seconds.diagram += watch.lap();
    const Index moved = mayRepair ? mend(task, rounds, result) : 0;
    if (moved == 0)
    {
      return Status::success();
    }
    result.movedSites += moved;
    if (rounds.adjustments > settledAdjustments)
    {
      roundToCaller(task.surface, result.sites); // nothing is to change but what was touched
      continue;
    }
    if (Status status = settle(task.surface, options.seed, control.silent(), result); !status.ok())
    {
      return status;
    }
    result.seconds.repair += watch.lap();
  }
}

/** What the outputs tell beside the sums that a density weights. */
Status sumPlainly(const Task& task, const RunControl& control, RemeshResult& result)
{
  if (!task.surface.hasDensity)
  {
    return Status::success();
  }
  Status status =
    sumSitesPlainly(task.surface, result.sites, result.diagram, control, result.plainSums);
  return status.ok() ? sumGroupsPlainly(task.surface, result.diagram, result.components.ofPiece,
                         result.components.count(), control, result.plainComponentSums)
                     : status;
}

/** What each vertex may do when it is placed anew. */
std::vector<VertexKind> findVertexKinds(const RemeshResult& result)
{
  std::vector<VertexKind> kinds(
    static_cast<std::size_t>(result.components.count()), VertexKind::Free);
  for (std::size_t p = 0; p < result.seams.components.size(); ++p)
  {
    if (result.seams.components[p] != noIndex)
    {
      kinds[result.seams.components[p]] =
        result.featureSites.points[p].isCorner ? VertexKind::Corner : VertexKind::OnCurve;
    }
  }
  return kinds;
}

/** Vertices on features stay where they are. */
Status place(const Task& task, const RunControl& control, RemeshResult& result)
{
  Stopwatch watch;
  std::vector<char> fixed;
  for (const VertexKind kind : result.vertexKinds)
  {
    fixed.push_back(kind != VertexKind::Free);
  }
  const PlacementProblem problem{ task.mesh, task.surface, result.sites, result.diagram,
    result.components, result.dual.triangles, fixed, &result.seams.segments };
  Status status = placeVertices(problem, task.options.placement, control, result.locations,
    result.dual.triangles, result.placement);
  result.seconds.placement = watch.lap();
  return status;
}
}

Status remesh(const SurfaceMesh& mesh, const EmbeddedSurface& surface, const RemeshOptions& options,
  RunControl control, RemeshResult& result, const Features* features)
{
  result = RemeshResult{};
  const Task task{ mesh, surface, features, options };
  Stopwatch watch;

  control.enterPhase("Sampling", 0.0, 0.02);
  if (Status status = makeSites(task, control, result); !status.ok())
  {
    return status;
  }
  result.seconds.sampling = watch.lap();

  if (options.optimize)
  {
    RestrictedVoronoi voronoi(surface);
    if (Status status = optimize(surface, options, control, voronoi, result); !status.ok())
    {
      return status;
    }
    roundToCaller(surface, result.sites);
    result.evaluations = voronoi.evaluations();
  }
  control.enterPhase("Restricted Voronoi diagram", 0.85, 0.94);
  if (Status status = finish(task, control, result); !status.ok())
  {
    return status;
  }
  if (Status status = sumPlainly(task, control.silent(), result); !status.ok())
  {
    return status;
  }
  result.vertexKinds = findVertexKinds(result);
  result.wantedVertices =
    options.exactNumber ? options.numberOfSites : result.numberOfVertexSites() - result.emptyCells;
  if (!options.optimize)
  {
    result.convergence.add(0.0, 0.0, 0.0);
  }
  if (result.movedSites == 0)
  {
    // The last row is that of the diagram given back, to the bit.
    result.convergence.rows.back().energy = result.sums.totalEnergy;
    result.convergence.rows.back().gradientNorm = freeGradientNorm(result.sites, result.sums);
  }
  control.enterPhase("Vertex placement", 0.94, 1.0);
  if (Status status = place(task, control, result); !status.ok())
  {
    return status;
  }
  control.report(1.0);
  return Status::success();
}
}
