#include "Voronoi/Ownership.h"

#include "Embedding/CornerReader.h"
#include "Embedding/Distance.h"
#include "Support/Parallel.h"
#include "Voronoi/SecurityRadius.h"

#include <cmath>

namespace remesh
{
namespace
{
/**
 * A site nearer to the point than `owner`, or noIndex. Sites farther than twice the owner's
 * distance from the owner cannot be. `owned` is that distance, squared.
 */
template <int D>
Index findNearer(const double* point, Index owner, const Sites& sites, const NeighborLists& lists,
  LongerLists& longer, double& owned)
{
  const int d = sites.dimension;
  const SecurityRadius security(d);
  owned = squaredDistance<D>(sites.site(owner), point, d);
  const double radius = std::sqrt(owned);
  NeighborWalk walk(lists, longer, owner);
  while (walk.next())
  {
    if (security.excludes(walk.leastDistance(), radius, radius))
    {
      return noIndex;
    }
    const double other = squaredDistance<D>(sites.site(walk.site()), point, d);
    if (other < owned || (other == owned && walk.site() < owner))
    {
      return walk.site();
    }
  }
  return noIndex;
}
}

Status findOwners(const EmbeddedSurface& surface, const Sites& sites, const NeighborLists& lists,
  const RunControl& control, std::vector<Index>& owners, std::vector<double>& squared)
{
  const bool known = owners.size() == static_cast<std::size_t>(surface.numberOfCorners());
  owners.resize(static_cast<std::size_t>(surface.numberOfCorners()));
  squared.resize(owners.size());
  const auto walkTo = [&](auto dimension, Index corner, auto& reader, LongerLists& longer)
  {
    const double* point = reader.corner(corner);
    Index owner = known ? owners[corner] : lists.search().nearest(point);
    for (Index nearer = owner; nearer != noIndex;)
    {
      owner = nearer;
      nearer =
        findNearer<decltype(dimension)::value>(point, owner, sites, lists, longer, squared[corner]);
    }
    owners[corner] = owner;
  };
  const bool done = forEachRange(Blocks::cut(surface.numberOfCorners(), 1024, 4096), control,
    [&](Offset begin, Offset end)
    {
      LongerLists longer;
      dispatchDimension(sites.dimension,
        [&](auto dimension)
        {
          CornerReader<decltype(dimension)::value> reader(surface);
          for (Offset corner = begin; corner < end; ++corner)
          {
            walkTo(dimension, static_cast<Index>(corner), reader, longer);
          }
        });
    });
  return done ? Status::success() : Status::cancelled();
}
}
