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

  double coarseShare(double area) const
  {
    double coarse = 0.0;
    for (const TargetShape& shape : m_surface.shapes)
    {
      coarse += shape.variation > maxVariation ? shape.area() : 0.0;
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
      if (!limitToStraightEdges(*m_mesh, edges, *m_metric, last, control, m_surface.metric) ||
        !limitGrowth(*m_mesh, edges, { m_options.growth, last }, control, m_surface.metric))
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
    this->measureLimits();
    return Status::success();
  }

  void measureLimits()
  {
    m_surface.limits.resize(m_mesh->points.size());
    for (std::size_t p = 0; p < m_surface.limits.size(); ++p)
    {
      const TangentFrame frame = TangentFrame::across(m_metric->normals[p]);
      const Tensor2 given = frame.within(m_metric->tensors[p]);
      const Tensor2 limited = frame.within(m_surface.metric.tensors[p]);
      const double limit = std::sqrt(std::max(1.0, relativeSizes(given, limited).max));
      const double share = 1.0 / limit;
      m_surface.limits[p] = static_cast<float>(limit);
      m_surface.shapeMetric.tensors[p] = frame.tensorOf(
        exponential(logarithm(given) * share + logarithm(limited) * (1.0 - share)), 1.0);
    }
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
