#include "Delaunay/TopologyResult.h"

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
      return remesh::describe(this->certificate);
    case TopologyFailure::Mesh:
      return "The mesh differs from the surface: Euler characteristic " +
        std::to_string(this->mesh.eulerCharacteristic) + " for " +
        std::to_string(this->surface.eulerCharacteristic) + ", components " +
        std::to_string(this->mesh.components) + " for " + std::to_string(this->surface.components) +
        ", border loops " + std::to_string(this->mesh.boundaryLoops) + " for " +
        std::to_string(this->surface.boundaryLoops) + ", non-manifold edges " +
        std::to_string(this->mesh.nonManifoldEdges) + ".";
    default:
      return "";
  }
}
}
