/**
 * @file CurveStretches.h
 * @brief The curves' own Voronoi cells in R^d, each side of each feature edge for itself.
 */
#ifndef remesh_CurveStretches_h
#define remesh_CurveStretches_h

#include "Features/FeatureSites.h"

#include <algorithm>

namespace remesh
{
using Coordinates = Eigen::Map<const Eigen::VectorXd>;

/** What one station has of a side of an edge of its curve. */
struct Stretch
{
  const CollarEdge& collar;
  Index owner;         ///< feature point of the station
  std::size_t station; ///< of the curve
  double begin;        ///< [0, 1] along the edge, as the curve runs
  double end;
  const Eigen::VectorXd& start; ///< of the edge, d
  const Eigen::VectorXd& along; ///< the edge

  Eigen::VectorXd placeAt(double t) const { return this->start + t * this->along; }
  /** The place of the whole edge that is nearest to a point of R^d; beyond its ends, too. */
  double footOf(const Coordinates& point) const
  {
    const double squared = this->along.squaredNorm();
    return squared > 0.0 ? (point - this->start).dot(this->along) / squared : this->begin;
  }
  /** As the curve's stations count. */
  Station stationAt(double t, const FeatureCurve& curve) const
  {
    return stationIn(
      this->collar.segment, t < 1.0 ? t : 1.0, static_cast<Index>(curve.edges.size()));
  }
};

inline Coordinates coordinatesOf(const FeatureSites& sites, Index site)
{
  return Coordinates(sites.sites.site(site), sites.sites.dimension);
}

/** Whether a feature point is one of those before and after a station. */
bool isNextTo(const FeaturedSurface& featured, const FeatureSites& sites, Index curve,
  std::size_t station, Index point);

/** Calls `visit(const Stretch&)` for all, curve by curve, edge by edge, side by side. */
template <class Visit>
void forEachStretch(const FeaturedSurface& featured, const FeatureSites& sites, const Visit& visit)
{
  const auto& [mesh, surface, features] = featured;
  std::size_t first = 0; // station, of the edge
  for (const CollarEdge& collar : sites.collar)
  {
    first = collar.segment == 0 ? 0 : first;
    for (Offset i = features.edges.edgeFacetsBegin[collar.edge];
         i < features.edges.edgeFacetsBegin[collar.edge + 1]; ++i)
    {
      const Index facet = features.edges.edgeFacets[i];
      const int k = features.edges.sideOf(facet, collar.edge);
      const bool forward = mesh.facetPoints[facet][k] == collar.start;
      const Triple& corners = mesh.facetCorners[facet];
      const Eigen::VectorXd start =
        Coordinates(surface.corner(corners[forward ? k : (k + 1) % 3]), surface.dimension);
      const Eigen::VectorXd along =
        Coordinates(surface.corner(corners[forward ? (k + 1) % 3 : k]), surface.dimension) - start;
      std::size_t station = first;
      Index owner = collar.first;
      double begin = 0.0;
      for (const CollarEdge::Change& change : collar.changes)
      {
        visit(Stretch{ collar, owner, station++, begin, change.t, start, along });
        owner = change.to;
        begin = change.t;
      }
      visit(Stretch{ collar, owner, station, begin, 1.0, start, along });
    }
    first += collar.changes.size();
  }
}
}

#endif
