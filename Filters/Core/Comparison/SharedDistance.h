/**
 * @file SharedDistance.h
 * @brief The distance of a surface from a mesh, measured by all ranks but the first.
 *
 * Each rank gets the mesh, handed on from rank to rank, and a range of the surface's triangles:
 * whole blocks, whose sums it sends back. The first adds them up in the order of the blocks: how
 * many ranks there are changes no bit.
 *
 * Sent: to each rank 12 bytes for a triangle of the mesh and 24 for a vertex; 75 for each of the
 * surface's triangles, once; back 32 for each of up to 1024 blocks.
 */
#ifndef remesh_SharedDistance_h
#define remesh_SharedDistance_h

#include "Comparison/DistanceSums.h"
#include "Comparison/SurfaceDistance.h"
#include "Support/RankOrders.h"

namespace remesh
{
/** The first rank's order. Throws runtime_error. @param to has triangles with an area. */
void tellToMeasure(OtherRanks& others, const SampledTriangles& from, const Triangles& to);

/** Waits for the answers. Throws runtime_error. */
Status takeMeasured(OtherRanks& others, OneSidedDistance& distance);

/** Another rank's side: adds the sums of its blocks to the answer. Memory: the mesh and its tree.
 */
Status sumPartDistances(Packet& mesh, Packet& part, Packet& answer);
}

#endif
