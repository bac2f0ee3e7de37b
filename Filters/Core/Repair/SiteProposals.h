/**
 * @file SiteProposals.h
 * @brief What can be done to sites whose dual is not what it should be.
 *
 * Each proposal answers one entry of the verdict. SiteRepair.cxx has the table: in which order they
 * are asked, how often, and for which input.
 */
#ifndef remesh_SiteProposals_h
#define remesh_SiteProposals_h

#include "Repair/SiteCandidate.h"

#include <memory>

namespace remesh
{
/** A proposal whose first edits are followed by a few of Lloyd's steps around what they changed. */
class SettledProposal : public SiteProposal
{
public:
  explicit SettledProposal(int settledEdits)
    : m_settledEdits(settledEdits)
  {
  }

  Status edit(SiteCandidate& candidate, int edit, const RunControl& control, bool& done) final;

protected:
  /** Returns whether it changes anything. */
  virtual bool change(SiteCandidate& candidate, int edit, const RunControl& control) = 0;

private:
  int m_settledEdits;
};

/** Where cells reach a curve between two of its sites, these join the curve. */
std::unique_ptr<SiteProposal> joinCurves();

/** How the topology is refined. */
enum class Refining
{
  AddSites,    ///< where the certificate fails, others are taken away
  CutTips,     ///< the same, but thin tips are left to the cells around them
  BeyondNumber ///< none are taken away, as far as more points are allowed
};
std::unique_ptr<SiteProposal> refineFaults(Refining how, int settledEdits);

/** Where other cells on features reach a curve, and the certificate fails, it gets places. */
std::unique_ptr<SiteProposal> divideCurves();

/** Sites are added or taken away until the mesh has as many vertices as wanted. */
std::unique_ptr<SiteProposal> adjustNumber(int settledEdits);

/** Curves that are too coarse for inverted triangles get places. */
std::unique_ptr<SiteProposal> divideCurvesAtInverted();

/** Sites where triangles are inverted. */
std::unique_ptr<SiteProposal> refineInverted();

/** Sites where triangles face another part of the surface the wrong way. */
std::unique_ptr<SiteProposal> refineStrays();
}

#endif
