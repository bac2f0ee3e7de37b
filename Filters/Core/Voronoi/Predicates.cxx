#include "Voronoi/Predicates.h"

#include "Voronoi/Expansion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace remesh
{
namespace
{
constexpr double epsilon = std::numeric_limits<double>::epsilon() / 2.0; // 2^-53
// Shewchuk 1997, section 4: forward error of a determinant of once-rounded differences.
constexpr double orient2dBound = (3.0 + 16.0 * epsilon) * epsilon;
constexpr double orient3dBound = (7.0 + 56.0 * epsilon) * epsilon;
// Below this, underflow could make the bounds wrong: go exact.
constexpr double safeMagnitude = 1e-200;

using Plane = std::array<double, 2>;

int signOf(double value)
{
  return (value > 0.0) - (value < 0.0);
}

/** Exact sign of det(b - a, c - a) for points of the plane. */
int exactOrient2d(const Plane& a, const Plane& b, const Plane& c)
{
  Expansion sum;
  sum.addProduct(a[0], b[1]);
  sum.addProduct(-a[1], b[0]);
  sum.addProduct(b[0], c[1]);
  sum.addProduct(-b[1], c[0]);
  sum.addProduct(c[0], a[1]);
  sum.addProduct(-c[1], a[0]);
  return sum.sign();
}

int orient2d(const Plane& a, const Plane& b, const Plane& c, Decisions decisions)
{
  const double left = (b[0] - a[0]) * (c[1] - a[1]);
  const double right = (b[1] - a[1]) * (c[0] - a[0]);
  const double bound = orient2dBound * (std::abs(left) + std::abs(right));
  const double det = left - right;
  if ((std::abs(det) > bound && bound > safeMagnitude) || decisions == Decisions::FilterAlone)
  {
    return signOf(det);
  }
  return exactOrient2d(a, b, c);
}

/** Adds sign * det(a, b, c), the rows being the H values of three sites. */
void addDeterminant(
  Expansion& sum, double sign, const FacetSite& a, const FacetSite& b, const FacetSite& c)
{
  sum.addProduct(sign * a.h[0], b.h[1], c.h[2]);
  sum.addProduct(-sign * a.h[0], b.h[2], c.h[1]);
  sum.addProduct(sign * a.h[1], b.h[2], c.h[0]);
  sum.addProduct(-sign * a.h[1], b.h[0], c.h[2]);
  sum.addProduct(sign * a.h[2], b.h[0], c.h[1]);
  sum.addProduct(-sign * a.h[2], b.h[1], c.h[0]);
}

/** Sign of det(j - i, m - i, q - i). */
int orient3d(const FacetSite& i, const FacetSite& j, const FacetSite& m, const FacetSite& q,
  Decisions decisions)
{
  double u[3], v[3], w[3];
  for (int k = 0; k < 3; ++k)
  {
    u[k] = j.h[k] - i.h[k];
    v[k] = m.h[k] - i.h[k];
    w[k] = q.h[k] - i.h[k];
  }
  double det = 0.0;
  double permanent = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const double left = u[(k + 1) % 3] * v[(k + 2) % 3];
    const double right = u[(k + 2) % 3] * v[(k + 1) % 3];
    det += w[k] * (left - right);
    permanent += std::abs(w[k]) * (std::abs(left) + std::abs(right));
  }
  const double bound = orient3dBound * permanent;
  if ((std::abs(det) > bound && bound > safeMagnitude) || decisions == Decisions::FilterAlone)
  {
    return signOf(det);
  }
  Expansion sum;
  addDeterminant(sum, 1.0, j, m, q);
  addDeterminant(sum, -1.0, i, m, q);
  addDeterminant(sum, 1.0, i, j, q);
  addDeterminant(sum, -1.0, i, j, m);
  return sum.sign();
}

/** The orientation of b - a against the direction (1, 1): a difference of differences. */
int orientDiagonally(const Plane& a, const Plane& b)
{
  Expansion sum;
  sum.add(b[1]);
  sum.add(-b[0]);
  sum.add(-a[1]);
  sum.add(a[0]);
  return sum.sign();
}

/**
 * Sign of (1,1,1) . ((b - a) x (c - a)): how the determinant above grows with a common shift of
 * the fourth site, and the orientation in which the three cells meet.
 */
int orientationSum(const FacetSite& a, const FacetSite& b, const FacetSite& c)
{
  Expansion sum;
  const FacetSite* rows[3] = { &a, &b, &c };
  for (int r = 0; r < 3; ++r)
  {
    const FacetSite& x = *rows[r];
    const FacetSite& y = *rows[(r + 1) % 3];
    for (int k = 0; k < 3; ++k)
    {
      const int l = (k + 1) % 3;
      sum.addProduct(x.h[k], y.h[l]);
      sum.addProduct(-x.h[l], y.h[k]);
    }
  }
  return sum.sign();
}
}

// With u = H_j - H_i and w = H_q - H_i, the crossing is at t = u_k / (u_k - u_l), where w is
// (u_k w_l - u_l w_k) / (u_k - u_l): orient2d of (H_k, H_l) over a known sign. A common shift eps
// of one site changes that determinant by eps times: u_k - u_l for q, w_l - w_k for j, and for i
// the rest; the site of the largest id whose factor is not zero decides a tie.
bool beatsOnEdge(const FacetSite& q, const FacetSite& i, const FacetSite& j, int k, bool leaving,
  Decisions decisions)
{
  const int l = (k + 1) % 3;
  const int direction = leaving ? 1 : -1; // sign of u_k - u_l
  const Plane pi{ i.h[k], i.h[l] };
  const Plane pj{ j.h[k], j.h[l] };
  const Plane pq{ q.h[k], q.h[l] };
  int sign = orient2d(pi, pj, pq, decisions);
  if (sign == 0 && decisions == Decisions::Exact)
  {
    struct Factor
    {
      Index id;
      int sign;
    };
    std::array<Factor, 3> factors{ { { q.id, direction }, { j.id, orientDiagonally(pi, pq) },
      { i.id, orientDiagonally(pq, pj) } } };
    std::sort(
      factors.begin(), factors.end(), [](const Factor& a, const Factor& b) { return a.id > b.id; });
    for (const Factor& factor : factors)
    {
      if (factor.sign != 0)
      {
        sign = factor.sign;
        break;
      }
    }
  }
  return sign * direction < 0;
}

// With u = H_j - H_i, v = H_m - H_i, w = H_q - H_i the point is u x v over its (positive) sum, and
// q beats i there when det(u, v, w) < 0. A common shift of q, j, m or i changes the determinant by
// the orientation sums of the other three.
bool beatsInside(const FacetSite& q, const FacetSite& i, const FacetSite& j, const FacetSite& m,
  Decisions decisions)
{
  int sign = orient3d(i, j, m, q, decisions);
  if (sign == 0 && decisions == Decisions::Exact)
  {
    struct Factor
    {
      const FacetSite* site;
      const FacetSite* others[3];
    };
    std::array<Factor, 4> factors{ { { &q, { &i, &j, &m } }, { &j, { &i, &m, &q } },
      { &m, { &i, &q, &j } }, { &i, { &j, &q, &m } } } };
    std::sort(factors.begin(), factors.end(),
      [](const Factor& a, const Factor& b) { return a.site->id > b.site->id; });
    for (const Factor& factor : factors)
    {
      sign = factor.site == &q
        ? 1
        : orientationSum(*factor.others[0], *factor.others[1], *factor.others[2]);
      if (sign != 0)
      {
        break;
      }
    }
  }
  return sign < 0;
}
}
