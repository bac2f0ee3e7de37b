/**
 * @file ShapeTerm.h
 * @brief What the shape of a triangle in R^d adds to the normal equations of the fit.
 */
#ifndef remesh_ShapeTerm_h
#define remesh_ShapeTerm_h

#include "Placement/TriangleShape.h"
#include "Support/Symmetric3.h"

namespace remesh
{
struct ShapeTerm
{
  Symmetric3<double> block; ///< of an edge, times -1; half of a corner's
  Point3 slopes[3];         ///< of the corners; the negative gradient
};

/**
 * Of the energy (phi - 1)^(3/4), with phi = (sum of the squared edges) / (4 sqrt 3 times the area),
 * both in a metric: 1 for an equilateral triangle, and the same for similar ones (the shape measure
 * of P. Knupp, "Algebraic mesh quality metrics", 2001). phi - 1 goes with the square of how far
 * angles are from 60 degrees; with this power the term counts the angles of good triangles, too,
 * and spends less on the worst. (measured, relief and armadillo at equal distance: powers of 1/2,
 * 3/4 and 1 give 44.0, 43.8 and 43.2 degrees, and 1/2 more angles below 30 degrees.)
 *
 * The block is the graph Laplacian in the metric, which is what is left of the second derivative
 * where triangles around are alike: positive, and across the triangle zero.
 *
 * @param metric a tensor of R^3; what it says along the normal does not count.
 * @return false if triangle or metric have no area; the term is zero then.
 */
bool findShapeTerm(const Corners& corners, const Symmetric3<double>& metric, ShapeTerm& term);
}

#endif
