/**
 * @file SeamCharts.cxx
 *
 * 1. List the caller's points at each point of the mesh that has several.
 * 2. There, compare their values in the order of their ids: each is on the chart of the first that
 *    is close enough.
 */
#include "Preparation/SeamCharts.h"

#include "Mesh/EdgeTable.h"
#include "Mesh/NormalFlow.h"
#include "Support/Grouping.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace remesh
{
namespace
{
/** Of the points: as many may be on seams. */
constexpr double maxOnSeams = 1.0 / 3.0;

/** Of an array's range: what is left of equal values after they were rounded to 5 digits. */
constexpr double rounding = 1e-4;

/** Points that were merged although they are apart have other values by as much, or some times. */
double toleranceOf(const PreparationRequest& request)
{
  return std::max(rounding, 10.0 * request.mergeTolerance);
}

/** Whether an array is there for the run, with a value for each side of a crease. */
bool isUsed(const PreparationRequest& request, const std::string& name)
{
  const auto isIt = [&](const auto& array) { return array && array->name == name; };
  return isIt(request.normals) || isIt(request.embedding) || isIt(request.metric) ||
    isIt(request.density) ||
    std::any_of(request.coordinates.begin(), request.coordinates.end(),
      [&](const auto& coordinate) { return coordinate.first.name == name; });
}

/** A point of the mesh, and one of the caller's there. */
using Copy = std::pair<Index, Offset>;

/** Of the points of the mesh with several of the caller's: those, sorted. */
std::vector<Copy> findCopies(const SurfaceMesh& mesh)
{
  std::vector<Offset> first(mesh.points.size(), -1);
  std::vector<Copy> copies;
  for (Index facet = 0; facet < mesh.numberOfFacets(); ++facet)
  {
    const auto inputs = mesh.facetInputPoints[facet];
    for (int k = 0; k < 3; ++k)
    {
      const Index point = mesh.facetPoints[facet][k];
      if (first[point] < 0)
      {
        first[point] = inputs[k];
      }
      else if (first[point] != inputs[k])
      {
        copies.emplace_back(point, first[point]);
        copies.emplace_back(point, inputs[k]);
      }
    }
  }
  std::sort(copies.begin(), copies.end());
  copies.erase(std::unique(copies.begin(), copies.end()), copies.end());
  return copies;
}

/** A share of the range of each component's finite values. */
std::vector<double> stepsOf(const PointArray& array, double share)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> row(static_cast<std::size_t>(array.dimension));
  std::vector<double> low(row.size(), infinity);
  std::vector<double> high(row.size(), -infinity);
  for (Offset point = 0; point < array.count; ++point)
  {
    array.read(point, row.data());
    for (std::size_t c = 0; c < row.size(); ++c)
    {
      low[c] = std::isfinite(row[c]) ? std::min(low[c], row[c]) : low[c];
      high[c] = std::isfinite(row[c]) ? std::max(high[c], row[c]) : high[c];
    }
  }
  std::transform(high.begin(), high.end(), low.begin(), row.begin(),
    [&](double most, double least) { return most > least ? share * (most - least) : 0.0; });
  return row;
}

bool areSame(double here, double there, double step)
{
  return here == there || (std::isnan(here) && std::isnan(there)) || std::abs(here - there) <= step;
}

/** The chart of each copy; counts the points with several. */
std::vector<Index> findCharts(const std::vector<Copy>& copies, const PointArray& array,
  double tolerance, Offset& pointsWithSeveral)
{
  const std::vector<double> steps = stepsOf(array, tolerance);
  std::vector<double> here(steps.size());
  std::vector<double> there(steps.size());
  const auto areClose = [&](Offset a, Offset b)
  {
    array.read(a, here.data());
    array.read(b, there.data());
    std::size_t c = 0;
    while (c < steps.size() && areSame(here[c], there[c], steps[c]))
    {
      ++c;
    }
    return c == steps.size();
  };
  std::vector<Index> charts(copies.size(), 0);
  for (std::size_t begin = 0, end = 0; begin < copies.size(); begin = end)
  {
    std::vector<Offset> leaders;
    for (end = begin; end < copies.size() && copies[end].first == copies[begin].first; ++end)
    {
      const Offset input = copies[end].second;
      const auto leader = std::find_if(
        leaders.begin(), leaders.end(), [&](Offset other) { return areClose(other, input); });
      charts[end] = static_cast<Index>(leader - leaders.begin());
      if (leader == leaders.end())
      {
        leaders.push_back(input);
      }
    }
    pointsWithSeveral += leaders.size() > 1 ? 1 : 0;
  }
  return charts;
}

/** The length of all seams in R^3. O(F). */
double lengthOfSeams(
  const SurfaceMesh& mesh, const std::vector<Triple>& charts, const RunControl& control)
{
  const EdgeTable edges = buildEdgeTable(mesh.facetPoints, control);
  double length = 0.0;
  for (Index edge = 0; edge < edges.numberOfEdges() && !control.cancelled(); ++edge)
  {
    if (edges.valence(edge) == 2 && isSeam(mesh, edges, charts, edge))
    {
      const Index facet = edges.edgeFacets[edges.edgeFacetsBegin[edge]];
      const int k = edges.sideOf(facet, edge);
      const Triple& points = mesh.facetPoints[facet];
      length += (mesh.points[points[k]] - mesh.points[points[(k + 1) % 3]]).norm();
    }
  }
  return length;
}
}

