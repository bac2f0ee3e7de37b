#include "Features/FeatureSites.h"

#include "Support/Random.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace remesh
{
FeatureSiteMaker::FeatureSiteMaker(const FeaturedSurface& featured)
  : m_featured(featured)
  , m_facetOfCorner(featured.mesh.cornerPoints.size(), { noIndex, 0 })
{
  const SurfaceMesh& mesh = featured.mesh;
  // Not to be cancelled: it takes as long as one look at the surface.
  static_cast<void>(groupByKey(
    static_cast<Offset>(mesh.cornerPoints.size()), mesh.numberOfPoints(), RunControl(),
    [&](Offset corner) { return mesh.cornerPoints[corner]; }, m_cornersOfPoint));
  for (Index f = 0; f < mesh.numberOfFacets(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      auto& first = m_facetOfCorner[mesh.facetCorners[f][k]];
      if (first.first == noIndex)
      {
        first = { f, k };
      }
    }
  }
}

/** Makes the copies of one vertex after the other. */
class FeatureSiteMaker::Builder
{
public:
  Builder(const FeatureSiteMaker& maker, FeatureSites& result)
    : m_maker(maker)
    , m_mesh(maker.m_featured.mesh)
    , m_surface(maker.m_featured.surface)
    , m_features(maker.m_featured.features)
    , m_result(result)
    , m_coordinates(static_cast<std::size_t>(m_surface.dimension))
  {
    result.sites.dimension = m_surface.dimension;
    result.seatBegin.push_back(0);
  }

  /** A vertex at a point of the surface, with a copy for each corner there. */
  Index addAtPoint(Index point, Index curve)
  {
    this->begin(m_mesh.points[point], curve);
    const Groups& corners = m_maker.m_cornersOfPoint;
    for (Offset i = corners.begins[point]; i < corners.begins[point + 1]; ++i)
    {
      const Index corner = corners.items[i];
      std::copy_n(m_surface.corner(corner), m_surface.dimension, m_coordinates.begin());
      const auto [facet, k] = m_maker.m_facetOfCorner[corner];
      Seat seat{ facet, { 0.0, 0.0, 0.0 }, this->copyHere() };
      seat.b[k] = 1.0;
      m_result.seats.push_back(seat);
    }
    return this->end();
  }

  /** A vertex at a station of a curve. */
  Index addAt(const Station& station, Index curve)
  {
    const FeatureCurve& course = m_features.curves[curve];
    const Index point = course.points[station.segment];
    return station.t == 0.0
      ? this->addAtPoint(point, curve)
      : this->addOnEdge(course.edges[station.segment], point, station.t, curve);
  }

  /** A vertex inside an edge, with a copy for each facet around it. */
  Index addOnEdge(Index edge, Index start, double t, Index curve)
  {
    const auto [firstFacet, firstK] = this->sideOf(edge, 0);
    const Triple& ends = m_mesh.facetPoints[firstFacet];
    const Index a = ends[firstK];
    const Index b = ends[(firstK + 1) % 3];
    const double along = a == start ? t : 1.0 - t;
    this->begin((1.0 - along) * m_mesh.points[a] + along * m_mesh.points[b], curve);
    for (Index side = 0; side < m_features.edges.valence(edge); ++side)
    {
      const auto [facet, k] = this->sideOf(edge, side);
      const int l = (k + 1) % 3;
      const double there = m_mesh.facetPoints[facet][k] == start ? t : 1.0 - t;
      const double* p = m_surface.corner(m_mesh.facetCorners[facet][k]);
      const double* q = m_surface.corner(m_mesh.facetCorners[facet][l]);
      // From the same end in all facets, so that equal sides give equal copies.
      const bool turned = m_mesh.facetPoints[facet][k] != a;
      for (int c = 0; c < m_surface.dimension; ++c)
      {
        const double from = turned ? q[c] : p[c];
        const double to = turned ? p[c] : q[c];
        m_coordinates[c] = from == to ? from : (1.0 - along) * from + along * to;
      }
      Seat seat{ facet, { 0.0, 0.0, 0.0 }, this->copyHere() };
      seat.b[k] = 1.0 - there;
      seat.b[l] = there;
      m_result.seats.push_back(seat);
    }
    return this->end();
  }

private:
  /** Facet and place of the edge in it. */
  std::pair<Index, int> sideOf(Index edge, Index side) const
  {
    const Index facet = m_features.edges.edgeFacets[m_features.edges.edgeFacetsBegin[edge] + side];
    return { facet, m_features.edges.sideOf(facet, edge) };
  }

  void begin(const Point3& place, Index curve)
  {
    m_result.points.push_back({ place, curve == noIndex, curve });
    m_result.firstCopy.push_back(m_result.sites.count());
  }

  /** The copy of the current vertex with the current coordinates, made if it is new. */
  Index copyHere()
  {
    for (Index site = m_result.firstCopy.back(); site < m_result.sites.count(); ++site)
    {
      if (std::equal(m_coordinates.begin(), m_coordinates.end(), m_result.sites.site(site)))
      {
        return site;
      }
    }
    m_result.sites.coordinates.insert(
      m_result.sites.coordinates.end(), m_coordinates.begin(), m_coordinates.end());
    m_result.pointOfSite.push_back(m_result.numberOfPoints() - 1);
    return m_result.sites.count() - 1;
  }

  Index end()
  {
    m_result.seatBegin.push_back(static_cast<Offset>(m_result.seats.size()));
    return m_result.numberOfPoints() - 1;
  }

  const FeatureSiteMaker& m_maker;
  const SurfaceMesh& m_mesh;
  const EmbeddedSurface& m_surface;
  const Features& m_features;
  FeatureSites& m_result;
  std::vector<double> m_coordinates;
};

namespace
{
/** The curve's cells: each station's reaches half-way to the next. */
void addCollar(const FeaturedSurface& featured, Index curve, FeatureSites& result)
{
  const FeatureCurve& course = featured.features.curves[curve];
  const std::vector<double> lengths = measureCurve(featured, curve);
  const std::vector<Station>& stations = result.stations[curve];
  const std::vector<Index>& points = result.curvePoints[curve];
  std::size_t current = 0;
  const auto changeAfter = [&](std::size_t k)
  {
    return stationAt(
      lengths, 0.5 * (lengthAt(lengths, stations[k]) + lengthAt(lengths, stations[k + 1])));
  };
  for (std::size_t segment = 0; segment < course.edges.size(); ++segment)
  {
    CollarEdge edge{ course.edges[segment], course.points[segment], curve,
      static_cast<Index>(segment), points[current], {} };
    while (current + 1 < stations.size())
    {
      const Station change = changeAfter(current);
      if (change.segment > static_cast<Index>(segment))
      {
        break;
      }
      edge.changes.push_back({ change.t, points[++current] });
    }
    result.collar.push_back(std::move(edge));
  }
}

constexpr double offset = 1e-8; // of the square root of the surface's measure

/** Moves each site a little, by its place and nothing else. */
void shake(const EmbeddedSurface& surface, Sites& sites)
{
  const double most = offset * std::sqrt(surface.siteMeasure);
  for (Index i = 0; i < sites.count(); ++i)
  {
    std::uint64_t place = 0;
    for (int k = 0; k < surface.dimension; ++k)
    {
      std::uint64_t bits = 0;
      std::memcpy(&bits, sites.site(i) + k, sizeof(bits));
      place = mixBits(place ^ bits);
    }
    for (int k = 0; k < surface.dimension; ++k)
    {
      const double random = uniform01(place, static_cast<std::uint64_t>(k), 0);
      sites.site(i)[k] += most * (2.0 * random - 1.0);
    }
  }
}
}

FeatureSites FeatureSiteMaker::make(const Stations& stations) const
{
  FeatureSites result;
  result.stations = stations;
  Builder builder(*this, result);
  const Features& features = m_featured.features;
  std::vector<Index> atCorner(m_featured.mesh.points.size(), noIndex);
  for (const Index point : features.corners)
  {
    atCorner[point] = builder.addAtPoint(point, noIndex);
  }
  result.curvePoints.resize(stations.size());
  for (std::size_t c = 0; c < stations.size(); ++c)
  {
    const FeatureCurve& curve = features.curves[c];
    std::vector<Index>& points = result.curvePoints[c];
    for (std::size_t k = 0; k < stations[c].size(); ++k)
    {
      const bool isEnd = k == 0 || k + 1 == stations[c].size();
      if (isEnd && curve.hasCorners)
      {
        points.push_back(atCorner[k == 0 ? curve.points.front() : curve.points.back()]);
      }
      else if (k > 0 && isEnd)
      {
        points.push_back(points.front());
      }
      else
      {
        points.push_back(builder.addAt(stations[c][k], static_cast<Index>(c)));
      }
    }
    addCollar(m_featured, static_cast<Index>(c), result);
  }
  result.sites.fixed = result.sites.count();
  shake(m_featured.surface, result.sites);
  return result;
}
}
