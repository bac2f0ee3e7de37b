#include "Comparison/Comparison.h"

#include "Comparison/NormalDeviation.h"
#include "Comparison/PointDistance.h"
#include "Mesh/Weld.h"
#include "Support/Grouping.h"

namespace remesh
{
namespace
{
/** Triangles on the lowest of coincident points. Points that are not finite are not used. */
std::vector<Triple> weldTriangles(const Triangles& surface, const RunControl& control)
{
  std::vector<Point3> points = surface.points;
  for (Point3& point : points)
  {
    point = point.allFinite() ? point : Point3::Zero();
  }
  const std::vector<Index> lowest = weldEqualPoints(points, control);
  std::vector<Triple> triangles = surface.triangles;
  for (Triple& triangle : triangles)
  {
    triangle = { lowest[triangle[0]], lowest[triangle[1]], lowest[triangle[2]] };
  }
  return triangles;
}

double diagonalOf(const Triangles& surface)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Point3 lower = Point3::Constant(infinity);
  Point3 upper = -lower;
  for (const Triple& triangle : surface.triangles)
  {
    for (const Index point : triangle)
    {
      lower = lower.cwiseMin(surface.points[point]);
      upper = upper.cwiseMax(surface.points[point]);
    }
  }
  return (upper - lower).stableNorm();
}

/** Distances of `points` to a surface; with sides, where the welded surface is oriented. */
Status measurePoints(const std::vector<Point3>& points, const TriangleTree& tree,
  const Triangles& welded, bool oriented, const RunControl& control, PointDistances& result)
{
  if (!oriented)
  {
    return measurePointDistances(points, tree, nullptr, control, result.distances, result.behind);
  }
  const SideNormals sides(welded, control);
  return measurePointDistances(points, tree, &sides, control, result.distances, result.behind);
}

Status measureDistances(const Triangles& mesh, const Triangles& reference,
  const TriangleTree& meshTree, const TriangleTree& tree, DistanceOptions options,
  RunControl control, Comparison& comparison)
{
  options.negligible *= comparison.diagonal;
  control.enterPhase("Measuring distances to the reference", 0.2, 0.5);
  Status status =
    measureOneSidedDistance(mesh, tree, options, control, comparison.distance.forward);
  if (status.ok())
  {
    control.enterPhase("Measuring distances from the reference", 0.5, 0.8);
    status =
      measureOneSidedDistance(reference, meshTree, options, control, comparison.distance.backward);
  }
  return status;
}

Status measureAgainst(const Triangles& mesh, const Triangles& reference,
  const DistanceOptions& options, RunControl control, Comparison& comparison)
{
  const TriangleTree meshTree(mesh, control);
  const TriangleTree tree(reference, control);
  if (control.cancelled())
  {
    return Status::cancelled();
  }
  if (meshTree.empty() || tree.empty())
  {
    return Status::invalid(std::string("The ") + (tree.empty() ? "reference surface" : "mesh") +
      " has no triangle with an area above 0: there is nothing to measure distances to.");
  }
  comparison.hasReference = true;
  comparison.diagonal = diagonalOf(reference);
  const std::vector<Triple> meshTriangles = weldTriangles(mesh, control);
  const std::vector<Triple> referenceTriangles = weldTriangles(reference, control);
  const Triangles meshWelded{ mesh.points, meshTriangles };
  const Triangles welded{ reference.points, referenceTriangles };
  MeshTopology meshTopology;
  Status status = measureTopology(meshWelded, control.silent(), meshTopology);
  if (status.ok())
  {
    status = measureTopology(welded, control.silent(), comparison.referenceTopology);
  }
  if (status.ok())
  {
    status = measureDistances(mesh, reference, meshTree, tree, options, control, comparison);
  }
  control.enterPhase("Measuring points and normals", 0.8, 1.0);
  if (status.ok())
  {
    status = measurePoints(mesh.points, tree, welded, comparison.referenceTopology.oriented,
      control.step(0, 3), comparison.meshPoints);
  }
  if (status.ok())
  {
    status = measurePoints(reference.points, meshTree, meshWelded, meshTopology.oriented,
      control.step(1, 3), comparison.referencePoints);
  }
  if (status.ok())
  {
    status = measureNormalDeviations(
      mesh, tree, comparison.diagonal, control.step(2, 3), comparison.normalDeviations);
  }
  return status;
}
}

Status compareSurfaces(const Triangles& mesh, const Triangles* reference,
  const DistanceOptions& options, RunControl control, Comparison& comparison)
{
  comparison = {};
  control.enterPhase("Measuring the mesh", 0.0, 0.2);
  Status status = measureTopology(mesh, control.silent(), comparison.topology);
  if (!status.ok())
  {
    return status;
  }
  comparison.qualities.resize(static_cast<std::size_t>(mesh.count()));
  if (!forEachItem(mesh.count(), control,
        [&](Offset t) { comparison.qualities[t] = triangleQuality(mesh.corners(t)); }))
  {
    return Status::cancelled();
  }
  return reference ? measureAgainst(mesh, *reference, options, control, comparison)
                   : Status::success();
}
}
