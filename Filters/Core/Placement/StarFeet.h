/**
 * @file StarFeet.h
 * @brief The points of the triangles around a vertex closest to many samples of its cell.
 */
#ifndef remesh_StarFeet_h
#define remesh_StarFeet_h

#include "Placement/PlacementProblem.h"
#include "Placement/StarHeights.h"

namespace remesh
{
/** A place of the mesh. */
struct Foot
{
  Index triangle = noIndex; ///< noIndex: there is none
  double b[3] = { 0.0, 0.0, 0.0 };
};

/**
 * The triangles around one vertex at a time, prepared for their feet: the samples outnumber them.
 */
class StarFeet
{
public:
  StarFeet(const PlacementProblem& problem, const VertexStars& stars,
    const std::vector<Point3>& positions, const std::vector<Point3>& normals)
    : m_problem(problem)
    , m_stars(stars)
    , m_positions(positions)
    , m_normals(normals)
  {
  }

  /** Goes to the star of a vertex. O(its triangles). */
  void enter(Index vertex);

  /**
   * The foot of a point on the triangles that face as `normal` does. Where the point lies right
   * above some of them, the nearest of these; else the closest point of all. O(triangles).
   */
  Foot find(const Point3& point, const Point3& normal);

private:
  Foot footOn(std::size_t triangle, const Point3& way) const;
  Foot findClosest(const Point3& point, const Point3& normal) const;

  const PlacementProblem& m_problem;
  const VertexStars& m_stars;
  const std::vector<Point3>& m_positions;
  const std::vector<Point3>& m_normals; ///< T, unit, zero without area

  Index m_center = noIndex;
  std::vector<Index> m_triangles;  ///< with area
  std::vector<StarGroup> m_groups; ///< the same, but those too narrow to lie above
  std::vector<double> m_squared;   ///< what a search writes
  StarHeightEvaluation m_evaluate = starHeightEvaluation(widestInstructionSet());
};
}

#endif
