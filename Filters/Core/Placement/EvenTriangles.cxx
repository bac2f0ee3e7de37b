#include "Placement/EvenTriangles.h"

#include "Placement/Placement.h"
#include "Support/Parallel.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>

namespace remesh
{
namespace
{
/**
 * Of sizes, against shapes. Measured on a layer along a sine (10 : 1) and a direction that turns
 * (5 : 1): the mean quality in the metric, and the length that 1 % of the edges are shorter than.
 *
 *   without sliding   0.979, 0.847   0.954, 0.821
 *   weight 0.3        0.985, 0.828   0.963, 0.793
 *   weight 1          0.982, 0.842   0.959, 0.807
 */
constexpr double sizeWeight = 0.65;
constexpr double boundOfEnergy = 1.0 + 2.0 * sizeWeight;
constexpr double stepShare = 0.6; // of Newton's: neighbours make theirs at the same time
constexpr int maxRounds = 20;
constexpr double minDecrease = 0.001; // of what the energy is above its bound
constexpr double maxRise = 1.2;       // of a triangle's energy in a round, times
constexpr int maxHalvings = 3;        // then vertices stay

/** A triangle as the metric at its centre has it. */
struct MeasuredTriangle
{
  Eigen::Matrix<double, 2, 3> ruler; ///< to the plane where lengths are those of the metric
  double area = 0.0;                 ///< share of that of equal sides 1, along the surface
  double squares = 0.0;              ///< mean square of the edges

  double energy(double unit2) const
  {
    const double d = this->area / unit2;
    return d > 0.0 ? this->squares / this->area + sizeWeight * (d + 1.0 / d)
                   : std::numeric_limits<double>::infinity();
  }
};

constexpr double areaOfEqualSides = 0.43301270189221932; // sqrt(3) / 4

/** The edge of a triangle from the corner after k to the one before. */
Eigen::Vector2d opposite(
  const MeasuredTriangle& triangle, const std::array<Point3, 3>& corners, int k)
{
  return triangle.ruler * (corners[(k + 2) % 3] - corners[(k + 1) % 3]);
}

class EvenTriangles
{
public:
  EvenTriangles(const PlacementProblem& problem, const RunControl& control,
    std::vector<SurfaceLocation>& locations)
    : m_problem(problem)
    , m_control(control)
    , m_surface(problem, control)
    , m_stars(problem.triangles, problem.numberOfVertices())
    , m_locations(locations)
  {
  }

  Status run(std::vector<Point3>& places)
  {
    places = placesOnSurface(m_problem, m_locations, places);
    std::vector<MeasuredTriangle> triangles(m_problem.triangles.size());
    if (!this->measure(places, {}, triangles))
    {
      return Status::cancelled();
    }
    this->findUnit(triangles);
    double energy = this->meanEnergy(triangles);
    for (int round = 0; round < maxRounds && energy > boundOfEnergy; ++round)
    {
      State next{ places, m_locations, triangles };
      if (!this->go(places, triangles, next))
      {
        return Status::cancelled();
      }
      const double now = this->meanEnergy(next.triangles);
      if (!(now < energy))
      {
        break;
      }
      const bool isLast = energy - now < minDecrease * (energy - boundOfEnergy);
      energy = now;
      places = std::move(next.places);
      m_locations = std::move(next.locations);
      triangles = std::move(next.triangles);
      if (isLast)
      {
        break;
      }
    }
    return Status::success();
  }

private:
  struct State
  {
    std::vector<Point3> places;
    std::vector<SurfaceLocation> locations;
    std::vector<MeasuredTriangle> triangles;
  };

  std::array<Point3, 3> cornersOf(std::size_t t, const std::vector<Point3>& places) const
  {
    const Triple& vertices = m_problem.triangles[t];
    return { places[vertices[0]], places[vertices[1]], places[vertices[2]] };
  }

