/**
 * @file TopologyResult.h
 * @brief What is proven about the topology of a mesh, or why nothing is.
 */
#ifndef remesh_TopologyResult_h
#define remesh_TopologyResult_h

#include "Comparison/MeshTopology.h"
#include "Delaunay/Certificate.h"

namespace remesh
{
/** Why the mesh is not proven to be homeomorphic to the surface; the first that holds. */
enum class TopologyFailure : std::uint8_t
{
  None = 0,
  SurfaceNotManifold = 1,
  Diagram = 2, ///< the certificate fails
  Mesh = 3     ///< the mesh differs, as it is indexed
};

struct TopologyResult
{
  MeshTopology surface;    ///< connectivity of the input
  MeshTopology mesh;       ///< connectivity of the output
  Certificate certificate; ///< of the dual, before its vertices are placed

  TopologyFailure failure() const;
  bool preserved() const { return this->failure() == TopologyFailure::None; }
  /** Whether that of a manifold is not, or not proven to be. */
  bool lost() const
  {
    const TopologyFailure why = this->failure();
    return why == TopologyFailure::Diagram || why == TopologyFailure::Mesh;
  }
  /** One sentence with the numbers of what fails; "" where nothing does. */
  std::string describe() const;
};
}

#endif
