/**
 * @file FlipPasses.h
 * @brief What each pass of a repair of flipped triangles may do, and when there is no other.
 */
#ifndef remesh_FlipPasses_h
#define remesh_FlipPasses_h

#include "Placement/FlipRepair.h"
#include "Placement/StarRepair.h"

#include <limits>

namespace remesh
{
/**
 * 1. In the first passes every step must turn a triangle back: vertices move alone, then together;
 *    in the last of these passes edges turn, too.
 * 2. In later ones steps need only lower what triangles deviate, and may spoil what they cannot
 *    mend. After a pass without a step the next one makes more effort. Cavities are filled anew in
 *    the first of them, and after passes without a step; in all of them if few are flipped.
 * 3. There is no other pass when nothing is flipped, or more than is worth it; after all efforts;
 *    after a few passes in vain at the last effort, unless few triangles are left; and after as
 *    many passes as there may be.
 */
class FlipPasses
{
public:
  /** @param triangles how many there are, flipped or not. */
  FlipPasses(FlipSteps steps, Offset triangles)
    : m_steps(steps)
    , m_triangles(triangles)
  {
  }

  /**
   * Enters the next pass.
   *
   * @param repair the triangles that are flipped now, and all steps until now.
   * @return whether there is such a pass.
   */
  bool enter(const FlipRepair& repair);

  /** Whether the fewest are flipped now since steps may spoil something. */
  bool isBest() const { return m_isBest; }

  bool mayTurn() const;                      ///< edges
  bool mayMoveTogether() const;              ///< vertices around a triangle (Untangling.h)
  bool mayRefill() const;                    ///< cavities (CavityRepair.h)
  bool mayMendAround() const;                ///< a triangle that nothing helps alone
  Effort effort() const { return m_effort; } ///< at that
  double leastGain() const;                  ///< of a step (RepairContext)

private:
  bool isStuck(const FlipRepair& repair) const;
  bool hasTooMany(const FlipRepair& repair) const;
  bool isLast() const;
  bool isVain(const FlipRepair& repair) const;

  FlipSteps m_steps;
  Offset m_triangles;
  int m_pass = -1;
  FlipRepair m_entered; ///< as it was when the pass was entered
  Effort m_effort = Effort::OwnStars;
  bool m_isStuck = false; ///< the pass before took no step
  bool m_isBest = false;
  Offset m_fewest = std::numeric_limits<Offset>::max(); ///< flipped, since steps may spoil some
  int m_vainPasses = 0;                                 ///< at the last effort, since then
};
}

#endif
