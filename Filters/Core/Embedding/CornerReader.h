/**
 * @file CornerReader.h
 * @brief The coordinates of corners, whether the surface holds them or reads them when asked.
 */
#ifndef remesh_CornerReader_h
#define remesh_CornerReader_h

#include "Embedding/EmbeddedSurface.h"

#include <array>

namespace remesh
{
/** The centre of a facet, by its corners in R^d. */
inline void findCenter(const std::array<const double*, 3>& corners, std::vector<double>& center)
{
  for (std::size_t k = 0; k < center.size(); ++k)
  {
    center[k] = (corners[0][k] + corners[1][k] + corners[2][k]) * (1.0 / 3.0);
  }
}

/**
 * One thread's window on the corners of a surface. D: see dispatchDimension; only surfaces of other
 * dimensions than those compiled for are ever lent.
 * Cost: nothing where the surface holds its corners, O(d) a row otherwise.
 */
template <int D>
class CornerReader
{
public:
  explicit CornerReader(const EmbeddedSurface& surface)
    : m_surface(surface)
  {
  }

  /** The d scaled coordinates of a corner; valid until the next call for the same slot, 0 to 2. */
  const double* corner(Index id, int slot = 0)
  {
    if (D != Eigen::Dynamic || !m_surface.source.isLent())
    {
      return m_surface.corner(id);
    }
    std::vector<double>& row = m_rows[slot];
    if (row.empty() || m_ids[slot] != id)
    {
      row.resize(static_cast<std::size_t>(m_surface.dimension));
      m_surface.readScaled(id, row.data());
      m_ids[slot] = id;
    }
    return row.data();
  }

  /** The three corners of a facet; valid until the next call. */
  std::array<const double*, 3> facet(Index id)
  {
    const Triple& corners = m_surface.facetCorners[id];
    return { this->corner(corners[0], 0), this->corner(corners[1], 1),
      this->corner(corners[2], 2) };
  }

private:
  const EmbeddedSurface& m_surface;
  std::vector<double> m_rows[3];
  Index m_ids[3] = { noIndex, noIndex, noIndex };
};
}

#endif
