#include "Run/FirstSites.h"

#include "Embedding/Distance.h"
#include "Features/CurveAlignment.h"
#include "Features/CurveSampling.h"
#include "Features/CurveSeparation.h"
#include "Features/PatchSampling.h"
#include "Optimization/Lloyd.h"
#include "Optimization/SiteGrowth.h"
#include "Voronoi/NeighborSearch.h"
#include "Voronoi/RestrictedVoronoi.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace remesh
{
namespace
{
constexpr Offset growth = 4; // times as many sites, where each pair of neighbours has one
constexpr Offset minCoarse = 100;
constexpr Offset minForFixed = 20;  // sites in all: beside fixed ones nothing grows
constexpr Offset probes = 4000;     // of the surface
constexpr int maxSamplings = 3;     // of the curves
constexpr double fewOthers = 0.005; // of all points, from one sampling to the next
/**
 * Times the points on curves, to keep these apart. Where it takes more, parts go through each other
 * as a rule, and nothing is apart with more, either.
 */
constexpr double maxSeparationGrowth = 1.5;
constexpr int coarseLloyd = 2;
constexpr int coarseNewton = 8;

/** Of the surface, the share that is farther than the spacing from all sites. */
double shareApart(
  const EmbeddedSurface& surface, const Sites& sites, double spacing, const RunControl& control)
{
  Sites places;
  places.dimension = surface.dimension;
  const Status status =
    sampleSurface(surface, probes, { SamplingMethod::Stratified, 0 }, places, control);
  if (!status.ok() || sites.count() == 0)
  {
    return 1.0;
  }
  const NeighborSearch search(sites);
  Offset apart = 0;
  for (Index k = 0; k < places.count(); ++k)
  {
    const double* place = places.site(k);
    const double* nearest = sites.site(search.nearest(place));
    apart += squaredDistance<Eigen::Dynamic>(place, nearest, surface.dimension) > spacing * spacing;
  }
  return static_cast<double>(apart) / static_cast<double>(places.count());
}

/**
 * The sites on the features. What comes to keep curves apart is known when they are sampled; then
 * they are sampled again, at the spacing that is left with so many more, until it hardly changes.
 */
Status makeFixedSites(const Task& task, const RunControl& control, RemeshResult& result)
{
  const auto number = static_cast<double>(task.options.numberOfSites);
  const FeaturedSurface featured = task.featured();
  const std::vector<char> all(featured.features.curves.size(), 1);
  CurveSampler sampler(featured,
    { task.options.numberOfSites, task.options.maxCurveError, task.options.curvesFollowBends });
  result.neededFeaturePoints = sampler.limitBends(control);
  Offset others = 0;
  for (int round = 0; round < maxSamplings && !control.cancelled(); ++round)
  {
    sampler.findSpacing(others, control);
    if (control.cancelled())
    {
      break;
    }
    const Offset sampled = countFeaturePoints(featured.features, sampler.stations());
    result.featureSites = makeFeatureSites(featured, sampler.stations());
    alignCurves(featured, control, sampler, result.featureSites);
    const Index aligned = result.featureSites.numberOfPoints();
    result.shareApart =
      shareApart(task.surface, result.featureSites.sites, sampler.spacing(), control);
    const Offset most =
      std::min(task.maxPointsOnFeatures(task.options.numberOfSites, result.shareApart),
        static_cast<Offset>(maxSeparationGrowth * aligned));
    const Index added =
      separateCurves(featured, all, { most, sampler.spacing() }, control, result.featureSites);
    result.curvesAreApart = added > 0 && result.featureSites.numberOfPoints() < most;
    const Offset before = std::exchange(others, result.featureSites.numberOfPoints() - sampled);
    if (std::abs(static_cast<double>(others - before)) <= fewOthers * number)
    {
      break;
    }
  }
  result.sites = result.featureSites.sites;
  return control.cancelled() ? Status::cancelled() : Status::success();
}

/** How many free sites each patch gets. */
std::vector<Offset> shareOut(const Task& task, const RemeshResult& result, Offset freeSites)
{
  return task.features ? shareOutSites(task.featured(), result.featureSites, freeSites)
                       : std::vector<Offset>{ freeSites };
}

/** Draws so many in each patch. */
Status drawFreeSites(const Task& task, const std::vector<Offset>& counts, const RunControl& control,
  RemeshResult& result)
{
  const RemeshOptions& options = task.options;
  const SiteDrawing drawing{ options.sampling, options.seed };
  return task.features ? samplePatches(task.featured(), counts, drawing, result.sites, control)
                       : sampleSurface(task.surface, counts[0], drawing, result.sites, control);
}

/** A few iterations, and the diagram. */
Status relaxCoarse(const Task& task, const RunControl& control, RemeshResult& coarse)
{
  RestrictedVoronoi voronoi(task.surface);
  voronoi.divideAmong(task.options.ranks);
  const Relaxation relaxation = task.relaxation(voronoi, coarse);
  QuasiNewtonOptions newton = task.options.quasiNewton;
  newton.iterations = std::min(newton.iterations, coarseNewton);
  Status status =
    relaxLloyd(relaxation, std::min(task.options.lloydIterations, coarseLloyd), control.step(0, 3));
  if (status.ok())
  {
    status = minimizeQuasiNewton(relaxation, newton, control.step(1, 3));
  }
  if (status.ok())
  {
    status = voronoi.decompose(coarse.sites, control.step(2, 3), coarse.sums, coarse.diagram);
  }
  coarse.evaluations = voronoi.evaluations();
  return status;
}

/** Grows free sites from those of a quarter as many, where enough of them would be of use. */
Status growFreeSites(const Task& task, const RunControl& control, RemeshResult& result)
{
  const Offset coarseSites = (result.sites.count() - result.sites.fixed) / growth;
  if (coarseSites < minCoarse || result.sites.count() / minForFixed < result.sites.fixed)
  {
    return Status::success();
  }
  RemeshOptions options = task.options;
  options.numberOfSites = options.numberOfSites / growth + 2;
  const Task coarseTask{ task.mesh, task.surface, task.features, options };
  RemeshResult coarse;
  coarse.sites.dimension = task.surface.dimension;
  Status status =
    task.features ? makeFixedSites(coarseTask, control.silent(), coarse) : Status::success();
  if (status.ok())
  {
    status = drawFreeSites(
      coarseTask, shareOut(coarseTask, coarse, coarseSites + 2), control.silent(), coarse);
  }
  if (status.ok())
  {
    status = relaxCoarse(coarseTask, control, coarse);
  }
  result.evaluations = coarse.evaluations;
  return status.ok() ? growSites(task.surface, { coarse.sites, coarse.sums, coarse.diagram },
                         control.silent(), result.sites)
                     : status;
}
}

Status makeSites(const Task& task, const RunControl& control, RemeshResult& result)
{
  const RemeshOptions& options = task.options;
  if (options.initialSites.count() > 0)
  {
    result.sites = options.initialSites;
    return Status::success();
  }
  if (Status status = checkNumberOfSites(options.numberOfSites); !status.ok())
  {
    return status;
  }
  result.sites.dimension = task.surface.dimension;
  if (task.features)
  {
    if (Status status = makeFixedSites(task, control, result); !status.ok())
    {
      return status;
    }
  }
  const Offset freeSites = options.numberOfSites - result.featureSites.numberOfPoints();
  Status status = drawFreeSites(task, shareOut(task, result, freeSites), control.silent(), result);
  const bool iterates = options.lloydIterations > 0 || options.quasiNewton.iterations > 0;
  if (status.ok() && options.coarseStart && iterates)
  {
    status = growFreeSites(task, control, result);
  }
  return status;
}
}
