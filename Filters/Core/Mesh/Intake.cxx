/**
 * @file Intake.cxx
 *
 * 1. Check sizes and ids; collect the points that triangles use; check their coordinates
 *    (IntakeDraft).
 * 2. Merge coincident points (Weld), and the ends of sides that are nothing but rounding.
 * 3. Drop degenerate triangles, without opening slits (CapSplit), then duplicates and flaps
 * (Duplicates).
 * 4. Make the orientation consistent shell by shell (Orientation), in the order of the input, so
 *    that "the first facet" means the caller's first.
 * 5. Order the facets along a Hilbert curve (SpatialOrder), number the points in the order in
 *    which the facets then meet them, and write the mesh.
 *
 * Cost: O(T), sorts included, with the default merge distance, in parallel but for shells whose
 * facets disagree, and for borders. The caller's triangle is known by
 * its number up to step 5, so that the ids of cells and points are copied once.
 */
#include "Mesh/Intake.h"

#include "Mesh/CapSplit.h"
#include "Mesh/Duplicates.h"
#include "Mesh/EdgeTable.h"
#include "Mesh/Extent.h"
#include "Mesh/FacetGeometry.h"
#include "Mesh/IntakeDraft.h"
#include "Mesh/Orientation.h"
#include "Mesh/SpatialOrder.h"
#include "Mesh/Weld.h"
#include "Support/DisjointSets.h"
#include "Support/Grouping.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <new>
#include <numeric>

