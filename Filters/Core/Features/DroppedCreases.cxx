#include "Features/DroppedCreases.h"

namespace remesh
{
DroppedCreases tellDropped(const SurfaceMesh& mesh, const EdgeTable& edges,
  const std::vector<FeatureKind>& before, const FeatureEdges& features)
{
  DroppedCreases dropped;
  double longest = 0.0;
  auto needle = features.sidesOfNeedles.begin();
  for (Index edge = 0; edge < edges.numberOfEdges(); ++edge)
  {
    const bool isSide = needle != features.sidesOfNeedles.end() && *needle == edge;
    needle += isSide ? 1 : 0;
    const bool isKept = features.kinds[edge] == FeatureKind::Crease;
    const bool isGone =
      features.kinds[edge] == FeatureKind::None && (isSide || before[edge] == FeatureKind::Crease);
    if (!isKept && !isGone)
    {
      continue;
    }
    const Index facet = edges.edgeFacets[edges.edgeFacetsBegin[edge]];
    const int k = edges.sideOf(facet, edge);
    const Point3& from = mesh.points[mesh.facetPoints[facet][k]];
    const Point3& to = mesh.points[mesh.facetPoints[facet][(k + 1) % 3]];
    const double length = (to - from).norm();
    (isKept ? dropped.keptLength : dropped.length) += length;
    dropped.edges += isGone ? 1 : 0;
    dropped.sidesOfNeedles += isGone && isSide ? 1 : 0;
    if (isGone && length > longest)
    {
      longest = length;
      dropped.place = 0.5 * (from + to);
    }
  }
  return dropped;
}
}
