/**
 * @file Collar.h
 * @brief Sews the duals of the patches along the feature curves, whatever the cells do there.
 *
 * Along its border a patch is thought to go on a little, in a collar that belongs to the sites of
 * the curve alone: each has the stretch that is nearest to it along the curve. The dual of patch
 * and collar ends exactly on the curve's sites, in their order. Where the patch's own cells meet
 * the curve in that order, as they nearly always do, the collar adds nothing. Where another cell
 * reaches the curve between two of them, it adds the triangle that joins the three, which the
 * patch's own dual lacks. So the mesh is closed along each feature by construction, and each
 * stretch of a curve between two sites is an edge of it.
 *
 * Along creases with the same patch on both sides the surface is not cut and nothing is sewn: cells
 * that come between are only noted, for the curve to be refined.
 */
#ifndef remesh_Collar_h
#define remesh_Collar_h

#include "Delaunay/Components.h"
#include "Features/FeatureSites.h"

namespace remesh
{
/** An edge of the mesh along a feature. */
struct FeatureSegment
{
  std::array<Index, 2> ends; ///< components
  FeatureKind kind;
};

/** A cell that reaches a curve between two of the curve's sites, and is of neither. */
struct Intrusion
{
  Index curve;
  Index section; ///< of the curve, after this station
  Index site;
  Index component; ///< of the site, that reaches the curve
  Station foot;    ///< nearest to the site, of the curve's points in its cell
  double squared;  ///< distance of the two, in R^d
};

/** The collar of a vertex: all stretches of the curves that are its own, on all sides. */
enum class CollarShape : std::uint8_t
{
  None = 0, ///< no edge there is cut
  Disk = 1,
  Ring = 2 ///< a curve comes back to the vertex without another one between
};

/** Where a piece meets the collar of its own component, along one facet's edge. */
struct Contact
{
  Index piece;
  Index innerEnds; ///< of the two, those around which there is nothing but this component
};

/** A feature point where the surface is pinched. */
struct Pinch
{
  Index point;
  Index borders; ///< edges of the surface's border there
};

struct Seams
{
  std::vector<Index> components;        ///< of each feature point, or noIndex where it has no cell
  std::vector<FeatureSegment> segments; ///< of all curves, in their order
  std::vector<Triple> triangles;        ///< of components, oriented as their facet
  std::vector<Intrusion> intrusions;    ///< of free sites, by curve, section, component; each once
  std::vector<Intrusion> encroachments; ///< of sites on features, in the same order
  std::vector<CollarShape> collars;     ///< of each feature point
  std::vector<Pinch> pinches;           ///< ascending
  std::vector<Contact> contacts;        ///< edge by edge
  bool isComplete = true;               ///< each edge is covered by pieces from end to end
  /** Feature points on both sides of each point that parts them on the surface's border. */
  std::vector<std::pair<Index, Index>> borderCrossings;

  /** Calls `visit(component, pinch)` for those at which there is a cell. */
  template <class Visit>
  void forEachPinch(const Visit& visit) const
  {
    for (const Pinch& pinch : this->pinches)
    {
      if (const Index component = this->components[pinch.point]; component != noIndex)
      {
        visit(component, pinch);
      }
    }
  }
};

/** O(pieces along the features). */
Seams sewAlongFeatures(const VertexPlaces& places, const Components& components,
  const FeaturedSurface& featured, const FeatureSites& featureSites);

/** Whether each vertex of the mesh, a component, is a feature point. */
std::vector<char> verticesOnFeatures(const Seams& seams, Index numberOfVertices);
}

#endif
