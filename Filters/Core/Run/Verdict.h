/**
 * @file Verdict.h
 * @brief What is wrong with a mesh; decides which of two meshes is better.
 */
#ifndef remesh_Verdict_h
#define remesh_Verdict_h

#include "Support/Types.h"

namespace remesh
{
/**
 * What is wrong with a mesh, the worst first. Two verdicts are compared entry by entry. At the
 * first entry that differs, the lower one is better.
 *
 * The number of points comes before the topology. Points beyond the number that mend only a part of
 * what fails are of no use, and would be kept if the topology came first.
 *
 * Who makes a verdict fills in what it can see, and leaves the rest at 0. So only verdicts of one
 * maker are compared:
 * - of sites, SiteCandidate: all but `crossings` and `refilled`;
 * - of a placed mesh, PlacedCandidate: `inverted`, `strays` and `crossings`, each from its repair on;
 * - of passes over a placed mesh, MeshCandidate: `inverted` alone; strays are counted there, too,
 *   when the passes are to mend these;
 * - of whole runs, verdictOf: all but `intrusions` and `reserve`.
 */
struct Verdict
{
  Offset pointsOff = 0;    ///< vertices missing, or beyond the most that there may be
  bool isUnproven = false; ///< whether the certificate fails (Certificate.h)
  /** Vertices beyond those asked for, which features or cells of several parts take. */
  Offset pointsForced = 0;
  Offset intrusions = 0; ///< cells that reach a curve between two of its sites
  Offset faults = 0;     ///< places where the certificate fails
  Offset inverted = 0;   ///< triangles that face against the facets of their own cells
  Offset strays = 0;    ///< triangles that face against another part of the surface, that is closer
  Offset crossings = 0; ///< pairs of triangles that go through each other, where they need not
  Offset refilled = 0;  ///< triangles that differ from the dual's, which would be inverted
  Offset reserve = 0;   ///< sites that repairs added; the fewer the topology needs, the better
};

/** Whether `a` is better. */
bool operator<(const Verdict& a, const Verdict& b);

/** Whether all entries are equal. */
bool operator==(const Verdict& a, const Verdict& b);
}

#endif
