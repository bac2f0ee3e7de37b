#include "Remesh.h"

#include "Delaunay/TopologyRepair.h"
#include "Embedding/Embedding.h"
#include "Optimization/Lloyd.h"
#include "Voronoi/RestrictedVoronoi.h"

#include <algorithm>

namespace remesh
{
namespace
{
constexpr int mostRepairs = 8;
constexpr int settlingSteps = 2; // of Lloyd, after each

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

Status makeSites(const EmbeddedSurface& surface, const RemeshOptions& options, Sites& sites)
{
  if (options.initialSites.count() > 0)
  {
    sites = options.initialSites;
    return Status::success();
  }
  return sampleSurface(surface, options.numberOfSites, options.sampling, options.seed, sites);
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
Status dualize(const SurfaceMesh& mesh, const EmbeddedSurface& surface,
  const std::vector<Index>& owners, const RunControl& control, RemeshResult& result)
{
  if (Status status = findComponents(
        mesh, surface, result.edges, result.diagram, owners, control.step(0, 3), result.components);
      !status.ok())
  {
    return status;
  }
  if (Status status = locateOnSurface(
        mesh, result.diagram, result.components, control.step(1, 3), result.locations);
      !status.ok())
  {
    return status;
  }
  result.dual = buildDual(result.diagram, result.components);
  result.numbersOfNeighbors = countNeighbors(result.diagram, result.sites.count());
  control.report(1.0);
  return control.cancelled() ? Status::cancelled() : Status::success();
}

/** The exact diagram of the sites and its dual. */
Status diagramAndDual(const SurfaceMesh& mesh, const EmbeddedSurface& surface,
  const RunControl& control, RemeshResult& result)
{
  // Begun afresh, the diagram depends on the sites alone, and not on the way they came.
  RestrictedVoronoi voronoi(surface);
  if (Status status =
        voronoi.decompose(result.sites, control.step(0, 2), result.sums, result.diagram);
      !status.ok())
  {
    return status;
  }
  result.evaluations += voronoi.evaluations();
  return dualize(mesh, surface, voronoi.owners(), control.step(1, 2), result);
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

/** Diagram and dual, again and again while sites can be moved to where the dual is no manifold. */
Status finish(const SurfaceMesh& mesh, const EmbeddedSurface& surface, const RemeshOptions& options,
  const RunControl& control, RemeshResult& result)
{
  result.edges = buildEdgeTable(mesh.facetPoints);
  const bool mayRepair = options.optimize &&
    options.lloydIterations + options.quasiNewton.iterations > 0 && isManifold(result.edges);
  RunControl rest = control; // each round fills half of the progress that is left
  for (int round = 0;; ++round, rest = rest.step(1, 2))
  {
    Stopwatch watch;
    if (Status status = diagramAndDual(mesh, surface, rest.step(0, 2), result); !status.ok())
    {
      return status;
    }
    result.seconds.diagram += watch.lap();
    const Index moved = mayRepair && round < mostRepairs
      ? moveSitesToDefects(
          surface, result.diagram, result.components, result.dual, result.sums, result.sites)
      : 0;
    if (moved == 0)
    {
      return Status::success();
    }
    result.movedSites += moved;
    if (Status status = settle(surface, options.seed, control.silent(), result); !status.ok())
    {
      return status;
    }
    result.seconds.repair += watch.lap();
  }
}
}

Status remesh(const SurfaceMesh& mesh, const EmbeddedSurface& surface, const RemeshOptions& options,
  RunControl control, RemeshResult& result)
{
  result = RemeshResult{};
  Stopwatch watch;

  control.enterPhase("Sampling", 0.0, 0.02);
  if (Status status = makeSites(surface, options, result.sites); !status.ok())
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
  control.enterPhase("Restricted Voronoi diagram", 0.85, 1.0);
  if (Status status = finish(mesh, surface, options, control, result); !status.ok())
  {
    return status;
  }
  if (!options.optimize)
  {
    result.convergence.add(0.0, 0.0, 0.0);
    result.emptyCells = result.sums.countEmpty();
  }
  if (result.movedSites == 0)
  {
    // The last row is that of the diagram given back, to the bit.
    result.convergence.rows.back().energy = result.sums.totalEnergy;
    result.convergence.rows.back().gradientNorm = result.sums.gradientNorm;
  }
  control.report(1.0);
  return Status::success();
}
}
