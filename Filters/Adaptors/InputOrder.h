/**
 * @file InputOrder.h
 * @brief An order of a surface's points and cells that does not depend on how it came.
 *
 * A source may give a surface in one piece to one process, and in several to several; what the
 * processes gather has another order, and the points along the cuts are there more than once. A
 * mesh depends on the order of its input as on a seed. So a surface that could have come in pieces
 * is put in an order of its own, on one process as on many.
 */
#ifndef remesh_InputOrder_h
#define remesh_InputOrder_h

#include "vtkSmartPointer.h"

class vtkAlgorithm;
class vtkPolyData;

namespace remesh
{
/**
 * Whether some source of what is at an input port gives pieces when asked for them. A file that
 * one process reads does not. Cost: one look at each filter before `algorithm`.
 */
bool comesInPieces(vtkAlgorithm* algorithm, int port);

/**
 * The polygons and strips of a surface in an order of their own.
 *
 * Points are ordered by their coordinates, then by the values of their arrays, and those that agree
 * in all become one. A polygon starts with its first point; cells are ordered by their points, then
 * by the values of their arrays. The cell array blockCellName has the ids that cells had.
 *
 * @return the surface itself, if it has no points, or cells that name points that are not there.
 * Cost: O((points + cells) log(points + cells)), and the memory of a copy.
 */
vtkSmartPointer<vtkPolyData> inOwnOrder(vtkPolyData* surface);
}

#endif
