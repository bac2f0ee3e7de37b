#include "Voronoi/NeighborSearch.h"

#include "Embedding/Distance.h"

#include <nanoflann.hpp>

#include <algorithm>
#include <cmath>

namespace remesh
{
class NeighborSearch::Tree
{
public:
  virtual ~Tree() = default;
  /** Ids and squared distances of the nearest `count` sites; returns how many there are. */
  virtual std::size_t search(
    const double* point, std::size_t count, std::uint32_t* ids, double* squared) const = 0;
};

template <int D>
class NeighborSearch::TreeOf : public NeighborSearch::Tree
{
  struct Cloud
  {
    const Sites& sites;

    std::size_t kdtree_get_point_count() const
    {
      return static_cast<std::size_t>(this->sites.count());
    }
    double kdtree_get_pt(std::size_t site, std::size_t k) const
    {
      const int dimension = D == Eigen::Dynamic ? this->sites.dimension : D;
      return this->sites.coordinates[site * static_cast<std::size_t>(dimension) + k];
    }
    template <class Box>
    bool kdtree_get_bbox(Box&) const
    {
      return false;
    }
  };
  using Index32 = std::uint32_t;
  using Metric = nanoflann::L2_Simple_Adaptor<double, Cloud, double, Index32>;
  using KDTree = nanoflann::KDTreeSingleIndexAdaptor<Metric, Cloud, D, Index32>;

public:
  explicit TreeOf(const Sites& sites)
    : m_cloud{ sites }
    , m_tree(sites.dimension, m_cloud, nanoflann::KDTreeSingleIndexAdaptorParams(8))
  {
    m_tree.buildIndex();
  }

  std::size_t search(
    const double* point, std::size_t count, std::uint32_t* ids, double* squared) const override
  {
    return m_tree.knnSearch(point, count, ids, squared);
  }

private:
  Cloud m_cloud;
  KDTree m_tree;
};

NeighborSearch::NeighborSearch(const Sites& sites)
  : m_sites(&sites)
{
  m_tree = dispatchDimension(sites.dimension,
    [&](auto dimension) -> std::unique_ptr<Tree>
    { return std::make_unique<TreeOf<decltype(dimension)::value>>(sites); });
}

NeighborSearch::~NeighborSearch() = default;
NeighborSearch::NeighborSearch(NeighborSearch&&) noexcept = default;
NeighborSearch& NeighborSearch::operator=(NeighborSearch&&) noexcept = default;

Index NeighborSearch::nearest(const double* point) const
{
  std::uint32_t id = 0;
  double squared = 0.0;
  m_tree->search(point, 1, &id, &squared);
  return static_cast<Index>(id);
}

void NeighborSearch::neighbors(Index site, Index count, std::vector<Neighbor>& result) const
{
  const auto wanted = static_cast<std::size_t>(std::min(count, this->numberOfSites() - 1)) + 1;
  std::vector<std::uint32_t> ids(wanted);
  std::vector<double> squared(wanted);
  const std::size_t found = m_tree->search(m_sites->site(site), wanted, ids.data(), squared.data());
  result.clear();
  for (std::size_t k = 0; k < found; ++k)
  {
    const auto id = static_cast<Index>(ids[k]);
    if (id != site)
    {
      result.push_back({ id, std::sqrt(squared[k]) });
    }
  }
  // With more coincident sites than asked for, the site itself may not be among the answers.
  if (result.size() == wanted)
  {
    result.pop_back();
  }
}
}
