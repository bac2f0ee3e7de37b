#include "Delaunay/HangingTriangles.h"

#include <algorithm>

namespace remesh
{
namespace
{
/** Which vertex takes over each that hangs; noIndex for all others. */
std::vector<Index> findReplacements(const std::vector<Triple>& triangles, const EdgeValences& edges,
  const Components& components, const Seams& seams)
{
  std::vector<Index> uses(static_cast<std::size_t>(components.count()), 0);
  for (const Triple& triangle : triangles)
  {
    for (const Index vertex : triangle)
    {
      ++uses[vertex];
    }
  }
  std::vector<char> stays(uses.size(), 0);
  for (const Index component : seams.components)
  {
    if (component != noIndex)
    {
      stays[component] = 1;
    }
  }
  std::vector<Index> replacements(uses.size(), noIndex);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index from = triangles[t][k];
      const Index to = triangles[t][(k + 1) % 3];
      const Index apex = triangles[t][(k + 2) % 3];
      if (uses[apex] == 1 && !stays[apex] && edges.of(from, to) > 2 && edges.of(to, apex) == 1 &&
        edges.of(apex, from) == 1)
      {
        // Both have other triangles, and so do not hang themselves. The pieces must be next to the
        // replacement's: a vertex on a feature may meet them through the collar alone.
        replacements[apex] = stays[from] && !stays[to] ? to : from;
      }
    }
  }
  return replacements;
}

/** Gives the pieces and sums of each vertex to its replacement. */
void takeOver(const std::vector<Index>& replacements, Components& components)
{
  for (Index k = 0; k < components.count(); ++k)
  {
    if (const Index replacement = replacements[k]; replacement != noIndex)
    {
      components.mass[replacement] += components.mass[k];
      components.area[replacement] += components.area[k];
      components.energy[replacement] += components.energy[k];
    }
  }
}

/** Leaves out the vertices with replacements; returns the new number of each. */
std::vector<Index> renumber(const std::vector<Index>& replacements, Components& components)
{
  const Index count = components.count();
  std::vector<Index> numbers(static_cast<std::size_t>(count), noIndex);
  Index kept = 0;
  for (Index k = 0; k < count; ++k)
  {
    if (replacements[k] != noIndex)
    {
      continue;
    }
    const bool sameSite = kept > 0 && components.sites[kept - 1] == components.sites[k];
    components.ranks[kept] = sameSite ? components.ranks[kept - 1] + 1 : 0;
    components.sites[kept] = components.sites[k];
    components.mass[kept] = components.mass[k];
    components.area[kept] = components.area[k];
    components.energy[kept] = components.energy[k];
    components.centroids[kept] = components.centroids[k];
    numbers[k] = kept++;
  }
  for (Index k = 0; k < count; ++k)
  {
    if (replacements[k] != noIndex)
    {
      numbers[k] = numbers[replacements[k]];
    }
  }
  components.sites.resize(kept);
  components.ranks.resize(kept);
  components.mass.resize(kept);
  components.area.resize(kept);
  components.energy.resize(kept);
  components.centroids.resize(kept);
  return numbers;
}

void listPieces(Components& components)
{
  components.pieceBegin.assign(static_cast<std::size_t>(components.count()) + 1, 0);
  for (const Index component : components.ofPiece)
  {
    ++components.pieceBegin[static_cast<std::size_t>(component) + 1];
  }
  for (std::size_t k = 1; k < components.pieceBegin.size(); ++k)
  {
    components.pieceBegin[k] += components.pieceBegin[k - 1];
  }
  std::vector<Offset> next(components.pieceBegin.begin(), components.pieceBegin.end() - 1);
  for (std::size_t piece = 0; piece < components.ofPiece.size(); ++piece)
  {
    components.pieces[next[components.ofPiece[piece]]++] = static_cast<Index>(piece);
  }
}
}

namespace
{
/** Leaves out those of a vertex with an replacement. */
void renumber(const std::vector<Index>& replacements, const std::vector<Index>& numbers,
  std::vector<Triple>& triangles)
{
  std::size_t stay = 0;
  for (const auto& [a, b, c] : triangles)
  {
    if (replacements[a] == noIndex && replacements[b] == noIndex && replacements[c] == noIndex)
    {
      triangles[stay++] = { numbers[a], numbers[b], numbers[c] }; // as ascending as they were
    }
  }
  triangles.resize(stay);
}

void renumber(const std::vector<Index>& numbers, Seams& seams)
{
  for (Index& component : seams.components)
  {
    component = component == noIndex ? noIndex : numbers[component];
  }
  for (FeatureSegment& segment : seams.segments)
  {
    segment.ends = { numbers[segment.ends[0]], numbers[segment.ends[1]] };
  }
  for (std::vector<Intrusion>* list : { &seams.intrusions, &seams.encroachments })
  {
    for (Intrusion& intrusion : *list)
    {
      intrusion.component = numbers[intrusion.component];
    }
  }
}
}

Index removeHangingTriangles(const EdgeValences& edges, Components& components,
  std::vector<Triple>& triangles, std::vector<Triple>& repeated, Seams& seams)
{
  const std::vector<Index> replacements = findReplacements(triangles, edges, components, seams);
  const auto kept = std::count(replacements.begin(), replacements.end(), noIndex);
  const Index count = components.count() - static_cast<Index>(kept);
  if (count == 0)
  {
    return 0;
  }
  takeOver(replacements, components);
  const std::vector<Index> numbers = renumber(replacements, components);
  for (Index& component : components.ofPiece)
  {
    component = numbers[component];
  }
  listPieces(components);
  renumber(replacements, numbers, triangles);
  renumber(replacements, numbers, repeated);
  renumber(numbers, seams);
  return count;
}
}
