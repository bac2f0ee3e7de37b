#include "Features/PassedPoints.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace remesh
{
namespace
{
constexpr double rounding = 1e-12; // of a section's length

/** Of the way from one place to another, up to the nearest to a third one; [0, 1]. */
double nearestShare(const Point3& place, const Point3& from, const Point3& to)
{
  const double squared = (to - from).squaredNorm();
  return squared > 0.0 ? std::clamp((place - from).dot(to - from) / squared, 0.0, 1.0) : 0.0;
}

struct Foot
{
  Station station;
  Point3 place;
};

/** The part of a curve between two stations next to each other, and its chord. */
class Section
{
public:
  Section(
    const SurfaceMesh& mesh, const FeatureCurve& curve, const Station& begin, const Station& end)
    : m_points(mesh.points)
    , m_curve(curve.points)
    , m_begin(begin)
    , m_end(end)
    , m_from(this->placeAt(begin))
    , m_to(this->placeAt(end))
  {
    Point3 last = m_from;
    for (Index segment = begin.segment + 1; segment <= end.segment; ++segment)
    {
      const Point3& next = mesh.points[curve.points[segment]];
      m_length += (next - last).norm();
      last = next;
    }
    m_length += (m_to - last).norm();
  }

  /** Whether it has places beside its chord at all. */
  bool bends() const { return m_length > (1.0 + rounding) * (m_to - m_from).norm(); }

  /** The values of a coordinate of the places that may be passed. */
  std::pair<double, double> reach(int axis) const
  {
    const double middle = 0.5 * (m_from[axis] + m_to[axis]);
    return { middle - 0.5 * m_length, middle + 0.5 * m_length };
  }

  /** Whether a place is near enough to be between a part that bends one way and its chord. */
  bool mayPass(const Point3& place) const
  {
    return (place - m_from).norm() + (place - m_to).norm() < m_length;
  }

  /** Whether the angle at a place, between its foot and the chord's nearest point, is obtuse. */
  bool passes(const Point3& place, const Point3& foot) const
  {
    const Point3 onChord = m_from + nearestShare(foot, m_from, m_to) * (m_to - m_from);
    return (place - foot).dot(place - onChord) < 0.0;
  }

  Foot footOf(const Point3& place) const
  {
    Foot nearest;
    double squared = std::numeric_limits<double>::infinity();
    const auto segments = static_cast<Index>(m_curve.size()) - 1;
    for (Index segment = m_begin.segment; segment <= m_end.segment; ++segment)
    {
      const double first = segment == m_begin.segment ? m_begin.t : 0.0;
      const double last = segment == m_end.segment ? m_end.t : 1.0;
      const Point3 from = this->placeAt({ segment, first });
      const Point3 to = this->placeAt({ segment, last });
      const double share = nearestShare(place, from, to);
      const Point3 found = from + share * (to - from);
      if ((place - found).squaredNorm() < squared)
      {
        const double t = first + share * (last - first);
        squared = (place - found).squaredNorm();
        nearest = { stationIn(segment, t, segments), found };
      }
    }
    return nearest;
  }

private:
  Point3 placeAt(const Station& station) const
  {
    const Point3& start = m_points[m_curve[station.segment]];
    const Point3& end = m_points[m_curve[station.segment + 1]];
    return start + station.t * (end - start);
  }

  const std::vector<Point3>& m_points;
  const std::vector<Index>& m_curve; ///< points
  Station m_begin;
  Station m_end;
  Point3 m_from;
  Point3 m_to;
  double m_length = 0.0;
};
}

namespace
{
constexpr int axis = 0; // that points are ordered along

/** Calls `visit(point, foot)` for the points between a section and its chord, but for its ends. */
template <class Visit>
void visitPassed(const Section& section, const std::array<Index, 2>& ends,
  const std::vector<std::pair<double, Index>>& along, const FeatureSites& featureSites,
  const Visit& visit)
{
  const auto [least, most] = section.reach(axis);
  for (auto at = std::lower_bound(along.begin(), along.end(), std::pair(least, noIndex));
       at != along.end() && at->first <= most; ++at)
  {
    const Index point = at->second;
    const Point3& place = featureSites.points[point].place;
    if (point == ends[0] || point == ends[1] || !section.mayPass(place))
    {
      continue;
    }
    const Foot foot = section.footOf(place);
    if (section.passes(place, foot.place))
    {
      visit(point, foot.station);
    }
  }
}
}

std::vector<PassedPoint> findPassedPoints(const FeaturedSurface& featured,
  const FeatureSites& featureSites, const std::vector<Index>& points, const RunControl& control)
{
  std::vector<std::pair<double, Index>> along;
  for (const Index point : points)
  {
    along.emplace_back(featureSites.points[point].place[axis], point);
  }
  std::sort(along.begin(), along.end());
  std::vector<PassedPoint> found;
  const std::size_t curves = along.empty() ? 0 : featureSites.stations.size();
  for (std::size_t c = 0; c < curves && !control.cancelled(); ++c)
  {
    const std::vector<Station>& stations = featureSites.stations[c];
    const std::vector<Index>& ends = featureSites.curvePoints[c];
    for (std::size_t k = 0; k + 1 < stations.size(); ++k)
    {
      const Section section(
        featured.mesh, featured.features.curves[c], stations[k], stations[k + 1]);
      if (section.bends())
      {
        visitPassed(section, { ends[k], ends[k + 1] }, along, featureSites,
          [&](Index point, const Station& foot) {
            found.push_back({ point, static_cast<Index>(c), static_cast<Index>(k), foot });
          });
      }
    }
  }
  return found;
}
}
