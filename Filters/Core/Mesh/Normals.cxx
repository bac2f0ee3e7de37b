/**
 * @file Normals.cxx
 *
 * Estimation: the sum of the unit normals of the facets at a corner, each times the facet's angle
 * there (G. Thuermer, C. Wuethrich, *Computing vertex normals from polygonal facets*, Journal of
 * Graphics Tools 3(1), 1998), so that the result does not depend on how the surface is cut into
 * triangles.
 *
 * Smoothing: each pass replaces every normal by the normalised mean of itself and of its 1-ring
 * neighbours, all with the values of the pass before (Jacobi), so that the order of corners has
 * no influence. Corners are neighbours if an edge in corner space joins them: normals do not flow
 * across creases.
 */
#include "Mesh/Normals.h"

#include "Mesh/EdgeTable.h"
#include "Mesh/FacetGeometry.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace remesh
{
namespace
{
/** A sum shorter than this share of its weights has no direction but rounding error. */
constexpr double leastLength = 1e-12;

double angleBetween(const Point3& u, const Point3& v)
{
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

/** The three angles of a facet; edges are normalised first, so any scale will do. */
std::array<double, 3> facetAngles(const SurfaceMesh& mesh, std::size_t facet)
{
  const Triple& points = mesh.facetPoints[facet];
  std::array<Point3, 3> edges;
  for (int k = 0; k < 3; ++k)
  {
    edges[k] = (mesh.points[points[(k + 1) % 3]] - mesh.points[points[k]]).stableNormalized();
  }
  return { angleBetween(edges[0], -edges[2]), angleBetween(edges[1], -edges[0]),
    angleBetween(edges[2], -edges[1]) };
}

Point3 normalOf(const SurfaceMesh& mesh, std::size_t facet)
{
  const auto& [a, b, c] = mesh.facetPoints[facet];
  return facetNormal(mesh.points[a], mesh.points[b], mesh.points[c]);
}

std::vector<Point3> angleWeightedNormals(const SurfaceMesh& mesh)
{
  std::vector<Point3> normals(mesh.cornerPoints.size(), Point3::Zero());
  std::vector<double> angleSums(normals.size(), 0.0);
  for (std::size_t f = 0; f < mesh.facetCorners.size(); ++f)
  {
    const Point3 normal = normalOf(mesh, f);
    const std::array<double, 3> angles = facetAngles(mesh, f);
    for (int k = 0; k < 3; ++k)
    {
      const Index corner = mesh.facetCorners[f][k];
      normals[corner] += angles[k] * normal;
      angleSums[corner] += angles[k];
    }
  }
  // Backwards, so that the first facet of a corner without direction has the last word.
  for (std::size_t f = mesh.facetCorners.size(); f-- > 0;)
  {
    for (const Index corner : mesh.facetCorners[f])
    {
      if (angleSums[corner] >= 0.0 && !(normals[corner].norm() > leastLength * angleSums[corner]))
      {
        angleSums[corner] = -1.0;
      }
      if (angleSums[corner] < 0.0)
      {
        normals[corner] = normalOf(mesh, f);
      }
    }
  }
  for (Point3& normal : normals)
  {
    normal.stableNormalize();
  }
  return normals;
}

/** The 1-rings of all corners. */
struct CornerRings
{
  std::vector<Offset> begins; ///< C + 1, into `neighbours`
  std::vector<Index> neighbours;
};

/** Calls `visit(corner, corner)` for both directions of each edge, once per edge. */
template <class Visit>
void forEachEdge(const SurfaceMesh& mesh, const EdgeTable& edges, const Visit& visit)
{
  Index next = 0;
  for (std::size_t f = 0; f < mesh.facetCorners.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      // Edges are numbered as facets meet them: an edge is new when it has the next number.
      if (edges.facetEdges[f][k] == next)
      {
        const Index a = mesh.facetCorners[f][k];
        const Index b = mesh.facetCorners[f][(k + 1) % 3];
        visit(a, b);
        visit(b, a);
        ++next;
      }
    }
  }
}

CornerRings buildRings(const SurfaceMesh& mesh)
{
  const EdgeTable edges = buildEdgeTable(mesh.facetCorners);
  CornerRings rings;
  rings.begins.assign(mesh.cornerPoints.size() + 1, 0);
  forEachEdge(mesh, edges, [&](Index corner, Index) { ++rings.begins[corner + 1]; });
  for (std::size_t i = 1; i < rings.begins.size(); ++i)
  {
    rings.begins[i] += rings.begins[i - 1];
  }
  rings.neighbours.resize(rings.begins.back());
  std::vector<Offset> next(rings.begins);
  forEachEdge(mesh, edges,
    [&](Index corner, Index neighbour) { rings.neighbours[next[corner]++] = neighbour; });
  return rings;
}

void smoothOnce(
  const CornerRings& rings, const std::vector<Point3>& normals, std::vector<Point3>& smoothed)
{
  for (std::size_t corner = 0; corner < normals.size(); ++corner)
  {
    Point3 sum = normals[corner];
    const Offset begin = rings.begins[corner];
    const Offset end = rings.begins[corner + 1];
    for (Offset i = begin; i < end; ++i)
    {
      sum += normals[rings.neighbours[i]];
    }
    const double length = sum.norm();
    const bool hasDirection = length > leastLength * static_cast<double>(end - begin + 1);
    smoothed[corner] = hasDirection ? Point3(sum / length) : normals[corner];
  }
}

/** The caller's points at each corner, once per facet that uses them there. */
struct CornerInputs
{
  std::vector<Offset> begins; ///< C + 1, into `points`
  std::vector<Offset> points; ///< the caller's ids, ascending within a corner
};

CornerInputs collectCornerInputs(const SurfaceMesh& mesh)
{
  CornerInputs inputs;
  inputs.begins.assign(mesh.cornerPoints.size() + 1, 0);
  for (const Triple& corners : mesh.facetCorners)
  {
    for (const Index corner : corners)
    {
      ++inputs.begins[corner + 1];
    }
  }
  for (std::size_t i = 1; i < inputs.begins.size(); ++i)
  {
    inputs.begins[i] += inputs.begins[i - 1];
  }
  inputs.points.resize(inputs.begins.back());
  std::vector<Offset> next(inputs.begins);
  for (std::size_t f = 0; f < mesh.facetCorners.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      inputs.points[next[mesh.facetCorners[f][k]]++] = mesh.facetInputPoints[f][k];
    }
  }
  for (std::size_t corner = 0; corner + 1 < inputs.begins.size(); ++corner)
  {
    std::sort(inputs.points.begin() + inputs.begins[corner],
      inputs.points.begin() + inputs.begins[corner + 1]);
  }
  return inputs;
}

/** Mean direction of a corner's distinct input normals, or zero. */
Point3 meanOfInputs(
  const CornerInputs& inputs, std::size_t corner, const std::vector<Point3>& inputNormals)
{
  Point3 sum = Point3::Zero();
  int count = 0;
  for (Offset i = inputs.begins[corner]; i < inputs.begins[corner + 1]; ++i)
  {
    if (i == inputs.begins[corner] || inputs.points[i] != inputs.points[i - 1])
    {
      sum += inputNormals[inputs.points[i]].stableNormalized();
      ++count;
    }
  }
  const double length = sum.norm();
  return length > leastLength * count ? Point3(sum / length) : Point3(Point3::Zero());
}

Status checkInputNormals(const SurfaceMesh& mesh, const std::vector<Point3>& inputNormals)
{
  for (const auto& points : mesh.facetInputPoints)
  {
    for (const Offset point : points)
    {
      if (point < 0 || point >= static_cast<Offset>(inputNormals.size()))
      {
        return Status::invalid("There are " + std::to_string(inputNormals.size()) +
          " normals, but none for point " + std::to_string(point) + ".");
      }
      if (!inputNormals[point].allFinite())
      {
        return Status::invalid("The normal of point " + std::to_string(point) + " is not finite.");
      }
    }
  }
  return Status::success();
}
}

