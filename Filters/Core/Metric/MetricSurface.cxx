#include "Metric/MetricSurface.h"

#include "Mesh/EdgeTable.h"
#include "Metric/Gradation.h"
#include "Metric/MetricRefinement.h"
#include "Metric/StraightEdges.h"
#include "Support/Grouping.h"

#include <cmath>
#include <cstdlib>

namespace remesh
{
namespace
{
constexpr Offset facetsPerFacet = 2; // that refinement may make
constexpr Offset facetsPerSite = 40; // half a unit is the longest edge
/** Of sizes at the corners of a given facet: above, nothing tells what is between them. */
constexpr double maxVariation = 4.0;
constexpr double sameUnit = 0.03; // relative: limiting again would change nothing

/**
 * The largest factor, from 1, between sizes at two corners, by the change of the logarithm, whose
 * mean is taken between them: a thin layer that turns a little is one there, too, however thin.
 */
double variationOfLogarithms(const std::array<Tensor2, 3>& corners)
{
  double variation = 1.0;
  for (int k = 0; k < 3; ++k)
  {
    const Tensor2 change = logarithm(corners[k]) + logarithm(corners[(k + 1) % 3]) * -1.0;
    const double norm =
      0.5 * std::abs(change.xx + change.yy) + std::hypot(0.5 * (change.xx - change.yy), change.xy);
    variation = std::max(variation, std::exp(0.5 * norm));
  }
  return variation;
}

class Preparation
{
public:
  Preparation(const SurfaceMesh& mesh, const MetricField& metric, const MetricOptions& options,
    MetricSurface& surface)
    : m_mesh(&mesh)
    , m_metric(&metric)
    , m_options(options)
    , m_surface(surface)
  {
  }

  Status run(const Features* features, const RunControl& control)
  {
    double area = 0.0;
    Status status = this->findUnit(*m_metric, control, area);
    m_surface.coarseShare = this->coarseShare(area);
    if (status.ok() && m_options.mayRefine)
    {
      status = this->refineSurface(features, control);
    }
    if (status.ok())
    {
      status = this->limit(control);
    }
    return status;
  }

  const SurfaceMesh& mesh() const { return *m_mesh; }

private:
  Status findUnit(const MetricField& metric, const RunControl& control, double& area)
  {
    const Status status = findTargetShapes(*m_mesh, metric, control, m_surface.shapes);
    area = metricArea(m_surface.shapes);
    m_surface.unit = m_options.unit > 0.0 ? m_options.unit : unitOf(area, m_options.sites);
    return status;
  }

  /** The share of the area where nothing tells what the metric is between given points. */
  double coarseShare(double area) const
  {
    double coarse = 0.0;
    for (std::size_t f = 0; f < m_surface.shapes.size(); ++f)
    {
      // What is between the points is told by logarithms: they vary no more than sizes do.
      const TargetShape& shape = m_surface.shapes[f];
      if (shape.variation > maxVariation &&
        variationOfLogarithms(tensorsOf(*m_mesh, *m_metric, f)) > maxVariation)
      {
        coarse += shape.area();
      }
    }
    return area > 0.0 ? coarse / area : 0.0;
  }

  Status refineSurface(const Features* features, const RunControl& control)
  {
    const Offset maxFacets = std::min<Offset>(
      facetsPerFacet * m_mesh->numberOfFacets() + facetsPerSite * m_options.sites, maximumIndex);
    RefinedSurface refined;
    if (refineForMetric(*m_mesh, features, *m_metric, m_surface.unit, maxFacets, control, refined,
          m_refinedMetric))
    {
      m_surface.refined = std::move(refined);
      m_mesh = &m_surface.refined->mesh;
      m_metric = &m_refinedMetric;
    }
    return control.cancelled() ? Status::cancelled() : Status::success();
  }

  /** With the unit of the metric as given, and again where limiting changes it. */
  Status limit(const RunControl& control)
  {
    m_surface.metric = *m_metric;
    m_surface.shapeMetric = *m_metric;
    if (!m_options.isLimited)
    {
      return Status::success();
    }
    const EdgeTable edges = buildEdgeTable(m_mesh->facetPoints, control);
    if (control.cancelled())
    {
      return Status::cancelled();
    }
    for (double last = 0.0; std::abs(m_surface.unit - last) > sameUnit * m_surface.unit;)
    {
      const bool isSecond = last > 0.0;
      last = m_surface.unit;
      GradationLimits limits{ m_options.growth, last, {} };
      if (!limitToStraightEdges(*m_mesh, edges, *m_metric, last, control, m_surface.metric) ||
        !this->findLimits(control, limits.bends) ||
        !limitGrowth(*m_mesh, edges, limits, control, m_surface.metric))
      {
        return Status::cancelled();
      }
      double area = 0.0;
      if (Status status = this->findUnit(m_surface.metric, control, area); !status.ok())
      {
        return status;
      }
      if (isSecond)
      {
        break;
      }
    }
    return this->measureLimits(control);
  }

