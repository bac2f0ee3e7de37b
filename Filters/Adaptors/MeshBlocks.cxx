#include "Adaptors/MeshBlocks.h"

#include "Adaptors/BlockNames.h"
#include "Adaptors/CarriedArrays.h"
#include "Mesh/FacetGeometry.h"
#include "Mesh/TriangleTree.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <map>
#include <utility>

namespace remesh
{
namespace
{
/** A vertex, or a site, in a block. */
using InBlock = std::pair<Index, int>;

/** The facets of some blocks, and the places on them that are closest to points. */
class BlockLocator
{
public:
  BlockLocator(const DiagramSource& source, const std::vector<int>& blocks)
    : Source(source)
  {
    for (const int block : blocks)
    {
      this->Facets[block];
    }
    const auto count = static_cast<Index>(source.prepared.mesh.facetPoints.size());
    for (Index facet = 0; facet < count; ++facet)
    {
      if (const auto found = this->Facets.find(source.blockOfFacet(facet));
          found != this->Facets.end())
      {
        found->second.push_back(facet);
      }
    }
  }

  /** Calls `visit(locate)` for a block; `locate(point)` is the closest place. */
  template <class Visit>
  void On(int block, const Visit& visit) const
  {
    const std::vector<Index>& facets = this->Facets.at(block);
    const SurfaceMesh& mesh = this->Source.prepared.mesh;
    std::vector<Triple> triangles;
    triangles.reserve(facets.size());
    for (const Index facet : facets)
    {
      triangles.push_back(mesh.facetPoints[facet]);
    }
    const TriangleTree tree({ mesh.points, triangles }, this->Source.control);
    visit(
      [&](const Point3& point) -> SurfaceLocation
      {
        if (this->Source.control.cancelled() || tree.empty())
        {
          return { facets.front(), { 1.0, 0.0, 0.0 } };
        }
        const TriangleTree::Place place = tree.closest(point);
        return { facets[tree.triangleOf(place.slot)],
          { place.at.b[0], place.at.b[1], place.at.b[2] } };
      });
  }

private:
  const DiagramSource& Source;
  std::map<int, std::vector<Index>> Facets;
};

/** The blocks of each vertex, by its triangles. */
std::vector<InBlock> findUses(
  const std::vector<Triple>& triangles, const std::vector<int>& triangleBlocks)
{
  std::vector<InBlock> uses;
  uses.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (const Index vertex : triangles[t])
    {
      uses.emplace_back(vertex, triangleBlocks[t]);
    }
  }
  std::sort(uses.begin(), uses.end());
  uses.erase(std::unique(uses.begin(), uses.end()), uses.end());
  return uses;
}

/** Makes the points, one for each vertex and then the copies; returns the point of each use. */
std::vector<Index> makePoints(
  const DiagramSource& source, const std::vector<InBlock>& uses, MeshBlocks& mesh)
{
  const std::vector<SurfaceLocation>& locations = source.result.locations;
  const auto count = static_cast<Index>(locations.size());
  std::vector<Index> points(uses.size());
  mesh.locations = locations;
  for (Index v = 0; v < count; ++v)
  {
    mesh.vertices.push_back(v);
    mesh.pointBlocks.push_back(source.blockOfFacet(locations[v].facet));
  }
  for (std::size_t first = 0, end = 0; first < uses.size(); first = end)
  {
    const Index v = uses[first].first;
    bool isHome = false;
    for (end = first; end < uses.size() && uses[end].first == v; ++end)
    {
      isHome = isHome || uses[end].second == mesh.pointBlocks[v];
    }
    const int home = isHome ? mesh.pointBlocks[v] : uses[first].second;
    mesh.pointBlocks[v] = home;
    for (std::size_t k = first; k < end; ++k)
    {
      points[k] = v;
      if (uses[k].second != home)
      {
        points[k] = static_cast<Index>(mesh.vertices.size());
        mesh.vertices.push_back(v);
        mesh.locations.push_back(locations[v]);
        mesh.pointBlocks.push_back(uses[k].second);
      }
    }
  }
  return points;
}

/** Locations of points that lie on other blocks than they belong to. */
void relocate(const DiagramSource& source, MeshBlocks& mesh)
{
  std::map<int, std::vector<Index>> strangers;
  std::vector<int> blocks;
  for (std::size_t p = 0; p < mesh.vertices.size(); ++p)
  {
    if (source.blockOfFacet(mesh.locations[p].facet) != mesh.pointBlocks[p])
    {
      strangers[mesh.pointBlocks[p]].push_back(static_cast<Index>(p));
    }
  }
  for (const auto& entry : strangers)
  {
    blocks.push_back(entry.first);
  }
  const BlockLocator locator(source, blocks);
  for (const auto& entry : strangers)
  {
    const std::vector<Index>& points = entry.second;
    locator.On(entry.first,
      [&](const auto& locate)
      {
        for (const Index p : points)
        {
          mesh.locations[p] = locate(source.result.placement.positions[mesh.vertices[p]]);
        }
      });
  }
}

struct SitePart
{
  InBlock where;
  double area;
};

/** The area that each site has in each block, by site and block. */
std::vector<SitePart> measureSites(const DiagramSource& source)
{
  const Diagram& diagram = source.result.diagram;
  const SurfaceMesh& mesh = source.prepared.mesh;
  std::vector<SitePart> parts;
  parts.reserve(static_cast<std::size_t>(diagram.numberOfPieces()));
  for (Offset piece = 0; piece < diagram.numberOfPieces(); ++piece)
  {
    const Index facet = diagram.facets[piece];
    const Triple& corners = mesh.facetPoints[facet];
    const double area =
      facetArea(mesh.points[corners[0]], mesh.points[corners[1]], mesh.points[corners[2]]);
    parts.push_back({ { diagram.sites[piece], source.blockOfFacet(facet) },
      diagram.weights[piece].fraction() * area });
  }
  std::stable_sort(parts.begin(), parts.end(),
    [](const SitePart& a, const SitePart& b) { return a.where < b.where; });
  std::size_t count = 0;
  for (const SitePart& part : parts)
  {
    if (count > 0 && parts[count - 1].where == part.where)
    {
      parts[count - 1].area += part.area;
    }
    else
    {
      parts[count++] = part;
    }
  }
  parts.resize(count);
  return parts;
}
}

