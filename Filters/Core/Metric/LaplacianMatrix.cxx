#include "Metric/LaplacianMatrix.h"

#include "Support/ConjugateGradients.h"

#include <algorithm>

namespace remesh
{
namespace
{
constexpr int smoothingSteps = 25; // of conjugate gradients: waves of a hundred edges are heard
}

LaplacianMatrix::LaplacianMatrix(const MetricLaplacian& laplacian, const RunControl& control)
  : m_laplacian(laplacian)
  , m_entries(2 * laplacian.corners().items.size())
  , m_counts(laplacian.masses().size(), 0)
  , m_diagonal(laplacian.masses().size(), 0.0)
{
  const Groups& corners = laplacian.corners();
  const auto fillRow = [&](Offset point)
  {
    Entry* const entries = m_entries.data() + this->begin(point);
    Index& count = m_counts[point];
    for (Offset i = corners.begins[point]; i < corners.begins[point + 1]; ++i)
    {
      const auto facet = static_cast<Index>(corners.items[i] / 3);
      const auto k = static_cast<int>(corners.items[i] % 3);
      m_diagonal[point] += laplacian.entry(facet, k, k);
      for (const int l : { (k + 1) % 3, (k + 2) % 3 })
      {
        const Index other = laplacian.surface().facetPoints[facet][l];
        Entry* const found = std::find_if(
          entries, entries + count, [=](const Entry& entry) { return entry.column == other; });
        if (found == entries + count)
        {
          *found = { other, 0.0F };
          ++count;
        }
        found->value += static_cast<float>(laplacian.entry(facet, k, l));
      }
    }
  };
  static_cast<void>(forEachItem(laplacian.numberOfPoints(), control, fillRow));
}

bool LaplacianMatrix::smooth(double time, const RunControl& control, Rows& functions)
{
  Rows right(functions.rows(), functions.cols());
  const auto find = [&](Offset p)
  {
    this->applyTo<0>(functions, p, right.data() + p * right.cols());
    right.row(p) *= -1.0;
  };
  if (!forEachItem(functions.rows(), control, find))
  {
    return false;
  }
  const std::vector<double> diagonal = m_diagonal;
  for (std::size_t p = 0; p < m_diagonal.size(); ++p)
  {
    m_diagonal[p] += m_laplacian.masses()[p] / time;
  }
  Rows way;
  const bool done = this->approach(right, smoothingSteps, control, way);
  m_diagonal = diagonal;
  functions += way;
  return done;
}

bool LaplacianMatrix::approach(
  Rows& right, int steps, const RunControl& control, Rows& solution) const
{
  return right.cols() == 6 ? this->approachIn<6>(right, steps, control, solution)
                           : this->approachIn<0>(right, steps, control, solution);
}

template <int fixed>
void LaplacianMatrix::applyTo(const Rows& functions, Offset point, double* sum) const
{
  const auto d = fixed > 0 ? fixed : static_cast<int>(functions.cols());
  const double* const own = functions.data() + point * d;
  for (int k = 0; k < d; ++k)
  {
    sum[k] = m_diagonal[point] * own[k];
  }
  const Entry* const entries = m_entries.data() + this->begin(point);
  for (Index e = 0; e < m_counts[point]; ++e)
  {
    const double* const other = functions.data() + Offset(entries[e].column) * d;
    const double value = entries[e].value;
    for (int k = 0; k < d; ++k)
    {
      sum[k] += value * other[k];
    }
  }
}

/** Conjugate gradients for all columns as one system: what is done at each point. */
template <int fixed>
class LaplacianMatrix::Descent
{
public:
  Descent(const LaplacianMatrix& matrix, Rows& right, Rows& solution)
    : m_matrix(matrix)
    , m_dimension(fixed > 0 ? fixed : static_cast<int>(right.cols()))
    , m_rest(right)
    , m_solution(solution)
    , m_direction(right.rows(), right.cols())
    , m_image(right.rows(), right.cols())
  {
    solution.setZero(right.rows(), right.cols());
  }

  /** A point's part of the first direction. @return what it adds to rest . diagonal^-1 rest. */
  double begin(std::size_t point) { return this->divide(point, m_direction); }

  /** The direction's image. @return what a point adds to direction . image. */
  double apply(std::size_t point)
  {
    m_matrix.applyTo<fixed>(m_direction, static_cast<Offset>(point), this->row(m_image, point));
    double product = 0.0;
    for (std::size_t k = 0; k < this->columns(); ++k)
    {
      product += this->row(m_direction, point)[k] * this->row(m_image, point)[k];
    }
    return product;
  }

  /** Goes so far along the direction; the image becomes the rest over the diagonal. As `begin`. */
  double move(std::size_t point, double length)
  {
    for (std::size_t k = 0; k < this->columns(); ++k)
    {
      this->row(m_solution, point)[k] += length * this->row(m_direction, point)[k];
      this->row(m_rest, point)[k] -= length * this->row(m_image, point)[k];
    }
    return this->divide(point, m_image);
  }

  void turn(std::size_t point, double factor)
  {
    for (std::size_t k = 0; k < this->columns(); ++k)
    {
      double& direction = this->row(m_direction, point)[k];
      direction = this->row(m_image, point)[k] + factor * direction;
    }
  }

private:
  std::size_t columns() const { return fixed > 0 ? fixed : m_dimension; }
  double* row(Rows& rows, std::size_t point) const { return rows.data() + point * this->columns(); }

  double divide(std::size_t point, Rows& quotient)
  {
    const double* const rest = this->row(m_rest, point);
    double* const to = this->row(quotient, point);
    const double scale = 1.0 / m_matrix.m_diagonal[point];
    double product = 0.0;
    for (std::size_t k = 0; k < this->columns(); ++k)
    {
      to[k] = scale * rest[k];
      product += to[k] * rest[k];
    }
    return product;
  }

  const LaplacianMatrix& m_matrix;
  int m_dimension;
  Rows& m_rest; ///< V x d, and so are the others
  Rows& m_solution;
  Rows m_direction;
  Rows m_image;
};

template <int fixed>
bool LaplacianMatrix::approachIn(
  Rows& right, int steps, const RunControl& control, Rows& solution) const
{
  const Blocks blocks = Blocks::cut(right.rows(), 64, 1 << 15);
  Descent<fixed> descent(*this, right, solution);
  ConjugateGradientsLimits limits;
  limits.iterations = steps;
  limits.reduction = 0.0;
  return descendConjugately(blocks, limits, control, descent);
}
}
