#include "Repair/DualEdges.h"

#include <algorithm>
#include <set>
#include <utility>

namespace remesh
{
namespace
{
std::pair<Index, Index> edgeOf(const Triple& triangle, int k)
{
  return std::minmax(triangle[(k + 1) % 3], triangle[(k + 2) % 3]);
}

/** The triangles that are not those of the dual, and the edges of those that were there. */
struct Changes
{
  std::vector<Index> triangles; ///< ascending
  std::set<std::pair<Index, Index>> edges;

  bool hadEdge(const Triple& triangle, int k) const
  {
    return this->edges.count(edgeOf(triangle, k)) > 0;
  }
};

Changes changesOf(const std::vector<Triple>& dual, const std::vector<Triple>& triangles)
{
  Changes changes;
  for (std::size_t t = 0; t < dual.size(); ++t)
  {
    if (dual[t] != triangles[t])
    {
      changes.triangles.push_back(static_cast<Index>(t));
      for (int k = 0; k < 3; ++k)
      {
        changes.edges.insert(edgeOf(dual[t], k));
      }
    }
  }
  return changes;
}

/** Turns the edge opposite to corner k of a triangle back; false where that is not to be. */
bool flipEdgeBack(
  const Changes& changes, Index triangle, int k, RepairedMesh& mesh, MeshEdits& edits)
{
  RepairedMesh::EdgeFlip flip;
  if (changes.hadEdge(mesh.triangles()[triangle], k) || !mesh.canFlip(triangle, k, flip))
  {
    return false;
  }
  const auto& [first, second] = flip.fresh; // first: apex, a, opposite; its new edge is across a
  if (!changes.hadEdge(first, 1) || mesh.isInverted(first) || mesh.isInverted(second))
  {
    return false;
  }
  for (const Index old : flip.old)
  {
    edits.inverted -= mesh.isInverted(mesh.triangles()[old]) ? 1 : 0;
  }
  mesh.apply(flip);
  --edits.flippedEdges;
  return true;
}
}

void flipBack(const std::vector<Triple>& dual, RepairedMesh& mesh, MeshEdits& edits)
{
  const Changes changes = changesOf(dual, mesh.triangles());
  for (bool any = true; any;)
  {
    any = false;
    for (const Index triangle : changes.triangles)
    {
      for (int k = 0; k < 3; ++k)
      {
        any = flipEdgeBack(changes, triangle, k, mesh, edits) || any;
      }
    }
  }
}
}
