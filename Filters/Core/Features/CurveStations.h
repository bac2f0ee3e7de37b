/**
 * @file CurveStations.h
 * @brief Places on feature curves, and lengths along these.
 */
#ifndef remesh_CurveStations_h
#define remesh_CurveStations_h

#include "Features/FeaturedSurface.h"

#include <vector>

namespace remesh
{
/** A place on a curve: on its edge `segment`, from point `segment` (t = 0) to the next. */
struct Station
{
  Index segment;
  double t; ///< [0, 1); 1 only at the very end of a curve

  bool operator==(const Station& other) const
  {
    return this->segment == other.segment && this->t == other.t;
  }
  bool operator<(const Station& other) const
  {
    return this->segment != other.segment ? this->segment < other.segment : this->t < other.t;
  }
};

/** On one of m segments; what is at a point is on the segment that begins there. */
inline Station stationIn(Index segment, double t, Index numberOfSegments)
{
  return t == 1.0 && segment + 1 < numberOfSegments ? Station{ segment + 1, 0.0 }
                                                    : Station{ segment, t };
}

/** For each curve, places in ascending order; both ends are among them, also of closed curves. */
using Stations = std::vector<std::vector<Station>>;

/**
 * Length along a curve in the embedding, as a density scales it, at each of its points (m + 1): of
 * its finest side.
 */
std::vector<double> measureCurve(const FeaturedSurface& featured, Index curve);

/** The lengths along each curve that is asked for. */
class CurveLengths
{
public:
  explicit CurveLengths(const FeaturedSurface& featured)
    : m_featured(featured)
    , m_lengths(featured.features.curves.size())
  {
  }

  const std::vector<double>& of(Index curve)
  {
    std::vector<double>& lengths = m_lengths[curve];
    if (lengths.empty())
    {
      lengths = measureCurve(m_featured, curve);
    }
    return lengths;
  }

private:
  FeaturedSurface m_featured;
  std::vector<std::vector<double>> m_lengths;
};

/** The place at some length of a curve with these lengths at its points. */
Station stationAt(const std::vector<double>& lengths, double length);

/** The length at a place. */
double lengthAt(const std::vector<double>& lengths, const Station& station);

/**
 * Puts a place between those of a curve with these lengths at its points; false, and nothing done,
 * if its section is shorter than `minSection`, or it would be nearer to one of them than
 * `minGap` of the section.
 */
bool insertStation(const std::vector<double>& lengths, const Station& station, double minSection,
  double minGap, std::vector<Station>& places);

/** The first place from one end of a curve that is at some distance from that end in R^3. */
Station stationAtRadius(
  const SurfaceMesh& mesh, const FeatureCurve& curve, bool fromFront, double radius);
}

#endif
