/**
 * @file SurfaceIntake.h
 * @brief From vtkPolyData to the triangles that the core takes in.
 */
#ifndef remesh_SurfaceIntake_h
#define remesh_SurfaceIntake_h

#include "Mesh/SurfaceMesh.h"
#include "Support/Status.h"

#include <string>

class vtkPolyData;

namespace remesh
{
/**
 * Reads polygons of any size and triangle strips; vertices and lines are left out. Point ids are
 * the input's; a triangle's cell id is that of vtkPolyData (vertices, lines, polygons, strips).
 *
 * - A quadrilateral is cut along its shorter diagonal (a tie: the one of its first point), unless
 *   that diagonal lies outside or on the border (the two triangles oppose each other, or one has
 *   no area) and the other does not.
 * - Larger polygons are cut by vtkPolygon, or by clipEars where vtkPolygon gives up, as it does
 *   on holes with bridges to them. One that crosses itself becomes a fan, and a warning tells.
 * - Repeated consecutive points of a polygon count once. A polygon that has one or two points left
 *   is handed on as one degenerate triangle, which the intake then counts and drops; one without
 *   points is skipped.
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

/**
 * Whether there is anything to read, before arrays are looked for: an empty input has none.
 *
 * @return what readTriangleSoup does for inputs without polygons and strips.
 */
Status checkForPolygons(vtkPolyData* input);
}

#endif
