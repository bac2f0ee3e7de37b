/**
 * @file DiagramPoints.h
 * @brief One point for each vertex of the diagram, shared by all pieces around it.
 */
#ifndef remesh_DiagramPoints_h
#define remesh_DiagramPoints_h

#include "Mesh/EdgeTable.h"
#include "Support/RunControl.h"
#include "Support/Status.h"
#include "Voronoi/VertexPlaces.h"

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
 * sites), and a meeting of three in a facet. Within an edge or a facet, points are ordered by their
 * sites.
 *
 * @param control asked for cancellation; nothing is reported.
 * @return Cancelled; then `points` are of no use.
 * Cost: O(V) for V vertices but for those of one place, which are sorted; in parallel.
 */
Status numberDiagramPoints(const SurfaceMesh& mesh, const EdgeTable& edges,
  const VertexPlaces& places, const RunControl& control, DiagramPoints& points);
}

#endif
