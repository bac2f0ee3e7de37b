// Placement: distances against the theoretical optimum, no flipped triangle, fixed vertices.

#include "TestPlacements.h"

#include "Support/Random.h"

#include <atomic>

using namespace remesh;

namespace
{
SurfaceMesh scaledSphere(int levels, const Point3& axes)
{
  SurfaceMesh sphere = test::meshOf(test::icosphere(levels));
  for (Point3& point : sphere.points)
  {
    point = point.cwiseProduct(axes);
  }
  return sphere;
}

/**
 * The least RMS distance of n points to an ellipsoid, for large n. An equilateral triangle of edge
 * h on the unit sphere, at its best height, has a mean squared distance of h^4 / 960 (the variance
 * of r^2 / 2 over it); triangles of area A along the curvature, sqrt(K) A times as much; the best
 * density for the sum of squares is K^(1/3).
 */
double optimum(const SurfaceMesh& ellipsoid, const Point3& axes, Offset n)
{
  double area = 0.0, power = 0.0;
  for (const auto& [a, b, c] : ellipsoid.facetPoints)
  {
    const Point3 middle = (ellipsoid.points[a] + ellipsoid.points[b] + ellipsoid.points[c]) / 3.0;
    const double share = facetArea(ellipsoid.points[a], ellipsoid.points[b], ellipsoid.points[c]);
    const double length2 = middle.cwiseQuotient(axes.cwiseAbs2()).squaredNorm();
    const double curvature = 1.0 / std::pow(axes.prod() * length2, 2.0);
    area += share;
    power += share * std::cbrt(curvature);
  }
  const double perArea = std::sqrt(1.0 / 960.0) * 4.0 / std::sqrt(3.0); // h^2 = 4 A / sqrt(3)
  return perArea * std::pow(power, 1.5) / std::sqrt(area) / (2.0 * static_cast<double>(n));
}

/** Vertices on a convex surface cannot come below 4 times, fitted ones come near 1. */
void testEllipsoids()
{
  struct Case
  {
    Point3 axes;
    double anisotropy;
    double most; // times the optimum
  };
  for (const Case& c : { Case{ { 1.0, 1.0, 1.0 }, 0.0, 1.15 }, Case{ { 1.0, 0.6, 0.2 }, 0.1, 1.4 },
         Case{ { 1.0, 0.5, 0.5 }, 0.2, 1.4 } })
  {
    const SurfaceMesh mesh = scaledSphere(5, c.axes);
    constexpr Offset n = 250;
    const double best = optimum(mesh, c.axes, n);
    const RemeshResult centroids = test::remeshed(mesh, c.anisotropy, n, VertexPlacement::Centroid);
    double rms[4];
    for (int way = 0; way < 4; ++way)
    {
      const RemeshResult result =
        test::placedAnew(mesh, c.anisotropy, centroids, static_cast<VertexPlacement>(way));
      rms[way] = test::rmsDistance(mesh, result, 17) / best;
      CHECK_EQUAL(result.placement.edits.inverted, 0);
    }
    CHECK(rms[0] > 3.0 && rms[1] > 3.0);
    CHECK(rms[2] < 0.75 * rms[1]);
    CHECK(rms[3] < rms[2]);
    CHECK(rms[3] > 0.95); // or the optimum is wrong
    CHECK(rms[3] < c.most);
  }
}

SurfaceMesh noisySphere()
{
  SurfaceMesh sphere = test::meshOf(test::icosphere(4));
  for (std::size_t i = 0; i < sphere.points.size(); ++i)
  {
    sphere.points[i] *= 1.0 + 0.02 * (uniform01(3, i, 0) - 0.5);
  }
  return sphere;
}

/** Two discs this far apart, closed along their borders. */
SurfaceMesh thinPlate(double thickness)
{
  TriangleSoup soup = test::icosphere(4);
  for (Point3& point : soup.points)
  {
    const double r = std::hypot(point[0], point[1]);
    const double side = point[2] < 0.0 ? -1.0 : 1.0;
    point[2] = 0.5 * thickness * side * std::sqrt(std::min(1.0, 4.0 * (1.0 - std::min(1.0, r))));
  }
  return test::meshOf(soup);
}

/**
 * Where flips come from: noise, thin sheets, anisotropy so strong that edges must be turned over.
 * The count is that by definition.
 */
void testFlips()
{
  const std::vector<SurfaceMesh> meshes = { test::meshOf(test::torus(1.0, 0.3, 60, 25)),
    noisySphere(), thinPlate(0.1) };
  for (std::size_t m = 0; m < meshes.size(); ++m)
  {
    for (const double anisotropy : { 0.03, 0.1, 0.4 })
    {
      const RemeshResult centroids =
        test::remeshed(meshes[m], anisotropy, 300, VertexPlacement::Centroid);
      for (const VertexPlacement way : { VertexPlacement::Centroid, VertexPlacement::Fit })
      {
        const RemeshResult result = test::placedAnew(meshes[m], anisotropy, centroids, way);
        CHECK_EQUAL(result.placement.edits.inverted, 0);
        CHECK_EQUAL(test::countInverted(meshes[m], result), 0);
      }
    }
  }
}

PlacementProblem problemOf(const SurfaceMesh& mesh, const EmbeddedSurface& surface,
  const RemeshResult& result, const std::vector<char>& fixed)
{
  return { mesh, surface, result.sites, result.diagram, result.components, result.dual.triangles,
    fixed };
}

/** Each location is the point of the whole surface closest to the vertex. */
void checkLocations(const PlacementProblem& problem, const std::vector<Point3>& positions,
  const std::vector<SurfaceLocation>& locations)
{
  for (std::size_t v = 0; v < positions.size(); ++v)
  {
    Point3 place = Point3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      CHECK(locations[v].b[k] >= 0.0);
      place += locations[v].b[k] * problem.facetPoint(locations[v].facet, k);
    }
    const double least =
      test::distanceTo(problem.mesh.facetPoints, problem.mesh.points, positions[v]);
    CHECK_NEAR((place - positions[v]).norm(), least, 1e-12);
  }
}

