#include "Comparison/TriangleTree.h"

#include "Mesh/FacetGeometry.h"
#include "Mesh/SpatialOrder.h"
#include "Support/Grouping.h"

namespace remesh
{
TriangleTree::TriangleTree(const Triangles& surface, const RunControl& control)
{
  std::vector<Index> kept;
  std::vector<Point3> centroids;
  if (!packItems(
        surface.count(), control.silent(),
        [&](Offset t)
        {
          const auto [a, b, c] = surface.corners(t);
          return hasArea(a, b, c);
        },
        [&](Offset count)
        {
          kept.resize(static_cast<std::size_t>(count));
          centroids.resize(kept.size());
        },
        [&](Offset t, Offset k)
        {
          const auto [a, b, c] = surface.corners(t);
          kept[k] = static_cast<Index>(t);
          centroids[k] = (a + b + c) / 3.0;
        }) ||
    kept.empty())
  {
    return;
  }
  const std::vector<Index> order = orderAlongHilbertCurve(centroids, control.silent());
  m_ids.resize(kept.size());
  m_corners.resize(kept.size());
  const auto size = static_cast<Offset>(kept.size());
  if (!forEachItem(size, control.silent(),
        [&](Offset slot)
        {
          m_ids[slot] = kept[order[slot]];
          m_corners[slot] = surface.corners(m_ids[slot]);
        }))
  {
    return;
  }
  const auto leaves = static_cast<Index>((size + leafSize - 1) / leafSize);
  m_boxes.resize(2 * static_cast<std::size_t>(leaves) - 1);
  this->joinBoxes(0, 0, leaves);
}

TriangleTree::Box TriangleTree::joinBoxes(Index box, Index begin, Index end)
{
  Box& whole = m_boxes[box];
  if (end - begin == 1)
  {
    whole = { m_corners[begin * leafSize][0], m_corners[begin * leafSize][0] };
    const auto last = std::min<Index>(end * leafSize, static_cast<Index>(m_ids.size()));
    for (Index slot = begin * leafSize; slot < last; ++slot)
    {
      for (const Point3& corner : m_corners[slot])
      {
        whole = { whole.lower.cwiseMin(corner), whole.upper.cwiseMax(corner) };
      }
    }
    return whole;
  }
  const Index middle = begin + (end - begin) / 2;
  const Box first = this->joinBoxes(box + 1, begin, middle);
  const Box second = this->joinBoxes(box + 2 * (middle - begin), middle, end);
  whole = { first.lower.cwiseMin(second.lower), first.upper.cwiseMax(second.upper) };
  return whole;
}

TriangleTree::Node TriangleTree::root(const Point3& point) const
{
  return { 0, 0, static_cast<Index>((m_boxes.size() + 1) / 2), m_boxes[0].squaredDistance(point) };
}

void TriangleTree::children(const Node& node, const Point3& point, Node (&found)[2]) const
{
  const Index middle = node.begin + (node.end - node.begin) / 2;
  const Index first = node.box + 1;
  const Index second = node.box + 2 * (middle - node.begin);
  found[0] = { first, node.begin, middle, m_boxes[first].squaredDistance(point) };
  found[1] = { second, middle, node.end, m_boxes[second].squaredDistance(point) };
}

TriangleTree::Place TriangleTree::closestOn(Index slot, const Point3& point) const
{
  const auto& [a, b, c] = m_corners[slot];
  return { slot, closestOnTriangle(point, a, b, c) };
}

TriangleTree::Place TriangleTree::closest(const Point3& point, Index hint) const
{
  Place best;
  if (this->empty())
  {
    return best;
  }
  if (hint != noIndex)
  {
    best = this->closestOn(hint, point);
  }
  Stack stack;
  stack.push(this->root(point));
  while (stack.size > 0)
  {
    const Node node = stack.pop();
    if (!(node.squaredDistance < best.at.squared))
    {
      continue;
    }
    if (!node.isLeaf())
    {
      Node found[2];
      this->children(node, point, found);
      const int nearer = found[1].squaredDistance < found[0].squaredDistance ? 1 : 0;
      stack.push(found[1 - nearer]);
      stack.push(found[nearer]);
      continue;
    }
    const auto end = std::min<Index>((node.begin + 1) * leafSize, static_cast<Index>(m_ids.size()));
    for (Index slot = node.begin * leafSize; slot < end; ++slot)
    {
      const Place place = this->closestOn(slot, point);
      if (place.at.squared < best.at.squared)
      {
        best = place;
      }
    }
  }
  return best;
}
}
