/**
 * @file SurfaceDistance.h
 * @brief How far two surfaces are from each other: root mean square and maximum, both ways.
 */
#ifndef remesh_SurfaceDistance_h
#define remesh_SurfaceDistance_h

#include "Comparison/DistanceSums.h"
#include "Mesh/TriangleTree.h"
#include "Support/RunControl.h"
#include "Support/Status.h"

namespace remesh
{
struct DistanceOptions
{
  /**
   * About how many points of each surface are looked at, spread by area; each triangle with area
   * gets at least one.
   */
  Offset numberOfSamples = 200000;

  /**
   * The bound of the maximum is refined until it is at most this much (a share) above the largest
   * distance found, or below `negligible`. Negative: no bound is sought, it is infinite.
   */
  double boundTolerance = 0.01;
  double negligible = 0.0; ///< in the unit of the points

  /** Parts of triangles that are looked at for the bound, each way, at most. */
  Offset maximumParts = 1000000;
};

/** The distances of the points of one surface to another, in the unit of the points. */
struct OneSidedDistance
{
  double area = 0.0;         ///< of the surface
  double mean = 0.0;         ///< over the area, by quadrature (or few places on small triangles)
  double rms = 0.0;          ///< root mean square over the area, by quadrature
  double maximum = 0.0;      ///< the largest found: reached at a point of the surface
  double maximumBound = 0.0; ///< no point of the surface is further away (up to rounding)
};

struct TwoSidedDistance
{
  OneSidedDistance forward;  ///< from the first surface to the second
  OneSidedDistance backward; ///< from the second to the first

  /** Root of the mean of the two mean squares. */
  double rms() const;
  /** The Hausdorff distance is between these two. */
  double maximum() const { return std::max(this->forward.maximum, this->backward.maximum); }
  double maximumBound() const
  {
    return std::max(this->forward.maximumBound, this->backward.maximumBound);
  }
};

/**
 * 1. Cuts each triangle into k^2 equal parts, with k so that the parts have about equal area, and
 *    takes six points on each, with which squares of quadratic functions are integrated exactly.
 *    On a triangle too small for six it takes as many as it is due, at least one, at places by a
 *    hash of its number.
 * 2. The largest distance is looked for there and at the corners, and further by step 3.
 * 3. Bounds the maximum (MaximumBound.h).
 *
 * Triangles without area are left out of both surfaces. The same points are taken each time.
 *
 * @param to has triangles.
 * @return InvalidInput if no triangle of `from` has area, or its area is beyond all doubles;
 *         Cancelled.
 * Cost: a search in the tree for each of max(T, numberOfSamples) samples and up to maximumParts
 * parts, in parallel; the results do not depend on the threads.
 */
Status measureOneSidedDistance(const Triangles& from, const TriangleTree& to,
  const DistanceOptions& options, const RunControl& control, OneSidedDistance& distance);

/**
 * Steps 1 and 2 alone: the bound of the maximum is infinite.
 *
 * @return as measureOneSidedDistance.
 */
Status measureSamples(const SampledTriangles& from, const TriangleTree& to,
  const RunControl& control, OneSidedDistance& distance);

/** @return what measureSamples finds, from the sums of all blocks, in their order. */
OneSidedDistance distanceOf(const std::vector<DistanceSums>& blocks);

/** Steps 1 to 3 both ways; builds the trees. */
Status measureTwoSidedDistance(const Triangles& first, const Triangles& second,
  const DistanceOptions& options, const RunControl& control, TwoSidedDistance& distance);
}

#endif
