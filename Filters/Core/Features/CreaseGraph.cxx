#include "Features/CreaseGraph.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numeric>

namespace remesh
{
double CreaseGraph::length(Index edge) const
{
  return (this->mesh.points[this->ends[edge][0]] - this->mesh.points[this->ends[edge][1]]).norm();
}

double CreaseGraph::turn(Index point) const
{
  const Point3& here = this->mesh.points[point];
  const Point3 in = here - this->mesh.points[this->other(this->at(point, 0), point)];
  const Point3 out = this->mesh.points[this->other(this->at(point, 1), point)] - here;
  return std::atan2(in.cross(out).norm(), in.dot(out));
}

void CreaseGraph::listAround(const std::vector<FeatureKind>& kinds)
{
  this->begin.assign(this->mesh.points.size() + 1, 0);
  for (std::size_t e = 0; e < kinds.size(); ++e)
  {
    if (kinds[e] != FeatureKind::None)
    {
      ++this->begin[this->ends[e][0] + 1];
      ++this->begin[this->ends[e][1] + 1];
    }
  }
  std::partial_sum(this->begin.begin(), this->begin.end(), this->begin.begin());
  this->around.resize(static_cast<std::size_t>(this->begin.back()));
  std::vector<Offset> next(this->begin.begin(), this->begin.end() - 1);
  for (std::size_t e = 0; e < kinds.size(); ++e)
  {
    if (kinds[e] != FeatureKind::None)
    {
      this->around[next[this->ends[e][0]]++] = static_cast<Index>(e);
      this->around[next[this->ends[e][1]]++] = static_cast<Index>(e);
    }
  }
}

CreaseGraph makeCreaseGraph(
  const SurfaceMesh& mesh, const EdgeTable& edges, const std::vector<FeatureKind>& kinds)
{
  CreaseGraph graph{ mesh, {}, {}, {}, {} };
  graph.ends.resize(kinds.size(), { noIndex, noIndex });
  for (Index f = 0; f < mesh.numberOfFacets(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      std::array<Index, 2>& ends = graph.ends[edges.facetEdges[f][k]];
      if (ends[0] == noIndex)
      {
        ends = { mesh.facetPoints[f][k], mesh.facetPoints[f][(k + 1) % 3] };
      }
    }
  }
  graph.listAround(kinds);
  return graph;
}

CreaseGraph makeCreaseGraph(const SurfaceMesh& mesh, const EdgeTable& edges,
  const FeatureOptions& options, const std::vector<FeatureKind>& kinds)
{
  CreaseGraph graph = makeCreaseGraph(mesh, edges, kinds);
  graph.droppable.assign(kinds.size(), 0);
  for (std::size_t e = 0; e < kinds.size(); ++e)
  {
    graph.droppable[e] = kinds[e] == FeatureKind::Crease &&
      !isGivenFeature(mesh, edges, options, static_cast<Index>(e));
  }
  return graph;
}
}
