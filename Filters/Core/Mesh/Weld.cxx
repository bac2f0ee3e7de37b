/**
 * @file Weld.cxx
 *
 * Equal points:
 * 1. Hash the coordinates' bits and sort the points by hash (radix sort, stable).
 * 2. Points with one hash are consecutive; sort each such run by coordinates, then by id, so that
 *    hash collisions do no harm. The first of equal points stands for them.
 *
 * Near points, after equal ones:
 * 1. Put the points into a grid whose cells are a little smaller than distance / sqrt(3), so that
 *    points of one cell are always near, and points further than two cells apart never are.
 * 2. Unite the points of each cell.
 * 3. Sweep the sorted cells against the sorted cells of each of the 13 rows of cells that follow
 *    within reach, and unite two cells at their first near pair. Cells already united are skipped:
 *    the partition cannot change any more.
 */
#include "Mesh/Weld.h"

#include "Support/DisjointSets.h"
#include "Support/Grouping.h"
#include "Support/KeyOrder.h"
#include "Support/Random.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <tuple>

namespace remesh
{
namespace
{
std::uint64_t hashPoint(const Point3& point)
{
  std::uint64_t hash = 0;
  for (int k = 0; k < 3; ++k)
  {
    const double coordinate = point[k] + 0.0; // -0 to +0
    std::uint64_t bits = 0;
    std::memcpy(&bits, &coordinate, sizeof bits);
    hash = mixBits(hash ^ bits);
  }
  return hash;
}

bool lessByCoordinates(const Point3& a, const Point3& b)
{
  return std::tie(a[0], a[1], a[2]) < std::tie(b[0], b[1], b[2]);
}

/** Writes the representatives of a run of points that share a hash. */
void weldRun(const std::vector<Point3>& points, std::vector<Index>::iterator begin,
  std::vector<Index>::iterator end, std::vector<Index>& lowest)
{
  std::sort(begin, end,
    [&points](Index a, Index b)
    {
      const bool less = lessByCoordinates(points[a], points[b]);
      return less || (!lessByCoordinates(points[b], points[a]) && a < b);
    });
  Index representative = *begin;
  for (auto item = begin; item != end; ++item)
  {
    if (points[*item] != points[representative])
    {
      representative = *item;
    }
    lowest[*item] = representative;
  }
}

using GridCell = std::array<std::int64_t, 3>;

/** Points sorted by grid cell, and the cells that hold any. */
struct PointGrid
{
  std::vector<GridCell> cells;          ///< ascending
  std::vector<std::size_t> pointsBegin; ///< cells + 1, into `points`
  std::vector<Index> points;
  bool cellsAreNear = true; ///< all points of a cell are nearer than the distance
};

/** Each point after its cell, cell by cell. */
std::vector<std::pair<GridCell, Index>> sortIntoCells(
  const std::vector<Point3>& points, const Point3& lower, double side)
{
  std::vector<std::pair<GridCell, Index>> items(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Point3 position = (points[i] - lower) / side;
    for (int k = 0; k < 3; ++k)
    {
      items[i].first[k] = static_cast<std::int64_t>(position[k]);
    }
    items[i].second = static_cast<Index>(i);
  }
  std::sort(items.begin(), items.end());
  return items;
}

PointGrid buildPointGrid(const std::vector<Point3>& points, double distance)
{
  Point3 lower = points.front();
  Point3 upper = lower;
  for (const Point3& point : points)
  {
    lower = lower.cwiseMin(point);
    upper = upper.cwiseMax(point);
  }
  // A hair below 1 / sqrt(3), for the rounding of the cell numbers; and no more cells per axis
  // than a double counts exactly.
  const double wanted = 0.577 * distance;
  const double least = (upper - lower).maxCoeff() * 0x1.0p-50;
  const double side = std::max(wanted, least);

  const std::vector<std::pair<GridCell, Index>> items = sortIntoCells(points, lower, side);
  PointGrid grid;
  grid.cellsAreNear = wanted >= least;
  grid.points.reserve(items.size());
  for (const auto& [cell, point] : items)
  {
    if (grid.cells.empty() || grid.cells.back() != cell)
    {
      grid.cells.push_back(cell);
      grid.pointsBegin.push_back(grid.points.size());
    }
    grid.points.push_back(point);
  }
  grid.pointsBegin.push_back(grid.points.size());
  return grid;
}

/** The search for near pairs between two cells, or within one. */
struct CellJoiner
{
  const std::vector<Point3>& points;
  const PointGrid& grid;
  double squaredDistance;
  DisjointSets& sets;

  bool near(Index a, Index b) const
  {
    return (this->points[a] - this->points[b]).squaredNorm() < this->squaredDistance;
  }

  void joinWithin(std::size_t cell)
  {
    const std::size_t end = this->grid.pointsBegin[cell + 1];
    for (std::size_t i = this->grid.pointsBegin[cell]; i < end; ++i)
    {
      const std::size_t last = this->grid.cellsAreNear ? std::min(i + 2, end) : end;
      for (std::size_t j = i + 1; j < last; ++j)
      {
        const Index a = this->grid.points[i];
        const Index b = this->grid.points[j];
        if (this->grid.cellsAreNear || this->near(a, b))
        {
          this->sets.unite(a, b);
        }
      }
    }
  }

