/**
 * @file FeatureGaps.cxx
 *
 * Hysteresis, as J. Canny has it for the edges of images ("A Computational Approach to Edge
 * Detection", 1986): strong edges begin a feature, weaker ones may continue it.
 */
#include "Features/FeatureEdges.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
constexpr double minCosineAcross = 0.8;  // 37 degrees
constexpr std::size_t longestGap = 4096; // edges

/** The edges at each point that are features or may continue one. */
class CandidateGraph
{
public:
  CandidateGraph(
    const SurfaceMesh& mesh, const EdgeTable& edges, double minAngle, const FeatureEdges& features)
    : m_mesh(mesh)
    , m_ends(features.kinds.size())
    , m_around(mesh.points.size())
    , m_degrees(mesh.points.size(), 0)
    , m_seenFrom(features.kinds.size(), noIndex)
  {
    std::vector<char> seen(features.kinds.size(), 0);
    for (Index f = 0; f < mesh.numberOfFacets(); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        const Index edge = edges.facetEdges[f][k];
        const bool feature = features.kinds[edge] != FeatureKind::None;
        if (seen[edge] || !(feature || features.angles[edge] > minAngle))
        {
          continue;
        }
        seen[edge] = 1;
        m_ends[edge] = { mesh.facetPoints[f][k], mesh.facetPoints[f][(k + 1) % 3] };
        for (const Index end : m_ends[edge])
        {
          m_around[end].push_back(edge);
          m_degrees[end] += feature;
        }
      }
    }
  }

  Index degree(Index point) const { return m_degrees[point]; }
  const std::vector<Index>& around(Index point) const { return m_around[point]; }
  Index other(Index edge, Index point) const
  {
    return m_ends[edge][m_ends[edge][0] == point ? 1 : 0];
  }
  void addFeature(Index edge)
  {
    ++m_degrees[m_ends[edge][0]];
    ++m_degrees[m_ends[edge][1]];
  }

  /** The straightest continuation at a point of an edge that ends there, or noIndex. */
  Index continuation(Index edge, Index point) const
  {
    const Point3& at = m_mesh.points[point];
    const Point3 in = (at - m_mesh.points[this->other(edge, point)]).stableNormalized();
    Index best = noIndex;
    double straightest = minCosineAcross;
    for (const Index next : m_around[point])
    {
      const Point3 out = (m_mesh.points[this->other(next, point)] - at).stableNormalized();
      if (next != edge && in.dot(out) > straightest)
      {
        straightest = in.dot(out);
        best = next;
      }
    }
    return best;
  }

  /**
   * The edges from a loose end to where the next feature is, or none.
   *
   * @param isFeature tells of an edge whether it is one.
   */
  template <class IsFeature>
  std::vector<Index> gapFrom(Index end, const IsFeature& isFeature)
  {
    std::vector<Index> gap;
    Index edge = *std::find_if(m_around[end].begin(), m_around[end].end(), isFeature);
    Index at = end;
    while (gap.size() < longestGap)
    {
      edge = this->continuation(edge, at);
      if (edge == noIndex || isFeature(edge) || m_seenFrom[edge] == end)
      {
        break;
      }
      m_seenFrom[edge] = end;
      gap.push_back(edge);
      at = this->other(edge, at);
      if (m_degrees[at] > 0)
      {
        return gap;
      }
    }
    return {};
  }

private:
  const SurfaceMesh& m_mesh;
  std::vector<std::array<Index, 2>> m_ends;
  std::vector<std::vector<Index>> m_around;
  std::vector<Index> m_degrees;  ///< feature edges at each point
  std::vector<Index> m_seenFrom; ///< E, the last loose end
};
}

void bridgeGaps(const SurfaceMesh& mesh, const EdgeTable& edges, const FeatureOptions& options,
  FeatureEdges& features)
{
  if (std::all_of(features.kinds.begin(), features.kinds.end(),
        [](FeatureKind kind) { return kind != FeatureKind::Crease; }))
  {
    return;
  }
  CandidateGraph graph(mesh, edges, weakShare * options.angleDegrees * pi / 180.0, features);
  const auto isFeature = [&](Index edge) { return features.kinds[edge] != FeatureKind::None; };
  for (Index end = 0; end < mesh.numberOfPoints(); ++end)
  {
    if (graph.degree(end) != 1)
    {
      continue;
    }
    for (const Index bridged : graph.gapFrom(end, isFeature))
    {
      features.kinds[bridged] = FeatureKind::Crease;
      graph.addFeature(bridged);
    }
  }
}
}
