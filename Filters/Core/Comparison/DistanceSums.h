/**
 * @file DistanceSums.h
 * @brief The distances of samples of a surface to another one, added up by blocks of triangles.
 */
#ifndef remesh_DistanceSums_h
#define remesh_DistanceSums_h

#include "Mesh/TriangleTree.h"
#include "Support/Parallel.h"
#include "Support/Status.h"

#include <cmath>
#include <vector>

namespace remesh
{
/** Integrals over a part of a surface. */
struct DistanceSums
{
  double area = 0.0;
  double distance = 0.0;
  double squared = 0.0;
  double largestSquared = 0.0;

  void add(double weight, double squaredDistance);
  DistanceSums& operator+=(const DistanceSums& part);
};

/** A surface, or a range of its triangles, and how it is sampled. */
struct SampledTriangles
{
  Triangles triangles;
  std::vector<char>
    isFirst;         ///< T x 3, whether a point comes for the first time, of those with area
  double area = 0.0; ///< of the whole surface
  double samplesPerArea = 0.0;
  Offset first = 0; ///< the number in the surface of the first of them

  bool hasArea() const { return this->area > 0.0 && std::isfinite(this->area); }
};

/** @param numberOfSamples see DistanceOptions. Cost: O(T), serial. */
SampledTriangles sampledTriangles(const Triangles& surface, Offset numberOfSamples);

/** The blocks by which the sums of a surface are added up. */
Blocks sampledBlocks(Offset triangles);

/**
 * The sums of each block, for steps 1 and 2 of SurfaceDistance.h. Those of a range of blocks are
 * the same by themselves, to the bit.
 *
 * @param to has triangles.
 * @return Cancelled, or success.
 */
Status sumDistances(const SampledTriangles& from, const TriangleTree& to, const Blocks& blocks,
  const RunControl& control, std::vector<DistanceSums>& sums);
}

#endif