  /** Measures triangles, but for those whose vertices are where they were; `before` may be empty.
   */
  bool measure(const std::vector<Point3>& places, const std::vector<Point3>& before,
    std::vector<MeasuredTriangle>& triangles) const
  {
    return forEachItem(Blocks::cut(static_cast<Offset>(triangles.size()), 64, 4096), m_control,
      [&](Offset t)
      {
        const Triple& vertices = m_problem.triangles[t];
        const bool hasMoved = before.empty() ||
          std::any_of(
            vertices.begin(), vertices.end(), [&](Index v) { return places[v] != before[v]; });
        if (hasMoved)
        {
          triangles[t] = this->measured(static_cast<std::size_t>(t), places);
        }
      });
  }

  MeasuredTriangle measured(std::size_t t, const std::vector<Point3>& places) const
  {
    const std::array<Point3, 3> corners = this->cornersOf(t, places);
    const Index* cells = m_problem.triangles[t].data();
    const SurfaceLocation at =
      m_surface.closest(cells, cells + 3, (corners[0] + corners[1] + corners[2]) / 3.0);
    MeasuredTriangle triangle;
    if (at.facet == noIndex)
    {
      return triangle;
    }
    triangle.ruler = rulerAt(m_problem.mesh, *m_problem.metric, at.facet, at.b);
    const Eigen::Vector2d a = opposite(triangle, corners, 0);
    const Eigen::Vector2d b = opposite(triangle, corners, 1);
    triangle.area = 0.5 * (a[0] * b[1] - a[1] * b[0]) / areaOfEqualSides;
    triangle.squares = (a.squaredNorm() + b.squaredNorm() + (a + b).squaredNorm()) / 3.0;
    return triangle;
  }

  /** The area of which all triangles should be: the mean of logarithms, so that few do not count.
   */
  void findUnit(const std::vector<MeasuredTriangle>& triangles)
  {
    double sum = 0.0;
    Offset count = 0;
    for (const MeasuredTriangle& triangle : triangles)
    {
      if (triangle.area > 0.0)
      {
        sum += std::log(triangle.area);
        ++count;
      }
    }
    m_unit2 = count > 0 ? std::exp(sum / static_cast<double>(count)) : 1.0;
  }

  /** Of the triangles that face along the surface at the start, and then always do. */
  double meanEnergy(const std::vector<MeasuredTriangle>& triangles) const
  {
    double sum = 0.0;
    Offset count = 0;
    for (const MeasuredTriangle& triangle : triangles)
    {
      if (triangle.area > 0.0)
      {
        sum += triangle.energy(m_unit2);
        ++count;
      }
    }
    return count > 0 ? sum / static_cast<double>(count) : 0.0;
  }

  /** The step of a vertex; 0 where it must stay. */
  Point3 wayOf(Index vertex, const std::vector<Point3>& places,
    const std::vector<MeasuredTriangle>& triangles) const
  {
    Point3 slope = Point3::Zero();
    Eigen::Matrix3d bend = Eigen::Matrix3d::Zero();
    for (Offset k = m_stars.begin(vertex); k < m_stars.end(vertex); ++k)
    {
      const auto t = static_cast<std::size_t>(m_stars.triangles[k]);
      const MeasuredTriangle& triangle = triangles[t];
      if (!(triangle.area > 0.0))
      {
        return Point3::Zero();
      }
      const Triple& vertices = m_problem.triangles[t];
      const auto corner =
        static_cast<int>(std::find(vertices.begin(), vertices.end(), vertex) - vertices.begin());
      this->addTerm(triangle, this->cornersOf(t, places), corner, slope, bend);
    }
    const TangentFrame frame =
      TangentFrame::of(m_problem.mesh, static_cast<std::size_t>(m_locations[vertex].facet));
    const Tensor2 within = frame.within(bend);
    if (!(within.determinant() > 0.0))
    {
      return Point3::Zero();
    }
    const Tensor2 inverted = inverse(within);
    const double x = -stepShare * slope.dot(frame.x);
    const double y = -stepShare * slope.dot(frame.y);
    return (inverted.xx * x + inverted.xy * y) * frame.x +
      (inverted.xy * x + inverted.yy * y) * frame.y;
  }

