#include "Pipeline/ToleranceSearch.h"

#include "Comparison/DistanceLimit.h"
#include "Embedding/CornerReader.h"
#include "Embedding/Distance.h"
#include "Embedding/Embedding.h"
#include "Mesh/ClosestPoint.h"
#include "Run/MeshDistance.h"
#include "Voronoi/RestrictedVoronoi.h"
#include "Voronoi/VertexPlaces.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
constexpr double meanOfTolerance = 0.35; // what the mean distance is to be
constexpr Offset pilotGrowth = 8;        // of the points, from one pilot to the next
constexpr double maxOnFeatures = 0.6;    // of the points, see sampleCurves
constexpr int settlingSteps = 2;
constexpr int maxRounds = 40;
constexpr int maxIdleRounds = 14; // without progress
constexpr int crowdingRounds = 2; // likewise; then cells around far places get sites, too
/**
 * Share of cells with a far place from which on no others move for those that are added: they would
 * come to be too far themselves, so that the far places wander and do not end.
 */
constexpr double fewFarCells = 0.05;
constexpr double progress = 0.95; // of the least share of cells with a far place so far
constexpr double tooNear = 0.2;   // to a site, for another one; over the root of its cell's mass
constexpr double manyTolerances = 3.0; // beyond which a cell gets two sites at once

/** A place of the surface from which a distance is beyond the tolerance. */
struct Excess
{
  double distance;
  Index facet;
  ClosestPoint at;
  Index component = noIndex; ///< whose cell it is in
};

/** All that the rounds share. */
struct Search
{
  const RunRequest& request;
  RunOutcome& outcome;
  TriangleTree tree; ///< of the surface
  const SurfaceMesh& mesh = outcome.prepared.mesh;
  const EmbeddedSurface& surface = outcome.prepared.surface;
  RemeshResult& result = outcome.result;
};

std::vector<double> embeddedPlace(const EmbeddedSurface& surface, Index facet, const double b[3])
{
  CornerReader<Eigen::Dynamic> reader(surface);
  const auto corners = reader.facet(facet);
  std::vector<double> place(static_cast<std::size_t>(surface.dimension));
  for (int k = 0; k < surface.dimension; ++k)
  {
    place[k] = b[0] * corners[0][k] + b[1] * corners[1][k] + b[2] * corners[2][k];
  }
  return place;
}

/** The component of the nearest site's piece in the place's facet. */
Index componentAt(const Search& search, const Excess& excess)
{
  const Diagram& diagram = search.result.diagram;
  const std::vector<double> place = embeddedPlace(search.surface, excess.facet, excess.at.b);
  Offset nearest = diagram.facetBegin[excess.facet];
  double least = std::numeric_limits<double>::infinity();
  for (Offset p = nearest; p < diagram.facetBegin[excess.facet + 1]; ++p)
  {
    const double squared = squaredDistance<Eigen::Dynamic>(
      place.data(), search.result.sites.site(diagram.sites[p]), search.surface.dimension);
    if (squared < least)
    {
      nearest = p;
      least = squared;
    }
  }
  return search.result.components.ofPiece[nearest];
}

/** @param place of the surface, in that facet or near it. */
Excess excessAt(const Search& search, double distance, Index facet, const Point3& place)
{
  const auto& [a, b, c] = search.mesh.facetPoints[facet];
  const std::vector<Point3>& points = search.mesh.points;
  Excess excess{ distance, facet, closestOnTriangle(place, points[a], points[b], points[c]) };
  excess.component = componentAt(search, excess);
  return excess;
}

/** Orders them by component, and leaves the farthest of each alone. */
void keepFarthest(std::vector<Excess>& excess)
{
  std::stable_sort(excess.begin(), excess.end(),
    [](const Excess& a, const Excess& b)
    { return a.component != b.component ? a.component < b.component : a.distance > b.distance; });
  excess.erase(std::unique(excess.begin(), excess.end(),
                 [](const Excess& a, const Excess& b) { return a.component == b.component; }),
    excess.end());
}

/** Both ways; ordered by component, the farthest of each alone. */
Status findExcess(const Search& search, const RunControl& control, std::vector<Excess>& excess)
{
  const double limit = search.request.tolerance.tolerance;
  const Triangles mesh = trianglesOf(search.result);
  const TriangleTree meshTree(mesh, control);
  std::vector<FarPlace> places;
  if (control.cancelled()) // the tree may be empty then
  {
    return Status::cancelled();
  }
  if (meshTree.empty())
  {
    return Status::invalid("The mesh has no triangle with an area above 0.");
  }
  excess.clear();
  if (Status status = findPlacesBeyond(mesh, search.tree, limit, control.step(0, 2), places);
      !status.ok())
  {
    return status;
  }
  for (const FarPlace& far : places)
  {
    const Index facet = search.tree.triangleOf(search.tree.closest(far.place).slot);
    excess.push_back(excessAt(search, far.distance, facet, far.place));
  }
  if (Status status =
        findPlacesBeyond(trianglesOf(search.mesh), meshTree, limit, control.step(1, 2), places);
      !status.ok())
  {
    return status;
  }
  for (const FarPlace& far : places)
  {
    excess.push_back(excessAt(search, far.distance, far.triangle, far.place));
  }
  keepFarthest(excess);
  return Status::success();
}

