/**
 * @file ComparisonData.h
 * @brief From vtkPolyData to what the comparison measures, and from that to the filter's outputs.
 *
 * Array names, types and meaning: see vtkSurfaceMeshComparison.
 */
#ifndef remesh_ComparisonData_h
#define remesh_ComparisonData_h

#include "Comparison/Comparison.h"

#include <string>

class vtkPolyData;
class vtkTable;

namespace remesh
{
/** The triangles of a vtkPolyData as they stand. */
struct ComparedSurface
{
  std::vector<Point3> points;     ///< P, the input's
  std::vector<Triple> triangles;  ///< T x 3, ids into `points`
  std::vector<Offset> inputCells; ///< T
  /** With blocks: T x 3, on the lowest of points with equal coordinates in different blocks. */
  std::vector<Triple> joined;

  /** Blocks that touch are one surface. */
  Triangles view() const
  {
    return { this->points, this->joined.empty() ? this->triangles : this->joined };
  }
};

/**
 * Polygons and strips are cut into triangles as the remesher does (SurfaceIntake.h); nothing is
 * merged, dropped or turned.
 *
 * @param name of the surface in messages, such as "mesh".
 * @return EmptyInput for no points and no cells; InvalidInput as SurfaceIntake.h, for more
 *         triangles or points than can be counted, for points of triangles that are not finite or
 *         beyond `largestCoordinate`, and for a surface below `smallestExtent` (Mesh/Intake.h).
 */
Status readComparedSurface(vtkPolyData* input, const std::string& name, ComparedSurface& surface);

/** Port 0: the mesh, cut into triangles where it has other cells, with its arrays. */
void writeComparedMesh(vtkPolyData* input, const ComparedSurface& mesh,
  const Comparison& comparison, vtkPolyData* output);

/** Port 1: the reference with its distances. */
void writeComparedReference(vtkPolyData* input, const Comparison& comparison, vtkPolyData* output);

/** Port 2: one row of numbers. */
void writeComparisonSummary(
  const ComparedSurface& mesh, const Comparison& comparison, vtkTable* output);

/** Port 3: one row for each of `bins` bins. */
void writeComparisonHistograms(const Comparison& comparison, int bins, vtkTable* output);
}

#endif
