#include "Voronoi/NeighborSearch.h"

#include "Embedding/Distance.h"
#include "Support/Parallel.h"

#include <nanoflann.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace remesh
{
namespace
{
/** Measured: 8 to 32 differ by a few per cent. */
constexpr std::size_t leafSize = 16;

/** At most so many trees. */
constexpr int maxTrees = 4;
/** Smaller trees are not worth their boxes. */
constexpr Offset minInTree = 2048;

/** Takes all sites that the trees offer, which are those nearer than a radius. */
class WithinRadius
{
public:
  WithinRadius(double squaredRadius, std::vector<Neighbor>& found)
    : m_squaredRadius(squaredRadius)
    , m_found(found)
  {
    m_found.clear();
  }

  bool addPoint(double squared, std::uint32_t id)
  {
    m_found.push_back({ static_cast<Index>(id), squared });
    return true;
  }

  double worstDist() const { return m_squaredRadius; }
  std::size_t size() const { return m_found.size(); }
  bool full() const { return true; }

private:
  double m_squaredRadius;
  std::vector<Neighbor>& m_found;
};
}

class NeighborSearch::Forest
{
public:
  virtual ~Forest() = default;
  /** Ids and squared distances of the nearest `count` sites in reach; returns how many there are.
   */
  virtual std::size_t search(const double* point, std::size_t count, double squaredLimit,
    std::uint32_t* ids, double* squared) const = 0;
  virtual void search(const double* point, WithinRadius& result) const = 0;
};

/** Trees over runs of consecutive sites, which lie together as a rule: built in parallel. */
template <int D>
class NeighborSearch::ForestOf : public NeighborSearch::Forest
{
  /** The sites from `first` on. */
  struct Cloud
  {
    const Sites& sites;
    std::size_t first;
    std::size_t count;

    std::size_t kdtree_get_point_count() const { return this->count; }
    double kdtree_get_pt(std::size_t site, std::size_t k) const
    {
      const int dimension = D == Eigen::Dynamic ? this->sites.dimension : D;
      return this->sites
        .coordinates[(this->first + site) * static_cast<std::size_t>(dimension) + k];
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

  struct Tree
  {
    Cloud cloud;
    KDTree tree;
    std::vector<double> least; ///< d, of the box around the sites
    std::vector<double> most;  ///< d

    Tree(const Sites& sites, std::size_t first, std::size_t count)
      : cloud{ sites, first, count }
      , tree(sites.dimension, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(leafSize))
      , least(sites.site(static_cast<Index>(first)),
          sites.site(static_cast<Index>(first)) + sites.dimension)
      , most(least)
    {
      this->tree.buildIndex();
      for (std::size_t k = 0; k < count * least.size(); ++k)
      {
        const double x = sites.coordinates[first * least.size() + k];
        least[k % least.size()] = std::min(least[k % least.size()], x);
        most[k % least.size()] = std::max(most[k % least.size()], x);
      }
    }

    double squaredDistanceTo(const double* point) const
    {
      const std::size_t d = D == Eigen::Dynamic ? least.size() : static_cast<std::size_t>(D);
      double squared = 0.0;
      for (std::size_t k = 0; k < d; ++k)
      {
        const double outside = std::max({ 0.0, least[k] - point[k], point[k] - most[k] });
        squared += outside * outside;
      }
      return squared;
    }
  };

  /** Nothing beyond a limit is looked at: far from all others, a site would else look at them all.
   */
  template <class Set>
  struct InReach
  {
    Set& set;
    double squaredLimit;

    bool addPoint(double squared, Index32 id) { return this->set.addPoint(squared, id); }
    double worstDist() const { return std::min(this->set.worstDist(), this->squaredLimit); }
    std::size_t size() const { return this->set.size(); }
    bool full() const { return true; }
  };

  /** Turns the ids of one tree into those of the sites. */
  template <class Set>
  struct Shifted
  {
    using DistanceType = double; // what newer versions of nanoflann ask for
    using IndexType = Index32;

    Set& set;
    std::size_t first;

    bool addPoint(double squared, Index32 id)
    {
      return this->set.addPoint(squared, static_cast<Index32>(this->first + id));
    }
    double worstDist() const { return this->set.worstDist(); }
    std::size_t size() const { return this->set.size(); }
    bool full() const { return this->set.full(); }
    void sort() {} // they ask for this, too
  };

public:
  explicit ForestOf(const Sites& sites)
    : m_trees(static_cast<std::size_t>(treesOf(sites).count()))
  {
    const Blocks blocks = treesOf(sites);
    const RunControl control; // not to be cancelled: half a forest is none
    const bool done = forEachBlock(blocks.count(), control,
      [&](Offset block)
      {
        m_trees[block] =
          std::make_unique<Tree>(sites, static_cast<std::size_t>(blocks.begin(block)),
            static_cast<std::size_t>(blocks.end(block) - blocks.begin(block)));
      });
    static_cast<void>(done);
  }

  std::size_t search(const double* point, std::size_t count, double squaredLimit,
    std::uint32_t* ids, double* squared) const override
  {
    nanoflann::KNNResultSet<double, Index32> set(count);
    set.init(ids, squared);
    InReach<nanoflann::KNNResultSet<double, Index32>> nearest{ set, squaredLimit };
    this->searchTrees(point, nearest);
    return nearest.size();
  }

  void search(const double* point, WithinRadius& result) const override
  {
    this->searchTrees(point, result);
  }

private:
  static Blocks treesOf(const Sites& sites)
  {
    const Offset wanted = std::clamp<Offset>(sites.count() / minInTree, 1, maxTrees);
    return Blocks::cut(sites.count(), wanted, sites.count());
  }

  /** The nearest tree first: it rules out most of the others. */
  template <class Set>
  void searchTrees(const double* point, Set& set) const
  {
    const auto searchIn = [&](const Tree& tree)
    {
      Shifted<Set> shifted{ set, tree.cloud.first };
      tree.tree.findNeighbors(shifted, point, {});
    };
    if (m_trees.size() == 1)
    {
      searchIn(*m_trees.front());
      return;
    }
    double away[maxTrees];
    std::size_t first = 0;
    for (std::size_t t = 0; t < m_trees.size(); ++t)
    {
      away[t] = m_trees[t]->squaredDistanceTo(point);
      first = away[t] < away[first] ? t : first;
    }
    searchIn(*m_trees[first]);
    for (std::size_t t = 0; t < m_trees.size(); ++t)
    {
      if (t != first && away[t] <= set.worstDist())
      {
        searchIn(*m_trees[t]);
      }
    }
  }

  std::vector<std::unique_ptr<Tree>> m_trees;
};

NeighborSearch::NeighborSearch(const Sites& sites)
  : m_sites(&sites)
{
  m_forest = dispatchDimension(sites.dimension,
    [&](auto dimension) -> std::unique_ptr<Forest>
    { return std::make_unique<ForestOf<decltype(dimension)::value>>(sites); });
}

NeighborSearch::~NeighborSearch() = default;
NeighborSearch::NeighborSearch(NeighborSearch&&) noexcept = default;
NeighborSearch& NeighborSearch::operator=(NeighborSearch&&) noexcept = default;

Index NeighborSearch::nearest(const double* point) const
{
  std::uint32_t id = 0;
  double squared = 0.0;
  m_forest->search(point, 1, std::numeric_limits<double>::infinity(), &id, &squared);
  return static_cast<Index>(id);
}

void NeighborSearch::neighbors(
  Index site, Index count, double limit, std::vector<Neighbor>& result) const
{
  const auto wanted = static_cast<std::size_t>(std::min(count, this->numberOfSites() - 1)) + 1;
  std::vector<std::uint32_t> ids(wanted);
  std::vector<double> squared(wanted);
  const std::size_t found =
    m_forest->search(m_sites->site(site), wanted, limit * limit, ids.data(), squared.data());
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

void NeighborSearch::within(const double* point, double radius, std::vector<Neighbor>& result) const
{
  WithinRadius found(radius * radius, result);
  m_forest->search(point, found);
  for (Neighbor& neighbor : result)
  {
    neighbor.distance = std::sqrt(neighbor.distance);
  }
}
}
