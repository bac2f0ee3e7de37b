/**
 * @file FeatureEdges.h
 * @brief Which edges of a surface are features.
 */
#ifndef remesh_FeatureEdges_h
#define remesh_FeatureEdges_h

#include "Features/Features.h"
#include "Mesh/Normals.h"
#include "Support/RunControl.h"

namespace remesh
{
/** Share of the feature angle above which edges may continue a feature. */
constexpr double weakShare = 0.5;

struct FeatureOptions
{
  double angleDegrees = 35.0;     ///< creases: angle between the facets' normals above this
  std::vector<Index> facetLabels; ///< F, or empty: edges between different labels are features
  /**
   * F x 3, or empty: which of several values of an array the point has in that facet. Edges whose
   * ends have not the same on both sides are features: seams of the array.
   */
  std::vector<Triple> cornerCharts;
  double spacing = 0.0; ///< of the points to come, in the unit of the points
};

struct FeatureEdges
{
  std::vector<FeatureKind> kinds; ///< E
  /** E, between the facets' normals, radians; 0 below `weakShare` of the angle, and at other edges.
   */
  std::vector<float> angles;
  std::vector<Index> sidesOfNeedles; ///< edges that are left out, see findFeatureEdges; ascending
  /** Facets without a normal of their own, ascending, with those they take. */
  std::vector<FacetNormal> borrowed;
};

/**
 * The kind of each edge. Some facets have no normal of their own: those thinner than what single
 * precision resolves (1e-6 of the bounding-box diagonal), and needles, whose normals make creases
 * of both their long sides, though points at this spacing cannot follow them:
 * - facets lower than a fiftieth of the spacing;
 * - flaps: facets lower than a fifth of it and than an eighth of their longest side, where those
 *   beyond the long sides agree clearly better with each other than with it, and which are not
 *   turned back (by 134 degrees) from both.
 * They take the normal of the facet beyond their longest edge, and on from there if that has none
 * either; two that meet in the longest edge of both, the same. Where none is found within a few
 * facets, they keep their own. O(F), in parallel. Of no use when cancelled.
 */
FeatureEdges findFeatureEdges(const SurfaceMesh& mesh, const EdgeTable& edges,
  const FeatureOptions& options, const RunControl& control);

/** Whether an edge of two facets is a border of labels, or a seam. */
bool isGivenFeature(
  const SurfaceMesh& mesh, const EdgeTable& edges, const FeatureOptions& options, Index edge);

/** Whether the charts of an edge's ends differ between its two facets (FeatureOptions). */
bool isSeam(const SurfaceMesh& mesh, const EdgeTable& edges,
  const std::vector<Triple>& cornerCharts, Index edge);

/**
 * Drops creases that are small against the spacing: connected sets of crease edges whose extent is
 * below a few spacings, more if they are weak and zigzag or branch like noise, less if they are
 * strong or close to a smooth loop; those of any extent that zigzag and branch at almost every
 * point; those around one or two facets that are turned back (by 134 degrees) from all around them
 * and lie on more than twice their area; and short dead ends of the others. Borders, non-manifold
 * edges, borders of labels and seams stay, and creases between them as short as they may be, unless
 * they zigzag or branch.
 *
 * O(F).
 */
void dropSmallFeatures(const SurfaceMesh& mesh, const EdgeTable& edges,
  const FeatureOptions& options, FeatureEdges& features);

/**
 * Where features meet, end or bend at more points than the spacing gives, drops the steps of
 * voxels: creases that are gone where the surface is smoothed over at most the spacing, among such
 * that hang together and move by little of it. Over a quarter of the spacing, then half of it, then
 * all, until such points are fewer than half of those that the spacing gives.
 *
 * @return the number of edges dropped; 0 as a rule. O(F), and the smoothing (NormalFlow.h).
 */
Index dropSteps(const SurfaceMesh& mesh, const EdgeTable& edges, const FeatureOptions& options,
  const RunControl& control, FeatureEdges& features);

/**
 * Goes on from the loose ends of creases along edges of at least half the angle, as straight as
 * they come, and keeps what leads to another feature: creases whose angle wavers are not left in
 * pieces. O(F).
 */
void bridgeGaps(const SurfaceMesh& mesh, const EdgeTable& edges, const FeatureOptions& options,
  FeatureEdges& features);
}

#endif
