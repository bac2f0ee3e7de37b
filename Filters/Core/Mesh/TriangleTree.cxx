#include "Mesh/TriangleTree.h"

#include "Mesh/FacetGeometry.h"
#include "Mesh/SpatialOrder.h"
#include "Support/Grouping.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace remesh
{
namespace
{
constexpr int laneBits = 3;
static_assert(1 << laneBits == lanes);

/** Those with an area, along a Hilbert curve; none when cancelled. */
std::vector<Index> orderTriangles(const Triangles& surface, const RunControl& control)
{
  std::vector<Index> kept;
  std::vector<Point3> centroids;
  if (!packItems(
        surface.count(), control,
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
    return {};
  }
  std::vector<Index> order = orderAlongHilbertCurve(centroids, control);
  const bool done = forEachItem(static_cast<Offset>(kept.size()), control,
    [&](Offset slot) { order[slot] = kept[order[slot]]; });
  return done ? order : std::vector<Index>();
}
}

TriangleTree::TriangleTree(const Triangles& surface, const RunControl& control)
  : m_surface(surface)
  , m_ids(orderTriangles(surface, control.silent()))
{
  if (m_ids.empty())
  {
    return;
  }
  Offset nodes = this->leaves();
  do
  {
    nodes = (nodes + lanes - 1) / lanes;
    m_levels.emplace_back(static_cast<std::size_t>(nodes));
  } while (this->findBoxes(static_cast<int>(m_levels.size()) - 1, control.silent()) && nodes > 1);
}

namespace
{
/** The box around all boxes of a group. */
void findBox(const BoxGroup& boxes, Point3& lower, Point3& upper)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    lower[axis] = *std::min_element(boxes.lower[axis], boxes.lower[axis] + lanes);
    upper[axis] = *std::max_element(boxes.upper[axis], boxes.upper[axis] + lanes);
  }
}
}

bool TriangleTree::findBoxes(int level, const RunControl& control)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<BoxGroup>* const below = level > 0 ? &m_levels[level - 1] : nullptr;
  const auto end = static_cast<Offset>(below ? below->size() : m_ids.size());
  return forEachItem(static_cast<Offset>(m_levels[level].size()), control,
    [&](Offset node)
    {
      BoxGroup& boxes = m_levels[level][node];
      for (int child = 0; child < lanes; ++child)
      {
        Point3 lower = Point3::Constant(infinity);
        Point3 upper = -lower;
        if (below && node * lanes + child < end)
        {
          findBox((*below)[node * lanes + child], lower, upper);
        }
        const Offset first = below ? end : (node * lanes + child) * leafSize;
        for (Offset slot = first; slot < std::min(first + leafSize, end); ++slot)
        {
          for (const Point3& corner : this->cornersOf(slot))
          {
            lower = lower.cwiseMin(corner);
            upper = upper.cwiseMax(corner);
          }
        }
        for (int axis = 0; axis < 3; ++axis)
        {
          boxes.lower[axis][child] = lower[axis];
          boxes.upper[axis][child] = upper[axis];
        }
      }
    });
}

/** The groups, from this one on, whose boxes meet this one's; in the tree's order. */
void TriangleTree::findGroups(Index group, std::vector<Index>& groups) const
{
  Point3 lower;
  Point3 upper;
  findBox(m_levels.front()[group], lower, upper);
  // Level by level, from the root, those nodes that have any such group.
  groups.assign(1, 0);
  std::vector<Index> children;
  for (auto level = static_cast<int>(m_levels.size()) - 1; level > 0; --level)
  {
    const Index first = group >> (laneBits * (level - 1));
    children.clear();
    for (const Index node : groups)
    {
      for (unsigned bits = m_meet({ m_levels[level][node], lower.data(), upper.data() }); bits != 0;
           bits &= bits - 1)
      {
        const Index child = node * lanes + __builtin_ctz(bits);
        if (child >= first)
        {
          children.push_back(child);
        }
      }
    }
    groups.swap(children);
  }
}

template <class Reaches, class Visit>
void TriangleTree::visitLeaves(
  const Point3& point, const Reaches& reaches, const Visit& visit) const
{
  if (this->empty())
  {
    return;
  }
  Pending pending[(lanes - 1) * maxLevels + 1];
  int size = 0;
  pending[size++] = { 0.0, 0, static_cast<int>(m_levels.size()) - 1 };
  while (size > 0)
  {
    const Pending node = pending[--size];
    if (!reaches(node.squared))
    {
      continue;
    }
    if (node.level < 0)
    {
      const Index begin = node.id * leafSize;
      const auto end = std::min<Index>(begin + leafSize, static_cast<Index>(m_ids.size()));
      for (Index slot = begin; slot < end; ++slot)
      {
        visit(slot);
      }
      continue;
    }
    double squared[lanes];
    m_distances({ m_levels[node.level][node.id], point.data(), squared });
    const int bottom = size;
    const auto children =
      node.level > 0 ? static_cast<Index>(m_levels[node.level - 1].size()) : this->leaves();
    for (int k = 0; k < std::min<Index>(lanes, children - node.id * lanes); ++k)
    {
      if (reaches(squared[k]))
      {
        int at = size++;
        for (; at > bottom && pending[at - 1].squared < squared[k]; --at)
        {
          pending[at] = pending[at - 1];
        }
        pending[at] = { squared[k], node.id * lanes + k, node.level - 1 };
      }
    }
  }
}

void TriangleTree::findWithin(const Point3& point, double distance, std::vector<Index>& slots) const
{
  slots.clear();
  const double reach = distance * distance;
  this->visitLeaves(
    point, [reach](double squared) { return squared <= reach; },
    [&](Index slot) { slots.push_back(slot); });
}

