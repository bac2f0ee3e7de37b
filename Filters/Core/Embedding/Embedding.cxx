#include "Embedding/Embedding.h"

#include "Embedding/CornerReader.h"
#include "Embedding/Distance.h"
#include "Support/Parallel.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
/** Of a facet with these corners. */
void measureEdges(int d, const std::array<const double*, 3>& p, FacetConstants& constants)
{
  for (int k = 0; k < 3; ++k)
  {
    constants.edge2[k] = squaredDistance<Eigen::Dynamic>(p[k], p[(k + 1) % 3], d);
  }
}

/** Squared edges and area of one facet. */
FacetConstants measureFacet(int d, const std::array<const double*, 3>& p)
{
  FacetConstants constants;
  constants.mass = triangleArea(p[0], p[1], p[2], d);
  measureEdges(d, p, constants);
  return constants;
}

/** The least and the largest value of each coordinate. */
Status findRanges(
  const CornerCoordinates& coordinates, std::vector<double>& lower, std::vector<double>& upper)
{
  std::vector<double> scratch;
  const double* first = coordinates.row(0, scratch);
  lower.assign(first, first + coordinates.dimension);
  upper = lower;
  for (Offset c = 0; c < coordinates.count(); ++c)
  {
    const double* x = coordinates.row(static_cast<Index>(c), scratch);
    for (int k = 0; k < coordinates.dimension; ++k)
    {
      if (!std::isfinite(x[k]))
      {
        return Status::invalid(
          "The embedding has a coordinate that is not a finite number (component " +
          std::to_string(k) + ").");
      }
      lower[k] = std::min(lower[k], x[k]);
      upper[k] = std::max(upper[k], x[k]);
    }
  }
  return Status::success();
}

/**
 * About the middle of the coordinates' ranges, and the power of two not less than the largest
 * distance from there. The centre lies on a coarse grid, so that centring loses no more bits than
 * it must (see roundToCaller).
 */
Status findFrame(const CornerCoordinates& coordinates, EmbeddedSurface& surface)
{
  const int d = coordinates.dimension;
  std::vector<double> lower;
  std::vector<double> upper;
  if (Status status = findRanges(coordinates, lower, upper); !status.ok())
  {
    return status;
  }
  double largest = 0.0;
  for (int k = 0; k < d; ++k)
  {
    largest = std::max(largest, 0.5 * upper[k] - 0.5 * lower[k]);
  }
  int exponent = 0;
  std::frexp(1.125 * largest, &exponent); // room for half a step of the grid
  surface.unit = std::ldexp(1.0, exponent);
  surface.center.resize(d);
  for (int k = 0; k < d; ++k)
  {
    const double middle = 0.5 * lower[k] + 0.5 * upper[k];
    const double steps = middle / surface.unit * 16.0;
    surface.center[k] =
      std::abs(steps) < 0x1.0p52 ? std::round(steps) / 16.0 * surface.unit : middle;
  }
  if (!(largest > 0.0) || !std::isfinite(surface.unit) || largest < 1e-290)
  {
    return Status::invalid("The embedded surface is a single point, or too small or large to "
                           "compute with.");
  }
  return Status::success();
}
}

double triangleArea(const double* p1, const double* p2, const double* p3, int dimension)
{
  using Vector = Eigen::Map<const Eigen::VectorXd>;
  const Vector a(p1, dimension), b(p2, dimension), c(p3, dimension);
  // Height over the longest edge: no cancellation for slivers.
  const double ab = (b - a).squaredNorm();
  const double bc = (c - b).squaredNorm();
  const double ca = (a - c).squaredNorm();
  const double longest = std::max({ ab, bc, ca });
  if (!(longest > 0.0))
  {
    return 0.0;
  }
  const Vector& start = longest == ab ? a : (longest == bc ? b : c);
  const Vector& end = longest == ab ? b : (longest == bc ? c : a);
  const Vector& apex = longest == ab ? c : (longest == bc ? a : b);
  const double t = (end - start).dot(apex - start) / longest;
  const double height2 = ((apex - start) - t * (end - start)).squaredNorm();
  return 0.5 * std::sqrt(longest) * std::sqrt(height2);
}

CornerCoordinates positionCoordinates(const SurfaceMesh& mesh)
{
  CornerCoordinates coordinates;
  coordinates.dimension = 3;
  coordinates.values.reserve(3 * mesh.cornerPoints.size());
  for (const Index point : mesh.cornerPoints)
  {
    const Point3& p = mesh.points[point];
    coordinates.values.insert(coordinates.values.end(), p.data(), p.data() + 3);
  }
  return coordinates;
}

CornerCoordinates gaussMapCoordinates(
  const SurfaceMesh& mesh, const std::vector<Point3>& normals, double s)
{
  CornerCoordinates normalPart;
  normalPart.dimension = 3;
  normalPart.values.reserve(3 * normals.size());
  for (const Point3& normal : normals)
  {
    normalPart.values.insert(normalPart.values.end(), normal.data(), normal.data() + 3);
  }
  CornerCoordinates coordinates = positionCoordinates(mesh);
  appendCoordinates(coordinates, normalPart, s);
  return coordinates;
}

void widenCoordinates(CornerCoordinates& coordinates, int more)
{
  const int before = coordinates.dimension;
  const auto total = static_cast<std::size_t>(before) + static_cast<std::size_t>(more);
  const auto count = static_cast<std::size_t>(coordinates.count());
  std::vector<double> values(count * total);
  for (std::size_t c = 0; c < count; ++c)
  {
    std::copy_n(coordinates.values.data() + c * static_cast<std::size_t>(before), before,
      values.data() + c * total);
  }
  coordinates.dimension = static_cast<int>(total);
  coordinates.values = std::move(values);
}

