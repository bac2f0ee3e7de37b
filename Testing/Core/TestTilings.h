/**
 * @file TestTilings.h
 * @brief What the pieces of every diagram must satisfy: they tile the facets and fit together.
 */
#ifndef remesh_TestTilings_h
#define remesh_TestTilings_h

#include "TestEmbeddings.h"
#include "Voronoi/VertexPlaces.h"

#include <cstring>
#include <tuple>

namespace remesh::test
{
/** A vertex of a piece with its place, and the edge that starts there. */
struct DiagramVertex
{
  double b[3];
  Index across;
};

/** A diagram whose vertices know where they lie. */
struct PlacedDiagram : Diagram
{
  std::vector<DiagramVertex> vertices;

  void place(const EmbeddedSurface& surface, const Sites& sites)
  {
    const VertexPlaces places{ surface, sites, *this };
    this->vertices.resize(this->across.size());
    for (Offset p = 0; p < this->numberOfPieces(); ++p)
    {
      for (Offset v = this->vertexBegin[p]; v < this->vertexBegin[p + 1]; ++v)
      {
        const std::array<double, 3> b = places.at(p, v);
        this->vertices[v] = { { b[0], b[1], b[2] }, this->across[v] };
      }
    }
  }
};

/** Twice the signed share of the triangle in its facet. */
inline double turn(const double* a, const double* b, const double* c)
{
  return (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
}

inline bool sameBits(const DiagramVertex& a, const DiagramVertex& b)
{
  return std::memcmp(a.b, b.b, sizeof a.b) == 0;
}

/** The vertices of a piece in order, with the first once more at the end. */
inline std::vector<DiagramVertex> loopOf(const PlacedDiagram& diagram, Offset piece)
{
  std::vector<DiagramVertex> loop(diagram.vertices.begin() + diagram.vertexBegin[piece],
    diagram.vertices.begin() + diagram.vertexBegin[piece + 1]);
  loop.push_back(loop.front());
  return loop;
}

/** A piece by itself: inside the facet, convex, counter-clockwise, with the right integrals. */
inline void checkPiece(const PlacedDiagram& diagram, Offset piece)
{
  const std::vector<DiagramVertex> loop = loopOf(diagram, piece);
  const PieceIntegral integral = diagram.integralOf(piece);
  CHECK(loop.size() >= 4);
  double area = 0.0;
  double minTurn = 0.0;
  bool inside = true;
  for (std::size_t v = 0; v + 1 < loop.size(); ++v)
  {
    const double* b = loop[v].b;
    inside = inside && b[0] >= 0.0 && b[1] >= 0.0 && b[2] >= 0.0 &&
      std::abs(b[0] + b[1] + b[2] - 1.0) < 1e-15;
    if (loop[v].across < 0)
    {
      // On the facet's edge k the coordinate of the third corner is exactly zero.
      const int third = (-1 - loop[v].across + 2) % 3;
      inside = inside && b[third] == 0.0 && loop[v + 1].b[third] == 0.0;
    }
    for (std::size_t w = 0; w + 1 < loop.size(); ++w)
    {
      minTurn = std::min(minTurn, turn(b, loop[v + 1].b, loop[w].b));
    }
    area += b[1] * loop[v + 1].b[2] - b[2] * loop[v + 1].b[1];
  }
  CHECK(inside);
  CHECK(minTurn > -1e-14);
  CHECK_NEAR(integral.fraction(), area, 1e-14);
  CHECK_NEAR(integral.weights[0] + integral.weights[1] + integral.weights[2], area, 1e-14);
  CHECK(integral.energy > -1e-16);
}

/** Whether the piece of the site across an edge has the same edge, turned round. */
inline bool edgeIsShared(
  const PlacedDiagram& diagram, Offset piece, const DiagramVertex& start, const DiagramVertex& end)
{
  const Offset other = diagram.pieceOf(diagram.facets[piece], start.across);
  if (other < 0)
  {
    return false;
  }
  const std::vector<DiagramVertex> loop = loopOf(diagram, other);
  int found = 0;
  for (std::size_t v = 0; v + 1 < loop.size(); ++v)
  {
    found += loop[v].across == diagram.sites[piece] && sameBits(loop[v], end) &&
      sameBits(loop[v + 1], start);
  }
  return found == 1;
}

/** A part of a surface edge in one cell: its ends as coordinates of the higher corner. */
using EdgePart = std::tuple<double, double, Index>;

/**
 * The parts of a facet's edge k from the lower corner to the higher one; empty if they leave a gap.
 * They are followed from cell to cell: where cells tie, parts may be shorter than rounding.
 */
inline std::vector<EdgePart> edgeParts(
  const EmbeddedSurface& surface, const PlacedDiagram& diagram, Index facet, int k)
{
  struct Part
  {
    double start, end;
    Index next;
  };
  const Triple& corners = surface.facetCorners[facet];
  const bool ascending = corners[k] < corners[(k + 1) % 3];
  const int high = ascending ? (k + 1) % 3 : k;
  std::map<Index, Part> partOfSite;
  Index at = noIndex;
  for (Offset p = diagram.facetBegin[facet]; p < diagram.facetBegin[facet + 1]; ++p)
  {
    const std::vector<DiagramVertex> loop = loopOf(diagram, p);
    Index incoming = loop[loop.size() - 2].across;
    for (std::size_t v = 0; v + 1 < loop.size(); ++v)
    {
      if (loop[v].across == -1 - k)
      {
        partOfSite[diagram.sites[p]] = { loop[v].b[high], loop[v + 1].b[high], loop[v + 1].across };
        at = incoming < 0 ? diagram.sites[p] : at;
      }
      incoming = loop[v].across;
    }
  }
  std::vector<EdgePart> parts;
  double reached = ascending ? 0.0 : 1.0;
  while (partOfSite.count(at) && partOfSite[at].start == reached)
  {
    const Part part = partOfSite[at];
    parts.emplace_back(ascending ? part.start : part.end, ascending ? part.end : part.start, at);
    partOfSite.erase(at);
    at = part.next;
    reached = part.end;
  }
  const bool complete = partOfSite.empty() && at < 0 && reached == (ascending ? 1.0 : 0.0);
  std::reverse(parts.begin(), ascending ? parts.begin() : parts.end());
  return complete ? parts : std::vector<EdgePart>();
}

/** Pieces tile each facet, and agree bitwise along common edges in facets and between them. */
inline void checkTiling(const EmbeddedSurface& surface, const PlacedDiagram& diagram)
{
  std::map<std::pair<Index, Index>, std::vector<EdgePart>> sharedParts;
  int unshared = 0;
  int broken = 0;
  int different = 0;
  for (Index facet = 0; facet < surface.numberOfFacets(); ++facet)
  {
    double fractions = 0.0;
    for (Offset p = diagram.facetBegin[facet]; p < diagram.facetBegin[facet + 1]; ++p)
    {
      CHECK_EQUAL(diagram.facets[p], facet);
      CHECK_EQUAL(diagram.pieceOf(facet, diagram.sites[p]), p);
      checkPiece(diagram, p);
      fractions += diagram.weights[p].fraction();
      const std::vector<DiagramVertex> loop = loopOf(diagram, p);
      for (std::size_t v = 0; v + 1 < loop.size(); ++v)
      {
        unshared += loop[v].across >= 0 && !edgeIsShared(diagram, p, loop[v], loop[v + 1]);
      }
    }
    CHECK_NEAR(fractions, 1.0, 1e-12);
    for (int k = 0; k < 3; ++k)
    {
      const Triple& corners = surface.facetCorners[facet];
      const std::vector<EdgePart> parts = edgeParts(surface, diagram, facet, k);
      broken += parts.empty();
      const auto [entry, isNew] =
        sharedParts.try_emplace(std::minmax(corners[k], corners[(k + 1) % 3]), parts);
      different += entry->second != parts;
    }
  }
  CHECK_EQUAL(unshared, 0);
  CHECK_EQUAL(broken, 0);
  CHECK_EQUAL(different, 0);
}
}

#endif
