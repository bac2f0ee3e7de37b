#include "Embedding/Wrinkles.h"

#include "Embedding/Embedding.h"
#include "Support/Parallel.h"

#include <Eigen/Geometry>

#include <cmath>

namespace remesh
{
namespace
{
/** `areaOf(facet)` of all facets. */
template <class Area>
double sumOverFacets(const SurfaceMesh& mesh, const RunControl& control, const Area& areaOf)
{
  double sum = 0.0;
  const Blocks blocks = Blocks::cut(mesh.numberOfFacets(), 64, 1 << 15);
  return sumInBlocks(blocks, control, areaOf, sum) ? sum : 0.0;
}

/**
 * Half the volume that each facet's normals span: the area of a small triangle between them, and
 * none where they lie on one great circle, as those of a bend along one direction, however its
 * facets are turned.
 */
double areaOfNormals(
  const SurfaceMesh& mesh, const std::vector<Point3>& normals, const RunControl& control)
{
  return sumOverFacets(mesh, control,
    [&](std::size_t f)
    {
      const auto& [a, b, c] = mesh.facetCorners[f];
      return 0.5 * std::abs(normals[a].dot(normals[b].cross(normals[c])));
    });
}

double embeddedArea(
  const SurfaceMesh& mesh, const std::vector<Point3>& normals, double s, const RunControl& control)
{
  return sumOverFacets(mesh, control,
    [&](std::size_t f)
    {
      Eigen::Matrix<double, 6, 3> places;
      for (int k = 0; k < 3; ++k)
      {
        places.col(k) << mesh.points[mesh.facetPoints[f][k]], s * normals[mesh.facetCorners[f][k]];
      }
      return triangleArea(places.col(0).data(), places.col(1).data(), places.col(2).data(), 6);
    });
}
}

double wrinkledShare(const SurfaceMesh& mesh, const std::vector<Point3>& normals,
  const std::vector<Point3>& smoothed, double s, const RunControl& control)
{
  const double whole = embeddedArea(mesh, smoothed, s, control);
  const double lost =
    s * s * (areaOfNormals(mesh, normals, control) - areaOfNormals(mesh, smoothed, control));
  return whole > 0.0 ? lost / whole : 0.0;
}
}
