#include "Delaunay/SurfaceLocation.h"

#include "Mesh/ClosestPoint.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <limits>

namespace remesh
{
namespace
{
SurfaceLocation locate(
  const SurfaceMesh& mesh, const Diagram& diagram, const Components& components, Index component)
{
  SurfaceLocation location{ noIndex, { 0.0, 0.0, 0.0 } };
  double nearest = std::numeric_limits<double>::infinity();
  for (Offset p = components.pieceBegin[component]; p < components.pieceBegin[component + 1]; ++p)
  {
    const Index facet = diagram.facets[components.pieces[p]];
    const Triple& points = mesh.facetPoints[facet];
    const ClosestPoint closest = closestOnTriangle(components.centroids[component],
      mesh.points[points[0]], mesh.points[points[1]], mesh.points[points[2]]);
    if (closest.squared < nearest)
    {
      nearest = closest.squared;
      location.facet = facet;
      std::copy_n(closest.b, 3, location.b);
    }
  }
  return location;
}
}

Status locateOnSurface(const SurfaceMesh& mesh, const Diagram& diagram,
  const Components& components, const RunControl& control, std::vector<SurfaceLocation>& locations)
{
  locations.resize(static_cast<std::size_t>(components.count()));
  const bool done = forEachRange(Blocks::cut(components.count(), 256, 4096), control,
    [&](Offset begin, Offset end)
    {
      for (Offset k = begin; k < end; ++k)
      {
        locations[k] = locate(mesh, diagram, components, static_cast<Index>(k));
      }
    });
  return done ? Status::success() : Status::cancelled();
}
}
