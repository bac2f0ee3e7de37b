#include "Delaunay/Dual.h"

#include "Delaunay/HangingTriangles.h"
#include "Mesh/Duplicates.h"
#include "Support/Grouping.h"
#include "Voronoi/CellNeighbors.h"

#include <algorithm>

namespace remesh
{
namespace
{
/** The triangles of the points of one piece where it has the lowest site of the three. */
template <class Visit>
void forEachTriangle(
  const Diagram& diagram, const Components& components, Offset piece, const Visit& visit)
{
  const Index site = diagram.sites[piece];
  const Offset begin = diagram.vertexBegin[piece];
  const Offset end = diagram.vertexBegin[piece + 1];
  for (Offset v = begin; v < end; ++v)
  {
    const Index incoming = diagram.across[v == begin ? end - 1 : v - 1];
    const Index outgoing = diagram.across[v];
    if (incoming > site && outgoing > site)
    {
      const Index facet = diagram.facets[piece];
      const Triple triangle{ components.ofPiece[piece],
        components.ofPiece[diagram.pieceOf(facet, incoming)],
        components.ofPiece[diagram.pieceOf(facet, outgoing)] };
      // Two of them may be copies of one site.
      if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
      {
        visit(triangle);
      }
    }
  }
}

/** The triangles of all points where three cells meet, as often as they come. */
bool collectTriangles(const Diagram& diagram, const Components& components,
  const RunControl& control, std::vector<Triple>& triangles)
{
  const Blocks blocks = longBlocks(diagram.numberOfPieces());
  std::vector<std::vector<Triple>> found(static_cast<std::size_t>(blocks.count()));
  if (!forEachBlock(blocks.count(), control,
        [&](Offset block)
        {
          for (Offset piece = blocks.begin(block); piece < blocks.end(block); ++piece)
          {
            forEachTriangle(diagram, components, piece,
              [&](const Triple& triangle) { found[block].push_back(triangle); });
          }
        }))
  {
    return false;
  }
  for (std::vector<Triple>& some : found)
  {
    triangles.insert(triangles.end(), some.begin(), some.end());
    some = std::vector<Triple>(); // which frees it; {} would keep the memory
  }
  return true;
}

Triple sorted(Triple triangle)
{
  std::sort(triangle.begin(), triangle.end());
  return triangle;
}

/** Keeps the first of the triangles on the same three vertices; `twins` are the others, sorted. */
bool removeRepeated(
  const RunControl& control, std::vector<Triple>& triangles, std::vector<Triple>& twins)
{
  const std::vector<unsigned char> repeated = findDuplicates(triangles, control).repeats;
  std::size_t kept = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (repeated[t])
    {
      twins.push_back(sorted(triangles[t]));
    }
    else
    {
      triangles[kept++] = triangles[t];
    }
  }
  triangles.resize(kept);
  std::sort(twins.begin(), twins.end());
  return !control.cancelled();
}

/** For each vertex, the number of its triangles. */
std::vector<Index> countUses(const std::vector<Triple>& triangles, Index numberOfVertices)
{
  std::vector<Index> uses(static_cast<std::size_t>(numberOfVertices), 0);
  for (const Triple& triangle : triangles)
  {
    for (const Index vertex : triangle)
    {
      ++uses[vertex];
    }
  }
  return uses;
}

/** Counts what the triangles make. */
Status examine(Index numberOfVertices, const RunControl& control, Dual& dual)
{
  dual.edges = countEdgeValences(dual.triangles, numberOfVertices, control);
  if (control.cancelled())
  {
    return Status::cancelled();
  }
  const std::vector<Index> uses = countUses(dual.triangles, numberOfVertices);
  const auto used = static_cast<Offset>(uses.size()) - std::count(uses.begin(), uses.end(), 0);
  dual.eulerCharacteristic = used - dual.edges.edges + static_cast<Offset>(dual.triangles.size());
  return Status::success();
}
}

Status buildDual(const Diagram& diagram, const Components& components, const RunControl& control,
  Dual& dual, const Seams* seams)
{
  dual = Dual{};
  const RunControl silent = control.silent();
  if (!collectTriangles(diagram, components, silent, dual.triangles))
  {
    return Status::cancelled();
  }
  if (seams)
  {
    dual.triangles.insert(dual.triangles.end(), seams->triangles.begin(), seams->triangles.end());
  }
  if (!removeRepeated(silent, dual.triangles, dual.repeated))
  {
    return Status::cancelled();
  }
  return examine(components.count(), silent, dual);
}

Status dropHangingTriangles(
  Components& components, Seams& seams, const RunControl& control, Dual& dual)
{
  if (dual.edges.numberOfNonManifold() == 0 ||
    removeHangingTriangles(dual.edges, components, dual.triangles, dual.repeated, seams) == 0)
  {
    return Status::success();
  }
  return examine(components.count(), control.silent(), dual);
}

Status countNeighbors(const Diagram& diagram, Index numberOfSites, const RunControl& control,
  std::vector<Index>& counts)
{
  counts.assign(static_cast<std::size_t>(numberOfSites), 0);
  return forEachCell(diagram, numberOfSites, control,
    [&](Index site, const std::vector<Index>& neighbors)
    { counts[site] = static_cast<Index>(neighbors.size()); });
}
}
