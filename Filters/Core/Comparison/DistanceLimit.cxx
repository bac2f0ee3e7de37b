#include "Comparison/DistanceLimit.h"

#include "Comparison/SurfaceParts.h"
#include "Mesh/FacetGeometry.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
constexpr double farShare = 0.95; // of the limit
constexpr Offset maxParts = 1000000;
constexpr Offset maxSlices = 4000; // of one triangle
constexpr Offset partsBetweenQuestions = 4096;

/** Examines one triangle after the other; one per thread. */
class Examiner
{
public:
  Examiner(const TriangleTree& to, double limit, const RunControl& control)
    : m_to(to)
    , m_limit(limit)
    , m_control(control)
    , m_cutter(to, limit)
  {
  }

  /** Whether the triangle has a far place; also true when cancelled. */
  bool isFar(const std::array<Point3, 3>& corners, FarPlace& far)
  {
    m_open.assign(1, { corners, m_lastSlot });
    Offset examined = 0;
    while (!m_open.empty())
    {
      m_next.clear();
      far.distance = -1.0;
      for (const SurfacePart& part : m_open)
      {
        this->examine(part, far);
        ++examined;
        if (examined > maxParts || (examined % partsBetweenQuestions == 0 && m_control.cancelled()))
        {
          this->note(part, far); // it may be the first that is searched for
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
  void examine(const SurfacePart& part, FarPlace& far)
  {
    if (part.hint != noIndex && this->isWithin(part.corners, part.hint))
    {
      return;
    }
    if (part.isInside && m_cutter.cutAlong(part.hint, part, m_next))
    {
      return;
    }
    const double distance = this->note(part, far);
    const Offset room = maxParts - std::min(maxParts, static_cast<Offset>(m_next.size()));
    if (distance + part.reach() > m_limit && !this->isWithin(part.corners, m_lastSlot) &&
      !m_cutter.cutAcross(m_lastSlot, part, std::min(maxSlices, room), m_next))
    {
      m_cutter.cut(m_lastSlot, part, m_next);
    }
  }

  /** Searches for the centroid, and keeps it if it is farthest so far; its distance. */
  double note(const SurfacePart& part, FarPlace& far)
  {
    const Point3 centroid = part.centroid();
    const TriangleTree::Place place = m_to.closest(centroid, part.hint);
    m_lastSlot = place.slot;
    const double distance = std::sqrt(place.at.squared);
    if (distance > far.distance)
    {
      far.place = centroid;
      far.distance = distance;
    }
    return distance;
  }

  /** Whether a part is within the limit of a triangle, a convex set. */
  bool isWithin(const std::array<Point3, 3>& corners, const Index slot) const
  {
    return std::all_of(corners.begin(), corners.end(),
      [&](const Point3& corner)
      { return m_to.closestOn(slot, corner).at.squared <= m_limit * m_limit; });
  }

  const TriangleTree& m_to;
  double m_limit;
  const RunControl& m_control;
  PartCutter m_cutter;
  std::vector<SurfacePart> m_open;
  std::vector<SurfacePart> m_next;
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
