/**
 * @file IntakeWarnings.h
 * @brief What a user should know of the surface as it was taken in.
 */
#ifndef remesh_IntakeWarnings_h
#define remesh_IntakeWarnings_h

#include "Mesh/Intake.h"
#include "Mesh/SurfaceMesh.h"

#include <string>
#include <vector>

namespace remesh
{
/**
 * What rounding has left of the coordinates: it moves points and turns triangles round.
 *
 * @param precision of the numbers as they came: the epsilon of their type. Doubles that were in
 *   single precision before are found by their values.
 * Cost: O(F).
 */
void tellRounding(double precision, const SurfaceMesh& mesh, std::vector<std::string>& warnings);

/** A surface that cannot be oriented, slits between points that nearly coincide, doubled sheets. */
void tellIntake(
  const IntakeReport& intake, Offset numberOfFacets, std::vector<std::string>& warnings);
}

#endif
