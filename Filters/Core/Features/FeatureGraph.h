/**
 * @file FeatureGraph.h
 * @brief From feature edges to corners and curves, and the surface cut open along them.
 */
#ifndef remesh_FeatureGraph_h
#define remesh_FeatureGraph_h

#include "Features/FeatureEdges.h"

namespace remesh
{
/**
 * Strings the feature edges together. Corners are the points where not just two of them meet, two
 * of different kinds meet, a curve turns sharply (by more than 60 degrees, from point to point and
 * over the spacing of the points to come), or the surface is pinched.
 *
 * Curves from corners come first, in the order of their corners and edges; then those without, in
 * the order of their edges. O(V + E).
 */
void traceCurves(const SurfaceMesh& mesh, Features& features);

/**
 * Finds the patches, which are the parts of the surface that features enclose, and cuts the surface
 * open between them. Around a point, the facets joined by edges that are not cut are a fan. Each
 * fan gets an embedded corner of its own (`facetCorners`, `cornerPoints`), numbered as the facets
 * meet them. Points whose fans are not all joined by edges are pinches. O(F).
 */
void cutAlongFeatures(SurfaceMesh& mesh, Features& features);

/**
 * The points away from features around which the facets' angles sum to no more than at the tip of a
 * cone with sides 45 degrees from its axis, and all edges are longer than the spacing: what a mesh
 * does not have there it cuts off. Where edges are shorter, it may be noise. Ascending. O(F).
 */
std::vector<Index> findApexes(const SurfaceMesh& mesh, const Features& features, double spacing);

/**
 * All of it: edges, small ones dropped, corners, curves, fans and patches. Of no use, and neither
 * is the mesh, when cancelled; the control is asked between and within these steps.
 *
 * @param borrowed receives the normals of facets that have none of their own (FeatureEdges.h).
 */
Features findFeatures(SurfaceMesh& mesh, const FeatureOptions& options,
  const RunControl& control = RunControl(), std::vector<FacetNormal>* borrowed = nullptr);

/**
 * The edges of the surface as it is embedded: as its points have them, but where it is cut open
 * each facet has an edge of its own.
 *
 * @param features nullptr: it is cut nowhere.
 * @return of no use when cancelled.
 */
EdgeTable buildCutEdgeTable(
  const SurfaceMesh& mesh, const Features* features, const RunControl& control);
}

#endif
