#include "Comparison/Comparison.h"

#include "Comparison/NormalDeviation.h"
#include "Mesh/Weld.h"
#include "Support/Grouping.h"

#include <optional>

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

/** A surface that others are measured against, and its topology once coincident points are one. */
struct Measured
{
  Triangles surface;
  TriangleTree tree;
  std::vector<Triple> welded;
  MeshTopology topology;

  Measured(const Triangles& measured, const RunControl& control)
    : surface(measured)
    , tree(measured, control)
  {
  }

  Status weld(const RunControl& control)
  {
    this->welded = weldTriangles(this->surface, control);
    return measureTopology(
      { this->surface.points, this->welded }, control.silent(), this->topology);
  }

  /** Distances of points to it; with sides, where the welded surface is oriented. */
  Status measurePoints(
    const std::vector<Point3>& points, const RunControl& control, PointDistances& result) const
  {
    std::optional<SideNormals> sides;
    if (this->topology.oriented)
    {
      sides.emplace(Triangles{ this->surface.points, this->welded }, control);
    }
    return measurePointDistances(points, this->tree, sides ? &*sides : nullptr, control, result);
  }
};

Status measureDistances(const Measured& mesh, const Measured& reference, DistanceOptions options,
  RunControl control, Comparison& comparison)
{
  options.negligible *= comparison.diagonal;
  control.enterPhase("Measuring distances to the reference", 0.2, 0.5);
  Status status = measureOneSidedDistance(
    mesh.surface, reference.tree, options, control, comparison.distance.forward);
  if (status.ok())
  {
    control.enterPhase("Measuring distances from the reference", 0.5, 0.8);
    status = measureOneSidedDistance(
      reference.surface, mesh.tree, options, control, comparison.distance.backward);
  }
  return status;
}

Status measureAgainst(const Triangles& surface, const Triangles& against,
  const DistanceOptions& options, RunControl control, Comparison& comparison)
{
  Measured mesh(surface, control);
  Measured reference(against, control);
  if (control.cancelled())
  {
    return Status::cancelled();
  }
  if (mesh.tree.empty() || reference.tree.empty())
  {
    return Status::invalid(std::string("The ") +
      (reference.tree.empty() ? "reference surface" : "mesh") +
      " has no triangle with an area above 0: there is nothing to measure distances to.");
  }
  comparison.hasReference = true;
  comparison.diagonal = diagonalOf(against);
  Status status = mesh.weld(control);
  if (status.ok())
  {
    status = reference.weld(control);
    comparison.referenceTopology = reference.topology;
  }
  if (status.ok())
  {
    status = measureDistances(mesh, reference, options, control, comparison);
  }
  control.enterPhase("Measuring points and normals", 0.8, 1.0);
  if (status.ok())
  {
    status = reference.measurePoints(surface.points, control.step(0, 3), comparison.meshPoints);
  }
  if (status.ok())
  {
    status = mesh.measurePoints(against.points, control.step(1, 3), comparison.referencePoints);
  }
  if (status.ok())
  {
    status = measureNormalDeviations(surface, reference.tree, comparison.diagonal,
      control.step(2, 3), comparison.normalDeviations);
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
