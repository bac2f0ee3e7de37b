/**
 * @file NormalVariation.cxx
 *
 * 1. Facets are looked for that are long against the spacing in R^3, which is less than that in
 *    R^6, and whose own normals differ from those of their corners. As a rule there are none.
 * 2. In each round the normals of the corners are found anew, and from them the area in R^6 and the
 *    spacing there; then the edges that are too long.
 */
#include "Refinement/NormalVariation.h"

#include "Embedding/Embedding.h"
#include "Mesh/FacetGeometry.h"
#include "Mesh/NormalFlow.h"
#include "Support/Grouping.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace remesh
{
namespace
{
/** Of the spacing: what is shorter is no larger than the cells. */
constexpr double longest = 2.0;
/** Of the spacing: how far the linear map may be from what the normals are. */
constexpr double maxDeviation = 0.1;
/**
 * Of the angle between a given normal and the facet's plane: beyond 45 degrees it is that of a tip,
 * and nothing that the inside of the facet comes near to.
 */
constexpr double minCosine = 0.7071;
/** Of the rounding of coordinates: facets that are lower are not split. */
constexpr double minRoundings = 64.0;

constexpr Offset facetsPerFacet = 2;
constexpr Offset facetsPerSite = 4;

using Normals = std::array<Point3, 3>;

Point3 unit(const Point3& vector)
{
  const double squared = vector.squaredNorm();
  return squared > 0.0 ? Point3(vector / std::sqrt(squared)) : vector;
}

Normals pointsOf(const SurfaceMesh& mesh, Index facet)
{
  const auto& [a, b, c] = mesh.facetPoints[facet];
  return { mesh.points[a], mesh.points[b], mesh.points[c] };
}

double longestLength(const Normals& points)
{
  return std::sqrt(std::max({ (points[1] - points[0]).squaredNorm(),
    (points[2] - points[1]).squaredNorm(), (points[0] - points[2]).squaredNorm() }));
}

/** Between the normals that a facet has of its own and those of its corners. */
double largestDifference(
  const Normals& own, const Triple& corners, const std::vector<Point3>& normals)
{
  double squared = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    squared = std::max(squared, (own[k] - normals[corners[k]]).squaredNorm());
  }
  return std::sqrt(squared);
}

/** Step 1. */
bool mayNeedSplits(const OwnNormals& own, double s, Offset sites, const RunControl& control)
{
  const SurfaceMesh& mesh = own.mesh();
  const double spacing = meanSpacing(mesh, sites);
  const auto isLarge = [&](Offset item)
  {
    const auto facet = static_cast<Index>(item);
    return longestLength(pointsOf(mesh, facet)) > longest * spacing &&
      s * largestDifference(own.of(facet), mesh.facetCorners[facet], own.cornerNormals()) >
      maxDeviation * spacing;
  };
  return countItems(mesh.numberOfFacets(), control, isLarge) > 0;
}

/** The normals of a surface as it is split. */
class SplitNormals
{
public:
  explicit SplitNormals(const OwnNormals& own)
    : m_own(own)
  {
    m_before.reserve(own.mesh().facetPoints.size());
    for (Index f = 0; f < own.mesh().numberOfFacets(); ++f)
    {
      m_before.push_back(own.of(f));
    }
  }

  Normals of(const FacetOrigin& origin) const
  {
    const Normals& before = m_before[origin.facet];
    if (!m_own.areGiven())
    {
      return before;
    }
    Normals normals;
    for (int k = 0; k < 3; ++k)
    {
      normals[k] = Point3::Zero();
      for (int j = 0; j < 3; ++j)
      {
        normals[k] += static_cast<double>(origin.corners[k][j]) * before[j];
      }
      normals[k] = unit(normals[k]);
    }
    return normals;
  }

  std::vector<Point3> ofCorners(const RefinedSurface& surface) const
  {
    return m_own.areGiven() ? this->givenOf(surface) : this->estimatedOf(surface);
  }

private:
  std::vector<Point3> estimatedOf(const RefinedSurface& surface) const
  {
    std::vector<FacetNormal> planes;
    planes.reserve(surface.origins.size());
    for (const FacetOrigin& origin : surface.origins)
    {
      planes.push_back({ static_cast<Index>(planes.size()), m_before[origin.facet][0] });
    }
    return estimateCornerNormals(surface.mesh, 0, RunControl(), planes);
  }

  /** Corners that there were keep theirs. */
  std::vector<Point3> givenOf(const RefinedSurface& surface) const
  {
    const SurfaceMesh& mesh = surface.mesh;
    std::vector<Point3> normals(mesh.cornerPoints.size(), Point3::Zero());
    std::vector<char> known(normals.size(), 0);
    for (std::size_t f = 0; f < surface.origins.size(); ++f)
    {
      const FacetOrigin& origin = surface.origins[f];
      const Normals own = this->of(origin);
      for (int k = 0; k < 3; ++k)
      {
        const Index corner = mesh.facetCorners[f][k];
        const auto& place = origin.corners[k];
        const auto old = std::find(place.begin(), place.end(), 1.0F) - place.begin();
        known[corner] |= old < 3;
        normals[corner] = old < 3
          ? m_own.cornerNormals()[m_own.mesh().facetCorners[origin.facet][old]]
          : normals[corner] + own[k];
      }
    }
    for (std::size_t c = 0; c < normals.size(); ++c)
    {
      normals[c] = known[c] ? normals[c] : unit(normals[c]);
    }
    return normals;
  }

  const OwnNormals& m_own;
  std::vector<Normals> m_before; ///< F, of the surface before any split
};

/** Step 2: tells a round which edges are too long. */
class Criterion
{
public:
  Criterion(const SplitNormals& splitNormals, double s, Offset sites)
    : m_splitNormals(splitNormals)
    , m_s(s)
    , m_sites(sites)
  {
  }

  void operator()(const RefinedSurface& surface, const EdgeTable& edges, EdgesToSplit& wanted)
  {
    m_normals = m_splitNormals.ofCorners(surface);
    const double spacing = this->spacingOf(surface.mesh);
    measure(surface.mesh, edges, wanted);
    wanted.marked.assign(wanted.lengths.size(), 0);
    const double minHeight = minRoundings * roundingOf(surface.mesh);
    for (Index f = 0; f < surface.mesh.numberOfFacets(); ++f)
    {
      const Triple& sides = edges.facetEdges[f];
      const int side = longestSide(sides, wanted);
      const double length = wanted.lengths[sides[side]];
      if (!(length > longest * spacing))
      {
        continue;
      }
      const double height = 2.0 * facetArea(surface.mesh, f) / length;
      const Normals own = m_splitNormals.of(surface.origins[f]);
      if (height > longest * spacing &&
        m_s * largestDifference(own, surface.mesh.facetCorners[f], m_normals) >
          maxDeviation * spacing)
      {
        wanted.marked[sides[side]] = 1;
      }
      for (int k = 0; k < 3 && height > minHeight; ++k)
      {
        if (wanted.lengths[sides[k]] > longest * spacing && !wanted.marked[sides[k]])
        {
          wanted.marked[sides[k]] =
            m_s * this->deviationAt(surface, edges, f, k) > maxDeviation * spacing;
        }
      }
    }
  }

  std::vector<Point3>& normals() { return m_normals; }

private:
  static void measure(const SurfaceMesh& mesh, const EdgeTable& edges, EdgesToSplit& wanted)
  {
    wanted.lengths.resize(static_cast<std::size_t>(edges.numberOfEdges()));
    for (Index f = 0; f < mesh.numberOfFacets(); ++f)
    {
      const Normals points = pointsOf(mesh, f);
      for (int k = 0; k < 3; ++k)
      {
        wanted.lengths[edges.facetEdges[f][k]] = (points[(k + 1) % 3] - points[k]).norm();
      }
    }
  }

  static double roundingOf(const SurfaceMesh& mesh)
  {
    double largest = 0.0;
    for (const Point3& point : mesh.points)
    {
      largest = std::max(largest, point.cwiseAbs().maxCoeff());
    }
    return DBL_EPSILON * largest;
  }

  double spacingOf(const SurfaceMesh& mesh) const
  {
    double area = 0.0;
    for (Index f = 0; f < mesh.numberOfFacets(); ++f)
    {
      Eigen::Matrix<double, 6, 3> places;
      for (int k = 0; k < 3; ++k)
      {
        places.col(k) << mesh.points[mesh.facetPoints[f][k]],
          m_s * m_normals[mesh.facetCorners[f][k]];
      }
      area += triangleArea(places.col(0).data(), places.col(1).data(), places.col(2).data(), 6);
    }
    return std::sqrt(area / static_cast<double>(m_sites));
  }

  /** Between the normal at the middle of a side, of all facets there, and the mean of its ends. */
  double deviationAt(
    const RefinedSurface& surface, const EdgeTable& edges, Index facet, int side) const
  {
    const SurfaceMesh& mesh = surface.mesh;
    const Index edge = edges.facetEdges[facet][side];
    const Index a = mesh.facetCorners[facet][side];
    const Index b = mesh.facetCorners[facet][(side + 1) % 3];
    Point3 middle = Point3::Zero();
    for (Index i = edges.edgeFacetsBegin[edge]; i < edges.edgeFacetsBegin[edge + 1]; ++i)
    {
      const Index other = edges.edgeFacets[i];
      const Triple& corners = mesh.facetCorners[other];
      const int k = edges.sideOf(other, edge);
      const int next = (k + 1) % 3;
      const bool isJoined =
        (corners[k] == a && corners[next] == b) || (corners[k] == b && corners[next] == a);
      if (isJoined)
      {
        const Normals own = m_splitNormals.of(surface.origins[other]);
        middle += unit(own[k] + own[next]);
      }
    }
    return (unit(middle) - 0.5 * (m_normals[a] + m_normals[b])).norm();
  }

  const SplitNormals& m_splitNormals;
  double m_s;
  Offset m_sites;
  std::vector<Point3> m_normals; ///< C, of the last surface looked at
};
}

