// Cones around the normals of cells: never wrong about a facet, and wide enough to be of use.

#include "Placement/TriangleShape.h"
#include "Repair/InvertedSearch.h"
#include "TestLanes.h"
#include "TestPlacements.h"
#include "TestSurfaces.h"

using namespace remesh;

namespace
{
/** Facets as slim as rounding leaves them, some without a normal. */
SurfaceMesh slimSphere()
{
  SurfaceMesh mesh = test::meshOf(test::icosphere(3));
  for (std::size_t f = 0; f < mesh.facetPoints.size(); f += 7)
  {
    const auto& [a, b, c] = mesh.facetPoints[f];
    mesh.points[c] = 0.5 * (mesh.points[a] + mesh.points[b]);
  }
  return mesh;
}

Point3 normalOf(const PlacementProblem& problem, Index facet)
{
  return facetNormal(
    problem.facetPoint(facet, 0), problem.facetPoint(facet, 1), problem.facetPoint(facet, 2));
}

/** Against the facets of each cell one by one, normals of all directions. */
void checkCones(const PlacementProblem& problem)
{
  const NormalCones cones(problem, RunControl());
  const Components& components = problem.components;
  for (Index v = 0; v < problem.numberOfVertices(); ++v)
  {
    for (std::uint64_t k = 0; k < 40; ++k)
    {
      const Point3 normal =
        test::randomPoint(2, 40 * static_cast<std::uint64_t>(v) + k).normalized();
      double least = test::infinity;
      for (Offset p = components.pieceBegin[v]; p < components.pieceBegin[v + 1]; ++p)
      {
        const Point3 facet = normalOf(problem, problem.diagram.facets[components.pieces[p]]);
        least = std::min(least, facet.dot(normal));
      }
      CHECK(!cones.allAlong(v, normal) || least > 0.0);
    }
  }
}

/** Of the triangles, those that need no other look. */
double shareTold(const PlacementProblem& problem)
{
  const NormalCones cones(problem, RunControl());
  Offset told = 0;
  for (const Triple& triangle : problem.triangles)
  {
    const auto [a, b, c] = cornersOf(triangle, problem.components.centroids);
    const Point3 normal = facetNormal(a, b, c);
    told += std::all_of(triangle.begin(), triangle.end(),
      [&](Index vertex) { return cones.allAlong(vertex, normal); });
  }
  return static_cast<double>(told) / static_cast<double>(problem.triangles.size());
}

/** A search finds what is flipped triangle by triangle, vertices moved about. */
void checkSearch(const PlacementProblem& problem)
{
  for (const double noise : { 0.0, 0.05, 0.3 })
  {
    std::vector<Point3> positions = problem.components.centroids;
    for (std::size_t v = 0; v < positions.size(); ++v)
    {
      positions[v] += noise * test::randomPoint(1, v);
    }
    for (const NearbySurface& surface : { NearbySurface(problem, RunControl()),
           NearbySurface(problem, RunControl(), minHeight(problem.mesh)) })
    {
      std::vector<Index> expected, found;
      for (std::size_t t = 0; t < problem.triangles.size(); ++t)
      {
        const Triple& triangle = problem.triangles[t];
        if (surface.isInverted(triangle, cornersOf(triangle, positions)))
        {
          expected.push_back(static_cast<Index>(t));
        }
      }
      CHECK(InvertedSearch(surface).find(problem.triangles, positions, RunControl(), found).ok());
      CHECK(found == expected);
      CHECK(noise < 0.3 || !found.empty());
    }
  }
}

void check(const SurfaceMesh& mesh, double minShare)
{
  const EmbeddedSurface surface = test::gaussMapOf(mesh, 0.02);
  const RemeshResult result = test::remeshed(mesh, 0.02, 400, VertexPlacement::Centroid);
  const std::vector<char> none;
  const PlacementProblem problem{ mesh, surface, result.sites, result.diagram, result.components,
    result.dual.triangles, none };
  checkCones(problem);
  CHECK(shareTold(problem) >= minShare);
  checkSearch(problem);
}
}

int TestNormalCones(int, char*[])
{
  check(test::meshOf(test::torus(1.0, 0.4, 60, 30)), 0.9);
  check(slimSphere(), 0.0);
  return test::result();
}
