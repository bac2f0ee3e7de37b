/**
 * @file TestDiagrams.h
 * @brief What every restricted Voronoi diagram must satisfy: nearest sites, tilings, totals.
 */
#ifndef remesh_TestDiagrams_h
#define remesh_TestDiagrams_h

#include "Mesh/FacetGeometry.h"
#include "TestTilings.h"
#include "Voronoi/RestrictedVoronoi.h"

namespace remesh::test
{
struct Computed
{
  CellSums sums;
  PlacedDiagram diagram;
  Sites sites;
  std::vector<Index> owners;
};

inline double largestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  double largest = a.size() == b.size() ? 0.0 : std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
  {
    largest = std::max(largest, std::abs(a[k] - b[k]));
  }
  return largest;
}

/** The diagram; its sums are also what one gets without the pieces. */
inline Computed computed(const EmbeddedSurface& surface, const Sites& sites)
{
  Computed result;
  RestrictedVoronoi voronoi(surface);
  CHECK(voronoi.decompose(sites, RunControl(), result.sums, result.diagram).ok());
  result.owners = voronoi.owners();
  result.sites = sites;
  result.diagram.place(surface, sites);
  CellSums sums;
  CHECK(voronoi.integrate(sites, RunControl(), sums).ok());
  CHECK_NEAR(largestDifference(sums.mass, result.sums.mass), 0.0, 1e-14 * surface.mass);
  CHECK_NEAR(largestDifference(sums.energy, result.sums.energy), 0.0, 1e-13 * surface.mass);
  CHECK_NEAR(largestDifference(sums.moment, result.sums.moment), 0.0, 1e-13 * surface.mass);
  return result;
}

/** A diagram that was made in steps is what these sites have alone, to the bit. */
inline void checkMadeOf(
  const EmbeddedSurface& surface, const Sites& sites, const Diagram& diagram, const CellSums& sums)
{
  Diagram alone;
  CellSums sumsAlone;
  CHECK(RestrictedVoronoi(surface).decompose(sites, RunControl(), sumsAlone, alone).ok());
  CHECK(diagram.facetBegin == alone.facetBegin);
  CHECK(diagram.sites == alone.sites);
  CHECK(diagram.across == alone.across);
  CHECK(sums.mass == sumsAlone.mass && sums.energy == sumsAlone.energy);
  CHECK(sums.moment == sumsAlone.moment);
}

/** How much a point's site may be farther than the nearest one, squared: rounding of H. */
inline double roundingOfH(const EmbeddedSurface& surface, const Sites& sites)
{
  double reach2 = 0.0;
  for (Index site = 0; site < sites.count(); ++site)
  {
    for (Index corner = 0; corner < surface.numberOfCorners(); ++corner)
    {
      reach2 =
        std::max(reach2, exactDistance2(sites.site(site), surface.corner(corner), sites.dimension));
    }
  }
  return 16.0 * 0x1p-52 * reach2;
}

/** Differences of H values on a facet: site a minus site b, and their largest size. */
inline Barycentric differencesOfH(
  const EmbeddedSurface& surface, const Sites& sites, Index facet, Index a, Index b)
{
  Barycentric result{};
  for (int k = 0; k < 3; ++k)
  {
    const double* corner = surface.corner(surface.facetCorners[facet][k]);
    result[k] = exactDistance2(sites.site(a), corner, sites.dimension) -
      exactDistance2(sites.site(b), corner, sites.dimension);
  }
  return result;
}

inline double largest(const Barycentric& values)
{
  return std::max({ std::abs(values[0]), std::abs(values[1]), std::abs(values[2]) });
}

/**
 * How far rounding of the H values can move a vertex (incoming, start of outgoing) of the piece of
 * a site, per unit of rounding and in barycentric coordinates: the condition of its equations.
 */
inline double vertexCondition(const EmbeddedSurface& surface, const Sites& sites, Index facet,
  Index site, Index incoming, Index outgoing)
{
  if (incoming < 0 && outgoing < 0)
  {
    return 0.0;
  }
  const Barycentric u = differencesOfH(surface, sites, facet, std::max(incoming, outgoing), site);
  if (incoming < 0 || outgoing < 0)
  {
    const int k = -1 - std::min(incoming, outgoing);
    return 2.0 / std::abs(u[k] - u[(k + 1) % 3]);
  }
  const Barycentric v = differencesOfH(surface, sites, facet, std::min(incoming, outgoing), site);
  double sum = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    sum += u[k] * v[(k + 1) % 3] - u[(k + 1) % 3] * v[k];
  }
  return 4.0 * std::max(largest(u), largest(v)) / std::abs(sum);
}

/**
 * At each vertex the piece's site is the nearest of all, but for the rounding of H and what it
 * moves the vertex by.
 */
