/**
 * @file SeamCharts.cxx
 *
 * 1. List the caller's points at each point of the mesh that has several.
 * 2. There, compare their values in the order of their ids: each is on the chart of the first that
 *    is close enough.
 */
#include "Adaptors/SeamCharts.h"

#include "Adaptors/CarriedArrays.h"
#include "Adaptors/MeshBlocks.h"
#include "Mesh/EdgeTable.h"
#include "Mesh/NormalFlow.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace remesh
{
namespace
{
/** Of the points: as many may be on seams. */
constexpr double mostOnSeams = 1.0 / 3.0;

/** Of an array's range: what is left of equal values after they were rounded to 5 digits. */
constexpr double rounding = 1e-4;

/** Points that were merged although they are apart have other values by as much, or some times. */
double toleranceOf(const PreparationRequest& request)
{
  return std::max(rounding, 10.0 * request.mergeTolerance);
}

/** Whether an array is there for the run, with a value for each side of a crease. */
bool isUsed(const PreparationRequest& request, vtkDataArray* array)
{
  return array == request.normals || array == request.embedding || array == request.metric ||
    array == request.density ||
    std::any_of(request.coordinates.begin(), request.coordinates.end(),
      [&](const auto& coordinate) { return coordinate.first == array; });
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

/** Tells whether two tuples of an array are the same but for a share of its range. */
class Sameness
{
public:
  Sameness(vtkDataArray* array, double tolerance)
    : Array(array)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      double range[2];
      array->GetFiniteRange(range, c);
      this->Steps.push_back(range[1] > range[0] ? tolerance * (range[1] - range[0]) : 0.0);
    }
  }

  bool operator()(Offset a, Offset b) const
  {
    for (std::size_t c = 0; c < this->Steps.size(); ++c)
    {
      const double here = this->Array->GetComponent(a, static_cast<int>(c));
      const double there = this->Array->GetComponent(b, static_cast<int>(c));
      const bool bothNaN = std::isnan(here) && std::isnan(there);
      if (here != there && !bothNaN && !(std::abs(here - there) <= this->Steps[c]))
      {
        return false;
      }
    }
    return true;
  }

private:
  vtkDataArray* Array;
  std::vector<double> Steps; ///< by component
};

/** The chart of each copy; counts the points with several. */
std::vector<Index> findCharts(
  const std::vector<Copy>& copies, const Sameness& same, Offset& pointsWithSeveral)
{
  std::vector<Index> charts(copies.size(), 0);
  for (std::size_t begin = 0, end = 0; begin < copies.size(); begin = end)
  {
    std::vector<Offset> leaders;
    for (end = begin; end < copies.size() && copies[end].first == copies[begin].first; ++end)
    {
      const Offset input = copies[end].second;
      const auto leader = std::find_if(
        leaders.begin(), leaders.end(), [&](Offset other) { return same(other, input); });
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
  const SurfaceMesh& mesh, vtkDataArray* array, double tolerance, const RunControl& control)
{
  SeamCharts seams;
  if (!mesh.facetInputPoints.differ())
  {
    return seams;
  }
  const std::vector<Copy> copies = findCopies(mesh);
  const std::vector<Index> charts = findCharts(copies, Sameness(array, tolerance), seams.points);
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
  SeamCharts seams = findSeamCharts(mesh, request.seams, toleranceOf(request), control);
  if (seams.points > 0)
  {
    const double spacing = meanSpacing(mesh, request.numberOfSites);
    const double most = mostOnSeams * static_cast<double>(request.numberOfSites) * spacing;
    if (lengthOfSeams(mesh, seams.ofCorners, control) > most)
    {
      return {};
    }
  }
  return std::move(seams.ofCorners);
}

void tellJumps(vtkPolyData* input, const PreparationRequest& request, const RunControl& control,
  PreparedSurface& prepared)
{
  // Blocks keep their own values where they meet.
  const bool hasBlocks = blocksOfCells(input) != nullptr;
  if (!request.tellsJumps || !prepared.mesh.facetInputPoints.differ() || hasBlocks)
  {
    return;
  }
  vtkPointData* data = input->GetPointData();
  std::string others;
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* array = data->GetArray(k);
    const bool isCarried = array && array->GetName() && hasMeans(array) &&
      array->GetNumberOfTuples() == input->GetNumberOfPoints() &&
      !isReserved(meshPointNames, array->GetName());
    const bool isKept = array == request.seams && !prepared.charts.empty();
    if (!isCarried || isKept || isUsed(request, array) || array == data->GetNormals() ||
      findSeamCharts(prepared.mesh, array, toleranceOf(request), control).points == 0)
    {
      continue;
    }
    const std::string name = "\"" + std::string(array->GetName()) + "\"";
    if (array == request.seams && request.preserveFeatures)
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
