/**
 * @file BisectorValues.h
 * @brief How much farther than a site its neighbours are from the corners of a facet, many at once.
 *
 * |p - x_q|^2 - |p - x_i|^2 = |a|^2 - 2 t . a, with a = x_q - x_i and t = p - x_i.
 */
#ifndef remesh_BisectorValues_h
#define remesh_BisectorValues_h

#include "Support/InstructionSet.h"

#include <cstdint>

namespace remesh
{
/**
 * Values at three points of c - 2 t . a for many (a, c): t is 3 x d, `offsets` has a row of
 * `stride` numbers for each coordinate of the a, then one of the c. The first `count` are
 * evaluated, rounded up to whole `lanes`.
 */
struct BisectorValues
{
  const double* offsets;
  int stride;
  int count;
  const double* points;
  int dimension;
  const double (*limits)[3]; ///< numberOfLimits x 3
  int numberOfLimits;
  double* values; ///< 3 x stride

  /** A bit for each that is below every limit at some of its points; `lanes` bits a number. */
  std::uint8_t* chosen;
};

/** The same at one point, of which the least is wanted. */
struct BisectorsAtPoint
{
  const double* offsets;
  int stride;
  int count;
  const double* point;
  int dimension;
  double* values; ///< stride
};

/**
 * Packs rows for `BisectorValues`: the offsets of the listed sites from x, and the squares of their
 * lengths. The lanes [first, last), which are whole ones; those from `count` on stand for sites
 * that win nothing.
 */
struct BisectorPack
{
  const double* x;
  const double* coordinates; ///< of all sites, n x d
  const std::int32_t* sites; ///< count
  int count;
  int first;
  int last;
  int dimension;
  int stride;
  double* offsets; ///< (d + 1) x stride
};

using BisectorEvaluation = void (*)(const BisectorValues&);
using BisectorMinimum = double (*)(const BisectorsAtPoint&);
using BisectorPacking = void (*)(const BisectorPack&);

/** The loops, compiled for a set of instructions; all give the same bits. */
BisectorEvaluation bisectorEvaluation(InstructionSet set);
/** Returns the least value; infinity if there is none. */
BisectorMinimum bisectorMinimum(InstructionSet set);
BisectorPacking bisectorPacking(InstructionSet set);
}

#endif