  /** What a triangle adds to the slope of the energy at a corner, and about to the second one. */
  void addTerm(const MeasuredTriangle& triangle, const std::array<Point3, 3>& corners, int corner,
    Point3& slope, Eigen::Matrix3d& bend) const
  {
    const Eigen::Vector2d across = opposite(triangle, corners, corner);
    const Eigen::Vector2d toCorner =
      opposite(triangle, corners, (corner + 1) % 3); // from before it
    const Eigen::Vector2d fromCorner = opposite(triangle, corners, (corner + 2) % 3);
    const double d = triangle.area / m_unit2;
    const double shape = triangle.squares / triangle.area;
    const Eigen::Vector2d ofSquares = (2.0 / 3.0 / m_unit2) * (toCorner - fromCorner);
    const Eigen::Vector2d ofArea =
      Eigen::Vector2d(-across[1], across[0]) * (0.5 / areaOfEqualSides / m_unit2);
    const Eigen::Vector2d sum =
      ofSquares / d + (sizeWeight - (shape + sizeWeight / d) / d) * ofArea;
    slope += triangle.ruler.transpose() * sum;
    bend +=
      (1.0 / d + sizeWeight / (d * d * d)) / m_unit2 * triangle.ruler.transpose() * triangle.ruler;
  }

  /** One round, from the places at hand to those of `next`. */
  bool go(const std::vector<Point3>& places, const std::vector<MeasuredTriangle>& triangles,
    State& next) const
  {
    const auto count = static_cast<Offset>(places.size());
    std::vector<Point3> ways(places.size(), Point3::Zero());
    if (!forEachItem(Blocks::cut(count, 64, 4096), m_control,
          [&](Offset v)
          {
            if (!m_problem.isFixed(static_cast<std::size_t>(v)))
            {
              ways[v] = this->wayOf(static_cast<Index>(v), places, triangles);
            }
          }))
    {
      return false;
    }
    std::vector<char> halved(places.size(), 0); // times
    for (bool isDone = false; !isDone;)
    {
      if (!this->follow(places, ways, next))
      {
        return false;
      }
      isDone = !this->shorten(triangles, next.triangles, halved, ways);
    }
    return true;
  }

  /** Goes the ways on the surface, and measures what they make. */
  bool follow(const std::vector<Point3>& places, const std::vector<Point3>& ways, State& next) const
  {
    std::vector<Point3> goals = places;
    for (std::size_t v = 0; v < goals.size(); ++v)
    {
      goals[v] += ways[v];
    }
    const std::vector<Point3> before = next.places;
    next.locations = m_locations;
    if (!locatePlaces(m_surface, places, goals, m_control, next.locations).ok())
    {
      return false;
    }
    next.places = placesOnSurface(m_problem, next.locations, places);
    return this->measure(next.places, before, next.triangles);
  }

  /** Shortens the ways of vertices around what has become worse; whether there are any. */
  bool shorten(const std::vector<MeasuredTriangle>& triangles,
    const std::vector<MeasuredTriangle>& next, std::vector<char>& halved,
    std::vector<Point3>& ways) const
  {
    std::vector<char> isWorse(ways.size(), 0);
    bool any = false;
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      if (triangles[t].area > 0.0 &&
        next[t].energy(m_unit2) > maxRise * triangles[t].energy(m_unit2))
      {
        for (const Index vertex : m_problem.triangles[t])
        {
          isWorse[vertex] = 1;
          any = true;
        }
      }
    }
    for (std::size_t v = 0; any && v < ways.size(); ++v)
    {
      if (isWorse[v])
      {
        ways[v] *= halved[v] < maxHalvings ? 0.5 : 0.0;
        halved[v] = static_cast<char>(std::min<int>(halved[v] + 1, maxHalvings));
      }
    }
    return any;
  }

  const PlacementProblem& m_problem;
  const RunControl& m_control;
  NearbySurface m_surface;
  VertexStars m_stars;
  std::vector<SurfaceLocation>& m_locations;
  double m_unit2 = 1.0; ///< mean area, as a share of that of equal sides 1
};
}

Status evenOutTriangles(const PlacementProblem& problem, const RunControl& control,
  std::vector<SurfaceLocation> locations, std::vector<Point3>& places)
{
  return EvenTriangles(problem, control, locations).run(places);
}
}
