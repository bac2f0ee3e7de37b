/**
 * @file FacetStar.h
 * @brief The facets around a point of a surface that only has lengths, laid out in a plane.
 */
#ifndef remesh_FacetStar_h
#define remesh_FacetStar_h

#include "Support/Types.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace remesh
{
using Vector2 = Eigen::Vector2d;

inline double cross(const Vector2& a, const Vector2& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

inline int next(int k)
{
  return k == 2 ? 0 : k + 1;
}

/** Corner k of facet f, and side k, from it to the next one. */
inline Index cornerOf(Index facet, int k)
{
  return 3 * facet + k;
}

/** Facets with the lengths of their sides, and how they are joined. */
struct JoinedFacets
{
  std::vector<Triple> points;                 ///< noIndex: the facet is gone
  std::vector<std::array<double, 3>> lengths; ///< of side k
  std::vector<Triple> across;                 ///< of each side, the one that it is joined to
  std::vector<Index> cornerOfPoint;           ///< one of each
};

/** Facets around a point, counter-clockwise, in a plane with the point at its origin. */
struct Star
{
  static constexpr int maxFacets = 16; ///< more are no star

  bool isBorder = false;
  int facets = 0;
  Index corners[maxFacets];      ///< of the facets at the point
  int ends = 0;                  ///< points around
  Index points[maxFacets + 1];   ///< around
  Vector2 places[maxFacets + 1]; ///< of these
  double worst = 1.0;            ///< quality of its facets

  /** The k-th point from one of the ends, around. */
  int from(int end, int k) const { return (end + k) % this->ends; }
};

/** The facets around a point and their points; false where they are too many. */
bool walkAround(const JoinedFacets& facets, Index point, Star& star);

/** Lays the facets out, after `walkAround`. False where they do not fit into a plane. */
bool layOut(const JoinedFacets& facets, Star& star);

/**
 * The worst quality of the triangles from one end to all others; below 0 where it cannot be.
 *
 * @param longest side that they may have.
 */
double qualityFrom(const Star& star, int end, double longest);

/** Whether triangles from that end would join points that are joined already. */
bool isTaken(const JoinedFacets& facets, const Star& star, int end);

/** What is across the side of a facet of a star that is not at its point. */
Index outside(const JoinedFacets& facets, const Star& star, int facet);
}

#endif