  /** By how much a size at a point is smaller than given, at least 1. */
  double limitAt(std::size_t point, const Tensor2& given, const TangentFrame& frame) const
  {
    const Tensor2 limited = frame.within(m_surface.metric.tensors[point]);
    return std::sqrt(std::max(1.0, relativeSizes(given, limited).max));
  }

  bool findLimits(const RunControl& control, std::vector<float>& limits) const
  {
    limits.resize(m_mesh->points.size());
    return forEachItem(m_mesh->numberOfPoints(), control,
      [&](Offset point)
      {
        const auto p = static_cast<std::size_t>(point);
        const TangentFrame frame = TangentFrame::across(m_metric->normals[p]);
        const Tensor2 given = frame.within(m_metric->tensors[p]);
        limits[p] = static_cast<float>(this->limitAt(p, given, frame));
      });
  }

  Status measureLimits(const RunControl& control)
  {
    const auto mix = [&](Offset point)
    {
      const auto p = static_cast<std::size_t>(point);
      const TangentFrame frame = TangentFrame::across(m_metric->normals[p]);
      const Tensor2 given = frame.within(m_metric->tensors[p]);
      const Tensor2 limited = frame.within(m_surface.metric.tensors[p]);
      const double share = 1.0 / this->limitAt(p, given, frame);
      m_surface.shapeMetric.tensors[p] = frame.tensorOf(
        exponential(logarithm(given) * share + logarithm(limited) * (1.0 - share)), 1.0);
    };
    return this->findLimits(control, m_surface.limits) &&
        forEachItem(m_mesh->numberOfPoints(), control, mix)
      ? Status::success()
      : Status::cancelled();
  }

  const SurfaceMesh* m_mesh;
  const MetricField* m_metric;
  const MetricOptions& m_options;
  MetricSurface& m_surface;
  MetricField m_refinedMetric;
};
}

double unitOf(double area, Offset points)
{
  return std::sqrt(2.0 / std::sqrt(3.0) * area / static_cast<double>(std::max(points, Offset(1))));
}

Status findComplexityUnit(const SurfaceMesh& mesh, const MetricField& metric, double complexity,
  const RunControl& control, double& unit)
{
  unit = 1.0;
  if (!(complexity > 0.0))
  {
    return Status::success();
  }
  std::vector<TargetShape> shapes;
  const Status status = findTargetShapes(mesh, metric, control, shapes);
  unit = std::sqrt(metricArea(shapes) / complexity);
  return status;
}

MetricSize sizeOf(
  const SurfaceMesh& mesh, const std::vector<TargetShape>& shapes, const RunControl& control)
{
  const EdgeTable edges = buildEdgeTable(mesh.facetPoints, control);
  MetricSize size;
  size.area = metricArea(shapes);
  size.euler =
    static_cast<double>(mesh.numberOfPoints()) - edges.numberOfEdges() + mesh.numberOfFacets();
  for (std::size_t f = 0; f < edges.facetEdges.size(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (const Index valence = edges.valence(edges.facetEdges[f][k]); valence != 2)
      {
        size.border += (2.0 - valence) / valence * std::sqrt(shapes[f].edge2(k));
      }
    }
  }
  return size;
}

double MetricSize::points(double unit) const
{
  // V - E + F = euler, 3 F = 2 E - B, and F triangles of equal sides.
  return 2.0 / std::sqrt(3.0) * this->area / (unit * unit) + 0.5 * this->border / unit +
    this->euler;
}

Status measureMetric(const SurfaceMesh& mesh, const MetricField& metric,
  const MetricOptions& options, const RunControl& control, MetricSize& size)
{
  MetricSurface surface;
  Preparation preparation(mesh, metric, options, surface);
  Status status = preparation.run(nullptr, control.silent());
  if (status.ok())
  {
    status = findTargetShapes(preparation.mesh(), surface.metric, control, surface.shapes);
  }
  if (!status.ok())
  {
    return status;
  }
  size = sizeOf(preparation.mesh(), surface.shapes, control);
  return control.cancelled() ? Status::cancelled() : Status::success();
}

Status embedMetric(const SurfaceMesh& mesh, const Features* features, const MetricField& metric,
  const MetricOptions& options, const RunControl& control, MetricSurface& surface)
{
  surface = MetricSurface{};
  Preparation preparation(mesh, metric, options, surface);
  Status status = preparation.run(features, control.silent());
  if (status.ok())
  {
    status = findTargetShapes(preparation.mesh(), surface.metric, control.silent(), surface.shapes);
  }
  IsometryOptions isometry;
  isometry.dimension = options.dimension;
  isometry.unit = surface.unit;
  isometry.iterations = options.iterations;
  isometry.energyDecrease = options.energyDecrease;
  const SurfaceMesh& embedded = preparation.mesh();
  const ShapedFacets facets{ embedded.numberOfPoints(), embedded.facetPoints, surface.shapes };
  return status.ok() ? embedIsometrically(facets, isometry, control, surface.embedding) : status;
}
}
