/**
 * @file SurfaceSides.h
 * @brief The facets around each point, parted by creases, and the neighbourhood of each part.
 *
 * What is fitted to a surface, or differentiated along it, must not look across a crease: there
 * directions, and most functions' gradients, jump.
 */
#ifndef remesh_SurfaceSides_h
#define remesh_SurfaceSides_h

#include "Mesh/EdgeTable.h"
#include "Support/Grouping.h"
#include "Support/Status.h"

#include <memory>

namespace remesh
{
/** Facets around a point that are joined by edges that are no creases. */
struct SurfaceSide
{
  Index point = 0;
  Index facet = 0;   ///< the lowest of them
  double area = 0.0; ///< a third of theirs
};

class SurfaceSides
{
public:
  /** Edges where facets meet at more than 40 degrees are creases; so are borders. */
  static constexpr double cosineOfCrease = 0.766;

  /** The mesh must outlive this. @return Cancelled. O(F), in parallel. */
  Status build(const SurfaceMesh& mesh, const RunControl& control);

  const SurfaceMesh& mesh() const { return *m_mesh; }
  /** In the order of the points, and of the lowest facets. */
  const std::vector<SurfaceSide>& sides() const { return m_sides; }
  /** V + 1, into `sides`. */
  const std::vector<Offset>& begins() const { return m_begins; }

  /** Marks of one thread, so that nothing is looked at twice. */
  struct Scratch
  {
    std::vector<Index> facetMarks;
    std::vector<Index> pointMarks;
    Index mark = 0;
    std::vector<Index> facets; ///< of the neighbourhood, layer by layer; those of the side first
    std::size_t ownFacets = 0; ///< how many of `facets` are those of the side
    std::vector<Index> points; ///< of the neighbourhood; the side's own point first
  };
  std::unique_ptr<Scratch> makeScratch() const;

  /**
   * The side's facets, then layers of their neighbours across edges that are no creases, until
   * there are at least `wanted` points or no more facets.
   */
  void gather(const SurfaceSide& side, std::size_t wanted, Scratch& scratch) const;

private:
  void findCreases(Offset edge);
  void addFacet(Index facet, Scratch& scratch) const;
  /** Adds the facets around the side's point that can be reached from its lowest one. */
  void gatherOwn(const SurfaceSide& side, Scratch& scratch) const;
  void findSides(Index point, Scratch& scratch, std::vector<SurfaceSide>& sides) const;

  const SurfaceMesh* m_mesh = nullptr;
  EdgeTable m_edges;
  std::vector<char> m_isCrease; ///< E
  Groups m_corners;             ///< of each point: 3 facet + k
  std::vector<SurfaceSide> m_sides;
  std::vector<Offset> m_begins;
};
}

#endif
