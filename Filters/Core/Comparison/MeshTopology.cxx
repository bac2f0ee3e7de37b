/**
 * @file MeshTopology.cxx
 *
 * 1. Leave out the triangles that have not three points.
 * 2. Count edges by the number of their triangles.
 * 3. Fans: corners of triangles at one point, united across the edges of two triangles. A point
 *    with more than one fan is not manifold.
 * 4. Loops: a border passes through the fan at an end of a boundary edge to the one other boundary
 *    edge there; unite the fans at the two ends of each boundary edge, and count.
 */
#include "Comparison/MeshTopology.h"

#include "Mesh/Duplicates.h"
#include "Mesh/EdgeTable.h"
#include "Mesh/FacetGeometry.h"
#include "Mesh/Orientation.h"
#include "Mesh/Weld.h"
#include "Support/DisjointSets.h"
#include "Support/Grouping.h"

#include <algorithm>

namespace remesh
{
namespace
{
bool hasThreePoints(const Triple& t)
{
  return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

/** Which corner of a facet is at a point; it has the point. */
Index cornerAt(const std::vector<Triple>& facets, Index facet, Index point)
{
  const Triple& corners = facets[facet];
  return 3 * facet + (corners[0] == point ? 0 : corners[1] == point ? 1 : 2);
}

/** Step 3. Corner k of facet f is 3 f + k. */
bool uniteFans(const std::vector<Triple>& facets, const EdgeTable& edges, const RunControl& control,
  DisjointSets& fans)
{
  return forEachItem(static_cast<Offset>(facets.size()), control.silent(),
    [&](Offset f)
    {
      for (int k = 0; k < 3; ++k)
      {
        const Index edge = edges.facetEdges[f][k];
        const Index* around = edges.edgeFacets.data() + edges.edgeFacetsBegin[edge];
        if (edges.valence(edge) != 2 || around[0] != static_cast<Index>(f))
        {
          continue;
        }
        for (const Index point : { facets[f][k], facets[f][(k + 1) % 3] })
        {
          fans.unite(cornerAt(facets, around[0], point), cornerAt(facets, around[1], point));
        }
      }
    });
}

/** Step 4. */
Index countLoops(const std::vector<Triple>& facets, const EdgeTable& edges, DisjointSets& fans)
{
  DisjointSets loops(3 * facets.size());
  std::vector<char> atBorder(3 * facets.size(), 0);
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (edges.valence(edges.facetEdges[f][k]) == 1)
      {
        const auto corner = static_cast<Index>(3 * f);
        const Index first = fans.find(corner + k);
        const Index second = fans.find(corner + (k + 1) % 3);
        loops.unite(first, second);
        atBorder[first] = 1;
        atBorder[second] = 1;
      }
    }
  }
  Index count = 0;
  for (std::size_t corner = 0; corner < atBorder.size(); ++corner)
  {
    count += atBorder[corner] != 0 && loops.isLowest(static_cast<Index>(corner));
  }
  return count;
}

/** Counts the points used, those with several fans, and the components. */
void countPoints(const std::vector<Triple>& facets, std::size_t numberOfPoints, DisjointSets& fans,
  MeshTopology& topology)
{
  std::vector<Index> fansAt(numberOfPoints, 0);
  DisjointSets components(numberOfPoints);
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      fansAt[facets[f][k]] += fans.isLowest(static_cast<Index>(3 * f) + k);
      components.unite(facets[f][0], facets[f][k]);
    }
  }
  for (std::size_t point = 0; point < numberOfPoints; ++point)
  {
    topology.points += fansAt[point] > 0;
    topology.nonManifoldPoints += fansAt[point] > 1;
    topology.components += fansAt[point] > 0 && components.isLowest(static_cast<Index>(point));
  }
}

/** Used points that stand where a lower used one does. */
Index countDuplicatePoints(const Triangles& mesh, const RunControl& control)
{
  std::vector<char> used(mesh.points.size(), 0);
  for (const Triple& triangle : mesh.triangles)
  {
    for (const Index point : triangle)
    {
      used[point] = 1;
    }
  }
  std::vector<Point3> places;
  for (std::size_t point = 0; point < used.size(); ++point)
  {
    if (used[point])
    {
      places.push_back(mesh.points[point]);
    }
  }
  const std::vector<Index> lowest = weldEqualPoints(places, control);
  Index count = 0;
  for (std::size_t k = 0; k < lowest.size(); ++k)
  {
    count += lowest[k] != static_cast<Index>(k);
  }
  return count;
}
}

Status measureTopology(const Triangles& mesh, const RunControl& control, MeshTopology& topology)
{
  topology = {};
  topology.triangles = static_cast<Index>(mesh.triangles.size());
  std::vector<Triple> facets;
  facets.reserve(mesh.triangles.size());
  for (const Triple& triangle : mesh.triangles)
  {
    const bool sound = hasThreePoints(triangle);
    const auto& [a, b, c] = triangle;
    topology.degenerateTriangles +=
      !sound || !hasArea(mesh.points[a], mesh.points[b], mesh.points[c]);
    if (sound)
    {
      facets.push_back(triangle);
    }
  }
  const EdgeTable edges = buildEdgeTable(facets, control);
  const std::vector<unsigned char> repeated = findDuplicates(facets, control).repeats;
  topology.duplicatePoints = countDuplicatePoints(mesh, control);
  topology.duplicateTriangles =
    static_cast<Index>(std::count(repeated.begin(), repeated.end(), static_cast<unsigned char>(1)));
  const Index triangles = topology.triangles;
  const Status status =
    measureConnectivity(facets, edges, static_cast<Index>(mesh.points.size()), control, topology);
  topology.triangles = triangles;
  return status;
}

Status measureConnectivity(const std::vector<Triple>& triangles, const EdgeTable& edges,
  Index numberOfPoints, const RunControl& control, MeshTopology& topology)
{
  topology.triangles = static_cast<Index>(triangles.size());
  topology.edges = edges.numberOfEdges();
  for (Index edge = 0; edge < topology.edges; ++edge)
  {
    topology.boundaryEdges += edges.valence(edge) == 1;
    topology.nonManifoldEdges += edges.valence(edge) > 2;
  }
  topology.oriented = isOriented(triangles, edges, control);
  DisjointSets fans(3 * triangles.size());
  if (!uniteFans(triangles, edges, control, fans))
  {
    return Status::cancelled();
  }
  topology.boundaryLoops = topology.boundaryEdges > 0 ? countLoops(triangles, edges, fans) : 0;
  countPoints(triangles, static_cast<std::size_t>(numberOfPoints), fans, topology);
  topology.eulerCharacteristic = topology.points - topology.edges + topology.triangles;
  return control.cancelled() ? Status::cancelled() : Status::success();
}

bool haveSameTopology(const MeshTopology& a, const MeshTopology& b)
{
  return a.nonManifoldEdges == b.nonManifoldEdges && a.nonManifoldPoints == b.nonManifoldPoints &&
    a.boundaryLoops == b.boundaryLoops && a.components == b.components &&
    a.eulerCharacteristic == b.eulerCharacteristic && a.oriented == b.oriented;
}
}
