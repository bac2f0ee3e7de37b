/**
 * @file Comparison.h
 * @brief All that is measured of a mesh, alone and against a reference surface.
 */
#ifndef remesh_Comparison_h
#define remesh_Comparison_h

#include "Comparison/MeshTopology.h"
#include "Comparison/PointDistance.h"
#include "Comparison/SurfaceDistance.h"
#include "Comparison/TriangleQuality.h"

namespace remesh
{
struct Comparison
{
  MeshTopology topology;                  ///< of the mesh, as it is indexed
  std::vector<TriangleQuality> qualities; ///< T

  /** The rest is measured with a reference only. */
  bool hasReference = false;
  MeshTopology referenceTopology; ///< after coincident points were merged
  double diagonal = 0.0;          ///< of the reference's bounding box
  TwoSidedDistance distance;      ///< forward: from the mesh to the reference
  PointDistances meshPoints;
  PointDistances referencePoints;
  std::vector<double> normalDeviations; ///< T, see NormalDeviation.h
};

/** A triangle that makes a larger angle with the reference is flipped. */
constexpr double flippedDegrees = 90.0;

/**
 * @param reference nullptr: the mesh alone is measured.
 * @param options `negligible` is a share of the reference's diagonal.
 * @return InvalidInput if there is a reference, but no triangle of it or of the mesh has area;
 *         Cancelled.
 * Cost: see measureTwoSidedDistance, and a search for each point and triangle.
 */
Status compareSurfaces(const Triangles& mesh, const Triangles* reference,
  const DistanceOptions& options, RunControl control, Comparison& comparison);
}

#endif
