/**
 * @file Verdict.h
 * @brief What is wrong with a mesh: the record by which two of them are compared.
 */
#ifndef remesh_Verdict_h
#define remesh_Verdict_h

#include "Support/Types.h"

namespace remesh
{
/**
 * What is wrong, the worst first. Of two meshes that is the better one whose first differing entry
 * is lower.
 *
 * The number of points comes before the topology: while anything fails, more points that do not
 * mend all of it are of no use.
 */
struct Verdict
{
  Offset pointsOff = 0;    ///< vertices too few, or more than there may be
  bool isUnproven = false; ///< whether the certificate fails (Certificate.h)
  Offset pointsForced =
    0;                   ///< vertices beyond those asked for that features and parts of cells take
  Offset intrusions = 0; ///< cells that reach a curve between two of its sites
  Offset faults = 0;     ///< where the certificate fails
  Offset inverted = 0;   ///< triangles that face their own cells' facets the wrong way
  Offset strays = 0;     ///< triangles that face a closer part of the surface the wrong way
  Offset crossings = 0;  ///< pairs of triangles that go through each other
  Offset refilled = 0;   ///< triangles that are not the dual's, as else they were inverted
  Offset reserve = 0;    ///< sites that repairs added: as few as the topology needs
};

/** Whether the first is better. */
bool operator<(const Verdict& a, const Verdict& b);

/** Whether neither is better. */
bool operator==(const Verdict& a, const Verdict& b);
}

#endif
