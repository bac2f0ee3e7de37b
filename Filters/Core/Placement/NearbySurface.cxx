#include "Placement/NearbySurface.h"

#include "Mesh/ClosestPoint.h"
#include "Mesh/FacetGeometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace remesh
{
namespace
{
constexpr Offset fewPieces = 64; // of a cell: all are looked at
/** Of squared distances, which must not rule out what is as close. */
constexpr double roundingOfSquared = 1e-9;

Point3 centroidOf(const std::array<Point3, 3>& corners)
{
  return (corners[0] + corners[1] + corners[2]) / 3.0;
}

/** At least the distance from each facet's first point to the others. */
std::vector<float> findReaches(const SurfaceMesh& mesh, const RunControl& control)
{
  using Limits = std::numeric_limits<float>;
  std::vector<float> reaches(mesh.facetPoints.size());
  static_cast<void>(forEachItem(static_cast<Offset>(reaches.size()), control,
    [&](Offset f)
    {
      const auto& [a, b, c] = mesh.facetPoints[f];
      const Point3& first = mesh.points[a];
      const double reach = std::sqrt(
        std::max((mesh.points[b] - first).squaredNorm(), (mesh.points[c] - first).squaredNorm()));
      reaches[f] = std::nextafter(
        static_cast<float>(std::min<double>(reach, Limits::max())), Limits::infinity());
    }));
  return reaches;
}

/** Boxes of runs of pieces, as they are grouped by components; none if all of these are small. */
BoxTree findBoxes(const PlacementProblem& problem, Index runLength, const RunControl& control)
{
  const std::vector<Offset>& begins = problem.components.pieceBegin;
  const auto isLarge = [](Offset begin, Offset end) { return end - begin > fewPieces; };
  if (std::adjacent_find(begins.begin(), begins.end(), isLarge) == begins.end())
  {
    return {};
  }
  const std::vector<Index>& pieces = problem.components.pieces;
  const auto count = static_cast<Offset>(pieces.size());
  return BoxTree(static_cast<Index>((count + runLength - 1) / runLength), control,
    [&](Index run, Point3& lower, Point3& upper)
    {
      const Offset begin = static_cast<Offset>(run) * runLength;
      for (Offset p = begin; p < std::min(begin + runLength, count); ++p)
      {
        const Index facet = problem.diagram.facets[pieces[p]];
        for (int k = 0; k < 3; ++k)
        {
          lower = lower.cwiseMin(problem.facetPoint(facet, k));
          upper = upper.cwiseMax(problem.facetPoint(facet, k));
        }
      }
    });
}
}

NearbySurface::NearbySurface(
  const PlacementProblem& problem, const RunControl& control, double minHeight)
  : m_problem(problem)
  , m_leastHeight(minHeight)
  , m_bounds(std::make_shared<const Bounds>(Bounds{ findReaches(problem.mesh, control.silent()),
      findBoxes(problem, leafSize, control.silent()) }))
{
}

NearbySurface::NearbySurface(const NearbySurface& own, const WholeSurface& whole)
  : NearbySurface(own)
{
  m_whole = &whole;
}

SurfaceLocation NearbySurface::closest(
  const Index* begin, const Index* end, const Point3& point) const
{
  const Components& components = m_problem.components;
  SurfaceLocation location{ noIndex, { 0.0, 0.0, 0.0 } };
  double nearest2 = std::numeric_limits<double>::infinity();
  double nearest = nearest2;
  const auto lookAt = [&](Offset first, Offset last)
  {
    for (Offset p = first; p < last; ++p)
    {
      const Index facet = m_problem.diagram.facets[components.pieces[p]];
      const Point3& a = m_problem.facetPoint(facet, 0);
      const double bound = nearest + m_bounds->reach[facet];
      if ((a - point).squaredNorm() > bound * bound)
      {
        continue;
      }
      const ClosestPoint found =
        closestOnTriangle(point, a, m_problem.facetPoint(facet, 1), m_problem.facetPoint(facet, 2));
      if (found.squared < nearest2 || (found.squared == nearest2 && facet < location.facet))
      {
        nearest2 = found.squared;
        nearest = std::sqrt(found.squared);
        location.facet = facet;
        std::copy_n(found.b, 3, location.b);
      }
    }
  };
  for (const Index* component = begin; component != end; ++component)
  {
    const Offset first = components.pieceBegin[*component];
    const Offset last = components.pieceBegin[*component + 1];
    if (last - first <= fewPieces)
    {
      lookAt(first, last);
      continue;
    }
    m_bounds->boxes.visitLeaves(
      static_cast<Index>(first / leafSize), static_cast<Index>((last - 1) / leafSize), point,
      [&](double squared) { return squared <= (1.0 + roundingOfSquared) * nearest2; },
      [&](Index leaf)
      {
        const Offset at = static_cast<Offset>(leaf) * leafSize;
        lookAt(std::max(first, at), std::min(last, at + leafSize));
      });
  }
  return location;
}

bool NearbySurface::isFlat(const std::array<Point3, 3>& corners) const
{
  constexpr double sliver = 0.01; // of the length
  const double length = std::sqrt(std::max({ (corners[1] - corners[0]).squaredNorm(),
    (corners[2] - corners[1]).squaredNorm(), (corners[0] - corners[2]).squaredNorm() }));
  return 2.0 * facetArea(corners[0], corners[1], corners[2]) <
    length * std::min(m_leastHeight, sliver * length);
}

Point3 NearbySurface::closestPoint(const Index* begin, const Index* end, const Point3& point) const
{
  const SurfaceLocation at = this->closest(begin, end, point);
  return at.facet == noIndex ? point : this->positionOf(at);
}

SurfaceLocation NearbySurface::locationNear(
  const Triple& components, const std::array<Point3, 3>& corners) const
{
  return this->closest(components.data(), components.data() + 3, centroidOf(corners));
}

Point3 NearbySurface::positionOf(const SurfaceLocation& at) const
{
  return at.b[0] * m_problem.facetPoint(at.facet, 0) + at.b[1] * m_problem.facetPoint(at.facet, 1) +
    at.b[2] * m_problem.facetPoint(at.facet, 2);
}

Point3 NearbySurface::normalOf(Index facet) const
{
  return facet == noIndex ? Point3(Point3::Zero())
                          : facetNormal(m_problem.facetPoint(facet, 0),
                              m_problem.facetPoint(facet, 1), m_problem.facetPoint(facet, 2));
}

Point3 NearbySurface::normalNear(
  const Triple& components, const std::array<Point3, 3>& corners) const
{
  return this->normalOf(this->locationNear(components, corners).facet);
}

Facing NearbySurface::facingOf(const Triple& components, const std::array<Point3, 3>& corners) const
{
  const Point3 normal = facetNormal(corners[0], corners[1], corners[2]);
  const SurfaceLocation own = this->locationNear(components, corners);
  const Point3 wanted = this->normalOf(own.facet);
  if (normal.isZero(0.0) || wanted.isZero(0.0) || this->isFlat(corners))
  {
    return { -1.0, -1.0 };
  }
  const double cosine = normal.dot(wanted);
  if (!m_whole || cosine < 0.0)
  {
    return { cosine, cosine };
  }
  // Right above its own facet, others that are as close lie in the very same place.
  const Point3 centroid = centroidOf(corners);
  const bool isAbove = *std::min_element(own.b, own.b + 3) > 0.0;
  const double within =
    isAbove ? (this->positionOf(own) - centroid).norm() : std::numeric_limits<double>::infinity();
  return { cosine, std::min(cosine, m_whole->minCosine(centroid, normal, own.facet, within)) };
}

bool NearbySurface::isInverted(
  const Triple& components, const std::array<Point3, 3>& corners, const NormalCones& cones) const
{
  const Point3 normal = facetNormal(corners[0], corners[1], corners[2]);
  const bool facesAll = !m_whole &&
    std::all_of(components.begin(), components.end(),
      [&](Index component) { return cones.allAlong(component, normal); }) &&
    !this->isFlat(corners);
  return !facesAll && this->isInverted(components, corners);
}
}
