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
#include "Support/Parallel.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace remesh
{
Point3 normalOf(
  const SurfaceMesh& mesh, const std::vector<FacetNormal>& borrowed, std::size_t facet)
{
  const auto found = std::lower_bound(borrowed.begin(), borrowed.end(), facet,
    [](const FacetNormal& a, std::size_t b) { return static_cast<std::size_t>(a.facet) < b; });
  if (found != borrowed.end() && static_cast<std::size_t>(found->facet) == facet)
  {
    return found->normal;
  }
  const auto& [a, b, c] = mesh.facetPoints[facet];
  return facetNormal(mesh.points[a], mesh.points[b], mesh.points[c]);
}

std::vector<char> findCutPoints(const SurfaceMesh& mesh)
{
  std::vector<char> corners(mesh.points.size(), 0);
  for (const Index point : mesh.cornerPoints)
  {
    corners[point] = static_cast<char>(std::min(corners[point] + 1, 2));
  }
  for (char& count : corners)
  {
    count = count > 1;
  }
  return corners;
}

namespace
{
/** A sum shorter than this share of its weights has no direction but rounding error. */
constexpr double leastShare = 1e-12;

/** What a facet adds to its corners. */
struct FacetShare
{
  Point3 normal;
  std::array<double, 3> angles;
};

/** Lengths are taken in units of the facet's size, so any scale will do, and any sliver. */
FacetShare facetShare(const SurfaceMesh& mesh, std::size_t facet)
{
  const auto& [i, j, k] = mesh.facetPoints[facet];
  const Point3& a = mesh.points[i];
  const Point3& b = mesh.points[j];
  const Point3& c = mesh.points[k];
  const ShortEdges edges = shortEdges(a, b, c);
  const double size =
    std::max(edges.first.cwiseAbs().maxCoeff(), edges.second.cwiseAbs().maxCoeff());
  const double scale = size > 0.0 ? 1.0 / size : 0.0;
  const Point3 cross = (scale * edges.first).cross(scale * edges.second);
  const Point3 ab = scale * (b - a);
  const Point3 bc = scale * (c - b);
  const Point3 ca = scale * (a - c);
  const double doubleArea = cross.norm(); // the sine's part at each of the three corners
  return { doubleArea > 0.0 ? Point3(cross / doubleArea) : cross,
    { std::atan2(doubleArea, -ab.dot(ca)), std::atan2(doubleArea, -bc.dot(ab)),
      std::atan2(doubleArea, -ca.dot(bc)) } };
}

/** Gives corners whose sum has no direction the normal of their first facet. Uses up the angles. */
void replaceLost(const SurfaceMesh& mesh, const std::vector<FacetNormal>& borrowed,
  std::vector<double>& angleSums, std::vector<Point3>& normals)
{
  // Backwards, so that the first facet has the last word.
  for (std::size_t f = mesh.facetCorners.size(); f-- > 0;)
  {
    for (const Index corner : mesh.facetCorners[f])
    {
      if (angleSums[corner] >= 0.0 && !(normals[corner].norm() > leastShare * angleSums[corner]))
      {
        angleSums[corner] = -1.0;
      }
      if (angleSums[corner] < 0.0)
      {
        normals[corner] = normalOf(mesh, borrowed, f);
      }
    }
  }
}

std::vector<Point3> angleWeightedNormals(
  const SurfaceMesh& mesh, const std::vector<FacetNormal>& borrowed)
{
  std::vector<Point3> normals(mesh.cornerPoints.size(), Point3::Zero());
  std::vector<double> angleSums(normals.size(), 0.0);
  auto next = borrowed.begin();
  for (std::size_t f = 0; f < mesh.facetCorners.size(); ++f)
  {
    FacetShare share = facetShare(mesh, f);
    if (next != borrowed.end() && static_cast<std::size_t>(next->facet) == f)
    {
      share.normal = next->normal;
      ++next;
    }
    for (int k = 0; k < 3; ++k)
    {
      const Index corner = mesh.facetCorners[f][k];
      normals[corner] += share.angles[k] * share.normal;
      angleSums[corner] += share.angles[k];
    }
  }
  replaceLost(mesh, borrowed, angleSums, normals);
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

/** The mean of a corner's normal and those around it; its own where they cancel out. */
Point3 smoothedNormal(
  const CornerRings& rings, const std::vector<Point3>& normals, std::size_t corner)
{
  Point3 sum = normals[corner];
  const Offset begin = rings.begins[corner];
  const Offset end = rings.begins[corner + 1];
  for (Offset i = begin; i < end; ++i)
  {
    sum += normals[rings.neighbours[i]];
  }
  const double length = sum.norm();
  const bool hasDirection = length > leastShare * static_cast<double>(end - begin + 1);
  return hasDirection ? Point3(sum / length) : normals[corner];
}

/** Input points that lie in several corners of one point: their normals belong to none of them. */
std::vector<char> findSharedInputs(const SurfaceMesh& mesh, std::size_t numberOfInputs)
{
  const std::vector<char> cut = findCutPoints(mesh);
  std::vector<Index> corner(numberOfInputs, noIndex);
  std::vector<char> shared(numberOfInputs, 0);
  for (std::size_t f = 0; f < mesh.facetCorners.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Offset input = mesh.facetInputPoints[f][k];
      if (cut[mesh.facetPoints[f][k]])
      {
        shared[input] |= corner[input] != noIndex && corner[input] != mesh.facetCorners[f][k];
        corner[input] = mesh.facetCorners[f][k];
      }
    }
  }
  return shared;
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
Point3 meanOfInputs(const CornerInputs& inputs, std::size_t corner,
  const std::vector<Point3>& inputNormals, const std::vector<char>& shared)
{
  Point3 sum = Point3::Zero();
  int count = 0;
  for (Offset i = inputs.begins[corner]; i < inputs.begins[corner + 1]; ++i)
  {
    const bool first = i == inputs.begins[corner] || inputs.points[i] != inputs.points[i - 1];
    if (first && !shared[inputs.points[i]])
    {
      sum += inputNormals[inputs.points[i]].stableNormalized();
      ++count;
    }
  }
  const double length = sum.norm();
  return length > leastShare * count ? Point3(sum / length) : Point3(Point3::Zero());
}

Status checkInputNormals(const SurfaceMesh& mesh, const std::vector<Point3>& inputNormals)
{
  for (std::size_t f = 0; f < mesh.facetInputPoints.size(); ++f)
  {
    for (const Offset point : mesh.facetInputPoints[f])
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

std::vector<Point3> estimateCornerNormals(const SurfaceMesh& mesh, int passes,
  const RunControl& control, const std::vector<FacetNormal>& borrowed)
{
  std::vector<Point3> normals = angleWeightedNormals(mesh, borrowed);
  if (passes <= 0 || normals.empty())
  {
    return normals;
  }
  const CornerRings rings = buildRings(mesh);
  const Blocks blocks = Blocks::cut(static_cast<Offset>(normals.size()), 128, 1 << 15);
  std::vector<Point3> smoothed(normals.size());
  for (int pass = 0; pass < passes; ++pass)
  {
    const bool done = forEachRange(blocks, control.step(pass, passes),
      [&](Offset begin, Offset end)
      {
        for (Offset corner = begin; corner < end; ++corner)
        {
          smoothed[corner] = smoothedNormal(rings, normals, corner);
        }
      });
    if (!done)
    {
      break;
    }
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
  const std::vector<char> shared = findSharedInputs(mesh, inputNormals.size());
  std::vector<Point3> estimated; // on demand
  normals.resize(mesh.cornerPoints.size());
  for (std::size_t corner = 0; corner < normals.size(); ++corner)
  {
    normals[corner] = meanOfInputs(inputs, corner, inputNormals, shared);
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
