#include "Delaunay/TopologyRepair.h"

#include "Embedding/CornerReader.h"
#include "Embedding/Distance.h"
#include "Voronoi/VertexPlaces.h"

#include <algorithm>
#include <numeric>

namespace remesh
{
namespace
{
constexpr double mostDefects = 0.01; // of the number of sites

/** The vertex of a component's pieces farthest from their sites, in R^d. */
std::vector<double> farthestPoint(
  const VertexPlaces& places, const Components& components, Index component)
{
  const EmbeddedSurface& surface = places.surface;
  const Diagram& diagram = places.diagram;
  const int d = surface.dimension;
  std::vector<double> farthest(static_cast<std::size_t>(d));
  std::vector<double> point(farthest.size());
  CornerReader<Eigen::Dynamic> reader(surface);
  double largest = -1.0;
  for (Offset p = components.pieceBegin[component]; p < components.pieceBegin[component + 1]; ++p)
  {
    const Offset piece = components.pieces[p];
    const double* site = places.sites.site(diagram.sites[piece]);
    const auto corners = reader.facet(diagram.facets[piece]);
    for (Offset v = diagram.vertexBegin[piece]; v < diagram.vertexBegin[piece + 1]; ++v)
    {
      const std::array<double, 3> b = places.at(piece, v);
      for (int k = 0; k < d; ++k)
      {
        point[k] = b[0] * corners[0][k] + b[1] * corners[1][k] + b[2] * corners[2][k];
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
std::vector<Index> findDonors(const Components& components, const Dual& dual, const CellSums& sums,
  Index fixed, std::size_t wanted)
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
  for (auto i = static_cast<std::size_t>(fixed); i < keep.size(); ++i)
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
  const std::vector<Index> donors =
    findDonors(components, dual, sums, sites.fixed, dual.defects.size());
  const Sites cutSites = sites; // those of the diagram, while others move
  const VertexPlaces places{ surface, cutSites, diagram };
  for (std::size_t k = 0; k < donors.size(); ++k)
  {
    const Index component = dual.defects[k];
    const std::vector<double> place = farthestPoint(places, components, component);
    std::copy(place.begin(), place.end(), sites.site(donors[k]));
  }
  return static_cast<Index>(donors.size());
}

Index adjustNumber(const EmbeddedSurface& surface, const Diagram& diagram,
  const Components& components, const Dual& dual, const CellSums& sums, Offset wanted, Sites& sites)
{
  const Offset surplus = components.count() - wanted;
  const auto d = static_cast<std::size_t>(sites.dimension);
  if (surplus <= 0)
  {
    std::vector<Index> byEnergy(static_cast<std::size_t>(components.count()));
    std::iota(byEnergy.begin(), byEnergy.end(), Index(0));
    std::stable_sort(byEnergy.begin(), byEnergy.end(),
      [&](Index a, Index b) { return components.energy[a] > components.energy[b]; });
    byEnergy.resize(std::min(byEnergy.size(), static_cast<std::size_t>(-surplus)));
    std::vector<double> added;
    for (const Index component : byEnergy)
    {
      const std::vector<double> place =
        farthestPoint({ surface, sites, diagram }, components, component);
      added.insert(added.end(), place.begin(), place.end());
    }
    sites.coordinates.insert(sites.coordinates.end(), added.begin(), added.end());
    return static_cast<Index>(byEnergy.size());
  }
  const std::vector<Index> donors =
    findDonors(components, dual, sums, sites.fixed, static_cast<std::size_t>(surplus));
  std::vector<char> removed(static_cast<std::size_t>(sites.count()), 0);
  for (const Index donor : donors)
  {
    removed[donor] = 1;
  }
  std::size_t kept = 0;
  for (Index i = 0; i < sites.count(); ++i)
  {
    if (!removed[i])
    {
      std::copy_n(sites.site(i), d, sites.coordinates.data() + kept * d);
      ++kept;
    }
  }
  sites.coordinates.resize(kept * d);
  return static_cast<Index>(donors.size());
}
}
