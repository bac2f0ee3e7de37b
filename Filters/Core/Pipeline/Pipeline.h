/**
 * @file Pipeline.h
 * @brief The whole way from triangles and options to a mesh.
 *
 * 1. The surface is prepared for the sites: intake, features, normals, coordinates in R^d
 *    (Preparation/SurfacePreparation.h).
 * 2. Sites, optimisation, diagram, dual, repairs and placement make a mesh of it (Remesh.h).
 * 3. 1 and 2 are repeated with other normals where the mesh has faults (NumberRun.h).
 * 4. Mesh and surface are compared (MeshDistance.h).
 *
 * With a tolerance, 1 to 3 are done for one number of points after the other, each nearer to what
 * the tolerance takes. Then sites are added where the mesh is too far, until it is within the
 * tolerance (ToleranceRun.h).
 */
#ifndef remesh_Pipeline_h
#define remesh_Pipeline_h

#include "Pipeline/RunRequest.h"

namespace remesh
{
/**
 * Makes the mesh. The same request makes the same bytes, for any number of threads and processes.
 *
 * @param outcome is of use if the run succeeds. After an error only `prepared.intake` and the times
 *        are: they tell of what was done.
 * @return Cancelled; InvalidInput and EmptyInput of the preparation and the sites; InvalidInput for
 *         a tolerance below 1e-7 of the diagonal; OutOfMemory where that many sites do not fit.
 */
Status makeMesh(RunRequest request, const RunControl& control, RunOutcome& outcome);
}

#endif
