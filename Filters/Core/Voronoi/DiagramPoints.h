/**
 * @file DiagramPoints.h
 * @brief One point for each vertex of the diagram, shared by all pieces around it.
 */
#ifndef remesh_DiagramPoints_h
#define remesh_DiagramPoints_h

#include "Mesh/EdgeTable.h"
#include "Support/Status.h"
#include "Voronoi/Diagram.h"

namespace remesh
{
struct DiagramPoint
{
  Index facet;
  double b[3]; ///< barycentric coordinates in that facet
};

struct DiagramPoints
{
  std::vector<DiagramPoint> points; ///< corners of the surface first, then edges', then facets'
  std::vector<Offset> ofVertex;     ///< the point of each of the diagram's vertices
};

/**
 * A corner of the surface is one point; so is a crossing of two cells on an edge (told by edge and
 * sites), and a meeting of three in a facet. O(V log V) for V vertices.
 */
DiagramPoints numberDiagramPoints(
  const SurfaceMesh& mesh, const EdgeTable& edges, const Diagram& diagram);
}

#endif
