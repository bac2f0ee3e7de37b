// The pieces of facets, against the lower envelope by definition:
// - any sites as one facet sees them: each vertex is won by its sites in rational arithmetic, and
//   the pieces fit together;
// - small surfaces in R^d with sites that tie: the sites that FacetDecomposition looks at are
//   enough, and the rounded integrals of FacetIntegration are right.

#include "FuzzSupport.h"
#include "TestFacetSites.h"

#include "Embedding/Distance.h"
#include "Embedding/Embedding.h"
#include "Mesh/Intake.h"
#include "Support/InstructionSet.h"
#include "Voronoi/FacetDecomposition.h"
#include "Voronoi/FacetIntegration.h"
#include "Voronoi/Ownership.h"
#include "Voronoi/PieceIntegral.h"

#include <cstring>
#include <map>

namespace
{
using namespace remesh;

/** Pieces by slot; empty where a site has none. */
using Pieces = std::vector<Polygon>;

/** Each piece clipped by all other sites, starting anywhere. */
Pieces clipAll(FacetTiling& tiling, int start)
{
  const int count = tiling.numberOfSites();
  Pieces pieces(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    tiling.wholeFacet(pieces[i]);
    for (int k = 0; k < count && !pieces[i].empty(); ++k)
    {
      const int q = (start + k) % count;
      if (q != i)
      {
        tiling.clip(pieces[i], i, q);
      }
    }
  }
  return pieces;
}

bool sameBits(const PieceVertex& a, const PieceVertex& b)
{
  return std::memcmp(a.b, b.b, sizeof a.b) == 0;
}

int incomingOf(const Polygon& piece, std::size_t v)
{
  return piece[(v + piece.size() - 1) % piece.size()].edge;
}

/** More sites than this, and each vertex is held against some of them only: it is slow. */
constexpr int maxExact = 14;

/** No other site beats the ones that a vertex is made of: in rational arithmetic. */
void checkVertex(const test::ExactSites& exact, int count, int i, int incoming, int outgoing)
{
  for (int q = i % (1 + count / maxExact); q < count; q += 1 + count / maxExact)
  {
    if (q == i || q == incoming || q == outgoing)
    {
      continue;
    }
    if (incoming < 0 && outgoing < 0)
    {
      FUZZ_CHECK(exact.atCorner(q, i, -1 - outgoing) > 0);
    }
    else if (incoming < 0 || outgoing < 0)
    {
      FUZZ_CHECK(
        exact.onEdge(q, i, std::max(incoming, outgoing), -1 - std::min(incoming, outgoing)) > 0);
    }
    else
    {
      FUZZ_CHECK(exact.orientation(i, incoming, outgoing) > 0);
      FUZZ_CHECK(exact.inside(q, i, incoming, outgoing) > 0);
    }
  }
}

/** The same edge, turned round and to the bit, belongs to the piece across it. */
void checkEdge(const Pieces& pieces, int i, std::size_t v)
{
  const Polygon& piece = pieces[i];
  const PieceVertex& start = piece[v];
  const PieceVertex& end = piece[(v + 1) % piece.size()];
  const Polygon& other = pieces[start.edge];
  int found = 0;
  for (std::size_t w = 0; w < other.size(); ++w)
  {
    found += other[w].edge == i && sameBits(other[w], end) &&
      sameBits(other[(w + 1) % other.size()], start);
  }
  FUZZ_CHECK(found == 1);
}

/** Pieces are parts of the facet, and fit together as the parts of a disk. */
void checkTiling(const FacetTiling& tiling, const Pieces& pieces)
{
  std::vector<FacetSite> sites;
  for (int slot = 0; slot < tiling.numberOfSites(); ++slot)
  {
    sites.push_back(tiling.site(slot));
  }
  const test::ExactSites exact(sites);
  double fractions = 0.0;
  int onCorners = 0, onEdges = 0, inside = 0, edges = 0, borderEdges = 0, faces = 0;
  for (int i = 0; i < tiling.numberOfSites(); ++i)
  {
    const Polygon& piece = pieces[i];
    faces += !piece.empty();
    FUZZ_CHECK(piece.empty() || piece.size() >= 3);
    for (std::size_t v = 0; v < piece.size(); ++v)
    {
      const double* b = piece[v].b;
      FUZZ_CHECK(b[0] >= 0.0 && b[1] >= 0.0 && b[2] >= 0.0);
      FUZZ_CHECK(std::abs(b[0] + b[1] + b[2] - 1.0) < 1e-15);
      const int incoming = incomingOf(piece, v);
      const int outgoing = piece[v].edge;
      checkVertex(exact, tiling.numberOfSites(), i, incoming, outgoing);
      const int sides = (incoming < 0) + (outgoing < 0);
      onCorners += sides == 2;
      onEdges += sides == 1;
      inside += sides == 0;
      (outgoing < 0 ? borderEdges : edges) += 1;
      if (outgoing >= 0)
      {
        checkEdge(pieces, i, v);
      }
    }
    FacetConstants facet;
    facet.mass = 1.0;
    fractions += piece.empty() ? 0.0 : integratePiece(tiling, facet, piece, i).fraction();
  }
  FUZZ_CHECK(onCorners == 3 && onEdges % 2 == 0 && inside % 3 == 0);
  FUZZ_CHECK(faces - edges / 2 - borderEdges + 3 + onEdges / 2 + inside / 3 == 1);
  FUZZ_CHECK(std::abs(fractions - 1.0) < 1e-12);
}

/** The same pieces, by ids, whatever the order in which they were cut. */
std::map<Index, std::map<std::pair<Index, Index>, std::array<double, 3>>> named(
  const FacetTiling& tiling, const Pieces& pieces)
{
  std::map<Index, std::map<std::pair<Index, Index>, std::array<double, 3>>> result;
  const auto idOf = [&](int edge) { return edge < 0 ? edge : tiling.site(edge).id; };
  for (int i = 0; i < tiling.numberOfSites(); ++i)
  {
    for (std::size_t v = 0; v < pieces[i].size(); ++v)
    {
      const double* b = pieces[i][v].b;
      result[tiling.site(i).id][{ idOf(incomingOf(pieces[i], v)), idOf(pieces[i][v].edge) }] = {
        b[0], b[1], b[2]
      };
    }
  }
  return result;
}

void anyFacet(fuzz::Numbers& numbers)
{
  const int count = 1 + numbers.below(14);
  std::vector<FacetSite> sites = test::anyFacetSites(numbers, count);
  test::disturb(sites, numbers);
  test::shuffleIds(sites, numbers);
  FacetTiling tiling;
  tiling.begin({ 5, 9, 2 }, FacetConstants());
  for (const FacetSite& site : sites)
  {
    tiling.addSite(site);
  }
  const Pieces pieces = clipAll(tiling, 0);
  checkTiling(tiling, pieces);
  FUZZ_CHECK(named(tiling, pieces) == named(tiling, clipAll(tiling, numbers.below(count))));
}

/**
 * By how much rounding may move a border, in barycentric coordinates: H values are rounded as the
 * largest one is, and the less two sites differ along the facet, the more that matters.
 */
double toleranceOf(const FacetTiling& tiling, const Pieces& pieces)
{
  double largest = 0.0;
  for (int slot = 0; slot < tiling.numberOfSites(); ++slot)
  {
    const double* h = tiling.site(slot).h;
    largest = std::max({ largest, h[0], h[1], h[2] });
  }
  double tolerance = 1e-11;
  for (int i = 0; i < tiling.numberOfSites(); ++i)
  {
    for (int j = 0; j < tiling.numberOfSites(); ++j)
    {
      double u[3];
      for (int k = 0; k < 3; ++k)
      {
        u[k] = tiling.site(j).h[k] - tiling.site(i).h[k];
      }
      const double slope =
        std::max({ std::abs(u[0] - u[1]), std::abs(u[1] - u[2]), std::abs(u[2] - u[0]) });
      const double near = std::min({ std::abs(u[0]), std::abs(u[1]), std::abs(u[2]) });
      // Others that have nothing here come in where they are that near to winning.
      const bool matters =
        j != i && !pieces[i].empty() && (!pieces[j].empty() || near < 0x1p-40 * largest);
      tolerance += matters ? 0x1p-46 * largest / std::max(slope, 1e-300) : 0.0;
    }
  }
  return tolerance;
}

/** Rounded integrals against those of the exact pieces. */
template <class ForEachPart>
void checkIntegrals(const FacetTiling& tiling, const FacetConstants& facet, const Pieces& pieces,
  const ForEachPart& forEachPart)
{
  std::vector<PieceIntegral> parts(pieces.size());
  forEachPart([&](Index site, const PieceIntegral& part) { parts[site] = part; });
  PieceIntegral total;
  double exactEnergy = 0.0;
  double largest = 0.0;
  const double tolerance = toleranceOf(tiling, pieces);
  for (int i = 0; i < tiling.numberOfSites(); ++i)
  {
    const double* h = tiling.site(i).h;
    const PieceIntegral exact =
      pieces[i].empty() ? PieceIntegral() : integratePiece(tiling, facet, pieces[i], i);
    FUZZ_CHECK(std::abs(parts[i].fraction() - exact.fraction()) <= tolerance);
    for (int k = 0; k < 3; ++k)
    {
      FUZZ_CHECK(std::abs(parts[i].weights[k] - exact.weights[k]) <= tolerance);
      total.weights[k] += parts[i].weights[k];
      largest = std::max(largest, h[k]);
    }
    total.energy += parts[i].energy;
    exactEnergy += exact.energy;
  }
  FUZZ_CHECK(std::abs(total.fraction() - 1.0) < 1e-10);
  // The envelope is the least: where a border lies hardly matters to the energy.
  FUZZ_CHECK(std::abs(total.energy - exactEnergy) <= 1e-10 * facet.mass * largest);
}

/** One facet of a surface: all sites against all, and what the engine makes of it. */
template <int D>
void checkFacet(const EmbeddedSurface& surface, const Sites& sites, Index facet,
  FacetDecomposition<D>& decomposition, FacetIntegration<D>& integration)
{
  decomposition.gather(facet);
  decomposition.tile();
  const FacetConstants& constants = surface.constants[facet];
  FacetTiling tiling;
  tiling.begin(surface.facetCorners[facet], constants);
  for (Index site = 0; site < sites.count(); ++site)
  {
    FacetSite seen;
    seen.id = site;
    for (int k = 0; k < 3; ++k)
    {
      seen.h[k] = squaredDistance<D>(
        sites.site(site), surface.corner(surface.facetCorners[facet][k]), surface.dimension);
    }
    tiling.addSite(seen);
  }
  const Pieces expected = clipAll(tiling, 0);
  checkTiling(tiling, expected);
  Pieces found(expected.size());
  for (const FacetPiece& piece : decomposition)
  {
    if (!piece.polygon.empty())
    {
      Polygon& polygon = found[decomposition.tiling().site(piece.slot).id];
      polygon = piece.polygon;
      for (PieceVertex& vertex : polygon)
      {
        vertex.edge = vertex.edge < 0 ? vertex.edge : decomposition.tiling().site(vertex.edge).id;
      }
    }
  }
  FUZZ_CHECK(named(tiling, found) == named(tiling, expected));
  if (!integration.integrate(facet))
  {
    return;
  }
  checkIntegrals(
    tiling, constants, expected, [&](const auto& add) { integration.forEachPart(constants, add); });
}

template <int D>
void checkSurface(const EmbeddedSurface& surface, const Sites& sites)
{
  NeighborLists lists;
  FUZZ_CHECK(lists.build(sites, RunControl()).ok());
  Ownership ownership;
  FUZZ_CHECK(ownership.update(surface, sites, lists, RunControl()).ok());
  const std::vector<Index>& owners = ownership.owners();
  FacetDecomposition<D> decomposition(surface, sites, lists, owners);
  std::vector<Index> centers; // any are right
  for (Index facet = 0; facet < surface.numberOfFacets(); ++facet)
  {
    centers.push_back(facet % (sites.count() + 1) - 1);
  }
  static_assert(noIndex == -1);
  FacetIntegration<D> integration(surface, sites, lists, owners, centers, widestInstructionSet());
  for (Index facet = 0; facet < surface.numberOfFacets(); ++facet)
  {
    checkFacet<D>(surface, sites, facet, decomposition, integration);
  }
}

/** A coordinate of a point: on a coarse grid, or with all its bits. */
double coordinate(fuzz::Numbers& numbers, bool grid)
{
  return grid ? numbers.below(4) / 3.0 : numbers.fraction();
}

bool anySurface(fuzz::Numbers& numbers, EmbeddedSurface& surface)
{
  const bool grid = numbers.below(2) == 0;
  const double scale = std::ldexp(1.0, numbers.below(200) - 100);
  const double shift = numbers.below(2) == 0 ? 0.0 : scale * std::ldexp(1.0, numbers.below(20));
  const int count = 3 + numbers.below(5);
  TriangleSoup soup;
  for (int p = 0; p < count; ++p)
  {
    const double tiny = numbers.below(8) == 0 ? 0x1p-20 : 1.0;
    const double x = tiny * coordinate(numbers, grid);
    const double y = tiny * coordinate(numbers, grid);
    soup.points.emplace_back(
      scale * x + shift, scale * y, grid ? 0.0 : scale * coordinate(numbers, grid));
  }
  for (int t = 0; t < 6; ++t)
  {
    soup.triangles.push_back({ numbers.below(count), numbers.below(count), numbers.below(count) });
    soup.inputCells.push_back(t);
  }
  SurfaceMesh mesh;
  IntakeReport report;
  if (!buildSurfaceMesh(soup, IntakeOptions(), RunControl(), mesh, report).ok())
  {
    return false;
  }
  CornerCoordinates coordinates = positionCoordinates(mesh);
  const int dimensions[4] = { 3, 6, 8, 5 };
  CornerCoordinates more;
  more.dimension = dimensions[numbers.below(4)] - 3;
  for (std::size_t k = 0; k < mesh.cornerPoints.size() * more.dimension; ++k)
  {
    more.values.push_back(scale * coordinate(numbers, grid));
  }
  appendCoordinates(coordinates, more, numbers.below(3) == 0 ? 1.0 : 0.1);
  return embedSurface(mesh, coordinates, RunControl(), surface).ok();
}

/** Sites on corners, edges and grids, twice at a place, on circles, near and far. */
Sites anySites(fuzz::Numbers& numbers, const EmbeddedSurface& surface)
{
  const int d = surface.dimension;
  Sites sites;
  sites.dimension = d;
  const int count = 1 + numbers.below(numbers.below(8) == 0 ? 80 : 20);
  const int kind = numbers.below(6);
  const int steps = 1 + numbers.below(5);
  const double away = numbers.below(3) == 0 ? std::ldexp(1.0, numbers.below(30) - 20) : 0.0;
  for (int s = 0; s < count; ++s)
  {
    const int copy = numbers.below(8) == 0 && s > 0 ? numbers.below(std::min(s, 256)) : -1;
    const Triple& facet = surface.facetCorners[numbers.below(surface.numberOfFacets())];
    double b[3];
    for (double& share : b)
    {
      share = kind < 3 ? static_cast<double>(numbers.below(steps + 1)) / steps : numbers.fraction();
    }
    if (kind == 0)
    {
      b[1] = 1.0 - b[0];
      b[2] = 0.0;
    }
    for (int k = 0; k < d; ++k)
    {
      const double* p[3] = { surface.corner(facet[0]), surface.corner(facet[1]),
        surface.corner(facet[2]) };
      double x = p[0][k] + b[1] * (p[1][k] - p[0][k]) + b[2] * (p[2][k] - p[0][k]);
      x += away == 0.0 ? 0.0 : away * (numbers.fraction() - 0.5);
      x = copy >= 0 ? sites.coordinates[static_cast<std::size_t>(copy) * d + k] : x;
      x = kind == 5 && copy >= 0 ? std::nextafter(x, 2.0) : x;
      sites.coordinates.push_back(x);
    }
  }
  return sites;
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Bytes bytes(data, size);
  fuzz::Numbers numbers(bytes);
  while (!bytes.empty())
  {
    if (bytes.below(2) == 0)
    {
      anyFacet(numbers);
    }
    else if (EmbeddedSurface surface; anySurface(numbers, surface))
    {
      const Sites sites = anySites(numbers, surface);
      dispatchDimension(surface.dimension,
        [&](auto dimension) { checkSurface<decltype(dimension)::value>(surface, sites); });
    }
    ++fuzz::cases();
  }
  return 0;
}