TriangleTree::Place TriangleTree::closestOn(Index slot, const Point3& point) const
{
  const auto [a, b, c] = this->cornersOf(slot);
  return { slot, closestOnTriangle(point, a, b, c) };
}

void TriangleTree::findClosest(
  const Point3& point, const Tolerance& tolerance, double squared, std::vector<Place>& places) const
{
  const auto reachOf = [&](double least)
  {
    const double radius = (1.0 + tolerance.relative) * std::sqrt(least) + tolerance.absolute;
    return radius * radius;
  };
  places.clear();
  double best = squared;
  double reach = reachOf(best);
  bool found = false; // as close as was said
  this->visitLeaves(
    point, [&](double distance2) { return distance2 <= reach; },
    [&](Index slot)
    {
      const Place place = this->closestOn(slot, point);
      if (place.at.squared <= best)
      {
        found = true;
        best = place.at.squared;
        reach = reachOf(best);
      }
      if (place.at.squared <= reach)
      {
        places.push_back(place);
      }
    });
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!found && squared != infinity) // that one has no area
  {
    this->findClosest(point, tolerance, infinity, places);
    return;
  }
  places.erase(std::remove_if(places.begin(), places.end(),
                 [&](const Place& place) { return place.at.squared > reach; }),
    places.end());
}

TriangleTree::Place TriangleTree::closest(const Point3& point, Index hint) const
{
  Place best;
  if (hint != noIndex && !this->empty())
  {
    best = this->closestOn(hint, point);
  }
  this->visitLeaves(
    point, [&](double squared) { return squared < best.at.squared; },
    [&](Index slot)
    {
      const Place place = this->closestOn(slot, point);
      if (place.at.squared < best.at.squared)
      {
        best = place;
      }
    });
  return best;
}

void TriangleTree::takeCloser(Index slot, Packet& packet) const
{
  const auto [a, b, c] = this->cornersOf(slot);
  PacketTriangle triangle;
  unsigned nearer = 0;
  if (triangle.set(a, b, c))
  {
    nearer = m_packetPlaces({ triangle, packet.points });
  }
  else
  {
    for (int lane = 0; lane < lanes; ++lane)
    {
      const double squared = closestOnTriangle(packet.points.at(lane), a, b, c).squared;
      if (squared < packet.points.squared[lane])
      {
        packet.points.squared[lane] = squared;
        nearer |= 1U << lane;
      }
    }
  }
  for (; nearer != 0; nearer &= nearer - 1)
  {
    packet.slots[__builtin_ctz(nearer)] = slot;
  }
}

int TriangleTree::pushChildren(const Packet& packet, const Point3 (&box)[2], const Pending& node,
  Pending* pending, int size) const
{
  const BoxGroup& boxes = m_levels[node.level][node.id];
  double squared[lanes];
  m_packetGroup({ boxes, box[0], box[1], squared });
  const double farthest = packet.points.farthest();
  const int bottom = size;
  for (int k = 0; k < lanes; ++k)
  {
    if (!(squared[k] < farthest))
    {
      continue;
    }
    squared[k] = m_packetBox({ packet.points, boxes, k });
    if (squared[k] == std::numeric_limits<double>::infinity()) // of none
    {
      continue;
    }
    int at = size++;
    for (; at > bottom && pending[at - 1].squared < squared[k]; --at)
    {
      pending[at] = pending[at - 1];
    }
    pending[at] = { squared[k], node.id * lanes + k, node.level - 1 };
  }
  return size;
}

std::array<Index, lanes> TriangleTree::takeHints(Packet& packet) const
{
  std::array<Index, lanes> hints;
  std::copy_n(packet.slots, lanes, hints.begin());
  std::fill_n(packet.slots, lanes, noIndex);
  std::fill_n(packet.points.squared, lanes, std::numeric_limits<double>::infinity());
  for (auto hint = hints.begin(); hint != hints.end(); ++hint)
  {
    if (*hint != noIndex && std::find(hints.begin(), hint, *hint) == hint)
    {
      this->takeCloser(*hint, packet);
    }
  }
  return hints;
}

bool TriangleTree::isInReach(const Packet& packet, const Pending& node) const
{
  const BoxGroup& boxes = m_levels[node.level + 1][node.id / lanes];
  return m_packetBox({ packet.points, boxes, node.id % lanes }) !=
    std::numeric_limits<double>::infinity();
}

void TriangleTree::findClosest(Packet& packet) const
{
  const std::array<Index, lanes> hints = this->takeHints(packet);
  Point3 box[2] = { packet.points.at(0), packet.points.at(0) };
  for (int lane = 1; lane < lanes; ++lane)
  {
    box[0] = box[0].cwiseMin(packet.points.at(lane));
    box[1] = box[1].cwiseMax(packet.points.at(lane));
  }
  Pending pending[(lanes - 1) * maxLevels + 1];
  int size = 0;
  if (!this->empty())
  {
    pending[size++] = { 0.0, 0, static_cast<int>(m_levels.size()) - 1 };
  }
  bool isKnownInReach = true; // the last on the stack
  while (size > 0)
  {
    const Pending node = pending[--size];
    if (!isKnownInReach && !this->isInReach(packet, node))
    {
      continue;
    }
    isKnownInReach = false;
    if (node.level >= 0)
    {
      const int before = size;
      size = this->pushChildren(packet, box, node, pending, size);
      isKnownInReach = size > before;
      continue;
    }
    const Index end = std::min<Index>(this->size(), (node.id + 1) * leafSize);
    for (Index slot = node.id * leafSize; slot < end; ++slot)
    {
      if (std::find(hints.begin(), hints.end(), slot) == hints.end())
      {
        this->takeCloser(slot, packet);
      }
    }
  }
}
}
