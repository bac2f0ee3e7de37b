/**
 * @file TestSupport.h
 * @brief What unit tests of the core share: checks, surfaces, and measures of meshes.
 */
#ifndef remesh_TestSupport_h
#define remesh_TestSupport_h

#include "Mesh/Intake.h"
#include "TestChecks.h"
#include "TestSurfaces.h"

#include <Eigen/Geometry>

#include <map>
#include <utility>

namespace remesh::test
{
inline Status takeIn(const TriangleSoup& soup, SurfaceMesh& mesh, IntakeReport& report)
{
  return buildSurfaceMesh(soup, IntakeOptions(), RunControl(), mesh, report);
}

/** The mesh of a soup that must be fine. */
inline SurfaceMesh meshOf(const TriangleSoup& soup)
{
  SurfaceMesh mesh;
  IntakeReport report;
  CHECK(takeIn(soup, mesh, report).ok());
  return mesh;
}

inline double surfaceArea(const SurfaceMesh& mesh)
{
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.facetPoints)
  {
    sum += 0.5 * (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).norm();
  }
  return sum;
}

/** Positive if a closed surface faces outward. */
inline double enclosedVolume(const SurfaceMesh& mesh)
{
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.facetPoints)
  {
    sum += mesh.points[a].dot(mesh.points[b].cross(mesh.points[c])) / 6.0;
  }
  return sum;
}

/** Number of facets that run along each directed edge. By definition, with a map. */
inline std::map<std::pair<Index, Index>, int> directedEdges(const SurfaceMesh& mesh)
{
  std::map<std::pair<Index, Index>, int> counts;
  for (const Triple& facet : mesh.facetPoints)
  {
    for (int k = 0; k < 3; ++k)
    {
      ++counts[{ facet[k], facet[(k + 1) % 3] }];
    }
  }
  return counts;
}

inline Index eulerCharacteristic(const SurfaceMesh& mesh)
{
  const auto directed = directedEdges(mesh);
  Index edges = 0;
  for (const auto& [ends, count] : directed)
  {
    edges += ends.first < ends.second || !directed.count({ ends.second, ends.first });
  }
  return mesh.numberOfPoints() - edges + mesh.numberOfFacets();
}
}

#endif
