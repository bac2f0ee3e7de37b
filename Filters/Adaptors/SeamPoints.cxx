/**
 * @file SeamPoints.cxx
 *
 * For each feature point whose place has several charts around it:
 * 1. Its sides: the facets around the place, by the charts of the place in them.
 * 2. Its wedges: the triangles around the vertex, parted by edges along features.
 * 3. Each wedge belongs to the side on which its triangles lie, by the facet that is nearest to a
 *    step from the place into each triangle; the triangles' angles weigh.
 * 4. The side of the first wedge keeps the point; each other side gets a copy.
 */
#include "Adaptors/SeamPoints.h"

#include "Mesh/ClosestPoint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace remesh
{
namespace
{
using Pair = std::pair<Index, Index>;

/** Of the facets' shortest side: how far a step goes. */
constexpr double stepShare = 0.25;

/** The points of the input's surface around a place, and the charts that they have in a facet. */
using Charts = std::vector<Pair>;

/** The facets around the place of a feature point that have the same charts there. */
struct Side
{
  Charts charts;
  std::vector<Index> facets;
};

/** Items by key, for few keys. */
class Around
{
public:
  void add(Index key, Index item) { this->Items.emplace_back(key, item); }
  void sort() { std::sort(this->Items.begin(), this->Items.end()); }
  /** Calls `visit(item)` for those of a key, ascending. */
  template <class Visit>
  void forEach(Index key, const Visit& visit) const
  {
    auto item = std::lower_bound(
      this->Items.begin(), this->Items.end(), Pair(key, std::numeric_limits<Index>::min()));
    for (; item != this->Items.end() && item->first == key; ++item)
    {
      visit(item->second);
    }
  }

private:
  std::vector<Pair> Items;
};

class SeamSplitter
{
public:
  SeamSplitter(const DiagramSource& source, MeshBlocks& mesh)
    : Source(source)
    , Surface(source.prepared.mesh)
    , Mesh(mesh)
  {
    this->findSeats();
    this->listFacets();
    this->listTriangles();
    for (const FeatureSegment& segment : source.result.seams.segments)
    {
      const auto [low, high] = std::minmax(segment.ends[0], segment.ends[1]);
      this->Segments.emplace_back(low, high);
    }
    std::sort(this->Segments.begin(), this->Segments.end());
  }

  void split()
  {
    for (const auto& [vertex, seat] : this->Seats)
    {
      for (const Index p : this->pointsOf(vertex))
      {
        this->splitPoint(p, seat);
      }
    }
  }

private:
  /** Vertices whose place is on a seam, as all points of the input's surface around it have several
   * charts. */
  void findSeats()
  {
    const SurfaceMesh& input = this->Source.prepared.inputMesh();
    const std::vector<Triple>& charts = this->Source.prepared.charts;
    std::vector<char> hasCharts(input.points.size(), 0);
    for (std::size_t f = 0; f < charts.size(); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        hasCharts[input.facetPoints[f][k]] |= charts[f][k] > 0 ? 1 : 0;
      }
    }
    const FeatureSites& features = this->Source.result.featureSites;
    for (Index point = 0; point < features.numberOfPoints(); ++point)
    {
      const Seat& seat = features.seats[features.seatBegin[point]];
      const Index vertex = this->Source.result.seams.components[point];
      const Charts around = this->chartsIn(seat.facet, seat);
      if (vertex != noIndex && around.size() < 3 &&
        std::all_of(around.begin(), around.end(),
          [&](const Pair& chart) { return hasCharts[chart.first] != 0; }))
      {
        this->Seats.emplace_back(vertex, seat);
      }
    }
  }

  /** The charts of a seat's place as a facet around it has them. */
  Charts chartsIn(Index facet, const Seat& seat) const
  {
    const SurfaceLocation location = this->locationIn(facet, seat);
    const std::array<double, 3> b = this->Source.prepared.inputPlace(facet, location.b);
    const Index whole = this->Source.prepared.inputFacet(facet);
    Charts charts;
    for (int k = 0; k < 3; ++k)
    {
      if (b[k] > 0.0)
      {
        charts.emplace_back(this->Source.prepared.inputMesh().facetPoints[whole][k],
          this->Source.prepared.charts[whole][k]);
      }
    }
    std::sort(charts.begin(), charts.end());
    return charts;
  }

  /** Facets around the places on seams. */
  void listFacets()
  {
    std::vector<char> isAround(this->Surface.points.size(), 0);
    for (const auto& [vertex, seat] : this->Seats)
    {
      isAround[this->firstPoint(seat)] = 1;
    }
    for (Index f = 0; f < this->Surface.numberOfFacets(); ++f)
    {
      for (const Index point : this->Surface.facetPoints[f])
      {
        if (isAround[point])
        {
          this->Facets.add(point, f);
        }
      }
    }
    this->Facets.sort();
  }

  /** The first point of the surface that spans a seat's place. */
  Index firstPoint(const Seat& seat) const
  {
    const auto k = std::find_if(seat.b, seat.b + 3, [](double b) { return b > 0.0; }) - seat.b;
    return this->Surface.facetPoints[seat.facet][k];
  }

  /** Triangles around the points of vertices on features, and those points. */
  void listTriangles()
  {
    const std::vector<char> onFeature =
      verticesOnFeatures(this->Source.result.seams, this->Source.result.components.count());
    for (std::size_t t = 0; t < this->Mesh.triangles.size(); ++t)
    {
      for (const Index p : this->Mesh.triangles[t])
      {
        if (onFeature[this->Mesh.vertices[p]])
        {
          this->Triangles.add(p, static_cast<Index>(t));
        }
      }
    }
    this->Triangles.sort();
    for (std::size_t p = 0; p < this->Mesh.vertices.size(); ++p)
    {
      if (onFeature[this->Mesh.vertices[p]])
      {
        this->Points.add(this->Mesh.vertices[p], static_cast<Index>(p));
      }
    }
    this->Points.sort();
  }

  std::vector<Index> pointsOf(Index vertex) const
  {
    std::vector<Index> points;
    this->Points.forEach(vertex, [&](Index p) { points.push_back(p); });
    return points;
  }

  /** The weights of the place in another facet around it. */
  SurfaceLocation locationIn(Index facet, const Seat& seat) const
  {
    SurfaceLocation location{ facet, { 0.0, 0.0, 0.0 } };
    const Triple& there = this->Surface.facetPoints[facet];
    const Triple& here = this->Surface.facetPoints[seat.facet];
    for (int k = 0; k < 3; ++k)
    {
      const auto l = std::find(there.begin(), there.end(), here[k]) - there.begin();
      if (seat.b[k] > 0.0 && l < 3)
      {
        location.b[l] = seat.b[k];
      }
    }
    return location;
  }

  /** Whether a facet has all points that span a seat's place. */
  bool isAround(Index facet, const Seat& seat) const
  {
    const SurfaceLocation location = this->locationIn(facet, seat);
    return std::count(location.b, location.b + 3, 0.0) == std::count(seat.b, seat.b + 3, 0.0);
  }

  std::vector<Side> sidesOf(Index p, const Seat& seat) const
  {
    const bool hasBlocks = !this->Mesh.pointBlocks.empty();
    std::vector<Side> sides;
    this->Facets.forEach(this->firstPoint(seat),
      [&](Index facet)
      {
        if (!this->isAround(facet, seat) ||
          (hasBlocks && this->Source.blockOfFacet(facet) != this->Mesh.pointBlocks[p]))
        {
          return;
        }
        const Charts charts = this->chartsIn(facet, seat);
        auto side = std::find_if(
          sides.begin(), sides.end(), [&](const Side& other) { return other.charts == charts; });
        if (side == sides.end())
        {
          side = sides.insert(sides.end(), { charts, {} });
        }
        side->facets.push_back(facet);
      });
    return sides;
  }

  Point3 placeOf(const SurfaceLocation& location) const
  {
    Point3 place = Point3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      place += location.b[k] * this->Surface.points[this->Surface.facetPoints[location.facet][k]];
    }
    return place;
  }

  const Point3& positionOf(Index p) const
  {
    return this->Source.result.placement.positions[this->Mesh.vertices[p]];
  }

  double shortestSide(const std::vector<Side>& sides) const
  {
    double shortest = std::numeric_limits<double>::infinity();
    for (const Side& side : sides)
    {
      for (const Index facet : side.facets)
      {
        const Triple& points = this->Surface.facetPoints[facet];
        for (int k = 0; k < 3; ++k)
        {
          const Point3& end = this->Surface.points[points[(k + 1) % 3]];
          shortest = std::min(shortest, (end - this->Surface.points[points[k]]).norm());
        }
      }
    }
    return shortest;
  }

  /** The side with the facet that is nearest to a point. */
  std::size_t nearestSide(const std::vector<Side>& sides, const Point3& point) const
  {
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t s = 0; s < sides.size(); ++s)
    {
      for (const Index facet : sides[s].facets)
      {
        const Triple& points = this->Surface.facetPoints[facet];
        const auto& places = this->Surface.points;
        const double squared =
          closestOnTriangle(point, places[points[0]], places[points[1]], places[points[2]]).squared;
        if (squared < least)
        {
          least = squared;
          nearest = s;
        }
      }
    }
    return nearest;
  }

  /** Whether the mesh has an edge along a feature between two of its points. */
  bool isFeature(Index p, Index q) const
  {
    const auto [low, high] = std::minmax(this->Mesh.vertices[p], this->Mesh.vertices[q]);
    return std::binary_search(this->Segments.begin(), this->Segments.end(), Pair(low, high));
  }

  /** The wedge of each triangle around a point, by the lowest of its triangles' ranks. */
  std::vector<std::size_t> wedgesOf(Index p, const std::vector<Index>& triangles) const
  {
    std::vector<std::size_t> wedges(triangles.size());
    for (std::size_t t = 0; t < wedges.size(); ++t)
    {
      wedges[t] = t;
    }
    const auto meet = [&](std::size_t a, std::size_t b)
    {
      const Triple& first = this->Mesh.triangles[triangles[a]];
      const Triple& second = this->Mesh.triangles[triangles[b]];
      return std::any_of(first.begin(), first.end(),
        [&](Index q)
        {
          return q != p && std::find(second.begin(), second.end(), q) != second.end() &&
            !this->isFeature(p, q);
        });
    };
    for (bool changes = true; changes;)
    {
      changes = false;
      for (std::size_t a = 0; a < wedges.size(); ++a)
      {
        for (std::size_t b = 0; b < a; ++b)
        {
          if (wedges[a] != wedges[b] && meet(a, b))
          {
            wedges[a] = wedges[b] = std::min(wedges[a], wedges[b]);
            changes = true;
          }
        }
      }
    }
    return wedges;
  }

  /** The side that each triangle around a point belongs to, with all of its wedge. */
  std::vector<std::size_t> sidesOfTriangles(Index p, const Point3& place,
    const std::vector<Side>& sides, const std::vector<Index>& triangles) const
  {
    const std::vector<std::size_t> wedges = this->wedgesOf(p, triangles);
    const double step = stepShare * this->shortestSide(sides);
    std::map<std::size_t, std::vector<double>> votes;
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      Point3 ways[2];
      int count = 0;
      for (const Index q : this->Mesh.triangles[triangles[t]])
      {
        if (q != p)
        {
          ways[count++] = (this->positionOf(q) - place).normalized();
        }
      }
      const Point3 into = place + step * (ways[0] + ways[1]).normalized();
      std::vector<double>& weights = votes[wedges[t]];
      weights.resize(sides.size(), 0.0);
      weights[this->nearestSide(sides, into)] +=
        std::acos(std::clamp(ways[0].dot(ways[1]), -1.0, 1.0));
    }
    std::vector<std::size_t> found;
    for (const std::size_t wedge : wedges)
    {
      const std::vector<double>& weights = votes[wedge];
      found.push_back(std::max_element(weights.begin(), weights.end()) - weights.begin());
    }
    return found;
  }

  void splitPoint(Index p, const Seat& seat)
  {
    const std::vector<Side> sides = this->sidesOf(p, seat);
    std::vector<Index> triangles;
    this->Triangles.forEach(p, [&](Index t) { triangles.push_back(t); });
    if (sides.size() < 2 || triangles.empty())
    {
      return;
    }
    const Point3 place = this->placeOf({ seat.facet, { seat.b[0], seat.b[1], seat.b[2] } });
    const std::vector<std::size_t> found = this->sidesOfTriangles(p, place, sides, triangles);
    std::map<std::size_t, Index> points;
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      const std::size_t side = found[t];
      if (points.count(side) == 0)
      {
        points[side] = points.empty() ? p : this->copyPoint(p);
        this->Mesh.locations[points[side]] = this->locationIn(sides[side].facets.front(), seat);
      }
      Triple& corners = this->Mesh.triangles[triangles[t]];
      std::replace(corners.begin(), corners.end(), p, points[side]);
    }
  }

  Index copyPoint(Index p)
  {
    this->Mesh.vertices.push_back(this->Mesh.vertices[p]);
    this->Mesh.locations.push_back(this->Mesh.locations[p]);
    if (!this->Mesh.pointBlocks.empty())
    {
      this->Mesh.pointBlocks.push_back(this->Mesh.pointBlocks[p]);
    }
    return static_cast<Index>(this->Mesh.vertices.size()) - 1;
  }

  const DiagramSource& Source;
  const SurfaceMesh& Surface;
  MeshBlocks& Mesh;
  std::vector<std::pair<Index, Seat>> Seats; ///< of vertices on seams
  Around Facets;                             ///< of points of the surface
  Around Triangles;                          ///< of the mesh's points
  Around Points;                             ///< of the mesh's vertices
  std::vector<Pair> Segments;                ///< vertices, ascending
};
}

void splitAlongSeams(const DiagramSource& source, MeshBlocks& mesh)
{
  if (!source.result.seams.components.empty())
  {
    SeamSplitter(source, mesh).split();
  }
}
}
