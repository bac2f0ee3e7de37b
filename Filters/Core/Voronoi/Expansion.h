/**
 * @file Expansion.h
 * @brief Exact sums of products of doubles, as nonoverlapping expansions.
 *
 * J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
 * Predicates", Discrete & Computational Geometry 18, 1997: Two-Sum, Two-Product, Grow-Expansion
 * with zero elimination. Exact as long as nothing over- or underflows; needs strict IEEE doubles
 * (no contraction, no fast math).
 */
#ifndef remesh_Expansion_h
#define remesh_Expansion_h

#include <array>
#include <cmath>

namespace remesh
{
/** A running exact sum with room for the determinants of Predicates.cxx. */
class Expansion
{
public:
  /** Adds a * b. */
  void addProduct(double a, double b)
  {
    const double product = a * b;
    this->add(std::fma(a, b, -product));
    this->add(product);
  }

  /** Adds a * b * c. */
  void addProduct(double a, double b, double c)
  {
    const double high = a * b;
    const double low = std::fma(a, b, -high);
    this->addProduct(low, c);
    this->addProduct(high, c);
  }

  /** Adds one double. */
  void add(double value)
  {
    int kept = 0;
    double carry = value;
    for (int k = 0; k < m_size; ++k)
    {
      const double sum = carry + m_terms[k];
      const double virtualTerm = sum - carry;
      const double error = (carry - (sum - virtualTerm)) + (m_terms[k] - virtualTerm);
      carry = sum;
      if (error != 0.0)
      {
        m_terms[kept++] = error;
      }
    }
    if (carry != 0.0)
    {
      m_terms[kept++] = carry;
    }
    m_size = kept;
  }

  /** -1, 0 or 1: the sign of the largest term. */
  int sign() const { return m_size == 0 ? 0 : (m_terms[m_size - 1] > 0.0 ? 1 : -1); }

  /** The value, rounded: within two units of its last place. */
  double estimate() const
  {
    double sum = 0.0;
    for (int k = 0; k < m_size; ++k)
    {
      sum += m_terms[k];
    }
    return sum;
  }

private:
  // 24 triple products of four terms each are the longest sum; each add makes at most one more.
  std::array<double, 104> m_terms;
  int m_size = 0;
};
}

#endif
