// The fit against what it must not spoil: thin rims, shapes, and places that are the caller's.

#include "Placement/CellForms.h"
#include "Placement/Regularity.h"
#include "Run/MeshDistance.h"
#include "Support/Random.h"
#include "TestLanes.h"
#include "TestPlacements.h"

#include <numeric>

using namespace remesh;

namespace
{
/** Points spun around z, from pole to pole. */
SurfaceMesh spun(const std::vector<std::pair<double, double>>& profile, int around)
{
  std::vector<Point3> points;
  std::vector<std::array<Offset, 3>> triangles;
  std::vector<std::vector<Offset>> rows;
  for (const auto& [radius, height] : profile)
  {
    rows.emplace_back();
    for (int k = 0; k < around; ++k)
    {
      if (k == 0 || radius > 0.0)
      {
        const double angle = 2.0 * test::pi * k / around;
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height);
      }
      rows.back().push_back(static_cast<Offset>(points.size()) - 1);
    }
  }
  for (std::size_t row = 1; row < rows.size(); ++row)
  {
    for (std::size_t k = 0; k < rows[row].size(); ++k)
    {
      const std::size_t next = (k + 1) % rows[row].size();
      const auto add = [&](Offset a, Offset b, Offset c)
      {
        if (a != b && b != c && c != a)
        {
          triangles.push_back({ a, b, c });
        }
      };
      add(rows[row - 1][k], rows[row - 1][next], rows[row][next]);
      add(rows[row - 1][k], rows[row][next], rows[row][k]);
    }
  }
  return test::meshOf(test::makeSoup(std::move(points), std::move(triangles)));
}

/** A disc 20 wide and this thick, with a round rim. */
SurfaceMesh coin(double thickness)
{
  const double r = 0.5 * thickness;
  std::vector<std::pair<double, double>> profile = { { 0.0, -r } };
  for (int k = 0; k <= 8; ++k)
  {
    const double angle = test::pi * (k - 4) / 8.0;
    profile.emplace_back(10.0 + r * std::cos(angle), r * std::sin(angle));
  }
  profile.emplace_back(0.0, r);
  return spun(profile, 96);
}

/** How far places all over some triangles are from others at most. */
double farthest(const Triangles& from, const Triangles& to)
{
  constexpr int cuts = 8;
  const TriangleTree tree(to);
  double most = 0.0;
  for (Offset t = 0; t < from.count(); ++t)
  {
    const auto [a, b, c] = from.corners(t);
    for (int i = 0; i <= cuts; ++i)
    {
      for (int j = 0; i + j <= cuts; ++j)
      {
        const Point3 place = (i * a + j * b + (cuts - i - j) * c) / cuts;
        most = std::max(most, tree.closest(place).at.squared);
      }
    }
  }
  return std::sqrt(most);
}

/** The same mesh with its vertices at places chosen another way, without repairs. */
RemeshResult chosenAnew(const SurfaceMesh& mesh, const RemeshResult& centroids, VertexPlacement way)
{
  const EmbeddedSurface surface = test::gaussMapOf(mesh, 0.0);
  const std::vector<char> none;
  RemeshResult result = centroids;
  result.placement = {};
  const PlacementProblem problem{ mesh, surface, centroids.sites, centroids.diagram,
    centroids.components, centroids.dual.triangles, none };
  CHECK(
    choosePlaces(problem, way, RunControl(), result.locations, result.placement.positions).ok());
  return result;
}

/**
 * Where the fit starts, each vertex and the surface are some way from each other. Vertices do not
 * go farther out of thin rims than that, and all the same the mesh comes closer.
 */
void testThinRims()
{
  for (const double thickness : { 0.1, 0.3 })
  {
    const SurfaceMesh mesh = coin(thickness);
    const RemeshResult centroids = test::remeshed(mesh, 0.0, 700, VertexPlacement::Centroid);
    const RemeshResult quadric = chosenAnew(mesh, centroids, VertexPlacement::Quadric);
    const RemeshResult fit = chosenAnew(mesh, centroids, VertexPlacement::Fit);
    const double start = farthest(trianglesOf(mesh), trianglesOf(quadric));
    const auto distanceOf = [&](const RemeshResult& result, std::size_t v)
    { return test::distanceTo(mesh.facetPoints, mesh.points, result.placement.positions[v]); };
    for (std::size_t v = 0; v < fit.placement.positions.size(); ++v)
    {
      CHECK(distanceOf(fit, v) < 1.02 * std::max(start, distanceOf(quadric, v)));
    }
    CHECK(test::rmsDistance(mesh, fit, 1) < 0.9 * test::rmsDistance(mesh, quadric, 1));
    const RemeshResult repaired = test::placedAnew(mesh, 0.0, centroids, VertexPlacement::Fit);
    CHECK_EQUAL(repaired.placement.edits.inverted, 0);
  }
}

