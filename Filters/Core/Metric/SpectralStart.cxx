#include "Metric/SpectralStart.h"

#include "Support/DisjointSets.h"
#include "Support/Random.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace remesh
{
namespace
{
constexpr int spare = 3;              // functions beyond those wanted, for faster convergence
constexpr int iterations = 10;        // the start is near then
constexpr std::uint64_t drawing = 17; // a stream of random numbers of its own
/** Of the largest eigenvalue: below, functions are dependent. */
constexpr double minShareOfLargest = 1e-10;

/** The points of each component, and matrices summed over them in fixed blocks. */
class ComponentSums
{
public:
  ComponentSums(const ShapedFacets& surface, const RunControl& control)
    : m_control(control)
  {
    DisjointSets sets(static_cast<std::size_t>(surface.points));
    for (const Triple& points : surface.facetPoints)
    {
      sets.unite(points[0], points[1]);
      sets.unite(points[1], points[2]);
    }
    m_ofPoint.resize(static_cast<std::size_t>(surface.points));
    std::vector<Index> numbers(m_ofPoint.size(), noIndex);
    for (Index point = 0; point < surface.points; ++point)
    {
      Index& number = numbers[sets.find(point)];
      number = number == noIndex ? m_count++ : number;
      m_ofPoint[point] = number;
    }
    m_complete = groupByKey(
      surface.points, m_count, control, [&](Offset p) { return m_ofPoint[p]; }, m_points);
  }

  Index count() const { return m_count; }
  Index of(Offset point) const { return m_ofPoint[point]; }
  bool complete() const { return m_complete; }

  /** For each component the sum of `add(point, matrix)`, from zero matrices of a size. */
  template <class Add>
  std::vector<Eigen::MatrixXd> sum(Eigen::Index rows, Eigen::Index columns, const Add& add)
  {
    constexpr Offset longest = 1 << 13;
    std::vector<Eigen::MatrixXd> sums(m_count);
    std::vector<std::pair<Offset, Offset>> ranges;
    std::vector<Index> owners;
    for (Index c = 0; c < m_count; ++c)
    {
      sums[c] = Eigen::MatrixXd::Zero(rows, columns);
      for (Offset begin = m_points.begins[c]; begin < m_points.begins[c + 1]; begin += longest)
      {
        ranges.emplace_back(begin, std::min(begin + longest, m_points.begins[c + 1]));
        owners.push_back(c);
      }
    }
    std::vector<Eigen::MatrixXd> parts(ranges.size());
    m_complete &= forEachItem(static_cast<Offset>(ranges.size()), m_control,
      [&](Offset r)
      {
        parts[r] = Eigen::MatrixXd::Zero(rows, columns);
        for (Offset i = ranges[r].first; i < ranges[r].second; ++i)
        {
          add(m_points.items[i], parts[r]);
        }
      });
    for (std::size_t r = 0; r < parts.size() && m_complete; ++r)
    {
      sums[owners[r]] += parts[r];
    }
    return sums;
  }

private:
  RunControl m_control;
  Index m_count = 0;
  std::vector<Index> m_ofPoint;
  Groups m_points;
  bool m_complete = true;
};

class InverseIteration
{
public:
  InverseIteration(const MetricLaplacian& laplacian, const RunControl& control)
    : m_laplacian(laplacian)
    , m_control(control)
    , m_sums(laplacian.surface(), control.silent())
  {
  }

  bool run(int dimension, std::uint64_t seed, Rows& places)
  {
    if (!m_sums.complete())
    {
      return false;
    }
    this->draw(dimension + spare, seed);
    for (int k = 0; k < iterations && this->orthonormalize(); ++k)
    {
      m_control.report(static_cast<double>(k) / iterations);
      const Rows right = m_masses().asDiagonal() * m_functions;
      if (!m_laplacian.solve(right, m_control.silent(), m_functions))
      {
        return false;
      }
    }
    return this->orthonormalize() && this->takeSmoothest(dimension, places);
  }

private:
  Eigen::Map<const Eigen::VectorXd> m_masses() const
  {
    return { m_laplacian.masses().data(), m_laplacian.numberOfPoints() };
  }

  void draw(int columns, std::uint64_t seed)
  {
    m_functions.resize(m_laplacian.numberOfPoints(), columns);
    for (Eigen::Index k = 0; k < m_functions.size(); ++k)
    {
      m_functions.data()[k] = uniform01(seed, static_cast<std::uint64_t>(k), drawing) - 0.5;
    }
  }

  /** Multiplies the rows of each component by its matrix. */
  void multiply(const std::vector<Eigen::MatrixXd>& matrices)
  {
    Rows product(m_functions.rows(), matrices.empty() ? 0 : matrices[0].cols());
    m_complete &= forEachItem(m_functions.rows(), m_control.silent(),
      [&](Offset p) { product.row(p).noalias() = m_functions.row(p) * matrices[m_sums.of(p)]; });
    m_functions.swap(product);
  }

  /** Takes the mean out, and makes the functions orthonormal; dependent ones become 0. */
  bool orthonormalize()
  {
    const auto columns = m_functions.cols();
    const auto& masses = m_laplacian.masses();
    const auto means = m_sums.sum(1, columns + 1,
      [&](Index p, Eigen::MatrixXd& sum)
      {
        sum.leftCols(columns) += masses[p] * m_functions.row(p);
        sum(0, columns) += masses[p];
      });
    m_complete &= forEachItem(m_functions.rows(), m_control.silent(),
      [&](Offset p)
      {
        const Eigen::MatrixXd& mean = means[m_sums.of(p)];
        m_functions.row(p) -= mean.leftCols(columns) / mean(0, columns);
      });
    if (!this->complete())
    {
      return false;
    }
    auto grams = m_sums.sum(columns, columns,
      [&](Index p, Eigen::MatrixXd& sum)
      { sum += masses[p] * m_functions.row(p).transpose() * m_functions.row(p); });
    for (Eigen::MatrixXd& gram : grams)
    {
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(gram);
      const Eigen::VectorXd& values = solver.eigenvalues();
      const double least = minShareOfLargest * values[columns - 1];
      Eigen::VectorXd inverse = Eigen::VectorXd::Zero(columns);
      for (Eigen::Index c = 0; c < columns; ++c)
      {
        inverse[c] = values[c] > least && values[c] > 0.0 ? 1.0 / std::sqrt(values[c]) : 0.0;
      }
      gram = solver.eigenvectors() * inverse.asDiagonal();
    }
    this->multiply(grams);
    return this->complete() && !m_control.cancelled();
  }

  /** The combinations with the least energy, scaled. */
  bool takeSmoothest(int dimension, Rows& places)
  {
    const auto columns = m_functions.cols();
    Rows fields(2 * Offset(m_laplacian.numberOfFacets()), columns);
    m_complete &= forEachItem(m_laplacian.numberOfFacets(), m_control.silent(),
      [&](Offset f)
      { fields.middleRows(2 * f, 2) = m_laplacian.gradient(m_functions, static_cast<Index>(f)); });
    Rows images;
    m_complete &= m_laplacian.divergence(fields, m_control.silent(), images);
    auto energies = m_sums.sum(columns, columns,
      [&](Index p, Eigen::MatrixXd& sum)
      { sum += m_functions.row(p).transpose() * images.row(p); });
    const auto areas = m_sums.sum(
      1, 1, [&](Index p, Eigen::MatrixXd& sum) { sum(0, 0) += m_laplacian.masses()[p]; });
    if (!this->complete())
    {
      return false;
    }
    for (Index c = 0; c < m_sums.count(); ++c)
    {
      energies[c] = this->combination(energies[c], areas[c](0, 0), dimension);
    }
    this->multiply(energies);
    places.swap(m_functions);
    return this->complete();
  }

  /** Whether nothing was left out: else what was computed is not to be read. */
  bool complete() const { return m_complete && m_sums.complete(); }

  /**
   * Eigenvectors of small eigenvalues, each over the eigenvalue's root, so that all have the energy
   * 1; together, that of d functions, they are to have twice the area.
   */
  static Eigen::MatrixXd combination(const Eigen::MatrixXd& energy, double area, int dimension)
  {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      0.5 * (energy + energy.transpose()));
    const Eigen::VectorXd& values = solver.eigenvalues();
    const double least = minShareOfLargest * values[values.size() - 1];
    Eigen::MatrixXd chosen = Eigen::MatrixXd::Zero(energy.rows(), dimension);
    int count = 0;
    for (Eigen::Index k = 0; k < values.size() && count < dimension; ++k)
    {
      if (values[k] > least) // others are the functions that are 0
      {
        chosen.col(count++) = solver.eigenvectors().col(k) / std::sqrt(values[k]);
      }
    }
    return count > 0 ? Eigen::MatrixXd(chosen * std::sqrt(2.0 * area / count)) : chosen;
  }

  const MetricLaplacian& m_laplacian;
  RunControl m_control;
  ComponentSums m_sums;
  Rows m_functions; ///< V x (d + spare)
  bool m_complete = true;
};
}

bool makeSpectralStart(const MetricLaplacian& laplacian, int dimension, std::uint64_t seed,
  const RunControl& control, Rows& places)
{
  return InverseIteration(laplacian, control).run(dimension, seed, places);
}
}
