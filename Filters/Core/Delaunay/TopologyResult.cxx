#include "Delaunay/TopologyResult.h"

#include <cstdlib>

namespace remesh
{
namespace
{
/** "3 cells", "1 cell", or "" for none. */
std::string counted(std::size_t count, const std::string& one, const std::string& several)
{
  return count == 0 ? "" : std::to_string(count) + " " + (count == 1 ? one : several);
}

std::string joined(const std::vector<std::string>& parts)
{
  std::string text;
  for (const std::string& part : parts)
  {
    text += text.empty() || part.empty() ? part : ", " + part;
  }
  return text;
}

std::string describe(const Certificate& certificate)
{
  return "The cells are not proven to have the surface's topology: " +
    joined({ counted(certificate.cells.size(), "cell is no disk", "cells are no disks"),
      counted(certificate.edges.size(), "pair of cells meets not in one segment",
        "pairs of cells meet not in one segment"),
      counted(certificate.vertices.size(), "triple of cells meets more than once",
        "triples of cells meet more than once"),
      counted(static_cast<std::size_t>(certificate.lostPoints), "point on features has no cell",
        "points on features have no cells") }) +
    ".";
}

/** "5 components more", "1 component fewer", or "" for as many. */
std::string difference(Index has, Index should, const std::string& one, const std::string& several)
{
  const std::size_t count = static_cast<std::size_t>(std::abs(has - should));
  return count == 0 ? "" : counted(count, one, several) + (has < should ? " fewer" : " more");
}

/** Handles of closed or bordered orientable surfaces; -1 where that says nothing. */
Index handlesOf(const MeshTopology& topology)
{
  const Index twice =
    2 * topology.components - topology.boundaryLoops - topology.eulerCharacteristic;
  const bool isManifold = topology.nonManifoldEdges == 0 && topology.nonManifoldPoints == 0;
  return isManifold && topology.oriented && twice >= 0 && twice % 2 == 0 ? twice / 2 : -1;
}

/** What the mesh has that the surface has not, in words; "" for nothing. */
std::string differences(const MeshTopology& mesh, const MeshTopology& surface)
{
  const Index handles = handlesOf(mesh);
  const Index handlesWanted = handlesOf(surface);
  const bool areKnown = handles >= 0 && handlesWanted >= 0;
  const std::string euler = areKnown || mesh.eulerCharacteristic == surface.eulerCharacteristic
    ? ""
    : "Euler characteristic " + std::to_string(mesh.eulerCharacteristic) + " for " +
      std::to_string(surface.eulerCharacteristic);
  return joined({ difference(mesh.components, surface.components, "component", "components"),
    difference(mesh.boundaryLoops, surface.boundaryLoops, "border loop", "border loops"),
    areKnown ? difference(handles, handlesWanted, "handle", "handles") : "", euler,
    counted(
      static_cast<std::size_t>(mesh.nonManifoldEdges), "non-manifold edge", "non-manifold edges"),
    counted(static_cast<std::size_t>(mesh.nonManifoldPoints), "non-manifold point",
      "non-manifold points"),
    mesh.oriented == surface.oriented ? "" : "triangles side by side that face opposite ways" });
}
}

TopologyFailure TopologyResult::failure() const
{
  if (this->surface.nonManifoldEdges > 0 || this->surface.nonManifoldPoints > 0)
  {
    return TopologyFailure::SurfaceNotManifold;
  }
  if (!this->certificate.holds())
  {
    return TopologyFailure::Diagram;
  }
  return haveSameTopology(this->surface, this->mesh) ? TopologyFailure::None
                                                     : TopologyFailure::Mesh;
}

std::string TopologyResult::describe() const
{
  switch (this->failure())
  {
    case TopologyFailure::SurfaceNotManifold:
      return "The surface is no manifold, at " +
        joined({ counted(static_cast<std::size_t>(this->surface.nonManifoldEdges), "edge", "edges"),
          counted(static_cast<std::size_t>(this->surface.nonManifoldPoints), "point", "points") }) +
        ".";
    case TopologyFailure::Diagram:
    {
      const std::string found = differences(this->mesh, this->surface);
      return remesh::describe(this->certificate) +
        (found.empty() ? "" : " The mesh has, against the surface: " + found + ".");
    }
    case TopologyFailure::Mesh:
      return "The mesh has, against the surface: " + differences(this->mesh, this->surface) + ".";
    default:
      return "";
  }
}
}
