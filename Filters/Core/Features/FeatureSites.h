/**
 * @file FeatureSites.h
 * @brief The sites on the features: fixed ones, a copy in each fan, that stand for one vertex.
 */
#ifndef remesh_FeatureSites_h
#define remesh_FeatureSites_h

#include "Features/CurveStations.h"
#include "Support/Grouping.h"

namespace remesh
{
/** A vertex on a corner or a curve. */
struct FeaturePoint
{
  Point3 place;  ///< in R^3, on the input's edge or at its point
  bool isCorner; ///< of the feature graph
  Index curve;   ///< noIndex for a corner
};

/** Where a copy sits on a facet: its cell has a piece there, unless another copy coincides. */
struct Seat
{
  Index facet;
  double b[3]; ///< barycentric coordinates
  Index site;
};

/** The curve's own Voronoi cells along one feature edge, from one of its ends to the other. */
struct CollarEdge
{
  struct Change
  {
    double t; ///< [0, 1] along the edge
    Index to; ///< the feature point that owns what follows
  };

  Index edge;                  ///< of `Features::edges`
  Index start;                 ///< point of the surface where it starts
  Index curve;                 ///< of `Features::curves`
  Index segment;               ///< of the curve
  Index first;                 ///< feature point that owns the start
  std::vector<Change> changes; ///< ascending
};

struct FeatureSites
{
  Stations stations;                           ///< the places on the curves
  std::vector<FeaturePoint> points;            ///< corners first, as in Features, then curves
  Sites sites;                                 ///< the copies, point by point, all fixed
  std::vector<Index> pointOfSite;              ///< the feature point of each copy
  std::vector<Index> firstCopy;                ///< of each feature point
  std::vector<Offset> seatBegin;               ///< points + 1, into `seats`
  std::vector<Seat> seats;                     ///< at least one for each point
  std::vector<CollarEdge> collar;              ///< curve by curve, edge by edge
  std::vector<std::vector<Index>> curvePoints; ///< for each curve, the feature point per station

  Index numberOfPoints() const { return static_cast<Index>(this->points.size()); }
  /** The site that stands for the vertex of a site: the first of its copies. */
  Index mergedSite(Index site) const
  {
    return site < this->sites.count() ? this->firstCopy[this->pointOfSite[site]] : site;
  }
};

/**
 * Makes the sites for places on the curves and all corners.
 *
 * A vertex at a point of the surface has a copy for each corner there; one on an edge, for each
 * facet around it. Copies with equal coordinates are one site (both sides of a crease that ends
 * within its patch, where normals do not count).
 *
 * In the embedding the copies are off their places by up to 1e-8 of the square root of the
 * surface's measure (a millionth of the spacing of 10 000 sites), at random but for the same place
 * always alike: evenly spaced sites on a regular surface would meet at exactly one point in
 * fours, with pieces of no area.
 */
class FeatureSiteMaker
{
public:
  /** O(V + F). */
  explicit FeatureSiteMaker(const FeaturedSurface& featured);

  /** For these places. O(V + sites). */
  FeatureSites make(const Stations& stations) const;

private:
  class Builder;

  FeaturedSurface m_featured;
  Groups m_cornersOfPoint;                            ///< V
  std::vector<std::pair<Index, int>> m_facetOfCorner; ///< C
};

/** The same for one set of places. O(V + F). */
inline FeatureSites makeFeatureSites(const FeaturedSurface& featured, const Stations& stations)
{
  return FeatureSiteMaker(featured).make(stations);
}
}

#endif
