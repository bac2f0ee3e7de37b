#include "Delaunay/Certificate.h"

#include "Support/SortUnique.h"

#include <algorithm>

namespace remesh
{
namespace
{
using Pair = std::pair<Index, Index>;

/** Calls `add` for the components of two pieces of a facet that meet on one of its edges. */
template <class Add>
void addOnEdge(const CellComplex& cells, Index facet, Index edge, const Add& add)
{
  const auto& [joins, diagram, components, seams] = cells;
  for (Offset p = diagram.facetBegin[facet]; p < diagram.facetBegin[facet + 1]; ++p)
  {
    for (Offset v = diagram.vertexBegin[p]; v < diagram.vertexBegin[p + 1]; ++v)
    {
      const Index incoming = diagram.acrossIncoming(p, v);
      if (const Index side = diagram.across[v];
          incoming >= 0 && side < 0 && joins.edges.facetEdges[facet][-1 - side] == edge)
      {
        add(components.ofPiece[p], components.ofPiece[diagram.pieceOf(facet, incoming)]);
      }
    }
  }
}

/** The two components beside each point where the border of the surface passes between cells. */
std::vector<Pair> findCrossings(const CellComplex& cells)
{
  const EdgeTable& edges = cells.joins.edges;
  const Seams* seams = cells.seams;
  std::vector<Pair> crossings;
  const auto add = [&](Index a, Index b)
  {
    if (a != b && a != noIndex && b != noIndex)
    {
      crossings.push_back(std::minmax(a, b));
    }
  };
  if (seams)
  {
    for (const auto& [a, b] : seams->borderCrossings)
    {
      add(seams->components[a], seams->components[b]);
    }
  }
  else
  {
    for (Index edge = 0; edge < edges.numberOfEdges(); ++edge)
    {
      if (edges.valence(edge) == 1)
      {
        addOnEdge(cells, edges.edgeFacets[edges.edgeFacetsBegin[edge]], edge, add);
      }
    }
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

/** The edges on which more than two sheets of the surface meet, ascending. */
std::vector<Pair> findCrowded(const Seams* seams)
{
  std::vector<Pair> crowded;
  if (seams)
  {
    for (const FeatureSegment& segment : seams->segments)
    {
      if (segment.kind == FeatureKind::NonManifold)
      {
        crowded.push_back(std::minmax(segment.ends[0], segment.ends[1]));
      }
    }
    std::sort(crowded.begin(), crowded.end());
  }
  return crowded;
}

/**
 * How often the border of the surface may pass from each vertex to another: as often as borders end
 * there, at a pinch and where a curve of more than two sheets ends.
 */
std::vector<Index> maxCrossings(const Seams* seams, Index numberOfVertices)
{
  std::vector<Index> most(static_cast<std::size_t>(numberOfVertices), 2);
  if (seams)
  {
    seams->forEachPinch([&](Index vertex, const Pinch& pinch)
      { most[vertex] = std::max(most[vertex], pinch.borders); });
    std::vector<Index> borders(most.size(), 0);
    std::vector<char> isCrowded(most.size(), 0);
    for (const FeatureSegment& segment : seams->segments)
    {
      for (const Index end : segment.ends)
      {
        borders[end] += segment.kind == FeatureKind::Boundary;
        isCrowded[end] = isCrowded[end] || segment.kind == FeatureKind::NonManifold;
      }
    }
    for (std::size_t k = 0; k < most.size(); ++k)
    {
      most[k] = isCrowded[k] ? std::max(most[k], borders[k]) : most[k];
    }
  }
  return most;
}

/** Whether the border of the surface passes more often from each vertex to another. */
std::vector<char> areOverrun(
  const std::vector<Pair>& crossings, const Seams* seams, Index numberOfVertices)
{
  std::vector<Index> ends(static_cast<std::size_t>(numberOfVertices), 0);
  for (const auto& [a, b] : crossings)
  {
    ++ends[a];
    ++ends[b];
  }
  const std::vector<Index> most = maxCrossings(seams, numberOfVertices);
  std::vector<char> overrun(ends.size());
  for (std::size_t k = 0; k < ends.size(); ++k)
  {
    overrun[k] = ends[k] > most[k];
  }
  return overrun;
}

/** Step 3: each edge has two ends, at most one of them on the border. */
void checkEdges(const std::vector<EdgeValence>& odd, const std::vector<Pair>& crossings,
  const std::vector<Pair>& crowded, Certificate& certificate)
{
  const auto isBorder = [&](const Pair& edge)
  {
    const auto [begin, end] = std::equal_range(crossings.begin(), crossings.end(), edge);
    return end - begin == 1;
  };
  const auto isOpen = [&](const Pair& edge)
  { return std::binary_search(odd.begin(), odd.end(), std::make_pair(edge, Index(1))); };
  for (const auto& [edge, valence] : odd)
  {
    if (!(valence == 1 && isBorder(edge)) &&
      !std::binary_search(crowded.begin(), crowded.end(), edge))
    {
      certificate.edges.push_back(edge);
    }
  }
  for (const Pair& edge : crossings)
  {
    if (!isOpen(edge))
    {
      certificate.edges.push_back(edge);
    }
  }
  sortUnique(certificate.edges);
}

/** Step 2, and what was found of step 1. */
void checkCells(const std::vector<char>& isDisk, const std::vector<char>& overrun,
  const std::vector<Triple>& triangles, Certificate& certificate)
{
  std::vector<char> used(isDisk.size(), 0);
  for (const Triple& triangle : triangles)
  {
    used[triangle[0]] = used[triangle[1]] = used[triangle[2]] = 1;
  }
  for (std::size_t k = 0; k < isDisk.size(); ++k)
  {
    if (!isDisk[k] || !used[k] || overrun[k])
    {
      certificate.cells.push_back(static_cast<Index>(k));
    }
  }
}
}

Status certify(
  const CellComplex& cells, const Dual& dual, const RunControl& control, Certificate& certificate)
{
  certificate = Certificate{};
  const Seams* seams = cells.seams;
  const Index count = cells.components.count();
  const RunControl silent = control.silent();
  std::vector<char> isDisk;
  if (Status status = findDisks(cells, silent, isDisk); !status.ok())
  {
    return status;
  }
  if (seams)
  {
    certificate.lostPoints =
      static_cast<Index>(std::count(seams->components.begin(), seams->components.end(), noIndex));
    certificate.lostPoints += seams->isComplete ? 0 : 1;
  }
  const std::vector<Pair> crossings = findCrossings(cells);
  const std::vector<Pair> crowded = findCrowded(seams);
  const std::vector<char> overrun = areOverrun(crossings, seams, count);
  if (dual.repeated.empty())
  {
    checkCells(isDisk, overrun, dual.triangles, certificate);
    checkEdges(dual.edges.irregular, crossings, crowded, certificate);
  }
  else
  {
    std::vector<Triple> meetings = dual.triangles;
    meetings.insert(meetings.end(), dual.repeated.begin(), dual.repeated.end());
    checkCells(isDisk, overrun, meetings, certificate);
    checkEdges(
      countEdgeValences(meetings, count, silent).irregular, crossings, crowded, certificate);
  }
  certificate.vertices = dual.repeated;
  return control.cancelled() ? Status::cancelled() : Status::success();
}
}
