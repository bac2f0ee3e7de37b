/**
 * @file SiteProposals.h
 * @brief The ways to change sites whose dual is not what it should be.
 *
 * Each proposal answers one entry of the verdict. SiteRepair.cxx has the tables: in which order the
 * proposals are asked, and how often. Documentation/Tuning.md tells which input needs which.
 */
#ifndef remesh_SiteProposals_h
#define remesh_SiteProposals_h

#include "Repair/SiteCandidate.h"

#include <memory>

namespace remesh
{
/**
 * A proposal that implements `change`. Its first `settledEdits` edits are followed by two of
 * Lloyd's steps around what they changed; later ones move nothing else.
 */
class SettledProposal : public SiteProposal
{
public:
  explicit SettledProposal(int settledEdits)
    : m_settledEdits(settledEdits)
  {
  }

  Status edit(SiteCandidate& candidate, int edit, const RunControl& control, bool& done) final;

protected:
  /** Changes sites, and returns whether it did. `edit` as in Proposal::edit. */
  virtual bool change(SiteCandidate& candidate, int edit, const RunControl& control) = 0;

private:
  int m_settledEdits;
};

/** A curve that a cell reaches between two of its sites gets a place there; a free site goes. */
std::unique_ptr<SiteProposal> joinCurves(int settledEdits);

/** How `refineFaults` works. */
enum class Refining
{
  AddSites,    ///< sites are added where the certificate fails, and others are removed
  CutTips,     ///< the same, but each fourth edit leaves thin tips to the cells around them
  BeyondNumber ///< sites are added, and none removed, as far as extra points are allowed
};
/** Sites are added where the certificate fails. */
std::unique_ptr<SiteProposal> refineFaults(Refining how, int settledEdits);

/** A curve gets a place where the cell of another feature site reaches it, beside a fault. */
std::unique_ptr<SiteProposal> divideCurves();

/** Sites are added or removed until the mesh has as many vertices as wanted. */
std::unique_ptr<SiteProposal> adjustNumber(int settledEdits);

/** Curves get places where inverted triangles show that they are too coarse. */
std::unique_ptr<SiteProposal> divideCurvesAtInverted();

/** Sites are added where triangles are inverted, and others removed. */
std::unique_ptr<SiteProposal> refineInverted();

/** Sites are added where triangles are strays or inverted, and others removed. */
std::unique_ptr<SiteProposal> refineStrays();
}

#endif
