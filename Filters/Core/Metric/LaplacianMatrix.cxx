#include "Metric/LaplacianMatrix.h"

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

template <int fixed>
bool LaplacianMatrix::approachIn(
  Rows& right, int steps, const RunControl& control, Rows& solution) const
{
  const Offset n = right.rows();
  const auto d = fixed > 0 ? fixed : static_cast<int>(right.cols());
  const Blocks blocks = Blocks::cut(n, 64, 1 << 15);
  solution.setZero(n, d);
  Rows direction(n, d);
  Rows image(n, d);
  const auto precondition = [&](std::size_t p, double* to)
  {
    const double* const from = right.data() + p * d;
    const double scale = 1.0 / m_diagonal[p];
    double product = 0.0;
    for (int k = 0; k < d; ++k)
    {
      to[k] = scale * from[k];
      product += to[k] * from[k];
    }
    return product;
  };
  const auto apply = [&](std::size_t p)
  {
    this->applyTo<fixed>(direction, static_cast<Offset>(p), image.data() + p * d);
    double product = 0.0;
    for (std::size_t k = p * d; k < (p + 1) * d; ++k)
    {
      product += direction.data()[k] * image.data()[k];
    }
    return product;
  };
  double product = 0.0;
  bool done = sumInBlocks(
    blocks, control, [&](std::size_t p) { return precondition(p, direction.data() + p * d); },
    product);
  for (int step = 0; step < steps && done && product > 0.0; ++step)
  {
    double curvature = 0.0;
    double next = 0.0;
    done = sumInBlocks(blocks, control, apply, curvature);
    if (!done || !(curvature > 0.0))
    {
      break;
    }
    const double length = product / curvature;
    const auto move = [&](std::size_t p)
    {
      for (std::size_t k = p * d; k < (p + 1) * d; ++k)
      {
        solution.data()[k] += length * direction.data()[k];
        right.data()[k] -= length * image.data()[k];
      }
      return precondition(p, image.data() + p * d); // the image itself has served
    };
    done = sumInBlocks(blocks, control, move, next);
    const double turn = next / product;
    product = next;
    done = done &&
      forEachItem(n * d, control,
        [&](Offset k) { direction.data()[k] = image.data()[k] + turn * direction.data()[k]; });
  }
  return done;
}
}