inline void checkVertices(
  const EmbeddedSurface& surface, const Sites& sites, const PlacedDiagram& diagram, double rounding)
{
  double worst = 0.0;
  for (Offset p = 0; p < diagram.numberOfPieces(); ++p)
  {
    const Index site = diagram.sites[p];
    const Index facet = diagram.facets[p];
    Index incoming = diagram.vertices[diagram.vertexBegin[p + 1] - 1].across;
    for (Offset v = diagram.vertexBegin[p]; v < diagram.vertexBegin[p + 1]; ++v)
    {
      const auto& [b, across] = diagram.vertices[v];
      const std::vector<double> point = pointAt(surface, facet, { b[0], b[1], b[2] });
      const Index winner = nearestSite(sites, point.data());
      const double excess = exactDistance2(sites.site(site), point.data(), sites.dimension) -
        exactDistance2(sites.site(winner), point.data(), sites.dimension);
      if (excess > rounding)
      {
        const double slope = largest(differencesOfH(surface, sites, facet, winner, site));
        const double condition = vertexCondition(surface, sites, facet, site, incoming, across);
        worst = std::max(worst, excess / (rounding * (1.0 + slope * condition)));
      }
      incoming = across;
    }
  }
  CHECK_NEAR(worst, 0.0, 1.0);
}

/**
 * Whether a point of the facet lies in the loop, by counting crossings with a ray: edges shorter
 * than rounding, which ties leave, have no say.
 */
inline bool isInside(const std::vector<DiagramVertex>& loop, const Barycentric& b)
{
  bool inside = false;
  for (std::size_t v = 0; v + 1 < loop.size(); ++v)
  {
    const double* p = loop[v].b;
    const double* q = loop[v + 1].b;
    if ((p[1] > b[1]) != (q[1] > b[1]))
    {
      const double side = q[1] > p[1] ? turn(p, q, b.data()) : turn(q, p, b.data());
      inside = inside != (side > 0.0);
    }
  }
  return inside;
}

/** At random points of each facet the piece's site is the nearest of all. */
inline void checkRandomPoints(const EmbeddedSurface& surface, const Sites& sites,
  const PlacedDiagram& diagram, int pointsPerFacet, double tolerance)
{
  double excess = 0.0;
  int uncovered = 0;
  for (Index facet = 0; facet < surface.numberOfFacets(); ++facet)
  {
    for (int k = 0; k < pointsPerFacet; ++k)
    {
      const Barycentric b = randomBarycentric(static_cast<std::uint64_t>(facet), k);
      const std::vector<double> point = pointAt(surface, facet, b);
      int covering = 0;
      for (Offset p = diagram.facetBegin[facet]; p < diagram.facetBegin[facet + 1]; ++p)
      {
        const std::vector<DiagramVertex> loop = loopOf(diagram, p);
        if (isInside(loop, b))
        {
          ++covering;
          const double* winner = sites.site(nearestSite(sites, point.data()));
          const double own =
            exactDistance2(sites.site(diagram.sites[p]), point.data(), sites.dimension);
          excess = std::max(excess, own - exactDistance2(winner, point.data(), sites.dimension));
        }
      }
      uncovered += covering != 1;
    }
  }
  CHECK_EQUAL(uncovered, 0);
  CHECK_NEAR(excess, 0.0, tolerance);
}

inline double sumOf(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value;
  }
  return sum;
}

/** Sums over cells, over pieces, and the surface's own, to 1e-12. */
inline void checkTotals(
  const SurfaceMesh& mesh, const EmbeddedSurface& surface, const Computed& result)
{
  const double area = surfaceArea(mesh);
  double pieceMass = 0.0;
  double pieceArea = 0.0;
  double pieceEnergy = 0.0;
  for (Offset p = 0; p < result.diagram.numberOfPieces(); ++p)
  {
    const PieceIntegral integral = result.diagram.integralOf(p);
    pieceMass += integral.fraction() * surface.constants[result.diagram.facets[p]].mass;
    pieceArea += integral.fraction() * facetArea(mesh, result.diagram.facets[p]);
    pieceEnergy += integral.energy;
  }
  const CellSums& sums = result.sums;
  CHECK_NEAR(sumOf(sums.mass) / surface.mass, 1.0, 1e-12);
  CHECK_NEAR(pieceMass / surface.mass, 1.0, 1e-12);
  CHECK_NEAR(pieceArea / area, 1.0, 1e-12);
  CHECK_NEAR(sumOf(sums.energy) - pieceEnergy, 0.0, 1e-12 * pieceEnergy + 1e-300);
  CHECK_NEAR(sums.totalEnergy - pieceEnergy, 0.0, 1e-12 * pieceEnergy + 1e-300);
}

/** All that does not need the brute-force cells. */
inline void checkDiagram(const SurfaceMesh& mesh, const EmbeddedSurface& surface,
  const Sites& sites, const Computed& result)
{
  const double tolerance = roundingOfH(surface, sites);
  checkTiling(surface, result.diagram);
  checkVertices(surface, sites, result.diagram, tolerance);
  checkRandomPoints(surface, sites, result.diagram, 3, tolerance);
  checkTotals(mesh, surface, result);
}
}

#endif
