#include "Delaunay/FeatureRepair.h"

#include "Features/CurveLevel.h"
#include "Features/PassedPoints.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

namespace remesh
{
namespace
{
constexpr double minGap = 0.02; // of a section, between its ends and a new place

/** Section by section, those nearest to its middle first. */
std::vector<Intrusion> inwardFirst(
  const std::vector<Intrusion>& intrusions, const Stations& stations, CurveLengths& lengths)
{
  std::vector<std::tuple<Index, Index, double, std::size_t>> order;
  for (std::size_t k = 0; k < intrusions.size(); ++k)
  {
    const Intrusion& intrusion = intrusions[k];
    const std::vector<double>& along = lengths.of(intrusion.curve);
    const std::vector<Station>& places = stations[intrusion.curve];
    const double middle = 0.5 *
      (lengthAt(along, places[intrusion.section]) + lengthAt(along, places[intrusion.section + 1]));
    order.emplace_back(
      intrusion.curve, intrusion.section, std::abs(lengthAt(along, intrusion.foot) - middle), k);
  }
  std::sort(order.begin(), order.end());
  std::vector<Intrusion> ordered;
  for (const auto& place : order)
  {
    ordered.push_back(intrusions[std::get<std::size_t>(place)]);
  }
  return ordered;
}
}

namespace
{
/** The section of a curve that a place is in. */
std::ptrdiff_t sectionOf(const Station& place, const std::vector<Station>& places)
{
  return std::upper_bound(places.begin(), places.end(), place) - places.begin();
}

/**
 * Where a curve gets a place: see CurveLevel.h for sites that are on features themselves. The side
 * of the curve is the one that is nearest to the site, as patches lie apart.
 */
Station placeFor(
  const Intrusion& intrusion, const FeaturedSurface& featured, const FeatureSites& featureSites)
{
  const auto& [mesh, surface, features] = featured;
  if (intrusion.site >= featureSites.sites.count())
  {
    return intrusion.foot;
  }
  using Coordinates = Eigen::Map<const Eigen::VectorXd>;
  const Coordinates site(featureSites.sites.site(intrusion.site), surface.dimension);
  const FeatureCurve& curve = features.curves[intrusion.curve];
  const Index edge = curve.edges[intrusion.foot.segment];
  Eigen::VectorXd nearest; // of the foot's places on all sides
  for (Offset i = features.edges.edgeFacetsBegin[edge];
       i < features.edges.edgeFacetsBegin[edge + 1]; ++i)
  {
    const Index facet = features.edges.edgeFacets[i];
    const int k = features.edges.sideOf(facet, edge);
    const Triple& corners = mesh.facetCorners[facet];
    const bool forward = mesh.facetPoints[facet][k] == curve.points[intrusion.foot.segment];
    const double t = forward ? intrusion.foot.t : 1.0 - intrusion.foot.t;
    const Coordinates start(surface.corner(corners[k]), surface.dimension);
    const Coordinates end(surface.corner(corners[(k + 1) % 3]), surface.dimension);
    const Eigen::VectorXd place = (1.0 - t) * start + t * end;
    if (nearest.size() == 0 || (place - site).squaredNorm() < (nearest - site).squaredNorm())
    {
      nearest = place;
    }
  }
  return levelWith(
    featured, featureSites, intrusion.site, { intrusion.curve, intrusion.foot, nearest });
}
}

RefinedCurves refinedCurves(const FeaturedSurface& featured,
  const std::vector<Intrusion>& intrusions, FeatureSites& featureSites)
{
  RefinedCurves refined;
  refined.curves.assign(featured.features.curves.size(), 0);
  Stations stations = featureSites.stations;
  std::set<Index> removed; // sites
  std::set<std::pair<Index, Index>> divided;
  CurveLengths lengths(featured);
  for (const Intrusion& intrusion : inwardFirst(intrusions, stations, lengths))
  {
    const std::pair<Index, Index> section{ intrusion.curve, intrusion.section };
    if (removed.count(intrusion.site) > 0 || divided.count(section) > 0)
    {
      continue;
    }
    const std::vector<double>& along = lengths.of(intrusion.curve);
    std::vector<Station>& places = stations[intrusion.curve];
    const Station place = placeFor(intrusion, featured, featureSites);
    const bool isThere = sectionOf(place, places) == sectionOf(intrusion.foot, places);
    if ((isThere && insertStation(along, place, 0.0, minGap, places)) ||
      insertStation(along, intrusion.foot, 0.0, minGap, places))
    {
      ++refined.places;
      refined.curves[intrusion.curve] = 1;
      if (intrusion.site >= featureSites.sites.count()) // a free one
      {
        removed.insert(intrusion.site);
        refined.joining.push_back(intrusion.site);
      }
      divided.insert(section);
    }
  }
  if (refined.places > 0)
  {
    featureSites = makeFeatureSites(featured, stations);
  }
  return refined;
}

namespace
{
Triple inOrder(Triple triangle)
{
  std::sort(triangle.begin(), triangle.end());
  return triangle;
}
}

std::vector<Intrusion> coarseSections(const std::vector<Triple>& inverted, const Seams& seams,
  const FeaturedSurface& featured, const FeatureSites& featureSites, const RunControl& control)
{
  std::set<Index> components;
  std::set<Triple> triangles;
  for (const Triple& triangle : inverted)
  {
    triangles.insert(inOrder(triangle));
    components.insert(triangle.begin(), triangle.end());
  }
  std::vector<Index> corners; // on features
  for (std::size_t point = 0; point < seams.components.size(); ++point)
  {
    if (components.count(seams.components[point]) > 0)
    {
      corners.push_back(static_cast<Index>(point));
    }
  }
  std::vector<Intrusion> found;
  for (const PassedPoint& passed : findPassedPoints(featured, featureSites, corners, control))
  {
    found.push_back({ passed.curve, passed.section, featureSites.firstCopy[passed.point],
      seams.components[passed.point], passed.foot, 0.0 });
  }
  std::copy_if(seams.encroachments.begin(), seams.encroachments.end(), std::back_inserter(found),
    [&](const Intrusion& by)
    {
      const Index* ends = featureSites.curvePoints[by.curve].data() + by.section;
      return triangles.count(
               inOrder({ by.component, seams.components[ends[0]], seams.components[ends[1]] })) > 0;
    });
  return found;
}

void replaceFixed(const FeatureSites& featureSites, Sites& sites)
{
  const auto free = sites.coordinates.begin() +
    static_cast<std::ptrdiff_t>(sites.fixed) * static_cast<std::ptrdiff_t>(sites.dimension);
  Sites replaced = featureSites.sites;
  replaced.coordinates.insert(replaced.coordinates.end(), free, sites.coordinates.end());
  sites = std::move(replaced);
}
}
