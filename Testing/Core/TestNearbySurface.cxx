// The closest facet among those of a few cells, however many they are: as a look at all finds it.

#include "Placement/NearbySurface.h"

#include "Mesh/ClosestPoint.h"
#include "TestLanes.h"
#include "TestPlacements.h"
#include "TestSurfaces.h"

using namespace remesh;

namespace
{
/** The closest facet, the first of several as close; by a look at all. */
Index closestOfAll(
  const PlacementProblem& problem, const std::vector<Index>& cells, const Point3& point)
{
  std::pair<double, Index> best{ std::numeric_limits<double>::infinity(), noIndex };
  for (const Index cell : cells)
  {
    for (Offset p = problem.components.pieceBegin[cell];
         p < problem.components.pieceBegin[cell + 1]; ++p)
    {
      const Index facet = problem.diagram.facets[problem.components.pieces[p]];
      best = std::min(best,
        { closestOnTriangle(point, problem.facetPoint(facet, 0), problem.facetPoint(facet, 1),
            problem.facetPoint(facet, 2))
            .squared,
          facet });
    }
  }
  return best.second;
}

/** @param points of the mesh: cells of few and of very many facets. */
void check(const SurfaceMesh& mesh, Offset points)
{
  const EmbeddedSurface surface = test::gaussMapOf(mesh, 0.02);
  const RemeshResult result = test::remeshed(mesh, 0.02, points, VertexPlacement::Centroid);
  const std::vector<char> none;
  const PlacementProblem problem{ mesh, surface, result.sites, result.diagram, result.components,
    result.dual.triangles, none };
  const NearbySurface nearby(problem, RunControl());
  for (std::size_t t = 0; t < problem.triangles.size(); ++t)
  {
    const Triple& triangle = problem.triangles[t];
    const Point3& corner = problem.components.centroids[triangle[0]];
    const Index facet = problem.diagram.facets[problem.components.pieces[t]];
    // Near the surface, far from it, and on a point of the surface, which many facets share.
    for (const Point3& point : { corner, Point3(corner + 0.1 * test::randomPoint(3, t)),
           Point3(5.0 * test::randomPoint(4, t)), problem.facetPoint(facet, 1) })
    {
      for (std::size_t count = 1; count <= 3; ++count)
      {
        const std::vector<Index> cells(triangle.begin(), triangle.begin() + count);
        CHECK_EQUAL(nearby.closest(cells.data(), cells.data() + count, point).facet,
          closestOfAll(problem, cells, point));
      }
    }
  }
  CHECK_EQUAL(nearby.closest(nullptr, nullptr, Point3::Zero()).facet, noIndex);
}
}

int TestNearbySurface(int, char*[])
{
  const SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.4, 200, 100));
  check(mesh, 30);
  check(mesh, 3000);
  return test::result();
}
