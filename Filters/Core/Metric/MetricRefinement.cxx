#include "Metric/MetricRefinement.h"

#include "Support/Grouping.h"

#include <cmath>

namespace remesh
{
namespace
{
constexpr double longest = 0.5;         // of the unit
constexpr double shortest = 0.125;      // of the unit, where the metric changes
constexpr double maxRatioOfSizes = 1.3; // between sizes at an edge's ends
constexpr double goodPiece = 0.15;      // quality of pieces in the metric, 1 for equal sides
constexpr double needle = 0.04;         // quality of facets whose sides are split first

/** The tensors at three corners of a facet, as logarithms in its plane. */
using Logarithms = std::array<Tensor2, 3>;

/** The metric of a surface, on pieces of its facets. */
class Interpolation
{
public:
  Interpolation(const SurfaceMesh& mesh, const MetricField& metric)
    : m_mesh(mesh)
    , m_metric(metric)
    , m_logarithms(mesh.facetPoints.size())
    , m_sides(mesh.facetPoints.size())
  {
    for (std::size_t f = 0; f < m_logarithms.size(); ++f)
    {
      const std::array<Tensor2, 3> own = tensorsOf(mesh, metric, f);
      for (int k = 0; k < 3; ++k)
      {
        m_logarithms[f][k] = logarithm(own[k]);
      }
      const TangentFrame frame = TangentFrame::of(mesh, f);
      const Triple& points = mesh.facetPoints[f];
      const Point3 first = mesh.points[points[1]] - mesh.points[points[0]];
      const Point3 second = mesh.points[points[2]] - mesh.points[points[0]];
      m_sides[f] = { first.norm(), second.dot(frame.x), second.dot(frame.y) };
    }
  }

  /** Of a corner of a part, in the plane of the facet. */
  Tensor2 at(const FacetOrigin& origin, int corner) const
  {
    Tensor2 sum{ 0.0, 0.0, 0.0 };
    for (int k = 0; k < 3; ++k)
    {
      sum = sum + m_logarithms[origin.facet][k] * static_cast<double>(origin.corners[corner][k]);
    }
    return sum;
  }

  /** (a² + b² + c²) / area of a piece in the metric, the mean of its corners'. */
  double energy(const FacetOrigin& piece) const
  {
    Tensor2 sum{ 0.0, 0.0, 0.0 };
    for (int k = 0; k < 3; ++k)
    {
      sum = sum + exponential(this->at(piece, k));
    }
    const std::array<double, 3>& shape = m_sides[piece.facet]; // (u, 0) and (v, w)
    double second[3];
    double third[3];
    double x[3];
    double y[3];
    for (int k = 0; k < 3; ++k)
    {
      const auto& from = piece.corners[k];
      const auto& to = piece.corners[(k + 1) % 3];
      second[k] = static_cast<double>(to[1]) - static_cast<double>(from[1]);
      third[k] = static_cast<double>(to[2]) - static_cast<double>(from[2]);
      x[k] = second[k] * shape[0] + third[k] * shape[1];
      y[k] = third[k] * shape[2];
    }
    // Of what is exact: never 0 where the piece has an area.
    const double area = 0.5 * shape[0] * shape[2] * (second[0] * third[1] - second[1] * third[0]) *
      std::sqrt(sum.determinant());
    return (sum.squared(x[0], y[0]) + sum.squared(x[1], y[1]) + sum.squared(x[2], y[2])) / area;
  }

  /** Of all points of the refined surface. */
  MetricField of(const RefinedSurface& surface) const
  {
    const SurfaceMesh& mesh = surface.mesh;
    MetricField field;
    field.normals = pointNormals(mesh);
    std::vector<Tensor2> sums(mesh.points.size(), { 0.0, 0.0, 0.0 });
    std::vector<Index> old(mesh.points.size(), noIndex);
    std::vector<double> counts(mesh.points.size(), 0.0);
    for (std::size_t f = 0; f < surface.origins.size(); ++f)
    {
      this->add(surface, f, field.normals, sums, counts, old);
    }
    field.tensors.resize(mesh.points.size());
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
    {
      const Tensor2 mean = exponential(sums[p] * (1.0 / counts[p]));
      field.tensors[p] = old[p] != noIndex
        ? m_metric.tensors[old[p]]
        : TangentFrame::across(field.normals[p]).tensorOf(mean, 0.5 * (mean.xx + mean.yy));
      field.normals[p] = old[p] != noIndex ? m_metric.normals[old[p]] : field.normals[p];
    }
    return field;
  }

private:
  /** Adds what a facet says to its points, each in its own plane. */
  void add(const RefinedSurface& surface, std::size_t facet, const std::vector<Point3>& normals,
    std::vector<Tensor2>& sums, std::vector<double>& counts, std::vector<Index>& old) const
  {
    const FacetOrigin& origin = surface.origins[facet];
    const TangentFrame frame = TangentFrame::of(m_mesh, static_cast<std::size_t>(origin.facet));
    for (int k = 0; k < 3; ++k)
    {
      const Index point = surface.mesh.facetPoints[facet][k];
      for (int j = 0; j < 3; ++j)
      {
        if (origin.corners[k][j] == 1.0F)
        {
          old[point] = m_mesh.facetPoints[origin.facet][j];
        }
      }
      const TangentFrame there = frame.turnedTo(normals[point]);
      const TangentFrame own = TangentFrame::across(normals[point]);
      const double xx = own.x.dot(there.x);
      const double xy = own.x.dot(there.y);
      const double yx = own.y.dot(there.x);
      const double yy = own.y.dot(there.y);
      const Tensor2 log = this->at(origin, k);
      sums[point] = sums[point] +
        Tensor2{ log.squared(xx, xy),
          log.xx * xx * yx + log.xy * (xx * yy + xy * yx) + log.yy * xy * yy, log.squared(yx, yy) };
      counts[point] += 1.0;
    }
  }

