/**
 * @file Features.h
 * @brief The lines of a surface that a mesh of it must keep, and the smooth patches between them.
 *
 * Feature edges are creases, borders, non-manifold edges and borders between labels. They form a
 * graph of curves that end in corners. The surface is cut open along them: it falls into patches,
 * and a point on a feature has one embedded corner for each fan of facets around it.
 */
#ifndef remesh_Features_h
#define remesh_Features_h

#include "Mesh/EdgeTable.h"
#include "Mesh/SurfaceMesh.h"

#include <cstdint>

namespace remesh
{
/** Values as in the output array `EdgeType`. */
enum class FeatureKind : std::uint8_t
{
  None = 0,
  Crease = 1, ///< or a border between labels
  Boundary = 2,
  NonManifold = 3
};

/** A chain of feature edges without a corner between its ends. */
struct FeatureCurve
{
  std::vector<Index> points; ///< m + 1; the last is the first where the curve is closed
  std::vector<Index> edges;  ///< m, ids of `Features::edges`
  FeatureKind kind = FeatureKind::None;
  bool hasCorners = true; ///< false: closed, and begun anywhere

  bool closed() const { return this->points.front() == this->points.back(); }
};

/** Creases that are left out, as points at the spacing cannot follow them. */
struct DroppedCreases
{
  Index edges = 0;
  Index sidesOfNeedles = 0;      ///< of them; the others are short, like noise, or steps of voxels
  double length = 0.0;           ///< of them all; unit of the points
  double keptLength = 0.0;       ///< of the creases that are features
  Point3 place = Point3::Zero(); ///< the middle of the longest of them
};

struct Features
{
  EdgeTable edges;                ///< over the surface's points
  std::vector<FeatureKind> kinds; ///< E; None where an edge is no feature or was dropped
  /**
   * E; whether the surface is cut open there. Creases with the same patch on both sides, as those
   * that end within one, are not cut: their points are kept, and the surface goes on across them.
   */
  std::vector<char> cuts;
  std::vector<FeatureCurve> curves;
  std::vector<Index> corners;      ///< points of the surface, ascending
  std::vector<Index> pinches;      ///< corners where parts of it meet in just the point, ascending
  std::vector<Index> apexes;       ///< tips of cones: points without feature edges, ascending
  std::vector<Index> facetPatches; ///< F
  Index numberOfPatches = 1;
  double spacing = 0.0; ///< of the points to come; 0: not known
  DroppedCreases dropped;

  bool any() const
  {
    return !this->curves.empty() || !this->corners.empty() || !this->apexes.empty();
  }
  FeatureKind kind(Index facet, int k) const
  {
    return this->kinds[this->edges.facetEdges[facet][k]];
  }
};
}

#endif
