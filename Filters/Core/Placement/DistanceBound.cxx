#include "Placement/DistanceBound.h"

#include "Placement/NearbySurface.h"
#include "Support/Grouping.h"
#include "Support/SortUnique.h"

#include <algorithm>

namespace remesh
{
namespace
{
constexpr double payingShare = 6.0;
constexpr int halvings = 7; // of the way back

/** The cells of a vertex and of those around it. */
std::vector<Index> cellsAround(const FitTask& task, Index vertex)
{
  std::vector<Index> cells(1, vertex);
  for (Offset k = task.stars.begin(vertex); k < task.stars.end(vertex); ++k)
  {
    const Triple& triangle = task.problem.triangles[task.stars.triangles[k]];
    cells.insert(cells.end(), triangle.begin(), triangle.end());
  }
  sortUnique(cells);
  return cells;
}

/** From the facets of some cells. */
struct CellDistance
{
  const NearbySurface& surface;
  const Index* begin;
  const Index* end;

  double squared(const Point3& place) const
  {
    return (this->surface.closestPoint(this->begin, this->end, place) - place).squaredNorm();
  }
};

/** The farthest place on the way from `start` to `goal` whose squared distance is no more. */
Point3 lastWithin(
  const CellDistance& distance, double most, const Point3& start, const Point3& goal)
{
  double reached = 0.0;
  double beyond = 1.0;
  for (int k = 0; k < halvings; ++k)
  {
    const double middle = 0.5 * (reached + beyond);
    const bool isWithin = distance.squared(start + middle * (goal - start)) <= most;
    (isWithin ? reached : beyond) = middle;
  }
  return start + reached * (goal - start);
}
}

bool boundDistances(const FitTask& task, const std::vector<Point3>& start, const FitErrors& errors,
  const RunControl& control, std::vector<Point3>& positions)
{
  const NearbySurface surface(task.problem, control);
  const double mean = errors.mean();
  return forEachItem(static_cast<Offset>(positions.size()), control.silent(),
    [&](Offset item)
    {
      const auto v = static_cast<Index>(item);
      if (positions[v] == start[v] || !positions[v].allFinite())
      {
        return;
      }
      const double around = payingShare * errors.around(v);
      // Most are near their own cells, whatever is around.
      if (CellDistance{ surface, &v, &v + 1 }.squared(positions[v]) <=
        std::min(std::max(around, mean), errors.farthest))
      {
        return;
      }
      const std::vector<Index> cells = cellsAround(task, v);
      const CellDistance distance{ surface, cells.data(), cells.data() + cells.size() };
      const double before = distance.squared(start[v]);
      const double most =
        std::max(before, std::min(std::max(before + around, mean), errors.farthest));
      if (distance.squared(positions[v]) > most)
      {
        positions[v] = lastWithin(distance, most, start[v], positions[v]);
      }
    });
}
}