/** Lengths of a triangle's edges in R^d, its corners put there by `lift`. */
template <class Lift>
std::array<double, 3> liftedEdges(
  const Triple& triangle, const std::vector<Point3>& at, const Lift& lift)
{
  std::array<double, 3> lengths;
  for (int k = 0; k < 3; ++k)
  {
    lengths[k] = (lift(at[triangle[k]]) - lift(at[triangle[(k + 1) % 3]])).norm();
  }
  return lengths;
}

double minAngle(const std::array<double, 3>& edges)
{
  double least = 180.0;
  for (int k = 0; k < 3; ++k)
  {
    const double b = edges[(k + 1) % 3];
    const double c = edges[(k + 2) % 3];
    const double cosine = (b * b + c * c - edges[k] * edges[k]) / (2.0 * b * c);
    least = std::min(least, std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / test::pi);
  }
  return least;
}

/** A sphere with hills and valleys of this height, which the sites' spacing just resolves. */
SurfaceMesh hills(double height)
{
  SurfaceMesh mesh = test::meshOf(test::icosphere(5));
  for (Point3& point : mesh.points)
  {
    double sum = 0.0;
    for (std::uint64_t wave = 0; wave < 20; ++wave)
    {
      sum += std::sin(9.0 * test::randomPoint(5, wave).normalized().dot(point) + 7.0 * wave);
    }
    point *= 1.0 + height * sum / std::sqrt(20.0);
  }
  return mesh;
}

/**
 * The fit slides vertices to where the surface bends, and so halves the distance once more; of
 * their least angles, triangles lose 8.5 degrees for that. (11.5 if shapes do not count.)
 */
void testShapes()
{
  const SurfaceMesh mesh = hills(0.05);
  const RemeshResult centroids = test::remeshed(mesh, 0.0, 700, VertexPlacement::Centroid);
  const RemeshResult quadric = test::placedAnew(mesh, 0.0, centroids, VertexPlacement::Quadric);
  const RemeshResult fit = test::placedAnew(mesh, 0.0, centroids, VertexPlacement::Fit);
  const auto angleOf = [](const RemeshResult& result)
  {
    double sum = 0.0;
    for (const Triple& triangle : result.dual.triangles)
    {
      sum += minAngle(liftedEdges(
        triangle, result.placement.positions, [](const Point3& place) { return place; }));
    }
    return sum / static_cast<double>(result.dual.triangles.size());
  };
  CHECK(angleOf(fit) > angleOf(centroids) - 9.5);
  CHECK(test::rmsDistance(mesh, fit, 7) < 0.5 * test::rmsDistance(mesh, quadric, 7));
}

/** Where a torus is put in R^4: about 3 times as long around the tube as along it. */
Eigen::Vector4d torusLift(const Point3& place)
{
  const double u = std::atan2(place[1], place[0]);
  const double v = std::atan2(place[2], std::hypot(place[0], place[1]) - 1.0);
  const double ring = 1.0 + 0.4 * std::cos(v);
  return { ring * std::cos(u), ring * std::sin(u), 1.2 * std::cos(v), 1.2 * std::sin(v) };
}

EmbeddedSurface liftedTorus(const SurfaceMesh& mesh)
{
  CornerCoordinates coordinates;
  coordinates.dimension = 4;
  for (const Index point : mesh.cornerPoints)
  {
    const Eigen::Vector4d lifted = torusLift(mesh.points[point]);
    coordinates.values.insert(coordinates.values.end(), lifted.data(), lifted.data() + 4);
  }
  EmbeddedSurface surface;
  CHECK(embedSurface(mesh, coordinates, RunControl(), surface).ok());
  return surface;
}