void appendCoordinates(CornerCoordinates& coordinates, const CornerCoordinates& more, double scale)
{
  const int before = coordinates.dimension;
  widenCoordinates(coordinates, more.dimension);
  const auto total = static_cast<std::size_t>(coordinates.dimension);
  const auto size = static_cast<std::size_t>(more.dimension);
  for (std::size_t c = 0; c < static_cast<std::size_t>(coordinates.count()); ++c)
  {
    double* row = coordinates.values.data() + c * total + before;
    for (std::size_t k = 0; k < size; ++k)
    {
      row[k] = scale * more.values[c * size + k];
    }
  }
}

void roundToCaller(const EmbeddedSurface& surface, Sites& sites)
{
  for (Index i = 0; i < sites.count(); ++i)
  {
    double* x = sites.site(i);
    const Index patch = surface.patches.patchOf(x);
    for (int k = 0; k < sites.dimension; ++k)
    {
      const double offset = surface.patches.offset(patch, k);
      x[k] = surface.toScaled(surface.toCaller(x[k] - offset, k), k) + offset;
    }
  }
}

void weightByDensity(const std::vector<double>& densities, EmbeddedSurface& surface)
{
  double measure = 0.0; // for the mean of the square roots: their squares may overflow
  for (std::size_t f = 0; f < densities.size(); ++f)
  {
    measure += std::sqrt(densities[f]) * surface.constants[f].mass;
  }
  int exponent = 0;
  std::frexp(measure / surface.mass, &exponent);
  surface.densityUnit = std::ldexp(1.0, 2 * exponent - 1); // mean in (1/2, 2)
  surface.densities.resize(densities.size());
  surface.mass = 0.0;
  surface.siteMeasure = 0.0;
  for (std::size_t f = 0; f < densities.size(); ++f)
  {
    surface.densities[f] = densities[f] / surface.densityUnit;
    surface.constants[f].mass *= surface.densities[f];
    surface.mass += surface.constants[f].mass;
    surface.siteMeasure += surface.siteMeasureOf(static_cast<Index>(f));
  }
}

void separatePatches(
  const std::vector<Index>& facetPatches, Index numberOfPatches, EmbeddedSurface& surface)
{
  surface.patches = PatchLattice(surface.dimension, numberOfPatches);
  std::vector<Index> cornerPatches(static_cast<std::size_t>(surface.numberOfCorners()), 0);
  for (std::size_t f = 0; f < facetPatches.size(); ++f)
  {
    for (const Index corner : surface.facetCorners[f])
    {
      cornerPatches[corner] = facetPatches[f];
    }
  }
  const auto d = static_cast<std::size_t>(surface.dimension);
  for (std::size_t c = 0; c < cornerPatches.size(); ++c)
  {
    for (int k = 0; k < surface.dimension; ++k)
    {
      surface.corners[c * d + static_cast<std::size_t>(k)] +=
        surface.patches.offset(cornerPatches[c], k);
    }
  }
  // The corners were rounded: edges must agree with the distances that are measured from here on.
  CornerReader<Eigen::Dynamic> reader(surface);
  for (Index f = 0; f < surface.numberOfFacets(); ++f)
  {
    measureEdges(surface.dimension, reader.facet(f), surface.constants[f]);
  }
}

namespace
{
/** Scales the corners that the surface holds itself, and measures the facets. */
bool measureFacets(const RunControl& control, EmbeddedSurface& surface)
{
  const int d = surface.dimension;
  const Blocks held =
    Blocks::cut(static_cast<Offset>(surface.corners.size()) / d, 1024, 65536); // corners
  surface.constants.resize(surface.facetCorners.size());
  const Blocks facets = Blocks::cut(surface.numberOfFacets(), 1024, 65536);
  return forEachRange(held, control,
           [&](Offset begin, Offset end)
           {
             for (Offset k = begin * d; k < end * d; ++k)
             {
               surface.corners[k] = surface.toScaled(surface.corners[k], static_cast<int>(k % d));
             }
           }) &&
    forEachRange(facets, control,
      [&](Offset begin, Offset end)
      {
        CornerReader<Eigen::Dynamic> reader(surface);
        for (Offset f = begin; f < end; ++f)
        {
          surface.constants[f] = measureFacet(d, reader.facet(static_cast<Index>(f)));
        }
      });
}
}

Status embedSurface(const SurfaceMesh& mesh, CornerCoordinates coordinates,
  const RunControl& control, EmbeddedSurface& surface)
{
  surface = EmbeddedSurface{};
  surface.dimension = coordinates.dimension;
  surface.facetCorners = mesh.facetCorners;
  if (Status status = findFrame(coordinates, surface); !status.ok())
  {
    return status;
  }
  if (coordinates.isLent())
  {
    surface.source = std::move(coordinates);
  }
  else
  {
    surface.corners = std::move(coordinates.values);
  }
  if (!measureFacets(control, surface))
  {
    return Status::cancelled();
  }
  for (const FacetConstants& constants : surface.constants)
  {
    surface.mass += constants.mass;
  }
  surface.siteMeasure = surface.mass;
  return surface.mass > 0.0 ? Status::success()
                            : Status::invalid("The embedded surface has no area.");
}
}
