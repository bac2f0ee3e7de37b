/**
 * @file StarFit.h
 * @brief The feet of a cell's samples in the triangles around its vertex, and what they add there.
 */
#ifndef remesh_StarFit_h
#define remesh_StarFit_h

#include "Placement/StarSums.h"

namespace remesh
{
/** What the samples of a block of vertices add to the triangles that they meet. */
struct StarBlock
{
  std::vector<Index> triangles;
  std::vector<TriangleSums> sums;
};

/**
 * One thread's work on one block after the other, one vertex at a time: its triangles are prepared
 * once for its many samples. Takes 4 bytes for each triangle of the mesh.
 */
class StarFit
{
public:
  StarFit(
    const PlacementProblem& problem, const VertexStars& stars, const std::vector<Point3>& positions)
    : m_problem(problem)
    , m_stars(stars)
    , m_positions(positions)
    , m_slots(problem.triangles.size(), noIndex)
  {
  }

  /**
   * Sums up the samples of consecutive vertices, each in the triangles around its vertex that face
   * as it does (so never in another sheet): where it lies right above some of them, in the nearest
   * of these; else in the one with the closest point. O(samples times triangles of a vertex).
   *
   * @param number of the block of samples.
   */
  void sum(FitSamples& samples, Offset number, StarBlock& block);

private:
  Index slotOf(Index triangle, StarBlock& block);
  void enter(Index vertex, StarBlock& block);
  void addClosest(const SampleGroup& group, int lane, double unit, StarBlock& block) const;

  const PlacementProblem& m_problem;
  const VertexStars& m_stars;
  const std::vector<Point3>& m_positions;

  Index m_center = noIndex;
  std::vector<Index> m_slots;       ///< T, of the block's sums; noIndex where it has none
  std::vector<Index> m_entered;     ///< triangles with a slot
  std::vector<Point3> m_normals;    ///< of these, unit
  std::vector<StarTriangle> m_star; ///< those with area; zero where too narrow to lie above
  std::vector<Index> m_others;
  SampleBlock m_scratch; ///< samples that are not kept
  StarSummation m_sum = starSummation(widestInstructionSet());
};
}

#endif
