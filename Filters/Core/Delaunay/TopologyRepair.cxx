#include "Delaunay/TopologyRepair.h"

#include "Embedding/Distance.h"

#include <algorithm>
#include <numeric>

namespace remesh
{
namespace
{
constexpr double mostDefects = 0.01; // of the number of sites

/** The vertex of a component's pieces farthest from the site, in R^d. */
std::vector<double> farthestPoint(const EmbeddedSurface& surface, const Diagram& diagram,
  const Components& components, Index component, const double* site)
{
  const int d = surface.dimension;
  std::vector<double> farthest(static_cast<std::size_t>(d));
  std::vector<double> point(farthest.size());
  double largest = -1.0;
  for (Offset p = components.pieceBegin[component]; p < components.pieceBegin[component + 1]; ++p)
  {
    const Offset piece = components.pieces[p];
    const Triple& corners = surface.facetCorners[diagram.facets[piece]];
    for (Offset v = diagram.vertexBegin[piece]; v < diagram.vertexBegin[piece + 1]; ++v)
    {
      const double* b = diagram.vertices[v].b;
      for (int k = 0; k < d; ++k)
      {
        point[k] = b[0] * surface.corner(corners[0])[k] + b[1] * surface.corner(corners[1])[k] +
          b[2] * surface.corner(corners[2])[k];
      }
      const double squared = squaredDistance<Eigen::Dynamic>(point.data(), site, d);
      if (squared > largest)
      {
        largest = squared;
        farthest = point;
      }
    }
  }
  return farthest;
}

/** Sites by increasing energy of their cells, without those within two triangles of a defect. */
std::vector<Index> findDonors(
  const Components& components, const Dual& dual, const CellSums& sums, std::size_t wanted)
{
  std::vector<char> near(static_cast<std::size_t>(components.count()), 0);
  for (const Index defect : dual.defects)
  {
    near[defect] = 1;
  }
  for (int ring = 0; ring < 2; ++ring)
  {
    const std::vector<char> before = near;
    for (const Triple& triangle : dual.triangles)
    {
      if (before[triangle[0]] || before[triangle[1]] || before[triangle[2]])
      {
        near[triangle[0]] = near[triangle[1]] = near[triangle[2]] = 1;
      }
    }
  }
  std::vector<char> keep(sums.energy.size(), 0);
  for (Index k = 0; k < components.count(); ++k)
  {
    keep[components.sites[k]] |= near[k];
  }
  std::vector<Index> donors;
  for (std::size_t i = 0; i < keep.size(); ++i)
  {
    if (!keep[i])
    {
      donors.push_back(static_cast<Index>(i));
    }
  }
  const std::size_t count = std::min(wanted, donors.size());
  std::partial_sort(donors.begin(), donors.begin() + static_cast<std::ptrdiff_t>(count),
    donors.end(),
    [&](Index a, Index b)
    { return sums.energy[a] != sums.energy[b] ? sums.energy[a] < sums.energy[b] : a < b; });
  donors.resize(count);
  return donors;
}
}

Index moveSitesToDefects(const EmbeddedSurface& surface, const Diagram& diagram,
  const Components& components, const Dual& dual, const CellSums& sums, Sites& sites)
{
  if (dual.defects.empty() ||
    static_cast<double>(dual.defects.size()) > mostDefects * sites.count())
  {
    return 0;
  }
  const std::vector<Index> donors = findDonors(components, dual, sums, dual.defects.size());
  for (std::size_t k = 0; k < donors.size(); ++k)
  {
    const Index component = dual.defects[k];
    const std::vector<double> place = farthestPoint(
      surface, diagram, components, component, sites.site(components.sites[component]));
    std::copy(place.begin(), place.end(), sites.site(donors[k]));
  }
  return static_cast<Index>(donors.size());
}
}