/** The point of a component farthest from its site. */
std::vector<double> farthestPlace(const Search& search, Index component)
{
  const Diagram& diagram = search.result.diagram;
  const Components& components = search.result.components;
  const VertexPlaces vertices{ search.surface, search.result.sites, diagram };
  std::vector<double> farthest;
  double largest = -1.0;
  for (Offset p = components.pieceBegin[component]; p < components.pieceBegin[component + 1]; ++p)
  {
    const Offset piece = components.pieces[p];
    for (Offset v = diagram.vertexBegin[piece]; v < diagram.vertexBegin[piece + 1]; ++v)
    {
      std::vector<double> place =
        embeddedPlace(search.surface, diagram.facets[piece], vertices.at(piece, v).data());
      const double squared = squaredDistance<Eigen::Dynamic>(
        place.data(), search.result.sites.site(diagram.sites[piece]), search.surface.dimension);
      if (squared > largest)
      {
        largest = squared;
        farthest = std::move(place);
      }
    }
  }
  return farthest;
}

/** New sites for these places, at most so many; those for the farthest places first. */
std::vector<double> newSites(const Search& search, std::vector<Excess> excess, Offset most)
{
  if (most < static_cast<Offset>(excess.size()))
  {
    std::stable_sort(excess.begin(), excess.end(),
      [](const Excess& a, const Excess& b) { return a.distance > b.distance; });
    excess.resize(static_cast<std::size_t>(most));
  }
  const auto d = static_cast<std::size_t>(search.surface.dimension);
  std::vector<double> added;
  for (const Excess& each : excess)
  {
    const std::vector<double> place = embeddedPlace(search.surface, each.facet, each.at.b);
    const std::vector<double> farthest = farthestPlace(search, each.component);
    const double squared = squaredDistance<Eigen::Dynamic>(place.data(),
      search.result.sites.site(search.result.components.sites[each.component]),
      search.surface.dimension);
    const bool isNear = squared < tooNear * tooNear * search.result.components.mass[each.component];
    const bool takesTwo = each.distance > manyTolerances * search.request.tolerance.tolerance &&
      static_cast<Offset>(added.size() / d) + 1 < most;
    if (!isNear)
    {
      added.insert(added.end(), place.begin(), place.end());
    }
    if (isNear || takesTwo)
    {
      added.insert(added.end(), farthest.begin(), farthest.end());
    }
  }
  return added;
}

/** K, 1: one of these components or of those around them. */
std::vector<char> componentsAround(const Search& search, const std::vector<Excess>& excess)
{
  std::vector<char> chosen(static_cast<std::size_t>(search.result.components.count()), 0);
  for (const Excess& each : excess)
  {
    chosen[each.component] = 1;
  }
  const std::vector<char> core = chosen;
  for (const Triple& triangle : search.result.dual.triangles)
  {
    if (core[triangle[0]] || core[triangle[1]] || core[triangle[2]])
    {
      chosen[triangle[0]] = chosen[triangle[1]] = chosen[triangle[2]] = 1;
    }
  }
  return chosen;
}

/** Free sites of these components and of those around them. */
std::vector<char> sitesAround(const Search& search, const std::vector<Excess>& excess)
{
  const Components& components = search.result.components;
  const std::vector<char> chosen = componentsAround(search, excess);
  std::vector<char> sites(static_cast<std::size_t>(search.result.sites.count()), 0);
  for (Index k = 0; k < components.count(); ++k)
  {
    sites[components.sites[k]] |= chosen[k];
  }
  return sites;
}

/**
 * Lloyd's steps for some sites: all others, and so the mesh elsewhere, stay.
 *
 * @param sums of the last step.
 */
Status settle(
  Search& search, const std::vector<char>& moves, const RunControl& control, CellSums& sums)
{
  Sites& sites = search.result.sites;
  RestrictedVoronoi voronoi(search.surface);
  for (int step = 0; step < settlingSteps; ++step)
  {
    if (Status status = voronoi.integrate(sites, control.step(step, settlingSteps), sums);
        !status.ok())
    {
      return status;
    }
    for (Index i = sites.fixed; i < sites.count(); ++i)
    {
      if (moves[i] && !sums.isEmpty(i))
      {
        double* x = sites.site(i);
        const double* moment = sums.moment.data() + static_cast<std::size_t>(i) * sites.dimension;
        for (int k = 0; k < sites.dimension; ++k)
        {
          x[k] += moment[k] / sums.mass[i];
        }
      }
    }
  }
  roundToCaller(search.surface, sites);
  search.result.evaluations += voronoi.evaluations();
  return Status::success();
}

/** Takes one site more for each of these components and of those around them, at most so many. */
void crowd(
  const Search& search, const std::vector<Excess>& excess, Offset most, std::vector<double>& added)
{
  const std::vector<char> chosen = componentsAround(search, excess);
  const Offset room = most * search.surface.dimension;
  for (Index k = 0; k < search.result.components.count(); ++k)
  {
    if (chosen[k] && static_cast<Offset>(added.size()) + search.surface.dimension <= room)
    {
      const std::vector<double> farthest = farthestPlace(search, k);
      added.insert(added.end(), farthest.begin(), farthest.end());
    }
  }
}