SeamCharts findSeamCharts(
  const SurfaceMesh& mesh, const PointArray& array, double tolerance, const RunControl& control)
{
  SeamCharts seams;
  if (!mesh.facetInputPoints.differ())
  {
    return seams;
  }
  const std::vector<Copy> copies = findCopies(mesh);
  const std::vector<Index> charts = findCharts(copies, array, tolerance, seams.points);
  if (seams.points == 0)
  {
    return seams;
  }
  seams.ofCorners.resize(mesh.facetPoints.size(), Triple{ 0, 0, 0 });
  const auto findCorners = [&](Offset facet)
  {
    const auto inputs = mesh.facetInputPoints[facet];
    for (int k = 0; k < 3; ++k)
    {
      const Copy copy(mesh.facetPoints[facet][k], inputs[k]);
      const auto found = std::lower_bound(copies.begin(), copies.end(), copy);
      if (found != copies.end() && *found == copy)
      {
        seams.ofCorners[facet][k] = charts[found - copies.begin()];
      }
    }
  };
  static_cast<void>(forEachItem(mesh.numberOfFacets(), control, findCorners));
  return seams;
}

std::vector<Triple> findKeptSeams(
  const SurfaceMesh& mesh, const PreparationRequest& request, const RunControl& control)
{
  if (!request.seams)
  {
    return {};
  }
  SeamCharts seams = findSeamCharts(mesh, *request.seams, toleranceOf(request), control);
  if (seams.points > 0)
  {
    const double spacing = meanSpacing(mesh, request.numberOfSites);
    const double most = maxOnSeams * static_cast<double>(request.numberOfSites) * spacing;
    if (lengthOfSeams(mesh, seams.ofCorners, control) > most)
    {
      return {};
    }
  }
  return std::move(seams.ofCorners);
}

void tellJumps(
  const PreparationRequest& request, const RunControl& control, PreparedSurface& prepared)
{
  std::string others;
  for (const PointArray& array : request.carried)
  {
    const bool isSeams = request.seams && array.name == request.seams->name;
    if ((isSeams && !prepared.charts.empty()) || isUsed(request, array.name) ||
      findSeamCharts(prepared.mesh, array, toleranceOf(request), control).points == 0)
    {
      continue;
    }
    const std::string name = "\"" + array.name + "\"";
    if (isSeams && request.preserveFeatures)
    {
      prepared.warnings.push_back("The seams of " + name +
        " are not kept, as they would take more than a third of the points: its values are "
        "interpolated across. More points help.");
    }
    else
    {
      others += (others.empty() ? "" : ", ") + name;
    }
  }
  if (!others.empty())
  {
    prepared.warnings.push_back("Values jump where points of the surface coincide, and are "
                                "interpolated across: " +
      others + ". SeamArray keeps the seams of one array, with PreserveFeatures on.");
  }
}
}
