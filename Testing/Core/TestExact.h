/**
 * @file TestExact.h
 * @brief The decisions of Voronoi/Predicates by definition, in exact rational arithmetic.
 *
 * Every double is an integer over a power of two, and so is what +, - and * make of doubles: with
 * integers of any length, nothing is rounded. The symbolic perturbation becomes a true one, by
 * numbers small enough. Shares no code and no idea with Predicates.cxx and Expansion.h.
 */
#ifndef remesh_TestExact_h
#define remesh_TestExact_h

#include "Voronoi/Predicates.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace remesh::test
{
/** An integer of any length. */
class BigInteger
{
public:
  BigInteger() = default;

  /** value 2^shift, which must be an integer. */
  BigInteger(double value, int shift)
  {
    int exponent = 0;
    const double mantissa = std::frexp(std::abs(value), &exponent);
    auto limb = static_cast<std::uint64_t>(std::ldexp(mantissa, 53));
    exponent += shift - 53;
    if (exponent < 0) // what falls off must be zeros
    {
      limb = exponent > -64 ? limb >> -exponent : 0;
      exponent = 0;
    }
    const auto first = static_cast<std::size_t>(exponent / 64);
    const int bits = exponent % 64;
    m_negative = value < 0.0;
    m_limbs.assign(first + 2, 0);
    m_limbs[first] = limb << bits;
    m_limbs[first + 1] = bits > 0 ? limb >> (64 - bits) : 0;
    this->trim();
  }

  static BigInteger powerOfTwo(int exponent) { return BigInteger(1.0, exponent); }

  int sign() const { return m_limbs.empty() ? 0 : (m_negative ? -1 : 1); }

  BigInteger operator-() const
  {
    BigInteger result = *this;
    result.m_negative = !m_negative;
    return result;
  }

  friend BigInteger operator+(const BigInteger& a, const BigInteger& b)
  {
    if (a.m_negative == b.m_negative)
    {
      return summed(a, b);
    }
    return isLess(a, b) ? reduced(b, a) : reduced(a, b);
  }

  friend BigInteger operator-(const BigInteger& a, const BigInteger& b) { return a + -b; }

  friend BigInteger operator*(const BigInteger& a, const BigInteger& b)
  {
    BigInteger result;
    result.m_negative = a.m_negative != b.m_negative;
    result.m_limbs.assign(a.m_limbs.size() + b.m_limbs.size(), 0);
    for (std::size_t i = 0; i < a.m_limbs.size(); ++i)
    {
      Wide carry = 0;
      for (std::size_t j = 0; j < b.m_limbs.size(); ++j)
      {
        carry += static_cast<Wide>(a.m_limbs[i]) * b.m_limbs[j] + result.m_limbs[i + j];
        result.m_limbs[i + j] = static_cast<std::uint64_t>(carry);
        carry >>= 64;
      }
      result.m_limbs[i + b.m_limbs.size()] = static_cast<std::uint64_t>(carry);
    }
    result.trim();
    return result;
  }

private:
  __extension__ using Wide = unsigned __int128;

  /** Of the sizes alone. */
  static bool isLess(const BigInteger& a, const BigInteger& b)
  {
    if (a.m_limbs.size() != b.m_limbs.size())
    {
      return a.m_limbs.size() < b.m_limbs.size();
    }
    return std::lexicographical_compare(
      a.m_limbs.rbegin(), a.m_limbs.rend(), b.m_limbs.rbegin(), b.m_limbs.rend());
  }

  static BigInteger summed(const BigInteger& a, const BigInteger& b)
  {
    BigInteger result;
    result.m_negative = a.m_negative;
    const std::size_t size = std::max(a.m_limbs.size(), b.m_limbs.size());
    Wide carry = 0;
    for (std::size_t k = 0; k < size; ++k)
    {
      carry += k < a.m_limbs.size() ? a.m_limbs[k] : 0;
      carry += k < b.m_limbs.size() ? b.m_limbs[k] : 0;
      result.m_limbs.push_back(static_cast<std::uint64_t>(carry));
      carry >>= 64;
    }
    result.m_limbs.push_back(static_cast<std::uint64_t>(carry));
    result.trim();
    return result;
  }

  /** |a| - |b| with the sign of a, for |a| >= |b|. */
  static BigInteger reduced(const BigInteger& a, const BigInteger& b)
  {
    BigInteger result = a;
    std::uint64_t borrow = 0;
    for (std::size_t k = 0; k < a.m_limbs.size(); ++k)
    {
      const Wide taken = static_cast<Wide>(k < b.m_limbs.size() ? b.m_limbs[k] : 0) + borrow;
      borrow = taken > a.m_limbs[k] ? 1 : 0;
      result.m_limbs[k] = static_cast<std::uint64_t>(a.m_limbs[k] - taken);
    }
    result.trim();
    return result;
  }

  void trim()
  {
    while (!m_limbs.empty() && m_limbs.back() == 0)
    {
      m_limbs.pop_back();
    }
  }

  bool m_negative = false;
  std::vector<std::uint64_t> m_limbs; ///< lowest first, the last one not zero
};

/** Up to a handful of sites, perturbed: H_ik + eps_i with 0 < eps_0 << eps_1 << ... by id. */
class ExactSites
{
public:
  explicit ExactSites(std::vector<FacetSite> sites)
    : m_sites(std::move(sites))
  {
    bool found = false;
    for (const FacetSite& site : m_sites)
    {
      for (const double h : site.h)
      {
        if (h != 0.0)
        {
          int exponent = 0;
          std::frexp(h, &exponent);
          m_lowest = found ? std::min(m_lowest, exponent - 53) : exponent - 53;
          m_highest = found ? std::max(m_highest, exponent) : exponent;
          found = true;
        }
      }
    }
    for (const FacetSite& site : m_sites)
    {
      for (const double h : site.h)
      {
        m_plain.emplace_back(h, -m_lowest);
      }
    }
  }

  /** Sign of H_a - H_b at corner k. */
  int atCorner(int a, int b, int k) const
  {
    const int sign = gap(m_plain, a, b, k).sign();
    return sign != 0 ? sign : gap(this->perturbed(), a, b, k).sign();
  }

  /** Sign of H_q - H_i where H_i = H_j on the line through the corners k and k + 1; 0: nowhere. */
  int onEdge(int q, int i, int j, int k) const
  {
    const int sign = onEdge(m_plain, q, i, j, k);
    return sign != 0 ? sign : onEdge(this->perturbed(), q, i, j, k);
  }

  /** Sign of H_q - H_i where H_i = H_j = H_m; 0: nowhere. */
  int inside(int q, int i, int j, int m) const
  {
    const int sign = inside(m_plain, q, i, j, m);
    return sign != 0 ? sign : inside(this->perturbed(), q, i, j, m);
  }

  /** 1 where the cells of i, j, m meet counter-clockwise, 0 where they meet nowhere. */
  int orientation(int i, int j, int m) const { return orientation(m_plain, i, j, m); }

private:
  using Values = std::vector<BigInteger>;

  /**
   * The H values are integers below 2^bits, in units of 2^m_lowest: a determinant that is not zero,
   * or a factor of a perturbation, is at least 1 and below 2^(3 bits + 6). So steps of
   * 2^(3 bits + 16) keep each perturbation apart from the next, and all of them from 1.
   */
  const Values& perturbed() const
  {
    const int bits = m_highest - m_lowest + 1;
    const int step = 3 * bits + 16;
    const int fraction = step * static_cast<int>(m_sites.size());
    for (std::size_t v = m_perturbed.size(); v < m_plain.size(); ++v)
    {
      const FacetSite& site = m_sites[v / 3];
      const auto rank = static_cast<int>(std::count_if(m_sites.begin(), m_sites.end(),
        [&](const FacetSite& other) { return other.id < site.id; }));
      m_perturbed.push_back(
        BigInteger(site.h[v % 3], fraction - m_lowest) + BigInteger::powerOfTwo(step * rank));
    }
    return m_perturbed;
  }

  static BigInteger gap(const Values& h, int a, int b, int k)
  {
    return h[a * 3 + k] - h[b * 3 + k];
  }

  /** H_q - H_i at t along the edge, t = u_k / (u_k - u_l) for u = H_j - H_i. */
  static int onEdge(const Values& h, int q, int i, int j, int k)
  {
    const int l = (k + 1) % 3;
    const BigInteger numerator = gap(h, j, i, k);
    const BigInteger denominator = numerator - gap(h, j, i, l);
    const BigInteger atK = gap(h, q, i, k);
    const BigInteger atL = gap(h, q, i, l);
    return (atK * (denominator - numerator) + atL * numerator).sign() * denominator.sign();
  }

  /** The point where all are the same, in homogeneous coordinates: a cross product. */
  static void meetingPoint(const Values& h, int i, int j, int m, BigInteger b[3])
  {
    for (int k = 0; k < 3; ++k)
    {
      const int l = (k + 1) % 3;
      const int n = (k + 2) % 3;
      b[k] = gap(h, j, i, l) * gap(h, m, i, n) - gap(h, j, i, n) * gap(h, m, i, l);
    }
  }

  static int orientation(const Values& h, int i, int j, int m)
  {
    BigInteger b[3];
    meetingPoint(h, i, j, m, b);
    return (b[0] + b[1] + b[2]).sign();
  }

  static int inside(const Values& h, int q, int i, int j, int m)
  {
    BigInteger b[3];
    meetingPoint(h, i, j, m, b);
    BigInteger sum;
    for (int k = 0; k < 3; ++k)
    {
      sum = sum + b[k] * gap(h, q, i, k);
    }
    return sum.sign() * (b[0] + b[1] + b[2]).sign();
  }

  std::vector<FacetSite> m_sites;
  int m_lowest = 0;
  int m_highest = 0;
  Values m_plain;
  mutable Values m_perturbed; ///< made where sites tie
};
}

#endif