/** Fixed vertices stay where they are told to be, to the bit, and the others still fit. */
void testFixed()
{
  const SurfaceMesh mesh = noisySphere();
  const EmbeddedSurface surface = test::gaussMapOf(mesh, 0.05);
  RemeshResult result = test::remeshed(mesh, 0.05, 400, VertexPlacement::Centroid);
  std::vector<char> fixed(result.placement.positions.size(), 0);
  std::vector<Point3> places = result.placement.positions;
  for (std::size_t v = 0; v < fixed.size(); v += 7)
  {
    fixed[v] = 1;
    places[v] *= 1.0 + 0.01 * uniform01(1, v, 2);
  }
  const PlacementProblem problem = problemOf(mesh, surface, result, fixed);
  for (const VertexPlacement way : { VertexPlacement::Centroid, VertexPlacement::Surface,
         VertexPlacement::Quadric, VertexPlacement::Fit })
  {
    PlacedVertices placement;
    placement.positions = places;
    std::vector<Triple> triangles = result.dual.triangles;
    std::vector<SurfaceLocation> locations = result.locations;
    CHECK(test::placeVertices(problem, way, RunControl(), locations, triangles, placement).ok());
    if (way == VertexPlacement::Quadric || way == VertexPlacement::Fit)
    {
      checkLocations(problem, placement.positions, locations);
    }
    Index moved = 0;
    for (std::size_t v = 0; v < fixed.size(); ++v)
    {
      const bool stays = placement.positions[v] == places[v];
      CHECK(!fixed[v] || stays);
      moved += !stays;
    }
    CHECK(way == VertexPlacement::Centroid ? moved < 10 : moved > 300);
  }
}

/** Equal bytes for any order of the blocks, and an end when told so. */
void testControl()
{
  const SurfaceMesh mesh = noisySphere();
  const EmbeddedSurface surface = test::gaussMapOf(mesh, 0.1);
  RemeshResult result = test::remeshed(mesh, 0.1, 500, VertexPlacement::Centroid);
  const std::vector<char> none;
  const PlacementProblem problem = problemOf(mesh, surface, result, none);
  const auto run = [&](const RunControl& control, PlacedVertices& placement)
  {
    std::vector<Triple> triangles = result.dual.triangles;
    std::vector<SurfaceLocation> locations = result.locations;
    return test::placeVertices(
      problem, VertexPlacement::Fit, control, locations, triangles, placement);
  };
  PlacedVertices expected;
  CHECK(run(RunControl(), expected).ok());
  for (const Schedule schedule : { Schedule::ShuffledBlocks, Schedule::EightThreads })
  {
    RunControl control;
    control.schedule = schedule;
    PlacedVertices placement;
    CHECK(run(control, placement).ok());
    CHECK(placement.positions == expected.positions);
  }
  std::atomic<int> asked(0);
  PlacedVertices placement;
  CHECK(run(RunControl({}, [&]() { return ++asked < 0; }), placement).ok());
  const int all = asked;
  for (int k = 1; k < all; k += 1 + all / 23)
  {
    asked = 0;
    CHECK(
      run(RunControl({}, [&]() { return ++asked >= k; }), placement).code == StatusCode::Cancelled);
  }
}

/** Triangles that hang together in a point or stand alone, and none at all. */
void testSmall()
{
  for (const Offset sites : { 1, 2, 3, 4, 5 })
  {
    for (const SurfaceMesh& mesh : { test::meshOf(test::tetrahedron()),
           test::meshOf(test::threeSheets()), test::meshOf(test::moebiusStrip(20)) })
    {
      const RemeshResult result = test::remeshed(mesh, 0.05, sites, VertexPlacement::Fit);
      CHECK_EQUAL(result.placement.positions.size(), result.components.sites.size());
      for (const Point3& position : result.placement.positions)
      {
        CHECK(position.allFinite() && position.norm() < 3.0);
      }
    }
  }
}

}

