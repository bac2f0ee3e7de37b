#include "Support/SparseFactor.h"

#include <Eigen/OrderingMethods>

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
constexpr int rowsBetweenLooks = 64; // at whether the run is cancelled

/** The upper triangle of the matrix in the order of the factor. */
SparseFactor::Matrix inOrder(const SparseFactor::Matrix& lower, const std::vector<int>& places)
{
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order(
    Eigen::Map<const Eigen::VectorXi>(places.data(), static_cast<Eigen::Index>(places.size())));
  SparseFactor::Matrix upper(lower.rows(), lower.cols());
  upper.selfadjointView<Eigen::Upper>() = lower.selfadjointView<Eigen::Lower>().twistedBy(order);
  return upper;
}
}

void SparseFactor::analyze(const Matrix& lower)
{
  const Matrix whole = lower.selfadjointView<Eigen::Lower>();
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> back;
  Eigen::AMDOrdering<int>()(whole, back);
  m_places.resize(static_cast<std::size_t>(lower.rows()));
  for (int k = 0; k < back.size(); ++k)
  {
    m_places[back.indices()[k]] = k;
  }
  this->findPattern(inOrder(lower, m_places));
}

void SparseFactor::findPattern(const Matrix& upper)
{
  const auto n = static_cast<int>(upper.rows());
  m_parents.assign(static_cast<std::size_t>(n), -1);
  m_begins.assign(static_cast<std::size_t>(n) + 1, 0);
  std::vector<int> reached(static_cast<std::size_t>(n), -1);
  for (int k = 0; k < n; ++k)
  {
    reached[k] = k;
    for (Matrix::InnerIterator entry(upper, k); entry; ++entry)
    {
      for (auto i = static_cast<int>(entry.row()); i < k && reached[i] != k; i = m_parents[i])
      {
        m_parents[i] = m_parents[i] < 0 ? k : m_parents[i];
        ++m_begins[i + 1];
        reached[i] = k;
      }
    }
  }
  for (int k = 0; k < n; ++k)
  {
    m_begins[k + 1] += m_begins[k];
  }
  m_rows.resize(static_cast<std::size_t>(m_begins[n]));
  m_values.resize(m_rows.size());
  m_diagonal.resize(static_cast<std::size_t>(n));
}

FactorOutcome SparseFactor::factorize(const Matrix& lower, const RunControl& control)
{
  const Matrix upper = inOrder(lower, m_places);
  const auto n = static_cast<int>(upper.rows());
  std::vector<Offset> ends(m_begins.begin(), m_begins.end() - 1);
  std::vector<double> row(static_cast<std::size_t>(n), 0.0);
  std::vector<int> pattern(static_cast<std::size_t>(n));
  std::vector<int> reached(static_cast<std::size_t>(n), -1);
  for (int k = 0; k < n; ++k)
  {
    if (k % rowsBetweenLooks == 0 && control.cancelled())
    {
      return FactorOutcome::Cancelled;
    }
    int top = n; // of the pattern, whose columns are in the order in which they are eliminated
    reached[k] = k;
    for (Matrix::InnerIterator entry(upper, k); entry; ++entry)
    {
      auto i = static_cast<int>(entry.row());
      row[i] += entry.value();
      int length = 0;
      for (; reached[i] != k; i = m_parents[i])
      {
        pattern[length++] = i;
        reached[i] = k;
      }
      while (length > 0)
      {
        pattern[--top] = pattern[--length];
      }
    }
    double pivot = row[k];
    row[k] = 0.0;
    for (; top < n; ++top)
    {
      const int i = pattern[top];
      const double here = row[i];
      row[i] = 0.0;
      for (Offset p = m_begins[i]; p < ends[i]; ++p)
      {
        row[m_rows[p]] -= m_values[p] * here;
      }
      const double value = here / m_diagonal[i];
      pivot -= value * here;
      m_rows[ends[i]] = k;
      m_values[ends[i]++] = value;
    }
    if (pivot == 0.0 || !std::isfinite(pivot))
    {
      return FactorOutcome::Singular;
    }
    m_diagonal[k] = pivot;
  }
  return FactorOutcome::Done;
}

Index SparseFactor::negatives() const
{
  return static_cast<Index>(
    std::count_if(m_diagonal.begin(), m_diagonal.end(), [](double value) { return value < 0.0; }));
}

void SparseFactor::solveGroup(double* x) const
{
  const auto n = static_cast<Offset>(m_diagonal.size());
  for (Offset j = 0; j < n; ++j)
  {
    double own[width];
    std::copy_n(x + j * width, width, own);
    for (Offset p = m_begins[j]; p < m_begins[j + 1]; ++p)
    {
      double* other = x + Offset(m_rows[p]) * width;
      for (Offset k = 0; k < width; ++k)
      {
        other[k] -= m_values[p] * own[k];
      }
    }
  }
  for (Offset j = n - 1; j >= 0; --j)
  {
    double own[width];
    for (Offset k = 0; k < width; ++k)
    {
      own[k] = x[j * width + k] / m_diagonal[j];
    }
    for (Offset p = m_begins[j]; p < m_begins[j + 1]; ++p)
    {
      const double* other = x + Offset(m_rows[p]) * width;
      for (Offset k = 0; k < width; ++k)
      {
        own[k] -= m_values[p] * other[k];
      }
    }
    std::copy_n(own, width, x + j * width);
  }
}
}
