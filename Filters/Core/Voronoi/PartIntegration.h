/**
 * @file PartIntegration.h
 * @brief The integrals over the cells on a part of the surface: what a rank does for the first one.
 */
#ifndef remesh_PartIntegration_h
#define remesh_PartIntegration_h

#include "Support/Ranks.h"
#include "Voronoi/RestrictedVoronoi.h"

namespace remesh
{
/** A part of the surface and its diagram. */
class PartIntegration
{
public:
  /** @param part the length of blocks, how much of the surface it is, and its facets. */
  explicit PartIntegration(Packet& part);

  /**
   * @param sites as they are sent.
   * @param answer the sums of the part's blocks are added.
   */
  Status integrate(Packet& sites, Packet& answer);

private:
  Offset m_blockLength;
  double m_share;
  EmbeddedSurface m_surface;
  RestrictedVoronoi m_voronoi;
  Sites m_sites; ///< this and the next are kept for their memory
  std::vector<BlockSums> m_blocks;
};
}

#endif