std::vector<Point3> estimateCornerNormals(const SurfaceMesh& mesh, int passes)
{
  const int count = passes < 0 ? automaticSmoothingPasses : passes;
  std::vector<Point3> normals = angleWeightedNormals(mesh);
  if (count == 0 || normals.empty())
  {
    return normals;
  }
  const CornerRings rings = buildRings(mesh);
  std::vector<Point3> smoothed(normals.size());
  for (int pass = 0; pass < count; ++pass)
  {
    smoothOnce(rings, normals, smoothed);
    normals.swap(smoothed);
  }
  return normals;
}

Status givenCornerNormals(
  const SurfaceMesh& mesh, const std::vector<Point3>& inputNormals, std::vector<Point3>& normals)
{
  if (Status status = checkInputNormals(mesh, inputNormals); !status.ok())
  {
    return status;
  }
  const CornerInputs inputs = collectCornerInputs(mesh);
  std::vector<Point3> estimated; // on demand
  normals.resize(mesh.cornerPoints.size());
  for (std::size_t corner = 0; corner < normals.size(); ++corner)
  {
    normals[corner] = meanOfInputs(inputs, corner, inputNormals);
    if (normals[corner].isZero(0.0))
    {
      if (estimated.empty())
      {
        estimated = estimateCornerNormals(mesh, 0);
      }
      normals[corner] = estimated[corner];
    }
  }
  return Status::success();
}
}
