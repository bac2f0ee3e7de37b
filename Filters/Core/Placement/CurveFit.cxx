#include "Placement/CurveFit.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace remesh
{
namespace
{
using Matrix3 = Eigen::Matrix3d;

constexpr int rounds = 3;
constexpr double chordRounding = 1e-24; // of a chord's squared length
constexpr int sweeps = 24;              // each leaves a quarter of the error
// Of a place's weight:
constexpr double damping = 1e-3; // it stays where nothing pulls
constexpr double holding = 10.0; // along the curve, where it is spaced well

/** The normal equations of one section, for the displacements of its ends. */
struct SectionSums
{
  Matrix3 blocks[3] = { Matrix3::Zero(), Matrix3::Zero(), Matrix3::Zero() }; ///< 00, 01, 11
  Point3 slopes[2] = { Point3::Zero(), Point3::Zero() };
  double weights[2] = { 0.0, 0.0 };
};

/** Fits the places of one curve. */
class CurveFit
{
public:
  /** @param places at the stations; those of a round curve begin and end with the same. */
  CurveFit(const std::vector<Point3>& points, const FeatureCurve& curve,
    const std::vector<Station>& stations, std::vector<Point3> places)
    : m_points(points)
    , m_curve(curve)
    , m_stations(stations)
    , m_places(std::move(places))
  {
  }

  const std::vector<Point3>& fit()
  {
    for (int round = 0; round < rounds; ++round)
    {
      m_sums.clear();
      for (std::size_t k = 0; k + 1 < m_stations.size(); ++k)
      {
        m_sums.push_back(this->sumSection(k));
      }
      this->solve();
    }
    return m_places;
  }

private:
  Point3 placeAt(const Station& station) const
  {
    const Point3& start = m_points[m_curve.points[station.segment]];
    return start + station.t * (m_points[m_curve.points[station.segment + 1]] - start);
  }

  SectionSums sumSection(std::size_t section) const
  {
    SectionSums sums;
    Point3 last = this->placeAt(m_stations[section]);
    for (Index k = m_stations[section].segment + 1; k <= m_stations[section + 1].segment; ++k)
    {
      const Point3& next = m_points[m_curve.points[k]];
      this->addStretch(section, last, next, sums);
      last = next;
    }
    this->addStretch(section, last, this->placeAt(m_stations[section + 1]), sums);
    return sums;
  }

  /** A straight part of the curve; two samples integrate what is quadratic along it. */
  void addStretch(
    std::size_t section, const Point3& from, const Point3& to, SectionSums& sums) const
  {
    const double weight = 0.5 * (to - from).norm();
    const Point3& a = m_places[section];
    const Point3 chord = m_places[section + 1] - a;
    const double squared = chord.squaredNorm();
    if (!(weight > 0.0) || !(squared > 0.0))
    {
      return;
    }
    const Matrix3 across = Matrix3::Identity() - chord * chord.transpose() / squared;
    for (const double sample : { 0.5 - std::sqrt(1.0 / 12.0), 0.5 + std::sqrt(1.0 / 12.0) })
    {
      const Point3 offset = from + sample * (to - from) - a;
      const double t = std::clamp(offset.dot(chord) / squared, 0.0, 1.0);
      Point3 residual = across * (offset - t * chord);
      if (residual.squaredNorm() < chordRounding * squared)
      {
        residual.setZero(); // what is straight stays, to the bit
      }
      const double shares[2] = { 1.0 - t, t };
      sums.blocks[0] += weight * shares[0] * shares[0] * across;
      sums.blocks[1] += weight * shares[0] * shares[1] * across;
      sums.blocks[2] += weight * shares[1] * shares[1] * across;
      for (int end = 0; end < 2; ++end)
      {
        sums.slopes[end] += weight * shares[end] * residual;
        sums.weights[end] += weight * shares[end] * shares[end];
      }
    }
  }

  bool isRound() const { return !m_curve.hasCorners; }
  std::size_t before(std::size_t k) const { return k > 0 ? k - 1 : m_sums.size() - 1; }
  std::size_t after(std::size_t k) const
  {
    return k + 1 < m_sums.size() || !this->isRound() ? k + 1 : 0;
  }

  /** Of a place's own block. */
  Matrix3 inverseAt(std::size_t k) const
  {
    const SectionSums& left = m_sums[this->before(k)];
    const SectionSums& right = m_sums[k];
    const double weight = left.weights[1] + right.weights[0];
    if (!(weight > 0.0))
    {
      return Matrix3::Zero();
    }
    const Point3 along = (m_places[k + 1] - m_places[this->before(k)]).stableNormalized();
    return (left.blocks[2] + right.blocks[0] + damping * weight * Matrix3::Identity() +
      holding * weight * along * along.transpose())
      .inverse();
  }

  void solve()
  {
    const std::size_t sections = m_sums.size();
    const std::size_t first = this->isRound() ? 0 : 1;
    std::vector<Point3> moves(sections + 1, Point3::Zero());
    std::vector<Matrix3> inverses(sections + 1, Matrix3::Zero());
    for (std::size_t k = first; k < sections; ++k)
    {
      inverses[k] = this->inverseAt(k);
    }
    for (int sweep = 0; sweep < sweeps; ++sweep)
    {
      for (std::size_t k = first; k < sections; ++k)
      {
        const SectionSums& left = m_sums[this->before(k)];
        const SectionSums& right = m_sums[k];
        moves[k] = inverses[k] *
          (left.slopes[1] + right.slopes[0] - left.blocks[1] * moves[this->before(k)] -
            right.blocks[1] * moves[this->after(k)]);
      }
    }
    moves[sections] = this->isRound() ? moves[0] : Point3::Zero();
    for (std::size_t k = 0; k <= sections; ++k)
    {
      m_places[k] += moves[k];
    }
  }

  const std::vector<Point3>& m_points;
  const FeatureCurve& m_curve;
  const std::vector<Station>& m_stations;
  std::vector<Point3> m_places;
  std::vector<SectionSums> m_sums;
};
}

bool fitCurves(const FeaturedSurface& featured, const FeatureSites& featureSites,
  const RunControl& control, std::vector<Point3>& places)
{
  places.clear();
  for (const FeaturePoint& point : featureSites.points)
  {
    places.push_back(point.place);
  }
  for (std::size_t c = 0; c < featureSites.stations.size(); ++c)
  {
    if (control.cancelled())
    {
      return false;
    }
    const FeatureCurve& curve = featured.features.curves[c];
    const std::vector<Index>& points = featureSites.curvePoints[c];
    std::vector<Point3> start;
    for (const Index point : points)
    {
      start.push_back(featureSites.points[point].place);
    }
    CurveFit fit(featured.mesh.points, curve, featureSites.stations[c], std::move(start));
    const std::vector<Point3>& fitted = fit.fit();
    for (std::size_t k = curve.hasCorners ? 1 : 0; k + 1 < fitted.size(); ++k)
    {
      places[points[k]] = fitted[k];
    }
  }
  return true;
}
}
