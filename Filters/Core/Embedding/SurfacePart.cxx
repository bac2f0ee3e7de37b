#include "Embedding/SurfacePart.h"

namespace remesh
{
EmbeddedSurface partOf(const EmbeddedSurface& surface, Offset begin, Offset end)
{
  const auto d = static_cast<std::size_t>(surface.dimension);
  std::vector<Index> ids(static_cast<std::size_t>(surface.numberOfCorners()), noIndex);
  for (Offset facet = begin; facet < end; ++facet)
  {
    for (const Index corner : surface.facetCorners[facet])
    {
      ids[corner] = 0;
    }
  }
  EmbeddedSurface part;
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
  packet.add(surface.dimension);
  packet.add(surface.patches);
  packet.add(surface.corners);
  packet.add(static_cast<const std::vector<Triple>&>(surface.facetCorners));
  packet.add(surface.constants);
  packet.add(surface.densities);
  packet.add(surface.center);
  packet.add(surface.unit);
  packet.add(surface.mass);
  packet.add(surface.siteMeasure);
  packet.add(surface.densityUnit);
}

EmbeddedSurface takeSurface(Packet& packet)
{
  EmbeddedSurface surface;
  std::vector<Triple> facets;
  packet.take(surface.dimension);
  packet.take(surface.patches);
  packet.take(surface.corners);
  packet.take(facets);
  packet.take(surface.constants);
  packet.take(surface.densities);
  packet.take(surface.center);
  packet.take(surface.unit);
  packet.take(surface.mass);
  packet.take(surface.siteMeasure);
  packet.take(surface.densityUnit);
  surface.facetCorners = std::move(facets);
  return surface;
}
}