const int* blocksOfCells(vtkPolyData* input)
{
  auto* blocks = vtkIntArray::SafeDownCast(input->GetCellData()->GetAbstractArray(blockName));
  return blocks ? blocks->GetPointer(0) : nullptr;
}

MeshBlocks findMeshBlocks(const DiagramSource& source)
{
  MeshBlocks mesh;
  mesh.triangles = source.result.dual.triangles;
  mesh.triangleBlocks = findTriangleBlocks(source);
  const std::vector<InBlock> uses = findUses(mesh.triangles, mesh.triangleBlocks);
  const std::vector<Index> points = makePoints(source, uses, mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (Index& id : mesh.triangles[t])
    {
      const auto use =
        std::lower_bound(uses.begin(), uses.end(), InBlock(id, mesh.triangleBlocks[t]));
      id = points[use - uses.begin()];
    }
  }
  relocate(source, mesh);
  return mesh;
}

std::vector<int> findSiteBlocks(const DiagramSource& source, const std::vector<Point3>& places)
{
  constexpr int none = -1;
  constexpr double equal = 1.0 - 1e-9; // areas that differ by rounding alone
  std::vector<int> blocks(places.size(), none);
  std::vector<double> largest(places.size(), 0.0);
  for (const SitePart& part : measureSites(source))
  {
    const Index site = part.where.first;
    if (blocks[site] == none || part.area * equal > largest[site])
    {
      blocks[site] = part.where.second;
      largest[site] = part.area;
    }
  }
  if (std::find(blocks.begin(), blocks.end(), none) != blocks.end())
  {
    const SurfaceMesh& mesh = source.prepared.mesh;
    const TriangleTree tree({ mesh.points, mesh.facetPoints }, source.control);
    for (std::size_t i = 0; i < blocks.size() && !source.control.cancelled(); ++i)
    {
      if (blocks[i] == none)
      {
        blocks[i] = tree.empty()
          ? source.blockOfFacet(0)
          : source.blockOfFacet(tree.triangleOf(tree.closest(places[i]).slot));
      }
    }
  }
  return blocks;
}
}
