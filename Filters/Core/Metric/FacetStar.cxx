#include "Metric/FacetStar.h"

#include <algorithm>
#include <cmath>

namespace remesh
{
namespace
{
constexpr double maxBend = 1.0; // radians, by which angles may differ from a full turn
constexpr double maxBorderBend = 0.3;

double qualityOf(const Vector2& a, const Vector2& b, const Vector2& c)
{
  const double sum = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return 2.0 * std::sqrt(3.0) * cross(b - a, c - a) / sum;
}
}

bool walkAround(const JoinedFacets& facets, Index point, Star& star)
{
  const Index begin = facets.cornerOfPoint[point];
  Index corner = begin;
  for (Index side = facets.across[corner / 3][corner % 3]; side != noIndex;
       side = facets.across[corner / 3][corner % 3])
  {
    corner = cornerOf(side / 3, next(static_cast<int>(side % 3))); // clockwise
    if (corner == begin)
    {
      break;
    }
  }
  const Index first = corner;
  star.facets = 0;
  for (;;)
  {
    if (star.facets == Star::maxFacets)
    {
      return false;
    }
    const Index facet = corner / 3;
    const int k = static_cast<int>(corner % 3);
    star.points[star.facets] = facets.points[facet][next(k)];
    star.corners[star.facets++] = corner;
    const Index side = facets.across[facet][next(next(k))];
    star.isBorder = side == noIndex;
    if (star.isBorder)
    {
      star.points[star.facets] = facets.points[facet][next(next(k))];
      star.ends = star.facets + 1;
      return true;
    }
    corner = side; // the point is where that side begins
    if (corner == first)
    {
      star.ends = star.facets;
      return true;
    }
  }
}

bool layOut(const JoinedFacets& facets, Star& star)
{
  double spokes[Star::maxFacets + 1] = {};
  double angles[Star::maxFacets];
  double sum = 0.0;
  star.worst = 1.0;
  for (int i = 0; i < star.facets; ++i)
  {
    const std::array<double, 3>& lengths = facets.lengths[star.corners[i] / 3];
    const int k = static_cast<int>(star.corners[i] % 3);
    const double a = lengths[k];
    const double b = lengths[next(next(k))];
    const double c = lengths[next(k)];
    const double cosine = (a * a + b * b - c * c) / (2.0 * a * b);
    const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
    angles[i] = std::atan2(sine, cosine);
    sum += angles[i];
    star.worst =
      std::min(star.worst, 2.0 * std::sqrt(3.0) * a * b * sine / (a * a + b * b + c * c));
    const int end = star.from(i, 1);
    spokes[i] += (star.isBorder && i == 0 ? 1.0 : 0.5) * a;
    spokes[end] += (star.isBorder && i == star.facets - 1 ? 1.0 : 0.5) * b;
  }
  const double bend = sum - (star.isBorder ? pi : 2.0 * pi);
  if (!(std::abs(bend) < (star.isBorder ? maxBorderBend : maxBend)))
  {
    return false;
  }
  const double scale = star.isBorder ? 1.0 : 2.0 * pi / sum;
  double angle = 0.0;
  for (int i = 0; i < star.ends; ++i)
  {
    star.places[i] = { spokes[i] * std::cos(angle), spokes[i] * std::sin(angle) };
    angle += i < star.facets ? scale * angles[i] : 0.0;
  }
  return true;
}

double qualityFrom(const Star& star, int end, double longest)
{
  const double longest2 = longest * longest;
  double worst = 1.0;
  for (int k = 1; k + 1 < star.ends; ++k)
  {
    const Vector2& a = star.places[end];
    const Vector2& b = star.places[star.from(end, k)];
    const Vector2& c = star.places[star.from(end, k + 1)];
    if (k > 1 && (b - a).squaredNorm() > longest2)
    {
      return -1.0;
    }
    worst = std::min(worst, qualityOf(a, b, c));
  }
  // A border gets a new side, from one end to the other.
  return star.isBorder && (star.places[0] - star.places[star.ends - 1]).squaredNorm() > longest2
    ? -1.0
    : worst;
}

bool isTaken(const JoinedFacets& facets, const Star& star, int end)
{
  Star other;
  if (!walkAround(facets, star.points[end], other))
  {
    return true;
  }
  // Those next to it around the star are joined to it.
  const int first = star.isBorder && end != 0 ? 1 : 2;
  const int last = star.isBorder && end == 0 ? star.ends : star.ends - 1;
  for (int k = first; k < last; ++k)
  {
    const Index point = star.points[star.from(end, k)];
    if (std::find(other.points, other.points + other.ends, point) != other.points + other.ends)
    {
      return true;
    }
  }
  return false;
}

Index outside(const JoinedFacets& facets, const Star& star, int facet)
{
  const Index corner = star.corners[facet];
  return facets.across[corner / 3][next(static_cast<int>(corner % 3))];
}
}
