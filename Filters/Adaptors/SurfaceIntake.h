/**
 * @file SurfaceIntake.h
 * @brief From vtkPolyData to the triangles that the core takes in.
 */
#ifndef remesh_SurfaceIntake_h
#define remesh_SurfaceIntake_h

#include "Preparation/SurfacePreparation.h"

#include <string>

class vtkPolyData;

namespace remesh
{
/**
 * Reads polygons of any size and triangle strips; vertices and lines are left out. Point ids are
 * the input's; a triangle's cell id is that of vtkPolyData (vertices, lines, polygons, strips).
 *
 * - Polygons are cut as PolygonTriangulator says; a warning counts those that it could not cut.
 * - The degenerate triangle that a polygon of one or two points becomes is handed on: the intake
 *   counts and drops it.
 * - Cells marked as duplicate, refined or hidden in the input's ghost array are left out.
 *
 * @param input any point type; coordinates are converted to double, and not looked at.
 * @param soup is replaced; empty on failure.
 * @param warning gets a sentence where polygons cross themselves; may be nullptr.
 * @return EmptyInput for no points and no cells, or ghosts alone; InvalidInput for a null input,
 * for one without polygons and strips, for an inconsistent cell array, and for point ids out of
 * range. Cost: O(points + cells), polygons of more than four points apart.
 */
Status readTriangleSoup(vtkPolyData* input, TriangleSoup& soup, std::string* warning = nullptr);

/** The same as the core asks for it; the input must outlive it. */
SurfaceSource sourceOf(vtkPolyData* input);

/**
 * Whether there is anything to read, before arrays are looked for: an empty input has none.
 *
 * @return what readTriangleSoup does for inputs without polygons and strips.
 */
Status checkForPolygons(vtkPolyData* input);
}

#endif