/** By definition, from the vertices' own places in R^4. */
Regularity liftedRegularity(const RemeshResult& result)
{
  std::vector<double> all;
  double ratios = 0.0;
  for (const Triple& triangle : result.dual.triangles)
  {
    const auto edges = liftedEdges(triangle, result.placement.positions, torusLift);
    const auto& [a, b, c] = edges;
    ratios += (b + c - a) * (c + a - b) * (a + b - c) / (a * b * c);
    all.insert(all.end(), edges.begin(), edges.end());
  }
  const double count = static_cast<double>(all.size());
  const double mean = std::accumulate(all.begin(), all.end(), 0.0) / count;
  const auto even = std::count_if(all.begin(), all.end(),
    [&](double edge) { return edge > std::sqrt(0.5) * mean && edge < std::sqrt(2.0) * mean; });
  return { static_cast<double>(even) / count,
    ratios / static_cast<double>(result.dual.triangles.size()) };
}

/** Where the embedding is the caller's, the mesh stays regular in it, and comes closer. */
void testHeld()
{
  const SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.4, 90, 60));
  const EmbeddedSurface surface = liftedTorus(mesh);
  RemeshOptions options;
  options.numberOfSites = 800;
  RemeshResult results[3];
  const VertexPlacement ways[] = { VertexPlacement::Centroid, VertexPlacement::Fit,
    VertexPlacement::HeldFit };
  for (int k = 0; k < 3; ++k)
  {
    options.placement = ways[k];
    CHECK(remesh::remesh({ mesh, surface, nullptr, options }, RunControl(), results[k]).ok());
  }
  const Regularity before = liftedRegularity(results[0]);
  CHECK(!liftedRegularity(results[1]).isWithin(0.01, before)); // or this test tells nothing
  CHECK(liftedRegularity(results[2]).isWithin(0.01, before));
  const double distance = test::rmsDistance(mesh, results[2], 3);
  CHECK(distance < 0.35 * test::rmsDistance(mesh, results[0], 3));
  CHECK(distance < 1.1 * test::rmsDistance(mesh, results[1], 3));
}

/** The measure by the cells' metrics is nearly that by places; and it is reached again. */
void testRegularity()
{
  const SurfaceMesh mesh = test::meshOf(test::torus(1.0, 0.4, 90, 60));
  const EmbeddedSurface surface = liftedTorus(mesh);
  RemeshOptions options;
  options.numberOfSites = 800;
  options.placement = VertexPlacement::Centroid;
  RemeshResult result;
  CHECK(remesh::remesh({ mesh, surface, nullptr, options }, RunControl(), result).ok());
  const std::vector<char> none;
  const PlacementProblem problem{ mesh, surface, result.sites, result.diagram, result.components,
    result.dual.triangles, none };
  CellQuadrics planes;
  CellForms cells;
  CHECK(measureCells(problem, RunControl(), planes, cells));
  const std::vector<Point3> start = result.placement.positions;
  for (const double size : { 0.0, 0.01, 0.03 })
  {
    std::vector<Point3>& positions = result.placement.positions;
    positions = start;
    for (std::size_t v = 0; v < start.size(); ++v)
    {
      positions[v] += size * test::randomPoint(3, v);
    }
    const Regularity measured = regularityOf(problem, cells, positions);
    const Regularity expected = liftedRegularity(result);
    CHECK_NEAR(measured.evenEdges, expected.evenEdges, 0.02);
    CHECK_NEAR(measured.roundTriangles, expected.roundTriangles, 0.02);
    const std::vector<Point3> moved = positions;
    const bool isWorse = !measured.isWithin(0.01, regularityOf(problem, cells, start));
    const bool wasWorse = limitSliding(problem, cells, 0.01, start, positions);
    CHECK_EQUAL(wasWorse, isWorse);
    CHECK_EQUAL(isWorse, size > 0.02);
    CHECK(
      regularityOf(problem, cells, positions).isWithin(0.01, regularityOf(problem, cells, start)));
    for (std::size_t v = 0; v < start.size(); ++v)
    {
      CHECK_NEAR((positions[v] - moved[v]).dot(cells.normals[v].normalized()), 0.0, 1e-12);
    }
  }
}
}

int TestSurfaceFit(int, char*[])
{
  testThinRims();
  testShapes();
  testRegularity();
  testHeld();
  return test::result();
}
