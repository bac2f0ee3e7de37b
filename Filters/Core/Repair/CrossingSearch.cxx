#include "Repair/CrossingSearch.h"

#include "Placement/TriangleShape.h"
#include "Support/Parallel.h"
#include "Support/SortUnique.h"

#include <algorithm>

namespace remesh
{
namespace
{
constexpr double rounding = 1e-13; // of volumes, to the cube of the largest length

/** Six times the volume of a tetrahedron. */
double volumeBetween(const Point3& a, const Point3& b, const Point3& c, const Point3& d)
{
  return (b - a).cross(c - a).dot(d - a);
}

/** Whether a segment passes through the inside of a triangle. */
bool pierces(const Point3& p, const Point3& q, const Corners& t, double negligible)
{
  const double above = volumeBetween(t[0], t[1], t[2], p);
  const double below = volumeBetween(t[0], t[1], t[2], q);
  if ((above > 0.0) == (below > 0.0) || !(std::min(std::abs(above), std::abs(below)) > negligible))
  {
    return false;
  }
  const double u = volumeBetween(p, q, t[0], t[1]);
  const double v = volumeBetween(p, q, t[1], t[2]);
  const double w = volumeBetween(p, q, t[2], t[0]);
  return (u > 0.0 && v > 0.0 && w > 0.0) || (u < 0.0 && v < 0.0 && w < 0.0);
}

double longestEdge(const Corners& p)
{
  return std::sqrt(std::max(
    { (p[1] - p[0]).squaredNorm(), (p[2] - p[1]).squaredNorm(), (p[0] - p[2]).squaredNorm() }));
}
}

bool areCrossing(const Triple& first, const Triple& second, const std::vector<Point3>& positions)
{
  const auto common =
    std::count_if(first.begin(), first.end(), [&](Index vertex) { return has(second, vertex); });
  if (common > 1)
  {
    return false;
  }
  const Corners s = cornersOf(first, positions);
  const Corners t = cornersOf(second, positions);
  if (!boxAround(s).intersects(boxAround(t)))
  {
    return false;
  }
  const double length = std::max(longestEdge(s), longestEdge(t));
  const double negligible = rounding * length * length * length;
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    const bool firstIsFree = !has(second, first[k]) && !has(second, first[next]);
    const bool secondIsFree = !has(first, second[k]) && !has(first, second[next]);
    if ((firstIsFree && pierces(s[k], s[next], t, negligible)) ||
      (secondIsFree && pierces(t[k], t[next], s, negligible)))
    {
      return true;
    }
  }
  return false;
}

CrossingSearch::CrossingSearch(const std::vector<Triple>& triangles,
  const std::vector<Point3>& positions, const RunControl& control)
  : m_triangles(triangles)
  , m_positions(positions)
  , m_tree({ positions, triangles }, control)
  , m_hasChanged(triangles.size(), 0)
{
}

template <class Visit>
void CrossingSearch::visitCrossing(
  Index triangle, std::vector<Index>& slots, const Visit& visit) const
{
  const Triple& own = m_triangles[triangle];
  const Corners corners = cornersOf(own, m_positions);
  const auto& [a, b, c] = corners;
  const Point3 middle = boxAround(corners).center();
  const double radius2 = std::max(
    { (a - middle).squaredNorm(), (b - middle).squaredNorm(), (c - middle).squaredNorm() });
  m_tree.findWithin(middle, std::sqrt(radius2) * (1.0 + 1e-12), slots);
  for (const Index slot : slots)
  {
    const Index other = m_tree.triangleOf(slot);
    if (!m_hasChanged[other] && areCrossing(own, m_triangles[other], m_positions))
    {
      visit(other);
    }
  }
  for (const Index other : m_changed)
  {
    if (areCrossing(own, m_triangles[other], m_positions))
    {
      visit(other);
    }
  }
}

/** Pairs of triangles that are where they were when the tree was made. */
bool CrossingSearch::findInTree(
  const std::vector<char>& isInTree, const RunControl& control, std::vector<Pairs>& found) const
{
  const Blocks groups = Blocks::cut(m_tree.numberOfGroups(), 64, 256);
  found.resize(static_cast<std::size_t>(groups.count()));
  return forEachBlock(groups.count(), control,
    [&](Offset block)
    {
      std::vector<Index> scratch;
      for (auto k = static_cast<Index>(groups.begin(block)); k < groups.end(block); ++k)
      {
        m_tree.visitMeeting(k, scratch,
          [&](Index slot, Index otherSlot)
          {
            const Index triangle = m_tree.triangleOf(slot);
            const Index other = m_tree.triangleOf(otherSlot);
            if (isInTree[triangle] && isInTree[other] &&
              areCrossing(m_triangles[triangle], m_triangles[other], m_positions))
            {
              found[block].push_back(std::minmax(triangle, other));
            }
          });
      }
    });
}

/** Pairs of any triangle with those that have changed, or are not in the tree. */
bool CrossingSearch::findOthers(
  const std::vector<char>& isInTree, const RunControl& control, std::vector<Pairs>& found) const
{
  const Blocks all = Blocks::cut(static_cast<Offset>(m_triangles.size()), 64, 4096);
  found.resize(static_cast<std::size_t>(all.count()));
  return forEachBlock(all.count(), control,
    [&](Offset block)
    {
      std::vector<Index> slots;
      for (auto t = static_cast<Index>(all.begin(block)); t < all.end(block); ++t)
      {
        if (!isInTree[t])
        {
          this->visitCrossing(
            t, slots, [&](Index other) { found[block].push_back(std::minmax(t, other)); });
        }
      }
    });
}

Status CrossingSearch::find(const RunControl& control, Pairs& pairs) const
{
  pairs.clear();
  std::vector<char> isInTree(m_triangles.size(), 0); // as it has been, with area
  for (Index slot = 0; slot < m_tree.size(); ++slot)
  {
    const Index triangle = m_tree.triangleOf(slot);
    isInTree[triangle] = m_hasChanged[triangle] == 0;
  }
  std::vector<Pairs> inTree;
  std::vector<Pairs> others;
  if (!this->findInTree(isInTree, control.step(0, 2), inTree) ||
    !this->findOthers(isInTree, control.step(1, 2), others))
  {
    return Status::cancelled();
  }
  for (const std::vector<Pairs>* found : { &inTree, &others })
  {
    for (const Pairs& some : *found)
    {
      pairs.insert(pairs.end(), some.begin(), some.end());
    }
  }
  sortUnique(pairs);
  return Status::success();
}

Offset CrossingSearch::count(Index triangle) const
{
  Offset crossing = 0;
  std::vector<Index> slots;
  this->visitCrossing(triangle, slots, [&](Index) { ++crossing; });
  return crossing;
}

void CrossingSearch::setChanged(Index triangle)
{
  if (!m_hasChanged[triangle])
  {
    m_hasChanged[triangle] = 1;
    m_changed.push_back(triangle);
  }
}
}