  const SurfaceMesh& m_mesh;
  const MetricField& m_metric;
  std::vector<Logarithms> m_logarithms;       ///< F
  std::vector<std::array<double, 3>> m_sides; ///< F
};

/** Which edges are too long in the metric. */
class Criterion
{
public:
  Criterion(const SurfaceMesh& mesh, const Interpolation& interpolation, double unit)
    : m_mesh(mesh)
    , m_interpolation(interpolation)
    , m_unit(unit)
  {
  }

  void operator()(const RefinedSurface& surface, const EdgeTable& edges, EdgesToSplit& wanted) const
  {
    const auto count = static_cast<std::size_t>(edges.numberOfEdges());
    wanted.lengths.assign(count, 0.0);
    wanted.marked.assign(count, 0);
    for (std::size_t f = 0; f < surface.origins.size(); ++f)
    {
      const TangentFrame frame =
        TangentFrame::of(m_mesh, static_cast<std::size_t>(surface.origins[f].facet));
      for (int k = 0; k < 3; ++k)
      {
        const Index edge = edges.facetEdges[f][k];
        if (wanted.lengths[edge] == 0.0)
        {
          const auto [length, variation] = this->measure(surface, frame, f, k);
          wanted.lengths[edge] = length;
          wanted.marked[edge] = length > longest * m_unit ||
            (length > shortest * m_unit && variation > maxRatioOfSizes * maxRatioOfSizes);
        }
      }
    }
  }

private:
  /** The length of a facet's side, and how much squares of sizes vary along it, from 1. */
  std::pair<double, double> measure(
    const RefinedSurface& surface, const TangentFrame& frame, std::size_t facet, int side) const
  {
    const Triple& points = surface.mesh.facetPoints[facet];
    const int next = (side + 1) % 3;
    const Point3 edge = surface.mesh.points[points[next]] - surface.mesh.points[points[side]];
    const double x = edge.dot(frame.x);
    const double y = edge.dot(frame.y);
    const Tensor2 ends[2] = { m_interpolation.at(surface.origins[facet], side),
      m_interpolation.at(surface.origins[facet], next) };
    const Tensor2 a = exponential(ends[0]);
    const Tensor2 b = exponential(ends[1]);
    const Tensor2 middle = exponential((ends[0] + ends[1]) * 0.5);
    const RelativeSizes sizes = relativeSizes(a, b);
    return { (std::sqrt(a.squared(x, y)) + 4.0 * std::sqrt(middle.squared(x, y)) +
               std::sqrt(b.squared(x, y))) /
        6.0,
      std::max(sizes.max, 1.0 / sizes.min) };
  }

  const SurfaceMesh& m_mesh;
  const Interpolation& m_interpolation;
  double m_unit;
};
}

bool refineForMetric(const SurfaceMesh& mesh, const Features* features, const MetricField& metric,
  double unit, Offset maxFacets, const RunControl& control, RefinedSurface& refined,
  MetricField& refinedMetric)
{
  const Interpolation interpolation(mesh, metric);
  const Criterion criterion(mesh, interpolation, unit);
  refined = wholeSurface(mesh, features);
  RefinementLimits limits{ maxFacets };
  PieceShapes shapes;
  shapes.energy = [&](const FacetOrigin& piece) { return interpolation.energy(piece); };
  shapes.enough = 4.0 * std::sqrt(3.0) / goodPiece;
  shapes.needle = 4.0 * std::sqrt(3.0) / needle;
  limits.shapes = &shapes;
  const bool any = refine(criterion, limits, control, refined);
  if (any && !control.cancelled())
  {
    refinedMetric = interpolation.of(refined);
  }
  return any;
}

double metricArea(const std::vector<TargetShape>& shapes)
{
  double area = 0.0;
  for (const TargetShape& shape : shapes)
  {
    area += shape.area();
  }
  return area;
}
}
