/**
 * @file DroppedCreases.h
 * @brief What a surface loses of its creases, as points at the spacing cannot follow them.
 */
#ifndef remesh_DroppedCreases_h
#define remesh_DroppedCreases_h

#include "Features/FeatureEdges.h"
#include "Features/Features.h"

namespace remesh
{
/**
 * The creases among the features there were, and the sides of needles, that are none now. O(E).
 *
 * @param before E, the kinds that were found; `features` has those that are left.
 */
DroppedCreases tellDropped(const SurfaceMesh& mesh, const EdgeTable& edges,
  const std::vector<FeatureKind>& before, const FeatureEdges& features);
}

#endif
