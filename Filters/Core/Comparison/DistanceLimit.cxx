#include "Comparison/DistanceLimit.h"

#include "Mesh/FacetGeometry.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
constexpr double farShare = 0.95; // of the limit
constexpr double overlap = 0.01;  // of the limit, of parts beyond triangles, for no slivers
constexpr double mostSize = 4.0;  // of a part that is cut along a triangle, squared
constexpr double leastCosine = 0.8;
constexpr std::size_t mostParts = 1000000;
constexpr std::size_t partsBetweenQuestions = 4096;

struct Part
{
  std::array<Point3, 3> corners;
  Index hint;
  bool isInside = false; ///< of a side of the hinted triangle, along which it was cut
};

/** Examines one triangle after the other; one per thread. */
class Examiner
{
public:
  Examiner(const TriangleTree& to, double limit, const RunControl& control)
    : m_to(to)
    , m_limit(limit)
    , m_control(control)
  {
  }

  /** Whether the triangle has a far place; also true when cancelled. */
  bool isFar(const std::array<Point3, 3>& corners, FarPlace& far)
  {
    m_open.assign(1, { corners, m_lastSlot });
    std::size_t examined = 0;
    while (!m_open.empty())
    {
      m_next.clear();
      far.distance = -1.0;
      for (const Part& part : m_open)
      {
        this->examine(part, far);
        ++examined;
        if (examined > mostParts ||
          (examined % partsBetweenQuestions == 0 && m_control.cancelled()))
        {
          return true;
        }
      }
      if (far.distance > farShare * m_limit)
      {
        return true;
      }
      m_open.swap(m_next);
    }
    return false;
  }

private:
  /**
   * Leaves the part alone or cuts it, and keeps its centroid if that is farthest so far. What the
   * triangle of the part it was cut from tells of it spares a search.
   */
  void examine(const Part& part, FarPlace& far)
  {
    if (part.hint != noIndex && this->isWithin(part.corners, part.hint))
    {
      return;
    }
    if (part.isInside && this->cutAlong(part.hint, part))
    {
      return;
    }
    const Point3 centroid = (part.corners[0] + part.corners[1] + part.corners[2]) / 3.0;
    const TriangleTree::Place place = m_to.closest(centroid, part.hint);
    m_lastSlot = place.slot;
    const double distance = std::sqrt(place.at.squared);
    if (distance > far.distance)
    {
      far.place = centroid;
      far.distance = distance;
    }
    double reach = 0.0;
    for (const Point3& corner : part.corners)
    {
      reach = std::max(reach, (corner - centroid).squaredNorm());
    }
    if (distance + std::sqrt(reach) > m_limit && !this->isWithin(part.corners, place.slot) &&
      !this->cutAlong(place.slot, part))
    {
      this->cutIntoFour(place.slot, part);
    }
  }

  /** The square of a triangle's longest edge. */
  static double squaredSize(const std::array<Point3, 3>& corners)
  {
    const auto& [a, b, c] = corners;
    return std::max({ (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm() });
  }

  /** Whether a part is within the limit of a triangle, a convex set. */
  bool isWithin(const std::array<Point3, 3>& corners, const Index slot) const
  {
    return std::all_of(corners.begin(), corners.end(),
      [&](const Point3& corner)
      { return m_to.closestOn(slot, corner).at.squared <= m_limit * m_limit; });
  }

  /**
   * Cuts a part along that side of the prism over a triangle which it sticks out from most: what is
   * inside has one side less to stick out from. False for parts that are much larger than the
   * triangle, lean against it, or do not stick out.
   */
  bool cutAlong(Index slot, const Part& part)
  {
    const std::array<Point3, 3> t = m_to.cornersOf(slot);
    const Point3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const auto& [a, b, c] = part.corners;
    const Point3 own = (b - a).cross(c - a);
    if (squaredSize(part.corners) > mostSize * squaredSize(t) ||
      std::abs(own.dot(normal)) < leastCosine * own.norm() * normal.norm())
    {
      return false;
    }
    double lowest = -overlap * m_limit;
    Point3 origin = t[0];
    Point3 inwards = Point3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      const Point3 side = normal.cross(t[(k + 1) % 3] - t[k]).normalized();
      for (const Point3& corner : part.corners)
      {
        if (const double height = (corner - t[k]).dot(side); height < 2.0 * lowest)
        {
          lowest = 0.5 * height;
          origin = t[k];
          inwards = side;
        }
      }
    }
    return inwards.squaredNorm() > 0.0 && this->cut(part, slot, origin, inwards);
  }