OwnNormals::OwnNormals(const SurfaceMesh& mesh, const std::vector<FacetNormal>& borrowed,
  const std::vector<Point3>& normals, const std::vector<Point3>* given)
  : m_mesh(mesh)
  , m_borrowed(borrowed)
  , m_normals(normals)
  , m_given(given)
{
  if (given)
  {
    m_cutPoints = findCutPoints(mesh);
  }
}

std::array<Point3, 3> OwnNormals::of(Index facet) const
{
  const Point3 plane = normalOf(m_mesh, m_borrowed, static_cast<std::size_t>(facet));
  if (!m_given)
  {
    return { plane, plane, plane };
  }
  const std::array<Offset, 3> inputs = m_mesh.facetInputPoints[facet];
  std::array<Point3, 3> own;
  std::array<bool, 3> areNear{};
  for (int k = 0; k < 3; ++k)
  {
    const Point3 normal = (*m_given)[inputs[k]].stableNormalized();
    const bool counts = !m_cutPoints[m_mesh.facetPoints[facet][k]] && normal.squaredNorm() > 0.5;
    own[k] = counts ? normal : m_normals[m_mesh.facetCorners[facet][k]];
    areNear[k] = own[k].dot(plane) >= minCosine;
  }
  const bool anyNear = areNear[0] || areNear[1] || areNear[2];
  for (int k = 0; k < 3 && anyNear; ++k)
  {
    own[k] = areNear[k] ? own[k] : plane;
  }
  return own;
}

bool refineForNormals(const OwnNormals& own, const Features* features, double s, Offset sites,
  const RunControl& control, RefinedSurface& refined, std::vector<Point3>& normals)
{
  if (!(s > 0.0) || !mayNeedSplits(own, s, sites, control))
  {
    return false;
  }
  refined = wholeSurface(own.mesh(), features);
  const SplitNormals splitNormals(own);
  Criterion criterion(splitNormals, s, sites);
  const RefinementLimits limits{ std::min<Offset>(facetsPerFacet * own.mesh().numberOfFacets() +
      facetsPerSite * std::min(sites, Offset(maximumIndex)),
    maximumIndex) };
  const bool any = refine([&](const RefinedSurface& surface, const EdgeTable& edges,
                            EdgesToSplit& wanted) { criterion(surface, edges, wanted); },
    limits, control, refined);
  if (any)
  {
    normals = splitNormals.ofCorners(refined);
  }
  return any;
}
}
