/**
 * @file CurveSampling.h
 * @brief Where along the feature curves a mesh gets its points.
 */
#ifndef remesh_CurveSampling_h
#define remesh_CurveSampling_h

#include "Features/FeaturedSurface.h"

namespace remesh
{
/** A place on a curve: on its edge `segment`, from point `segment` (t = 0) to the next. */
struct Station
{
  Index segment;
  double t; ///< [0, 1); 1 only at the very end of a curve

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
 * if its section is shorter than `leastSection`, or it would be nearer to one of them than
 * `leastGap` of the section.
 */
bool insertStation(const std::vector<double>& lengths, const Station& station, double leastSection,
  double leastGap, std::vector<Station>& places);

/** The first place from one end of a curve that is at some distance from that end in R^3. */
Station stationAtRadius(
  const SurfaceMesh& mesh, const FeatureCurve& curve, bool fromFront, double radius);

/**
 * Divides each curve evenly in embedded length.
 *
 * 1. Breaks at points of the curve, as few as keep the chords within a distance of it, and so that
 *    the chords' errors are balanced. The distance is the finest for which the curves take no more
 *    than two fifths of the points, from 1e-6 to 2e-5 of the diagonal. Where even that takes more
 *    than half of them for the bends alone, or three fifths in all, it grows on, up to a twentieth
 *    of the points' spacing, until two fifths do for the bends: the rest of the surface needs its
 *    points, too.
 *    No distance is above `mostError`: then the curves take more points, if they must.
 *    Creases that zigzag, as on scans, say little by their bends: their distance is a fifth of the
 *    points' spacing from the beginning.
 * 2. Chords longer than the spacing that `numberOfPoints` give are divided evenly. Where the curves
 *    would take more than three fifths of the points, distance and spacing grow along them.
 * 3. A closed curve has three places at least; no two curves share both ends without a place
 *    between them.
 *
 * @param numberOfPoints of the whole mesh.
 * @param mostError in the unit of the points, above 0.
 * @param needed vertices that corners and bends alone take, at the coarsest distance.
 * @return of no use when cancelled: asked between the tries.
 * Cost: O(V log V) for V points on curves, times the tries for the distance.
 */
Stations sampleCurves(const FeaturedSurface& featured, Offset numberOfPoints, double mostError,
  const RunControl& control, Offset& needed);

/** The vertices that a mesh has on its features: corners, and places between. */
Offset countFeaturePoints(const Features& features, const Stations& stations);
}

#endif
