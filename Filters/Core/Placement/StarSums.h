/**
 * @file StarSums.h
 * @brief What the samples of a cell add to the triangles around its vertex, several at once.
 */
#ifndef remesh_StarSums_h
#define remesh_StarSums_h

#include "Placement/FitSamples.h"
#include "Support/InstructionSet.h"

namespace remesh
{
/** A triangle seen from one of its corners; without area, it has no normal. */
struct StarTriangle
{
  // Their products with a way from the corner are the weights of the other two corners.
  double first[3];
  double second[3];
  double normal[3]; ///< unit
  Index sums;       ///< which of the sums are the triangle's
  int corner;       ///< which of its corners the common one is
};

/**
 * Sums over samples with weight W (as the samples have it), unit normal n, feet (b0, b1, b2) in the
 * triangle and residuals r along n. Rows of eight, as that is how they are added.
 */
struct TriangleSums
{
  /** W b_i b_j (n n^T: xx xy xz yy yz zz; 1; 0), of the corners 00, 11, 22, 01, 12, 20. */
  double pairs[6][lanes];
  /** W b_i (r n; n; r^2; 1), of the corners 0, 1, 2. */
  double slopes[3][lanes];
  double farthest; ///< the greatest r^2
};

/** Adds the samples that lie right above a triangle, or below, each to the nearest of these. */
struct StarTask
{
  const std::vector<StarTriangle>& triangles;
  const SampleGroup* groups;
  double unit;         ///< of their lengths, a power of two
  Index count;         ///< of samples
  const double* shift; ///< from the common corner to what the samples' offsets count from
  TriangleSums* sums;
  Index* others; ///< room for `count`: receives the samples that lie above no triangle
};

/** Returns the number of the other samples. */
using StarSummation = Index (*)(const StarTask&);

/** Compiled for a set of instructions; all give the same bits. */
StarSummation starSummation(InstructionSet set);

/** Adds one sample with a foot. */
void addSample(
  const double normal[3], double weight, const double b[3], double residual, TriangleSums& sums);
}

#endif
