#include "Remesh.h"

#include "Embedding/Embedding.h"
#include "Optimization/FixedSites.h"
#include "Optimization/Lloyd.h"
#include "Optimization/SiteOrder.h"
#include "Placement/CurveFit.h"
#include "Placement/StepLimit.h"
#include "Placement/TriangleShape.h"
#include "Repair/PlacedMesh.h"
#include "Repair/SiteRepair.h"
#include "Run/FirstSites.h"
#include "Voronoi/RestrictedVoronoi.h"

#include <cmath>
#include <utility>

namespace remesh
{
namespace
{
/** Lloyd's iterations as an opening, then quasi-Newton ones. */
Status optimize(
  const Task& task, RunControl control, RestrictedVoronoi& voronoi, RemeshResult& result)
{
  Stopwatch watch;
  const RemeshOptions& options = task.options;
  const Relaxation relaxation = task.relaxation(voronoi, result);
  const double steps = options.lloydIterations + 1 + options.quasiNewton.iterations;
  const double lloydEnds = 0.02 + 0.83 * (options.lloydIterations + 1) / steps;
  control.enterPhase("Lloyd iterations", 0.02, lloydEnds);
  if (Status status = relaxLloyd(relaxation, options.lloydIterations, control); !status.ok())
  {
    return status;
  }
  result.seconds.lloyd = watch.lap();
  control.enterPhase("Quasi-Newton iterations", lloydEnds, 0.85);
  if (Status status = minimizeQuasiNewton(relaxation, options.quasiNewton, control); !status.ok())
  {
    return status;
  }
  result.seconds.newton = watch.lap();
  return Status::success();
}

/** What the outputs tell beside the sums that a density weights. */
Status sumPlainly(const Task& task, const RunControl& control, RemeshResult& result)
{
  if (!task.surface.hasDensity())
  {
    return Status::success();
  }
  Status status =
    sumSitesPlainly(task.surface, result.sites, result.diagram, control, result.plainSums);
  return status.ok() ? sumGroupsPlainly(task.surface, result.diagram, result.components.ofPiece,
                         result.components.count(), control, result.plainComponentSums)
                     : status;
}

/** The topology of the placed mesh. */
Status measureMesh(const RunControl& control, RemeshResult& result)
{
  const EdgeTable edges = buildEdgeTable(result.dual.triangles, control);
  return control.cancelled() ? Status::cancelled()
                             : measureConnectivity(result.dual.triangles, edges,
                                 result.components.count(), control, result.topology.mesh);
}

/** Leaves of a diagram nothing but which facets the pieces are of. */
void keepFacetsAlone(Diagram& diagram)
{
  Diagram kept;
  kept.facets.swap(diagram.facets);
  diagram = std::move(kept);
}

/** Makes room for the placement: leaves nothing of the diagram that it does not read. */
void keepForPlacement(const Task& task, RemeshResult& result)
{
  if (!task.options.keepDiagram)
  {
    result.diagram.energies = std::vector<double>();
    result.components.ofPiece = std::vector<Index>();
  }
  if (task.options.placement >= VertexPlacement::Fit)
  {
    task.forgetWholeSurface(); // the fit takes as much
  }
}

/** Fixes the vertices whose cells hold apexes there; the first of several in one cell. */
void fixAtApexes(const Task& task, std::vector<char>& fixed, RemeshResult& result)
{
  if (!task.features || task.features->apexes.empty())
  {
    return;
  }
  const std::vector<Index>& apexes = task.features->apexes;
  const std::vector<Index>& vertices = result.components.apexes;
  std::vector<Point3>& positions = result.placement.positions;
  if (positions.empty())
  {
    positions = result.components.centroids;
  }
  for (std::size_t k = 0; k < apexes.size(); ++k)
  {
    if (vertices[k] != noIndex && !fixed[vertices[k]])
    {
      fixed[vertices[k]] = 1;
      positions[vertices[k]] = task.mesh.points[apexes[k]];
    }
  }
}

/** Vertices on features, as near to where their edges are closest to these as none is spoilt. */
Status placeOnFeatures(const Task& task, const PlacementProblem& problem, const RunControl& control,
  RemeshResult& result)
{
  std::vector<Point3> places;
  if (!fitCurves(task.featured(), result.featureSites, control, places))
  {
    return Status::cancelled();
  }
  const std::vector<Point3>& start = result.components.centroids;
  std::vector<Point3> goals = start;
  for (std::size_t point = 0; point < places.size(); ++point)
  {
    if (const Index vertex = result.seams.components[point]; vertex != noIndex)
    {
      goals[vertex] = places[point];
    }
  }
  const VertexStars stars(problem.triangles, problem.numberOfVertices());
  const std::vector<Point3> normals = normalsOf(problem.triangles, start);
  const bool done = limitSteps(problem, stars, { start, normals, start }, control, goals);
  result.placement.positions = std::move(goals);
  return done ? Status::success() : Status::cancelled();
}

/** Vertices on features are fitted to these first, those at apexes come there, and both stay. */
Status place(const Task& task, const RunControl& control, RemeshResult& result)
{
  Stopwatch watch;
  keepForPlacement(task, result);
  std::vector<char> fixed = verticesOnFeatures(result.seams, result.components.count());
  PlacementProblem problem{ task.mesh, task.surface, result.sites, result.diagram,
    result.components, result.dual.triangles, fixed, &result.seams.segments, nullptr, task.metric };
  const VertexPlacement way = task.options.placement;
  Status status = Status::success();
  if (task.features && way >= VertexPlacement::Fit)
  {
    status = placeOnFeatures(task, problem, control.silent(), result);
  }
  fixAtApexes(task, fixed, result);
  if (status.ok())
  {
    status =
      choosePlaces(problem, way, control.step(0, 2), result.locations, result.placement.positions);
  }
  if (!task.options.keepDiagram)
  {
    keepFacetsAlone(result.diagram); // as long as they are of use
  }
  if (status.ok())
  {
    problem.whole = &task.wholeSurface(control);
    status = repairPlacedMesh(
      problem, way, control.step(1, 2), result.locations, result.dual.triangles, result.placement);
  }
  result.seconds.placement += watch.lap();
  if (!task.options.keepDiagram)
  {
    result.diagram = Diagram{};
  }
  return status.ok() ? measureMesh(control.silent(), result) : status;
}

/** From the sites to the mesh. */
Status endRun(const Task& task, bool othersStay, RunControl control, RemeshResult& result)
{
  result.topology = {};
  result.placement = {};
  result.fallsApart = false;
  control.enterPhase("Restricted Voronoi diagram", 0.0, 0.6);
  if (Status status = findRepairedDual(task, othersStay, control, result); !status.ok())
  {
    return status;
  }
  if (result.fallsApart)
  {
    return Status::success();
  }
  if (Status status = sumPlainly(task, control.silent(), result); !status.ok())
  {
    return status;
  }
  control.enterPhase("Vertex placement", 0.6, 1.0);
  return place(task, control, result);
}

/** Moves the sites to where the energy is low, in the order that is fast. */
Status moveSites(const Task& task, RunControl control, RemeshResult& result)
{
  const bool reorder = task.options.initialSites.count() > 0 && areScattered(result.sites);
  std::vector<Index> order;
  if (reorder)
  {
    order = orderInSpace(result.sites, control);
    if (control.cancelled())
    {
      return Status::cancelled();
    }
    result.sites = inOrder(result.sites, order);
  }
  RestrictedVoronoi voronoi(task.surface);
  voronoi.divideAmong(task.options.ranks);
  if (Status status = optimize(task, control, voronoi, result); !status.ok())
  {
    return status;
  }
  if (reorder)
  {
    result.sites = inFormerOrder(result.sites, order);
  }
  roundToCaller(task.surface, result.sites);
  result.evaluations += voronoi.evaluations();
  return Status::success();
}
}

Status completeMesh(const Task& task, RunControl control, RemeshResult& result)
{
  return endRun(task, true, control, result);
}

Status remesh(const Task& task, RunControl control, RemeshResult& result)
{
  result = RemeshResult{};
  Stopwatch watch;

  control.enterPhase("Sampling", 0.0, 0.02);
  if (Status status = makeSites(task, control, result); !status.ok())
  {
    return status;
  }
  result.seconds.sampling = watch.lap();

  if (task.options.optimize)
  {
    if (Status status = moveSites(task, control, result); !status.ok())
    {
      return status;
    }
  }
  if (Status status = endRun(task, false, control.part(0.85, 1.0), result);
      !status.ok() || result.fallsApart)
  {
    return status;
  }
  if (!task.options.optimize)
  {
    result.convergence.add(0.0, 0.0, 0.0);
  }
  if (result.movedSites == 0)
  {
    // The last row is that of the diagram given back, to the bit.
    result.convergence.rows.back().energy = result.sums.totalEnergy;
    result.convergence.rows.back().gradientNorm = freeGradientNorm(result.sites, result.sums);
  }
  control.enterPhase("Vertex placement", 0.99, 1.0);
  control.report(1.0);
  return Status::success();
}
}
