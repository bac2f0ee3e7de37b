/**
 * @file FitSamples.h
 * @brief The surface's samples (SurfaceSamples.h) as the fit reads them, round after round.
 *
 * They are put together by blocks of vertices, eight side by side, in single precision relative to
 * their cell, and kept from round to round where that takes little memory.
 */
#ifndef remesh_FitSamples_h
#define remesh_FitSamples_h

#include "Placement/PlacementProblem.h"
#include "Support/Lanes.h"
#include "Support/Parallel.h"

namespace remesh
{
/** Samples side by side, lengths in `FitSamples::unit`; places without one are zero. */
struct SampleGroup
{
  float offset[3][lanes]; ///< from the centroid of the vertex's component
  float normal[3][lanes]; ///< of length 1, of the facet
  float weight[lanes];    ///< area
};

/** The samples of consecutive vertices. */
struct SampleBlock
{
  std::vector<SampleGroup> groups;
  std::vector<Index> begins; ///< first group of each vertex, and the end
  std::vector<Index> counts; ///< samples of each vertex

  void clear();
};

class FitSamples
{
public:
  static constexpr double usualBytes = 256.0 * (1 << 20);

  /**
   * @param samples of each vertex, see forEachSample.
   * @param maxBytes that they may take, about, to be kept.
   */
  FitSamples(const PlacementProblem& problem, int samples, double maxBytes = usualBytes);

  const Blocks& blocks() const { return m_blocks; }
  /** A power of two near the surface's size, so that single precision holds surfaces of any. */
  double unit() const { return m_unit; }

  /**
   * The samples of a block's vertices, made in `scratch`: once, and kept, or each time where all
   * would take too much memory. Each block by one thread at a time.
   */
  const SampleBlock& of(Offset block, SampleBlock& scratch);

private:
  void make(Offset block, SampleBlock& made) const;

  const PlacementProblem& m_problem;
  int m_samples;
  double m_unit;
  Blocks m_blocks;
  std::vector<SampleBlock> m_kept; ///< none where they are not kept
};
}

#endif
