/**
 * @file FacetBatch.h
 * @brief The cells on facets that only the owners of their corners share, eight facets at once.
 *
 * That is most facets that are small against the cells. Each lane is a facet. As in Envelope.h a
 * site is three numbers, by how much it is farther than the reference from the corners; here two
 * sites part along a line, three in a point, and the integrals are closed forms:
 *
 * 1. the corners' coordinates, relative to the reference, and the sites' values there;
 * 2. the vertices of the cells: crossings of the facet's edges, and where three meet;
 * 3. parts as one or two triangles at their corners; the last one is what these leave;
 * 4. the sums of each part, as BlockSums has them.
 *
 * Three that do not meet on the facet leave two borders, which part the middle one from the others.
 * A third one without a corner has a triangle on the border between two, or all of it.
 *
 * Functions on a facet are affine here: another site has no part if it is above at all vertices of
 * the cells, and below none of the levels there (FacetRivals). BatchIntegration asks for it.
 *
 * Cost: O(d) for a facet, without a branch.
 */
#ifndef remesh_FacetBatch_h
#define remesh_FacetBatch_h

#include "Support/InstructionSet.h"
#include "Support/Lanes.h"

#include <Eigen/Core>

namespace remesh
{
/** More coordinates than this, and a batch does not stay in the nearest cache. */
constexpr int maxBatchDimensions = 16;

/** D: see dispatchDimension; Eigen::Dynamic has room for `maxBatchDimensions`. */
template <int D>
struct FacetBatch
{
  static constexpr int room = D == Eigen::Dynamic ? maxBatchDimensions : D;
  static constexpr int maxParts = 3;
  static constexpr int maxVertices = 4;

  int dimension = 0;
  const double* corners[3][lanes];
  const double* sites[maxParts][lanes]; ///< the reference first; who owns which corner: see below
  alignas(64) double mass[lanes];
  alignas(64) double edge2[3][lanes]; ///< as in FacetConstants, of these corners

  /** Mass, energy and moment of each part. */
  alignas(64) double sums[maxParts][2 + room][lanes];

  /** Twice the offsets of the cells' vertices from the reference, and the squares of these. */
  alignas(64) double vertices[maxVertices][room][lanes];
  alignas(64) double squared[maxVertices][lanes];
  /** A site whose value at a vertex is below this may have a part. That of its owners is. */
  alignas(64) double levels[maxVertices][lanes];

  /** Of three: by how much the third one is farther from where the edge at corner k is crossed. */
  alignas(64) double leads[3][lanes];
};

/** The plain ways to share a facet. */
enum class FacetPattern
{
  TwoCells, ///< the second site owns corner 0, the reference the others
  Meeting,  ///< each of three owns its corner, and they meet in a point
  Strip,    ///< the same, but the reference lies between the others, which do not meet
  Notch,    ///< as two cells, but a third one has the end of their border on the edge at corner 0
  Band      ///< as two cells, but a third one lies between them
};
constexpr int numberOfPatterns = 5;

/** The neighbours of a lane's reference, packed (BisectorPacks.h). */
template <int D>
struct FacetRivals
{
  const FacetBatch<D>& batch;
  int lane;
  const double* offsets;
  int stride;
  int count;
};

/** Returns a bit for each lane whose sites part in the plain way. */
template <int D>
using FacetSharing = unsigned (*)(FacetBatch<D>&);

/** Returns how many of the first `count` are below a level at any vertex: the owners are. */
template <int D>
using RivalCount = int (*)(const FacetRivals<D>&);

/** All sets of instructions give the same bits. */
template <int D>
struct FacetKernels
{
  FacetSharing<D> share;
  RivalCount<D> countRivals;

  static FacetKernels of(FacetPattern pattern, InstructionSet set);
};

extern template struct FacetKernels<3>;
extern template struct FacetKernels<6>;
extern template struct FacetKernels<Eigen::Dynamic>;
}

#endif
