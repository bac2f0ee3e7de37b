/**
 * @file EarClipping.h
 * @brief Triangles of a polygon that touches itself, as one with holes and bridges to them does.
 *
 * For what vtkPolygon gives up on, and so do VTK's other ways (EarCutTriangulation,
 * vtkContourTriangulator): corners in one place, and edges that run twice.
 */
#ifndef remesh_EarClipping_h
#define remesh_EarClipping_h

#include "Support/Types.h"

#include <array>
#include <vector>

namespace remesh
{
/**
 * Cuts the loop into n - 2 triangles, whose areas sum to its own in the projection along the axis
 * closest to its normal: none overlaps another where the loop does not cross itself. Corners on
 * straight lines get no triangles without area, if there are others.
 *
 * @param loop n >= 3 corners, finite, with differences about 1 in size.
 * @param triangles three corners each, turning as the loop does; of no use on failure.
 * @return false where the loop crosses itself so that this cannot be, or has no area.
 * Cost: O(n^2); where it takes far more, as it does where loops cross themselves, it fails.
 */
bool clipEars(const std::vector<Point3>& loop, std::vector<std::array<Offset, 3>>& triangles);
}

#endif