/** Leaves out those of the last sites that have no cell: two were added in one place. */
void dropEmpty(const CellSums& sums, Index first, Sites& sites)
{
  Index kept = first;
  for (Index i = first; i < sites.count(); ++i)
  {
    if (!sums.isEmpty(i))
    {
      std::copy_n(sites.site(i), sites.dimension, sites.site(kept++));
    }
  }
  sites.coordinates.resize(static_cast<std::size_t>(kept) * sites.dimension);
}

/**
 * Adds sites and makes the mesh anew.
 *
 * @param moves free sites that make room for the new ones.
 */
Status refine(
  Search& search, std::vector<char> moves, const std::vector<double>& added, RunControl control)
{
  RemeshResult& result = search.result;
  const auto first = static_cast<Index>(moves.size());
  result.sites.coordinates.insert(result.sites.coordinates.end(), added.begin(), added.end());
  moves.resize(static_cast<std::size_t>(result.sites.count()), 1);
  control.enterPhase("Refinement", 0.0, 0.3);
  CellSums sums;
  if (Status status = settle(search, moves, control, sums); !status.ok())
  {
    return status;
  }
  dropEmpty(sums, first, result.sites);
  result.movedSites += result.sites.count() - first;
  return completeMesh({ search.mesh, search.surface, search.outcome.prepared.featuresOrNone(),
                        search.request.options, search.outcome.prepared.metricOrNone() },
    control.part(0.3, 1.0), result);
}
}

Offset numberForTolerance(const NumberTrial& pilot, const ToleranceRequest& request)
{
  const double estimate =
    static_cast<double>(pilot.number) * pilot.mean / (meanOfTolerance * request.tolerance);
  const double least = std::max(4.0, static_cast<double>(pilot.minNumber) / maxOnFeatures);
  return static_cast<Offset>(
    std::min(std::max(estimate, least), static_cast<double>(request.maxPoints)));
}

Offset pilotAfter(Offset number, Offset estimate, bool isLost)
{
  const Offset many = pilotGrowth * number;
  return isLost && estimate > many ? many : 0;
}

namespace
{
/** Tells why the rounds end, and which cells are still too far. */
void conclude(const std::vector<Excess>& excess, Offset room, ToleranceOutcome& reached)
{
  reached.how = excess.empty() ? ToleranceOutcome::Kept
    : room <= 0                ? ToleranceOutcome::TooManyPoints
                               : ToleranceOutcome::Stuck;
  reached.farCells.clear();
  for (const Excess& each : excess)
  {
    reached.farCells.push_back(each.component);
  }
}

/** Adds sites where the mesh is too far, in more and more of a hurry. @param idle rounds. */
Status addSites(Search& search, const std::vector<Excess>& excess, Offset room, int idle,
  const RunControl& control)
{
  const RemeshResult& result = search.result;
  const double share = static_cast<double>(excess.size()) / result.components.count();
  std::vector<double> added = newSites(search, excess, room);
  if (idle >= crowdingRounds && share < fewFarCells)
  {
    crowd(search, excess, room, added);
  }
  const bool othersStay = idle > 0 || share < fewFarCells;
  std::vector<char> moves = othersStay
    ? std::vector<char>(static_cast<std::size_t>(result.sites.count()), 0)
    : sitesAround(search, excess);
  return refine(search, std::move(moves), added, control);
}
}

Status refineToTolerance(const RunRequest& request, Offset manyPoints, RunControl control,
  RunOutcome& outcome, ToleranceOutcome& reached)
{
  Search search{ request, outcome, TriangleTree(trianglesOf(outcome.prepared.mesh), control) };
  RemeshResult& result = outcome.result;
  std::vector<Excess> excess;
  auto least = std::numeric_limits<double>::infinity(); // share of cells with a far place
  int idle = 0;
  control.enterPhase("Refinement", 0.0, 1.0);
  for (int round = 0;; ++round)
  {
    // Each round fills half of the progress that is left.
    control = control.part(0.0, 1.0);
    control.enterPhase("Distance", 0.0, 0.1);
    if (Status status = findExcess(search, control, excess); !status.ok())
    {
      return status;
    }
    // Their number grows at first: where many more cells are needed, both halves of one are far.
    const double share = static_cast<double>(excess.size()) / result.components.count();
    idle = share < progress * least ? 0 : idle + 1;
    least = std::min(least, share);
    const Offset number = result.components.count();
    const Offset room = number < manyPoints ? request.tolerance.maxPoints - number : 0;
    if (excess.empty() || room <= 0 || idle == maxIdleRounds || round == maxRounds)
    {
      conclude(excess, room, reached);
      return Status::success();
    }
    if (Status status = addSites(search, excess, room, idle, control.part(0.1, 0.5)); !status.ok())
    {
      return status;
    }
    control = control.part(0.5, 1.0);
  }
}
}
