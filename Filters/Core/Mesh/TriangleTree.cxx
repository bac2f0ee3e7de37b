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
  , m_boxes(this->leaves(), control.silent(),
      [this](Index leaf, Point3& lower, Point3& upper)
      {
        const Index end = std::min<Index>((leaf + 1) * leafSize, this->size());
        for (Index slot = leaf * leafSize; slot < end; ++slot)
        {
          for (const Point3& corner : this->cornersOf(slot))
          {
            lower = lower.cwiseMin(corner);
            upper = upper.cwiseMax(corner);
          }
        }
      })
{
}

/** The groups, from this one on, whose boxes meet this one's; in the tree's order. */
void TriangleTree::findGroups(Index group, std::vector<Index>& groups) const
{
  Point3 lower = Point3::Constant(std::numeric_limits<double>::infinity());
  Point3 upper = -lower;
  BoxTree::widen(m_boxes.node(0, group), lower, upper);
  // Level by level, from the root, those nodes that have any such group.
  groups.assign(1, 0);
  std::vector<Index> children;
  for (int level = m_boxes.levels() - 1; level > 0; --level)
  {
    const Index first = BoxTree::ancestor(group, level - 1);
    children.clear();
    for (const Index node : groups)
    {
      for (unsigned bits = m_meet({ m_boxes.node(level, node), lower.data(), upper.data() });
           bits != 0; bits &= bits - 1)
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
  m_boxes.visitLeaves(0, this->leaves() - 1, point, reaches,
    [&](Index leaf)
    {
      const Index end = std::min<Index>((leaf + 1) * leafSize, this->size());
      for (Index slot = leaf * leafSize; slot < end; ++slot)
      {
        visit(slot);
      }
    });
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
  const BoxGroup& boxes = m_boxes.node(node.level, node.id);
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
    size =
      BoxTree::insert({ squared[k], node.id * lanes + k, node.level - 1 }, bottom, pending, size);
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
  const BoxGroup& boxes = m_boxes.node(node.level + 1, node.id / lanes);
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
  Pending pending[BoxTree::maxPending];
  int size = 0;
  if (!m_boxes.empty())
  {
    pending[size++] = m_boxes.root();
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
