/**
 * @file ThinTips.h
 * @brief Where a site goes at the tip of a thin sheet, between the two curves that meet there.
 *
 * Both sides of the sheet first have the same triangle there, of the corner and the next point on
 * each curve. A site at the vertex of the diagram that it is the dual of would reach the curves; so
 * these would be divided nearer to the corner, and the same would follow at every scale. A site
 * as far from the corner as those points are on average, where their cells meet, parts these on its
 * side: it is inside of the triangle's circumscribed circle. It reaches neither curve if it is
 * outside of the circles whose diameters are the curves' sections, as for any angle it is where
 * both points are equally far from the corner; at narrow angles they must nearly be.
 */
#ifndef remesh_ThinTips_h
#define remesh_ThinTips_h

#include "Delaunay/Components.h"
#include "Embedding/CornerReader.h"
#include "Voronoi/VertexPlaces.h"

#include <utility>

namespace remesh
{
class ThinTips
{
public:
  ThinTips(const VertexPlaces& places, const Components& components);

  /**
   * @param corner, first, second components that meet at two vertices of the diagram.
   * @return on the surface, d scaled coordinates, where the cells of `first` and `second` meet as
   *         far from the corner's site as theirs are on average, or the nearest to it. Empty if
   * they are not all of fixed sites, each its only one, or if the two share no segment on a patch
   *         of the corner's. Cost: O(pieces of the cells of the two points), and for each that both
   *         share O(pieces of the corner's).
   */
  std::vector<double> placeBetween(Index corner, Index first, Index second);

private:
  using Vector = Eigen::VectorXd;

  bool isFixed(Index component) const;
  Index copyBeside(Index component, Index other) const;
  Vector placeOf(Offset piece, Offset vertex);
  std::pair<Vector, double> placeOnSide(Index center, Offset piece, Offset vertex);
  Vector rowOf(const double* row) const;

  const VertexPlaces& m_places;
  const Components& m_components;
  CornerReader<Eigen::Dynamic> m_reader;
};
}

#endif
