/**
 * @file TestEmbeddings.h
 * @brief Surfaces in R^d, sites on them, and the nearest site by definition.
 */
#ifndef remesh_TestEmbeddings_h
#define remesh_TestEmbeddings_h

#include "Embedding/Embedding.h"
#include "Optimization/Sampling.h"
#include "Support/Random.h"
#include "TestSupport.h"

#include <string>

namespace remesh::test
{
/** Positions, and smooth random functions of them for the rest of the dimensions. */
inline EmbeddedSurface embedded(
  const SurfaceMesh& mesh, int dimension, std::uint64_t seed = 1, double amplitude = 0.3)
{
  CornerCoordinates coordinates = positionCoordinates(mesh);
  CornerCoordinates more;
  more.dimension = dimension - 3;
  for (const Index point : mesh.cornerPoints)
  {
    for (int k = 0; k < more.dimension; ++k)
    {
      double phase = 6.0 * uniform01(seed, k, 0);
      for (int c = 0; c < 3; ++c)
      {
        phase += (4.0 * uniform01(seed, k, 1 + c) - 2.0) * mesh.points[point][c];
      }
      more.values.push_back(std::sin(phase));
    }
  }
  if (more.dimension > 0)
  {
    appendCoordinates(coordinates, more, amplitude);
  }
  EmbeddedSurface surface;
  CHECK(embedSurface(mesh, coordinates, RunControl(), surface).ok());
  return surface;
}

inline Sites sampled(const EmbeddedSurface& surface, Offset count, std::uint64_t seed,
  SamplingMethod method = SamplingMethod::Random)
{
  Sites sites;
  CHECK(sampleSurface(surface, count, { method, seed }, sites).ok());
  return sites;
}

/** Moves each site by up to `size` along each axis: off the surface. */
inline Sites shaken(Sites sites, double size, std::uint64_t seed)
{
  for (std::size_t k = 0; k < sites.coordinates.size(); ++k)
  {
    sites.coordinates[k] += size * (2.0 * uniform01(seed, k, 7) - 1.0);
  }
  return sites;
}

/** Sites at points of R^3, in the caller's units. */
inline Sites sitesAt(const EmbeddedSurface& surface, const std::vector<Point3>& points)
{
  Sites sites;
  sites.dimension = 3;
  for (const Point3& point : points)
  {
    for (int k = 0; k < 3; ++k)
    {
      sites.coordinates.push_back(surface.toScaled(point[k], k));
    }
  }
  return sites;
}

/** By definition, in long double. */
inline double exactDistance2(const double* a, const double* b, int dimension)
{
  long double sum = 0.0L;
  for (int k = 0; k < dimension; ++k)
  {
    const long double difference = static_cast<long double>(a[k]) - b[k];
    sum += difference * difference;
  }
  return static_cast<double>(sum);
}

/** The lowest of the sites nearest to a point. */
inline Index nearestSite(const Sites& sites, const double* point)
{
  Index nearest = noIndex;
  double least = std::numeric_limits<double>::infinity();
  for (Index site = 0; site < sites.count(); ++site)
  {
    const double distance2 = exactDistance2(sites.site(site), point, sites.dimension);
    if (distance2 < least)
    {
      nearest = site;
      least = distance2;
    }
  }
  return nearest;
}

using Barycentric = std::array<double, 3>;

inline std::vector<double> pointAt(
  const EmbeddedSurface& surface, Index facet, const Barycentric& b)
{
  const auto [p0, p1, p2] = surface.facetCorners[facet];
  std::vector<double> point(static_cast<std::size_t>(surface.dimension));
  for (int k = 0; k < surface.dimension; ++k)
  {
    point[k] =
      b[0] * surface.corner(p0)[k] + b[1] * surface.corner(p1)[k] + b[2] * surface.corner(p2)[k];
  }
  return point;
}

inline Barycentric randomBarycentric(std::uint64_t seed, std::uint64_t index)
{
  double u = uniform01(seed, index, 11);
  double v = uniform01(seed, index, 12);
  if (u + v > 1.0)
  {
    u = 1.0 - u;
    v = 1.0 - v;
  }
  return { 1.0 - u - v, u, v };
}

/** A surface to test with, in R^3 and with a name for messages. */
struct NamedMesh
{
  std::string name;
  SurfaceMesh mesh;
};

/** Closed and open, fine and coarse, with slivers (the torus) and with flat parts. */
inline std::vector<NamedMesh> smallMeshes()
{
  return { { "icosphere", meshOf(icosphere(2)) }, { "torus", meshOf(torus(1.0, 0.4, 12, 9)) },
    { "patch", meshOf(gridPatch(7, 5)) }, { "cube", meshOf(cube()) } };
}
}

#endif
