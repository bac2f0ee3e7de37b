/**
 * @file PatchLattice.h
 * @brief Patches kept apart in R^d: each is moved to a place of its own, as a whole.
 *
 * The places form a cubic lattice in the last few coordinates, so that they are not far out, where
 * doubles are sparse: in six dimensions the coordinates of a hundred patches lose seven bits at
 * most. Only by moving farther than the surface is wide does a point come to be another patch's.
 */
#ifndef remesh_PatchLattice_h
#define remesh_PatchLattice_h

#include "Support/Types.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace remesh
{
class PatchLattice
{
public:
  /** One patch, which stays where it is. */
  PatchLattice() = default;

  /** @param dimension of the points, whose coordinates are at most 1 in size. */
  PatchLattice(int dimension, Index numberOfPatches)
    : m_dimension(dimension)
    , m_axes(std::min(dimension, 3))
  {
    // Other patches are then farther away than twice the diameter: no cell can reach them.
    int exponent = 0;
    std::frexp(4.0 * std::sqrt(static_cast<double>(dimension)) + 2.0, &exponent);
    m_step = std::ldexp(1.0, exponent);
    const auto holds = [&]
    { return std::pow(static_cast<double>(m_perAxis), m_axes) >= numberOfPatches; };
    while (!holds())
    {
      ++m_perAxis;
    }
  }

  /** How far a patch is moved along coordinate k. */
  double offset(Index patch, int k) const
  {
    int axis = m_dimension - 1 - k;
    if (axis >= m_axes)
    {
      return 0.0;
    }
    for (; axis > 0; --axis)
    {
      patch /= m_perAxis;
    }
    return m_step * (patch % m_perAxis);
  }

  /** The patch of a point that was moved with it. */
  Index patchOf(const double* point) const
  {
    Index patch = 0;
    for (int axis = m_axes - 1; axis >= 0; --axis)
    {
      const double place = std::round(point[m_dimension - 1 - axis] / m_step);
      patch = m_perAxis * patch + std::clamp(static_cast<Index>(place), 0, m_perAxis - 1);
    }
    return patch;
  }

  /** No two points of different patches are nearer: a search need not look into others. */
  double minDistance() const
  {
    return m_axes > 0 ? m_step - 2.0 : std::numeric_limits<double>::infinity();
  }

private:
  int m_dimension = 0;
  int m_axes = 0; ///< of the lattice
  Index m_perAxis = 1;
  double m_step = 0.0;
};
}

#endif