/** Which way the surface faces where it is closest, against all of its facets one by one. */
void testWholeSurface()
{
  SurfaceMesh plate = test::meshOf(test::cube());
  for (Point3& point : plate.points)
  {
    point.z() *= 0.1;
  }
  const WholeSurface whole(plate);
  for (std::uint64_t k = 0; k < 500; ++k)
  {
    const auto draw = [k](std::uint64_t i) { return uniform01(8, k, i); };
    Point3 place(2.0 * draw(0) - 0.5, 2.0 * draw(1) - 0.5, 0.3 * draw(2) - 0.1);
    if (k % 5 == 0) // on an edge between a side and the top
    {
      place = Point3(0.0, draw(1), 0.1);
    }
    const Point3 vector = Point3(draw(3) - 0.5, draw(4) - 0.5, draw(5) - 0.5).normalized();
    const auto corner = [&](const Triple& facet, int i) { return plate.points[facet[i]]; };
    const auto distanceTo = [&](const Triple& facet)
    {
      return std::sqrt(
        closestOnTriangle(place, corner(facet, 0), corner(facet, 1), corner(facet, 2)).squared);
    };
    double nearest = std::numeric_limits<double>::infinity();
    for (const Triple& facet : plate.facetPoints)
    {
      nearest = std::min(nearest, distanceTo(facet));
    }
    double least = 1.0;
    for (const Triple& facet : plate.facetPoints)
    {
      const Point3 normal = facetNormal(corner(facet, 0), corner(facet, 1), corner(facet, 2));
      const bool isNearest = distanceTo(facet) < 1.00001 * nearest + 1e-9;
      least = isNearest ? std::min(least, vector.dot(normal)) : least;
    }
    const Index hint = static_cast<Index>(k) % plate.numberOfFacets();
    CHECK_EQUAL(whole.minCosine(place, vector, hint), least);
    CHECK_EQUAL(whole.minCosine(place, vector, hint, 1.1 * nearest + 1e-6), least);
    CHECK_EQUAL(whole.minCosine(place, vector, hint, nearest), 1.0);
  }
}

/** A sheet that lies on another one, turned over and cut otherwise, makes no strays. */
void testCoincidentSheets()
{
  TriangleSoup soup = test::gridPatch(30, 30);
  TriangleSoup other = test::gridPatch(17, 23);
  for (std::size_t t = 0; t < other.triangles.size(); ++t)
  {
    test::flip(other, t);
  }
  test::append(soup, other, Point3::Zero());
  const SurfaceMesh mesh = test::meshOf(soup);
  const RemeshResult result = test::remeshed(mesh, 0.02, 300, VertexPlacement::Centroid);
  const EmbeddedSurface surface = test::gaussMapOf(mesh, 0.02);
  const std::vector<char> none;
  const PlacementProblem problem{ mesh, surface, result.sites, result.diagram, result.components,
    result.dual.triangles, none };
  const WholeSurface whole(mesh);
  const NearbySurface nearby(NearbySurface(problem, RunControl()), whole);
  Offset strays = 0;
  for (const Triple& triangle : result.dual.triangles)
  {
    const std::vector<Point3>& at = result.components.centroids;
    const Facing facing =
      nearby.facingOf(triangle, { at[triangle[0]], at[triangle[1]], at[triangle[2]] });
    strays += facing.cosine >= 0.0 && facing.least < 0.0; // they share their four corners
  }
  CHECK(result.dual.triangles.size() > 400);
  CHECK_EQUAL(strays, 0);
}

/** A surface of any size is fitted as well as another: the same numbers, scaled. */
void testScale()
{
  const TriangleSoup soup = test::torus(1.0, 0.4, 60, 30);
  SurfaceMesh mesh = test::meshOf(soup);
  const RemeshResult usual = test::remeshed(mesh, 0.05, 300, VertexPlacement::Fit);
  for (const int exponent : { -100, 100 })
  {
    SurfaceMesh scaledMesh = test::meshOf(test::scaled(soup, std::ldexp(1.0, exponent)));
    const RemeshResult result = test::remeshed(scaledMesh, 0.05, 300, VertexPlacement::Fit);
    CHECK_EQUAL(result.placement.positions.size(), usual.placement.positions.size());
    double worst = 0.0;
    for (std::size_t k = 0; k < usual.placement.positions.size(); ++k)
    {
      const Point3 back = result.placement.positions[k] * std::ldexp(1.0, -exponent);
      worst = std::max(worst, (back - usual.placement.positions[k]).norm());
    }
    CHECK_NEAR(worst, 0.0, 1e-9);
  }
}

int TestPlacement(int, char*[])
{
  testEllipsoids();
  testScale();
  testFlips();
  testFixed();
  testControl();
  testSmall();
  testWholeSurface();
  testCoincidentSheets();
  return test::result();
}
