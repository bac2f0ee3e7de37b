#include "Metric/MetricLaplacian.h"

#include <algorithm>
#include <vector>

namespace remesh
{
namespace
{
/** Of the masses, that makes the matrix regular, relative to its trace. */
constexpr double regularShare = 1e-10;
}

MetricLaplacian::MetricLaplacian(const ShapedFacets& surface, const RunControl& control)
  : m_surface(surface)
  , m_weights(surface.shapes.size())
  , m_masses(static_cast<std::size_t>(surface.points), 0.0)
{
  const std::vector<TargetShape>& shapes = surface.shapes;
  const auto findWeights = [&](Offset f)
  {
    const double a = shapes[f].a;
    const double b = shapes[f].b;
    const double c = shapes[f].c;
    auto& weights = m_weights[f].ofCorner;
    weights[1][0] = 1.0 / a;
    weights[1][1] = -b / (a * c);
    weights[2][0] = 0.0;
    weights[2][1] = 1.0 / c;
    weights[0][0] = -weights[1][0];
    weights[0][1] = -weights[1][1] - weights[2][1];
  };
  const auto pointOf = [&](Offset corner) { return surface.facetPoints[corner / 3][corner % 3]; };
  const auto findMass = [&](Offset point)
  {
    for (Offset k = m_corners.begins[point]; k < m_corners.begins[point + 1]; ++k)
    {
      m_masses[point] += shapes[m_corners.items[k] / 3].area() / 3.0;
    }
  };
  static_cast<void>(forEachItem(static_cast<Offset>(shapes.size()), control, findWeights) &&
    groupByKey(
      3 * static_cast<Offset>(shapes.size()), surface.points, control, pointOf, m_corners) &&
    forEachItem(surface.points, control, findMass));
  for (const double mass : m_masses)
  {
    m_area += mass;
  }
}

FacetRows MetricLaplacian::gradient(const Rows& functions, Index facet) const
{
  const Triple& points = m_surface.facetPoints[facet];
  const auto& weights = m_weights[facet].ofCorner;
  const auto first = functions.row(points[0]);
  FacetRows rows(2, functions.cols());
  rows.row(0) = weights[1][0] * (functions.row(points[1]) - first);
  rows.row(1) = weights[1][1] * (functions.row(points[1]) - first) +
    weights[2][1] * (functions.row(points[2]) - first);
  return rows;
}

bool MetricLaplacian::divergence(const Rows& fields, const RunControl& control, Rows& sums) const
{
  return fields.cols() == 6 ? this->divergenceIn<6>(fields, control, sums)
                            : this->divergenceIn<0>(fields, control, sums);
}

template <int fixed>
bool MetricLaplacian::divergenceIn(const Rows& fields, const RunControl& control, Rows& sums) const
{
  const auto d = fixed > 0 ? fixed : static_cast<int>(fields.cols());
  sums.resize(this->numberOfPoints(), d);
  return forEachItem(this->numberOfPoints(), control,
    [&](Offset point)
    {
      double* const sum = sums.data() + point * d;
      std::fill_n(sum, d, 0.0);
      for (Offset i = m_corners.begins[point]; i < m_corners.begins[point + 1]; ++i)
      {
        const auto facet = static_cast<Index>(m_corners.items[i] / 3);
        const auto& weights = m_weights[facet].ofCorner[m_corners.items[i] % 3];
        const double first = this->area(facet) * weights[0];
        const double second = this->area(facet) * weights[1];
        const double* const field = fields.data() + 2 * Offset(facet) * d;
        for (int k = 0; k < d; ++k)
        {
          sum[k] += first * field[k] + second * field[d + k];
        }
      }
    });
}

SparseFactor::Matrix MetricLaplacian::lowerTriangle() const
{
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(6 * m_surface.shapes.size() + m_masses.size());
  double trace = 0.0;
  for (Index facet = 0; facet < this->numberOfFacets(); ++facet)
  {
    const Triple& points = m_surface.facetPoints[facet];
    for (int k = 0; k < 3; ++k)
    {
      for (int l = 0; l <= k; ++l)
      {
        const double entry = this->entry(facet, k, l);
        entries.emplace_back(std::max(points[k], points[l]), std::min(points[k], points[l]), entry);
        trace += k == l ? entry : 0.0;
      }
    }
  }
  for (Index point = 0; point < this->numberOfPoints(); ++point)
  {
    entries.emplace_back(point, point, regularShare * trace / m_area * m_masses[point]);
  }
  SparseFactor::Matrix matrix(this->numberOfPoints(), this->numberOfPoints());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

Status MetricLaplacian::factor(const RunControl& control)
{
  const SparseFactor::Matrix matrix = this->lowerTriangle();
  if (control.cancelled())
  {
    return Status::cancelled();
  }
  m_factor.analyze(matrix);
  switch (m_factor.factorize(matrix, control))
  {
    case FactorOutcome::Cancelled:
      return Status::cancelled();
    case FactorOutcome::Singular:
      return Status::invalid("The metric's Laplacian cannot be factored: sizes "
                             "differ by more than numbers can tell.");
    default:
      return Status::success();
  }
}

bool MetricLaplacian::solve(const Rows& right, const RunControl& control, Rows& solution) const
{
  return m_factor.solve(right, control, solution);
}
}
