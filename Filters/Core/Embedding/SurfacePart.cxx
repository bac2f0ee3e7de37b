#include "Embedding/SurfacePart.h"

namespace remesh
{
namespace
{
/** All that is sent of a surface but its facets, in this order. */
template <class Surface, class Visit>
void visitValues(Surface& surface, const Visit& visit)
{
  visit(surface.dimension);
  visit(surface.patches);
  visit(surface.corners);
  visit(surface.constants);
  visit(surface.densities);
  visit(surface.center);
  visit(surface.unit);
  visit(surface.mass);
  visit(surface.siteMeasure);
  visit(surface.densityUnit);
}
}

namespace
{
/** Copies the corners whose id is not noIndex, and gives them ids in their order. */
void copyCorners(const EmbeddedSurface& surface, std::vector<Index>& ids, EmbeddedSurface& part)
{
  const auto d = static_cast<std::size_t>(surface.dimension);
  Index count = 0;
  std::vector<double> row(d);
  for (std::size_t corner = 0; corner < ids.size(); ++corner)
  {
    if (ids[corner] == noIndex)
    {
      continue;
    }
    ids[corner] = count++;
    const auto id = static_cast<Index>(corner);
    if (surface.source.isLent())
    {
      surface.readScaled(id, row.data());
    }
    const double* values = surface.source.isLent() ? row.data() : surface.corner(id);
    part.corners.insert(part.corners.end(), values, values + d);
  }
}
}

EmbeddedSurface partOf(const EmbeddedSurface& surface, Offset begin, Offset end)
{
  std::vector<Index> ids(static_cast<std::size_t>(surface.numberOfCorners()), noIndex);
  for (Offset facet = begin; facet < end; ++facet)
  {
    for (const Index corner : surface.facetCorners[facet])
    {
      ids[corner] = 0;
    }
  }
  EmbeddedSurface part;
  copyCorners(surface, ids, part);
  std::vector<Triple> facets(
    surface.facetCorners.begin() + begin, surface.facetCorners.begin() + end);
  for (Triple& facet : facets)
  {
    for (Index& corner : facet)
    {
      corner = ids[corner];
    }
  }
  part.dimension = surface.dimension;
  part.patches = surface.patches;
  part.facetCorners = std::move(facets);
  part.constants.assign(surface.constants.begin() + begin, surface.constants.begin() + end);
  if (surface.hasDensity())
  {
    part.densities.assign(surface.densities.begin() + begin, surface.densities.begin() + end);
  }
  part.center = surface.center;
  part.unit = surface.unit;
  part.mass = surface.mass;
  part.siteMeasure = surface.siteMeasure;
  part.densityUnit = surface.densityUnit;
  return part;
}

void addSurface(const EmbeddedSurface& surface, Packet& packet)
{
  packet.add(static_cast<const std::vector<Triple>&>(surface.facetCorners));
  visitValues(surface, [&](const auto& value) { packet.add(value); });
}

EmbeddedSurface takeSurface(Packet& packet)
{
  EmbeddedSurface surface;
  std::vector<Triple> facets;
  packet.take(facets);
  surface.facetCorners = std::move(facets);
  visitValues(surface, [&](auto& value) { packet.take(value); });
  return surface;
}
}