  void joinAcross(std::size_t cell, std::size_t other)
  {
    const auto& begin = this->grid.pointsBegin;
    if (this->grid.cellsAreNear &&
      this->sets.find(this->grid.points[begin[cell]]) ==
        this->sets.find(this->grid.points[begin[other]]))
    {
      return;
    }
    for (std::size_t i = begin[cell]; i < begin[cell + 1]; ++i)
    {
      for (std::size_t j = begin[other]; j < begin[other + 1]; ++j)
      {
        if (this->near(this->grid.points[i], this->grid.points[j]))
        {
          this->sets.unite(this->grid.points[i], this->grid.points[j]);
          if (this->grid.cellsAreNear)
          {
            return;
          }
        }
      }
    }
  }
};

constexpr std::int64_t reach = 2;              ///< cells further apart than this hold no near pair
constexpr std::size_t cancellationStride = 64; ///< cells between two questions

/** Joins each cell with those at (dx, dy, firstDz .. reach) from it. False if cancelled. */
bool joinRow(CellJoiner& joiner, const GridCell& firstOffset, const RunControl& control)
{
  const std::vector<GridCell>& cells = joiner.grid.cells;
  std::size_t begin = 0;
  for (std::size_t cell = 0; cell < cells.size(); ++cell)
  {
    if (cell % cancellationStride == 0 && control.cancelled())
    {
      return false;
    }
    GridCell first{};
    for (int k = 0; k < 3; ++k)
    {
      first[k] = cells[cell][k] + firstOffset[k];
    }
    const GridCell last = { first[0], first[1], cells[cell][2] + reach };
    while (begin < cells.size() && cells[begin] < first)
    {
      ++begin;
    }
    for (std::size_t other = begin; other < cells.size() && cells[other] <= last; ++other)
    {
      joiner.joinAcross(cell, other);
    }
  }
  return true;
}

/** Joins all pairs nearer than the distance. False if cancelled. */
bool joinNear(
  const std::vector<Point3>& points, double distance, const RunControl& control, DisjointSets& sets)
{
  const PointGrid grid = buildPointGrid(points, distance);
  CellJoiner joiner{ points, grid, distance * distance, sets };
  for (std::size_t cell = 0; cell < grid.cells.size(); ++cell)
  {
    joiner.joinWithin(cell);
  }
  for (std::int64_t dx = 0; dx <= reach; ++dx)
  {
    for (std::int64_t dy = dx == 0 ? 0 : -reach; dy <= reach; ++dy)
    {
      const std::int64_t firstDz = dx == 0 && dy == 0 ? 1 : -reach;
      if (!joinRow(joiner, { dx, dy, firstDz }, control))
      {
        return false;
      }
    }
  }
  return true;
}
}

std::vector<Index> weldEqualPoints(const std::vector<Point3>& points, const RunControl& control)
{
  const RunControl silent = control.silent();
  const auto count = static_cast<Offset>(points.size());
  std::vector<std::uint64_t> hashes(points.size());
  std::vector<Index> lowest(points.size());
  if (!forEachItem(count, silent, [&](Offset k) { hashes[k] = hashPoint(points[k]); }))
  {
    return lowest;
  }
  std::vector<Index> order = orderByKey(hashes, silent);
  const auto opensRun = [&](Offset k)
  { return k == 0 || hashes[order[k]] != hashes[order[k - 1]]; };
  std::vector<Offset> runs;
  if (!packItems(
        count, silent, opensRun,
        [&](Offset size)
        {
          runs.resize(static_cast<std::size_t>(size) + 1);
          runs.back() = count;
        },
        [&](Offset k, Offset number) { runs[number] = k; }) ||
    !forEachItem(static_cast<Offset>(runs.size()) - 1, silent,
      [&](Offset run)
      { weldRun(points, order.begin() + runs[run], order.begin() + runs[run + 1], lowest); }))
  {
    return std::vector<Index>(points.size());
  }
  return lowest;
}

std::vector<Index> weldNearPoints(
  const std::vector<Point3>& points, double distance, const RunControl& control)
{
  std::vector<Index> lowest = weldEqualPoints(points, control);
  std::vector<Index> distinct;
  std::vector<Point3> distinctPoints;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (lowest[i] == static_cast<Index>(i))
    {
      distinct.push_back(lowest[i]);
      distinctPoints.push_back(points[i]);
    }
  }
  if (distinct.empty())
  {
    return lowest;
  }
  DisjointSets sets(distinctPoints.size());
  if (!joinNear(distinctPoints, distance, control, sets))
  {
    return lowest;
  }
  // `distinct` ascends, so the lowest of a set is the lowest of its input points.
  for (std::size_t i = 0; i < distinct.size(); ++i)
  {
    lowest[distinct[i]] = distinct[sets.find(static_cast<Index>(i))];
  }
  for (Index& representative : lowest)
  {
    representative = lowest[representative];
  }
  return lowest;
}
}
