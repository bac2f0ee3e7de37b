#include "Metric/SurfaceSides.h"

#include "Mesh/FacetGeometry.h"

#include <algorithm>

namespace remesh
{
namespace
{
/** Whether a facet goes along its edge k from the lower point to the higher. */
bool goesUp(const Triple& points, int k)
{
  return points[k] < points[(k + 1) % 3];
}
}

Status SurfaceSides::build(const SurfaceMesh& mesh, const RunControl& control)
{
  m_mesh = &mesh;
  m_edges = buildEdgeTable(mesh.facetPoints, control.silent());
  if (control.cancelled())
  {
    return Status::cancelled();
  }
  m_isCrease.assign(static_cast<std::size_t>(m_edges.numberOfEdges()), 1);
  const auto pointOf = [&](Offset corner) { return mesh.facetPoints[corner / 3][corner % 3]; };
  if (!forEachItem(
        m_edges.numberOfEdges(), control.silent(), [&](Offset edge) { this->findCreases(edge); }) ||
    !groupByKey(3 * Offset(mesh.numberOfFacets()), mesh.numberOfPoints(), control.silent(), pointOf,
      m_corners))
  {
    return Status::cancelled();
  }
  const Blocks blocks = longBlocks(mesh.numberOfPoints());
  std::vector<std::vector<SurfaceSide>> parts(static_cast<std::size_t>(blocks.count()));
  ScratchPool<Scratch> pool([this]() { return this->makeScratch(); });
  const auto find = [&](Offset block)
  {
    const auto scratch = pool.borrow();
    for (Offset point = blocks.begin(block); point < blocks.end(block); ++point)
    {
      this->findSides(static_cast<Index>(point), *scratch, parts[block]);
    }
  };
  if (!forEachBlock(blocks.count(), control.silent(), find))
  {
    return Status::cancelled();
  }
  m_sides.clear();
  m_begins.assign(static_cast<std::size_t>(mesh.numberOfPoints()) + 1, 0);
  for (const std::vector<SurfaceSide>& part : parts)
  {
    for (const SurfaceSide& side : part)
    {
      m_sides.push_back(side);
      m_begins[side.point + 1] = static_cast<Offset>(m_sides.size());
    }
  }
  return Status::success();
}

void SurfaceSides::findCreases(Offset edge)
{
  if (m_edges.valence(static_cast<Index>(edge)) != 2)
  {
    return;
  }
  const Index* facets = m_edges.edgeFacets.data() + m_edges.edgeFacetsBegin[edge];
  Point3 normals[2];
  bool up[2];
  for (int k = 0; k < 2; ++k)
  {
    const Triple& points = m_mesh->facetPoints[facets[k]];
    normals[k] =
      facetNormal(m_mesh->points[points[0]], m_mesh->points[points[1]], m_mesh->points[points[2]]);
    up[k] = goesUp(points, m_edges.sideOf(facets[k], static_cast<Index>(edge)));
  }
  const double cosine = normals[0].dot(normals[1]);
  m_isCrease[edge] = (up[0] != up[1] ? cosine : -cosine) < cosineOfCrease;
}

std::unique_ptr<SurfaceSides::Scratch> SurfaceSides::makeScratch() const
{
  auto scratch = std::make_unique<Scratch>();
  scratch->facetMarks.assign(m_mesh->facetPoints.size(), 0);
  scratch->pointMarks.assign(m_mesh->points.size(), 0);
  return scratch;
}

void SurfaceSides::addFacet(Index facet, Scratch& scratch) const
{
  if (scratch.facetMarks[facet] == scratch.mark)
  {
    return;
  }
  scratch.facetMarks[facet] = scratch.mark;
  scratch.facets.push_back(facet);
  for (const Index point : m_mesh->facetPoints[facet])
  {
    if (scratch.pointMarks[point] != scratch.mark)
    {
      scratch.pointMarks[point] = scratch.mark;
      scratch.points.push_back(point);
    }
  }
}

void SurfaceSides::gatherOwn(const SurfaceSide& side, Scratch& scratch) const
{
  ++scratch.mark;
  scratch.facets.clear();
  scratch.points.assign(1, side.point);
  scratch.pointMarks[side.point] = scratch.mark;
  this->addFacet(side.facet, scratch);
  for (std::size_t i = 0; i < scratch.facets.size(); ++i)
  {
    const Index facet = scratch.facets[i];
    const Triple& points = m_mesh->facetPoints[facet];
    for (int k = 0; k < 3; ++k)
    {
      const Index edge = m_edges.facetEdges[facet][k];
      const bool isOwn = points[k] == side.point || points[(k + 1) % 3] == side.point;
      if (isOwn && !m_isCrease[edge])
      {
        const Index* around = m_edges.edgeFacets.data() + m_edges.edgeFacetsBegin[edge];
        this->addFacet(around[0] == facet ? around[1] : around[0], scratch);
      }
    }
  }
  scratch.ownFacets = scratch.facets.size();
}

void SurfaceSides::findSides(Index point, Scratch& scratch, std::vector<SurfaceSide>& sides) const
{
  const Offset begin = m_corners.begins[point];
  const Offset end = m_corners.begins[point + 1];
  std::vector<Index> left;
  for (Offset i = begin; i < end; ++i)
  {
    left.push_back(m_corners.items[i] / 3);
  }
  while (!left.empty())
  {
    SurfaceSide side{ point, left.front(), 0.0 };
    this->gatherOwn(side, scratch);
    for (const Index facet : scratch.facets)
    {
      side.area += facetArea(*m_mesh, facet) / 3.0;
    }
    sides.push_back(side);
    left.erase(std::remove_if(left.begin(), left.end(),
                 [&](Index facet) { return scratch.facetMarks[facet] == scratch.mark; }),
      left.end());
  }
}

void SurfaceSides::gather(const SurfaceSide& side, std::size_t wanted, Scratch& scratch) const
{
  this->gatherOwn(side, scratch);
  std::size_t begin = 0;
  while (scratch.points.size() < wanted && begin < scratch.facets.size())
  {
    const std::size_t end = scratch.facets.size();
    for (; begin < end; ++begin)
    {
      const Index facet = scratch.facets[begin];
      for (const Index edge : m_edges.facetEdges[facet])
      {
        if (!m_isCrease[edge])
        {
          const Index* around = m_edges.edgeFacets.data() + m_edges.edgeFacetsBegin[edge];
          this->addFacet(around[0] == facet ? around[1] : around[0], scratch);
        }
      }
    }
  }
}
}