namespace remesh
{
namespace
{
constexpr double shortSide = 1e-6; // of the longest one of a facet, if it may be but rounding

/** Calls `visit(a, b)` for the ends of sides of a triangle that are shorter than `least` and short.
 */
template <class Visit>
void visitShortSides(
  const std::vector<Point3>& points, const Triple& triangle, double least, const Visit& visit)
{
  std::array<double, 3> lengths{};
  for (int k = 0; k < 3; ++k)
  {
    lengths[k] = (points[triangle[k]] - points[triangle[(k + 1) % 3]]).norm();
  }
  const double longest = *std::max_element(lengths.begin(), lengths.end());
  for (int k = 0; k < 3; ++k)
  {
    const Index a = triangle[k];
    const Index b = triangle[(k + 1) % 3];
    if (a != b && lengths[k] < std::min(least, shortSide * longest))
    {
      visit(a, b);
    }
  }
}

/**
 * Makes the ends of sides that are nothing but rounding one point, the lowest. They are also short
 * against their facets, lest a part that is small against the distance to another one goes.
 */
bool mergeShortSides(const Draft& draft, const RunControl& control, std::vector<Index>& lowest)
{
  const double least = roundingOfPoints(draft.points);
  const auto forEachShortSide = [&](const auto& visit)
  {
    return forEachItem(static_cast<Offset>(draft.facets.size()), control,
      [&](Offset f)
      {
        const auto& [a, b, c] = draft.facets[f];
        visitShortSides(draft.points, { lowest[a], lowest[b], lowest[c] }, least, visit);
      });
  };
  std::atomic<bool> isAny = false;
  if (!forEachShortSide([&](Index, Index) { isAny.store(true, std::memory_order_relaxed); }))
  {
    return false;
  }
  if (!isAny.load())
  {
    return true;
  }
  DisjointSets sets(draft.points.size());
  if (!forEachShortSide([&](Index a, Index b) { sets.unite(a, b); }))
  {
    return false;
  }
  for (Index& point : lowest)
  {
    point = sets.find(point);
  }
  return true;
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
  std::vector<Index> lowest = distance > 0.0 ? weldNearPoints(draft.points, distance, control)
                                             : weldEqualPoints(draft.points, control);
  if (control.cancelled() || !mergeShortSides(draft, control.silent(), lowest))
  {
    return Status::cancelled();
  }
  const Offset merged = countItems(static_cast<Offset>(lowest.size()), control.silent(),
    [&](Offset i) { return lowest[i] != static_cast<Index>(i); });
  report.mergedPoints = std::max<Offset>(merged, 0);
  const bool done = merged == 0 ||
    forEachItem(static_cast<Offset>(draft.facets.size()), control.silent(),
      [&](Offset f)
      {
        Triple& facet = draft.facets[f];
        facet = { lowest[facet[0]], lowest[facet[1]], lowest[facet[2]] };
      });
  return done ? Status::success() : Status::cancelled();
}

/** Removes the facets that are marked, keeping the others' order; returns how many went. */
Offset removeFacets(const std::vector<unsigned char>& marked, Draft& draft)
{
  std::size_t kept = 0;
  for (std::size_t f = 0; f < draft.facets.size(); ++f)
  {
    if (!marked[f])
    {
      draft.facets[kept] = draft.facets[f];
      draft.facetTriangles[kept] = draft.facetTriangles[f];
      if (!draft.facetInputs.empty())
      {
        draft.facetInputs[kept] = draft.facetInputs[f];
      }
      ++kept;
    }
  }
  const auto dropped = static_cast<Offset>(draft.facets.size() - kept);
  draft.facets.resize(kept);
  draft.facetTriangles.resize(kept);
  draft.facetInputs.resize(draft.facetInputs.empty() ? 0 : kept);
  return dropped;
}

void dropDuplicates(const RunControl& control, Draft& draft, IntakeReport& report)
{
  Duplicates duplicates = findDuplicates(draft.facets, control);
  std::vector<unsigned char>& folded = duplicates.folded; // then of the facets that are left
  for (std::size_t f = 0, kept = 0; f < folded.size(); ++f)
  {
    folded[kept] = folded[f];
    kept += !duplicates.repeats[f];
  }
  report.droppedDuplicate = removeFacets(duplicates.repeats, draft);
  folded.resize(draft.facets.size());
  report.droppedFlaps = removeFacets(findFlaps(draft.facets, folded, control), draft);
}

Status dropBadFacets(
  const TriangleSoup& soup, const RunControl& control, Draft& draft, IntakeReport& report)
{
  const auto count = static_cast<Offset>(draft.facets.size());
  std::vector<unsigned char> marked(draft.facets.size(), 0);
  if (!forEachItem(count, control.silent(),
        [&](Offset f)
        {
          const auto& [a, b, c] = draft.facets[f];
          marked[f] = a == b || b == c || c == a ||
            !hasArea(draft.points[a], draft.points[b], draft.points[c]);
        }))
  {
    return Status::cancelled();
  }
  report.droppedDegenerate = std::count(marked.begin(), marked.end(), 1);
  if (report.droppedDegenerate > 0)
  {
    if (report.droppedDegenerate < count) // else there is nothing to keep joined
    {
      splitAtCaps(soup, control, marked, draft);
    }
    removeFacets(marked, draft);
    report.addedBySplits =
      static_cast<Offset>(draft.facets.size()) + report.droppedDegenerate - count;
  }
  dropDuplicates(control, draft, report);
  if (control.cancelled())
  {
    return Status::cancelled();
  }
  if (draft.facets.empty())
  {
    return Status::empty(count == 0
        ? std::string("The surface has no triangles.")
        : sentence("None of the surface's ", count, " triangles has an area."));
  }
  return Status::success();
}

/** Finds out which facets to turn round, and fills the edges' part of the report. */
Orientation orient(const Draft& draft, const RunControl& control, IntakeReport& report)
{
  const EdgeTable edges = buildEdgeTable(draft.facets, control);
  const auto count = [&](const auto& isWanted)
  {
    return static_cast<Index>(countItems(edges.numberOfEdges(), control.silent(),
      [&](Offset edge) { return isWanted(edges.valence(static_cast<Index>(edge))); }));
  };
  report.boundaryEdges = count([](Index valence) { return valence == 1; });
  report.nonManifoldEdges = count([](Index valence) { return valence > 2; });
  report.gaps = findBorderGaps(draft.points, draft.facets, edges, control.silent());
  Orientation orientation;
  if (isOriented(draft.facets, edges, control) || control.cancelled())
  {
    orientation.flipped.assign(draft.facets.size(), 0);
    return orientation;
  }
  std::vector<double> areas(draft.facets.size());
  for (std::size_t f = 0; f < areas.size(); ++f)
  {
    const auto& [a, b, c] = draft.facets[f];
    areas[f] = facetArea(draft.points[a], draft.points[b], draft.points[c]);
  }
  orientation = findOrientation(draft.facets, edges, areas);
  report.flippedFacets = orientation.numberOfFlipped;
  report.orientable = orientation.orientable;
  return orientation;
}

std::vector<Index> orderFacets(const Draft& draft, const RunControl& control)
{
  std::vector<Point3> centroids(draft.facets.size());
  const bool done = forEachItem(static_cast<Offset>(centroids.size()), control.silent(),
    [&](Offset f)
    {
      const auto& [a, b, c] = draft.facets[f];
      centroids[f] = (draft.points[a] + draft.points[b] + draft.points[c]) / 3.0;
    });
  return done ? orderAlongHilbertCurve(centroids, control) : std::vector<Index>(centroids.size());
}

/** The mesh's facets, with the draft's points, and where they come from. */
struct WrittenFacets
{
  std::vector<Triple> points;
  std::vector<std::array<Offset, 3>> inputPoints;
  std::vector<Offset> inputCells;
};

/** Writes the facets in their order. @param flipped of the draft's facets. */
bool writeFacets(const TriangleSoup& soup, const Draft& draft,
  const std::vector<unsigned char>& flipped, const RunControl& control, WrittenFacets& facets)
{
  const std::vector<Index> order = orderFacets(draft, control);
  if (control.cancelled())
  {
    return false; // the order may be none
  }
  facets.points.resize(order.size());
  facets.inputPoints.resize(order.size());
  facets.inputCells.resize(order.size());
  return forEachItem(static_cast<Offset>(order.size()), control,
    [&](Offset f)
    {
      const Index source = order[f];
      const Index triangle = draft.facetTriangles[source];
      facets.points[f] = draft.facets[source];
      facets.inputCells[f] = soup.inputCells[triangle];
      facets.inputPoints[f] =
        draft.facetInputs.empty() ? soup.triangles[triangle] : draft.facetInputs[source];
      if (flipped[source])
      {
        std::swap(facets.points[f][1], facets.points[f][2]);
        std::swap(facets.inputPoints[f][1], facets.inputPoints[f][2]);
      }
    });
}

/** Replaces the draft's point ids in the mesh's facets, numbering points as facets meet them. */
bool numberPoints(
  const Draft& draft, const RunControl& control, std::vector<Triple>& facets, SurfaceMesh& mesh)
{
  const Offset uses = 3 * static_cast<Offset>(facets.size());
  const auto pointOf = [&](Offset use) -> Index& { return facets[use / 3][use % 3]; };
  LowestItems firstUses(draft.points.size());
  std::vector<Index> numbers(draft.points.size(), noIndex);
  const bool done =
    forEachItem(uses, control, [&](Offset use) { firstUses.add(pointOf(use), use); }) &&
    packItems(
      uses, control, [&](Offset use) { return firstUses[pointOf(use)] == use; },
      [&](Offset points) { mesh.points.resize(static_cast<std::size_t>(points)); },
      [&](Offset use, Offset number)
      {
        mesh.points[number] = draft.points[pointOf(use)];
        numbers[pointOf(use)] = static_cast<Index>(number);
      }) &&
    forEachItem(uses, control, [&](Offset use) { pointOf(use) = numbers[pointOf(use)]; });
  mesh.cornerPoints.resize(mesh.points.size());
  std::iota(mesh.cornerPoints.begin(), mesh.cornerPoints.end(), Index(0));
  return done;
}

bool countComponents(const SurfaceMesh& mesh, const RunControl& control, Index& components)
{
  DisjointSets sets(mesh.points.size());
  if (!forEachItem(mesh.numberOfFacets(), control,
        [&](Offset f)
        {
          sets.unite(mesh.facetPoints[f][0], mesh.facetPoints[f][1]);
          sets.unite(mesh.facetPoints[f][1], mesh.facetPoints[f][2]);
        }))
  {
    return false;
  }
  components = static_cast<Index>(countItems(mesh.numberOfPoints(), control,
    [&](Offset point) { return sets.isLowest(static_cast<Index>(point)); }));
  return components >= 0;
}

/** Steps 1 to 3: everything that can fail. */
Status draftSurface(const TriangleSoup& soup, const IntakeOptions& options,
  const RunControl& control, Draft& draft, IntakeReport& report)
{
  Status status = draftSoup(soup, control, draft);
  if (status.ok())
  {
    control.report(0.2);
    status = mergePoints(options, control, draft, report);
  }
  if (status.ok())
  {
    control.report(0.4);
    status = dropBadFacets(soup, control, draft, report);
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
  const Orientation orientation = orient(draft, control, report);
  control.report(0.8);
  if (control.cancelled())
  {
    return Status::cancelled();
  }
  const RunControl silent = control.silent();
  WrittenFacets facets;
  const bool numbered = writeFacets(soup, draft, orientation.flipped, silent, facets) &&
    numberPoints(draft, silent, facets.points, mesh);
  mesh.facetInputCells = std::move(facets.inputCells);
  mesh.facetPoints = std::move(facets.points);
  mesh.facetCorners = mesh.facetPoints;
  if (!numbered || !countComponents(mesh, silent, report.components))
  {
    mesh = SurfaceMesh();
    return Status::cancelled();
  }
  mesh.facetInputPoints = { mesh.facetPoints, mesh.numberOfPoints(),
    std::move(facets.inputPoints) };
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