  /**
   * Cuts a part by a plane, moved outwards by the overlap. Corners a tenth of that beyond are
   * inside still, as those that earlier cuts made are. False if nothing is truly inside.
   */
  bool cut(const Part& part, Index slot, const Point3& origin, const Point3& inwards)
  {
    const double shift = overlap * m_limit;
    std::array<double, 3> heights{};
    for (int k = 0; k < 3; ++k)
    {
      heights[k] = (part.corners[k] - origin).dot(inwards);
    }
    if (!(*std::max_element(heights.begin(), heights.end()) > 0.0))
    {
      return false;
    }
    const auto isInside = [&](int k) { return heights[k] >= -1.1 * shift; };
    m_inner.clear();
    m_outer.clear();
    for (int k = 0; k < 3; ++k)
    {
      const int next = (k + 1) % 3;
      (isInside(k) ? m_inner : m_outer).push_back(part.corners[k]);
      if (isInside(k) != isInside(next))
      {
        const double along = (heights[k] + shift) / (heights[k] - heights[next]);
        const Point3 crossing =
          part.corners[k] + std::clamp(along, 0.0, 1.0) * (part.corners[next] - part.corners[k]);
        m_inner.push_back(crossing);
        m_outer.push_back(crossing);
      }
    }
    this->pushFan(m_inner, slot, true);
    this->pushFan(m_outer, slot, false);
    return true;
  }

  void pushFan(const std::vector<Point3>& polygon, Index hint, bool isInside)
  {
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    {
      m_next.push_back({ { polygon[0], polygon[k], polygon[k + 1] }, hint, isInside });
    }
  }

  void cutIntoFour(Index hint, const Part& part)
  {
    const auto& [a, b, c] = part.corners;
    const Point3 ab = 0.5 * (a + b);
    const Point3 bc = 0.5 * (b + c);
    const Point3 ca = 0.5 * (c + a);
    m_next.push_back({ { a, ab, ca }, hint });
    m_next.push_back({ { ab, b, bc }, hint });
    m_next.push_back({ { ca, bc, c }, hint });
    m_next.push_back({ { bc, ca, ab }, hint });
  }

  const TriangleTree& m_to;
  double m_limit;
  const RunControl& m_control;
  std::vector<Part> m_open;
  std::vector<Part> m_next;
  std::vector<Point3> m_inner; // polygons
  std::vector<Point3> m_outer;
  Index m_lastSlot = noIndex;
};
}

Status findPlacesBeyond(const Triangles& from, const TriangleTree& to, double limit,
  const RunControl& control, std::vector<FarPlace>& places)
{
  const Blocks blocks = Blocks::cut(from.count(), 1024, 1024);
  std::vector<std::vector<FarPlace>> found(static_cast<std::size_t>(blocks.count()));
  const bool done = forEachBlock(blocks.count(), control,
    [&](Offset block)
    {
      Examiner examiner(to, limit, control);
      for (Offset t = blocks.begin(block); t < blocks.end(block); ++t)
      {
        const std::array<Point3, 3> corners = from.corners(t);
        FarPlace far{ static_cast<Index>(t), Point3::Zero(), 0.0 };
        if (hasArea(corners[0], corners[1], corners[2]) && examiner.isFar(corners, far))
        {
          found[block].push_back(far);
        }
      }
    });
  places.clear();
  for (const std::vector<FarPlace>& some : found)
  {
    places.insert(places.end(), some.begin(), some.end());
  }
  return done && !control.cancelled() ? Status::success() : Status::cancelled();
}
}
