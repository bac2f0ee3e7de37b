/**
 * @file Intake.cxx
 *
 * 1. Check sizes and ids; collect the points that triangles use; check their coordinates.
 * 2. Merge coincident points (Weld).
 * 3. Drop degenerate triangles, then duplicates (Duplicates).
 * 4. Make the orientation consistent shell by shell (Orientation), in the order of the input, so
 *    that "the first facet" means the caller's first.
 * 5. Order the facets along a Hilbert curve (SpatialOrder), number the points in the order in
 *    which the facets then meet them, and write the mesh.
 *
 * Cost: O(T), sorts included, with the default merge distance. The caller's triangle is known by
 * its number up to step 5, so that the ids of cells and points are copied once.
 */
#include "Mesh/Intake.h"

#include "Mesh/Duplicates.h"
#include "Mesh/EdgeTable.h"
#include "Mesh/FacetGeometry.h"
#include "Mesh/Orientation.h"
#include "Mesh/SpatialOrder.h"
#include "Mesh/Weld.h"
#include "Support/DisjointSets.h"

#include <cmath>
#include <new>
#include <sstream>

namespace remesh
{
namespace
{
/** The surface between soup and mesh, in the order of the soup. */
struct Draft
{
  std::vector<Offset> inputPoints;   ///< U, the caller's ids of the used points, ascending
  std::vector<Point3> points;        ///< U
  std::vector<Triple> facets;        ///< F x 3, into `points`
  std::vector<Index> facetTriangles; ///< F, into the soup's triangles
};

constexpr std::size_t cancellationStride = std::size_t(1) << 16; ///< facets between two questions

bool cancelledAt(std::size_t facet, const RunControl& control)
{
  return facet % cancellationStride == 0 && control.cancelled();
}

template <class... Parts>
std::string sentence(const Parts&... parts)
{
  std::ostringstream stream;
  (stream << ... << parts);
  return stream.str();
}

Status checkTriangles(const TriangleSoup& soup)
{
  const auto count = static_cast<std::int64_t>(soup.triangles.size());
  if (count > maximumInputTriangles)
  {
    return Status::invalid(sentence("The surface has ", count, " triangles; the most that can be ",
      "taken in is ", maximumInputTriangles, "."));
  }
  if (soup.inputCells.size() != soup.triangles.size())
  {
    return Status::invalid(
      sentence("There are ", soup.inputCells.size(), " cell ids for ", count, " triangles."));
  }
  const auto numberOfPoints = static_cast<Offset>(soup.points.size());
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
  {
    for (const Offset point : soup.triangles[t])
    {
      if (point < 0 || point >= numberOfPoints)
      {
        return Status::invalid(sentence("Cell ", soup.inputCells[t], " refers to point ", point,
          ", but the surface has ", numberOfPoints, " points."));
      }
    }
  }
  return Status::success();
}

/** Numbers the used points and writes the facets with these numbers. */
Status collectUsedPoints(const TriangleSoup& soup, Draft& draft)
{
  std::vector<Index> local(soup.points.size(), noIndex);
  for (const auto& triangle : soup.triangles)
  {
    for (const Offset point : triangle)
    {
      local[point] = 0;
    }
  }
  for (std::size_t point = 0; point < local.size(); ++point)
  {
    if (local[point] == noIndex)
    {
      continue;
    }
    if (static_cast<std::int64_t>(draft.points.size()) == maximumIndex)
    {
      return Status::invalid(sentence("The surface has more than ", maximumIndex, " points."));
    }
    local[point] = static_cast<Index>(draft.points.size());
    draft.inputPoints.push_back(static_cast<Offset>(point));
    draft.points.push_back(soup.points[point]);
  }
  draft.facets.resize(soup.triangles.size());
  draft.facetTriangles.resize(soup.triangles.size());
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
  {
    const auto& triangle = soup.triangles[t];
    draft.facets[t] = { local[triangle[0]], local[triangle[1]], local[triangle[2]] };
    draft.facetTriangles[t] = static_cast<Index>(t);
  }
  return Status::success();
}

Status checkCoordinates(const Draft& draft)
{
  Point3 lower = Point3::Zero();
  Point3 upper = Point3::Zero();
  for (std::size_t i = 0; i < draft.points.size(); ++i)
  {
    const Point3& point = draft.points[i];
    if (!point.allFinite())
    {
      return Status::invalid(sentence("Point ", draft.inputPoints[i], " is not finite: (", point[0],
        ", ", point[1], ", ", point[2], ")."));
    }
    if (!(point.cwiseAbs().maxCoeff() <= largestCoordinate))
    {
      return Status::invalid(sentence("Point ", draft.inputPoints[i], " is too far away: (",
        point[0], ", ", point[1], ", ", point[2], ") exceeds ", largestCoordinate, "."));
    }
    lower = i == 0 ? point : Point3(lower.cwiseMin(point));
    upper = i == 0 ? point : Point3(upper.cwiseMax(point));
  }
  const double extent = (upper - lower).maxCoeff();
  if (extent > 0.0 && extent < smallestExtent)
  {
    return Status::invalid(sentence("The surface is too small: its longest extent, ", extent,
      ", is below ", smallestExtent, "; scale it up."));
  }
  return Status::success();
}

Status mergePoints(
  const IntakeOptions& options, const RunControl& control, Draft& draft, IntakeReport& report)
{
  const double distance = options.mergeDistance;
  if (!(distance >= 0.0) || std::isinf(distance))
  {
    return Status::invalid(
      sentence("The merge distance must be finite and not negative, but is ", distance, "."));
  }
  const std::vector<Index> lowest = distance > 0.0 ? weldNearPoints(draft.points, distance, control)
                                                   : weldEqualPoints(draft.points);
  for (std::size_t i = 0; i < lowest.size(); ++i)
  {
    report.mergedPoints += lowest[i] != static_cast<Index>(i);
  }
  for (Triple& facet : draft.facets)
  {
    facet = { lowest[facet[0]], lowest[facet[1]], lowest[facet[2]] };
  }
  return control.cancelled() ? Status::cancelled() : Status::success();
}

/** Keeps the facets for which `keep(facet)` holds, in their order; returns how many went. */
template <class Keep>
Offset keepFacets(Draft& draft, const Keep& keep)
{
  std::size_t kept = 0;
  for (std::size_t f = 0; f < draft.facets.size(); ++f)
  {
    if (keep(f))
    {
      draft.facets[kept] = draft.facets[f];
      draft.facetTriangles[kept] = draft.facetTriangles[f];
      ++kept;
    }
  }
  const auto dropped = static_cast<Offset>(draft.facets.size() - kept);
  draft.facets.resize(kept);
  draft.facetTriangles.resize(kept);
  return dropped;
}

Status dropBadFacets(const RunControl& control, Draft& draft, IntakeReport& report)
{
  const auto count = static_cast<Offset>(draft.facets.size());
  bool cancelled = false;
  report.droppedDegenerate = keepFacets(draft,
    [&](std::size_t f)
    {
      cancelled = cancelled || cancelledAt(f, control);
      const auto& [a, b, c] = draft.facets[f];
      return !cancelled && a != b && b != c && c != a &&
        hasArea(draft.points[a], draft.points[b], draft.points[c]);
    });
  if (cancelled)
  {
    return Status::cancelled();
  }
  const std::vector<unsigned char> duplicate = findDuplicates(draft.facets);
  report.droppedDuplicate = keepFacets(draft, [&](std::size_t f) { return !duplicate[f]; });
  if (draft.facets.empty())
  {
    return Status::empty(count == 0
        ? std::string("The surface has no triangles.")
        : sentence("None of the surface's ", count, " triangles has an area."));
  }
  return Status::success();
}

/** Turns facets round, keeping the first point of each, and fills the edges' part of the report. */
Orientation orient(const Draft& draft, IntakeReport& report)
{
  const EdgeTable edges = buildEdgeTable(draft.facets);
  for (Index edge = 0; edge < edges.numberOfEdges(); ++edge)
  {
    report.boundaryEdges += edges.valence(edge) == 1;
    report.nonManifoldEdges += edges.valence(edge) > 2;
  }
  std::vector<double> areas(draft.facets.size());
  for (std::size_t f = 0; f < areas.size(); ++f)
  {
    const auto& [a, b, c] = draft.facets[f];
    areas[f] = facetArea(draft.points[a], draft.points[b], draft.points[c]);
  }
  Orientation orientation = findOrientation(draft.facets, edges, areas);
  report.flippedFacets = orientation.numberOfFlipped;
  report.orientable = orientation.orientable;
  return orientation;
}

std::vector<Index> orderFacets(const Draft& draft)
{
  std::vector<Point3> centroids(draft.facets.size());
  for (std::size_t f = 0; f < centroids.size(); ++f)
  {
    const auto& [a, b, c] = draft.facets[f];
    centroids[f] = (draft.points[a] + draft.points[b] + draft.points[c]) / 3.0;
  }
  return orderAlongHilbertCurve(centroids);
}

void writeFacets(const TriangleSoup& soup, const Draft& draft, const Orientation& orientation,
  const std::vector<Index>& order, SurfaceMesh& mesh)
{
  const std::size_t count = order.size();
  mesh.facetPoints.resize(count);
  mesh.facetInputCells.resize(count);
  mesh.facetInputPoints.resize(count);
  for (std::size_t f = 0; f < count; ++f)
  {
    const Index source = order[f];
    const Index triangle = draft.facetTriangles[source];
    mesh.facetPoints[f] = draft.facets[source];
    mesh.facetInputCells[f] = soup.inputCells[triangle];
    mesh.facetInputPoints[f] = soup.triangles[triangle];
    if (orientation.flipped[source])
    {
      std::swap(mesh.facetPoints[f][1], mesh.facetPoints[f][2]);
      std::swap(mesh.facetInputPoints[f][1], mesh.facetInputPoints[f][2]);
    }
  }
}

/** Replaces the draft's point ids in the mesh's facets, numbering points as facets meet them. */
void numberPoints(const Draft& draft, SurfaceMesh& mesh)
{
  std::vector<Index> number(draft.points.size(), noIndex);
  for (Triple& facet : mesh.facetPoints)
  {
    for (Index& point : facet)
    {
      Index& given = number[point];
      if (given == noIndex)
      {
        given = mesh.numberOfPoints();
        mesh.points.push_back(draft.points[point]);
      }
      point = given;
    }
  }
  mesh.facetCorners = mesh.facetPoints;
  mesh.cornerPoints.resize(mesh.points.size());
  std::iota(mesh.cornerPoints.begin(), mesh.cornerPoints.end(), Index(0));
}

Index countComponents(const SurfaceMesh& mesh)
{
  DisjointSets sets(mesh.points.size());
  for (const auto& [a, b, c] : mesh.facetPoints)
  {
    sets.unite(a, b);
    sets.unite(b, c);
  }
  return sets.count();
}

/** Steps 1 to 3: everything that can fail. */
Status draftSurface(const TriangleSoup& soup, const IntakeOptions& options,
  const RunControl& control, Draft& draft, IntakeReport& report)
{
  Status status = checkTriangles(soup);
  if (status.ok())
  {
    status = collectUsedPoints(soup, draft);
  }
  if (status.ok())
  {
    status = checkCoordinates(draft);
  }
  if (status.ok())
  {
    control.report(0.2);
    status = mergePoints(options, control, draft, report);
  }
  if (status.ok())
  {
    control.report(0.4);
    status = dropBadFacets(control, draft, report);
  }
  return status;
}

Status takeIn(const TriangleSoup& soup, const IntakeOptions& options, const RunControl& control,
  SurfaceMesh& mesh, IntakeReport& report)
{
  Draft draft;
  if (Status status = draftSurface(soup, options, control, draft, report); !status.ok())
  {
    return status;
  }
  control.report(0.55);
  const Orientation orientation = orient(draft, report);
  control.report(0.8);
  if (control.cancelled())
  {
    return Status::cancelled();
  }
  writeFacets(soup, draft, orientation, orderFacets(draft), mesh);
  numberPoints(draft, mesh);
  report.components = countComponents(mesh);
  control.report(1.0);
  return Status::success();
}
}

Status buildSurfaceMesh(const TriangleSoup& soup, const IntakeOptions& options,
  const RunControl& control, SurfaceMesh& mesh, IntakeReport& report)
{
  mesh = SurfaceMesh();
  report = IntakeReport();
  if (control.cancelled())
  {
    return Status::cancelled();
  }
  try
  {
    return takeIn(soup, options, control, mesh, report);
  }
  catch (const std::bad_alloc&)
  {
    mesh = SurfaceMesh();
    return { StatusCode::OutOfMemory,
      sentence("There is not enough memory for ", soup.triangles.size(), " triangles.") };
  }
}
}
