#include "Repair/SiteProposals.h"

#include "Delaunay/FeatureRepair.h"
#include "Placement/StrayTriangles.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

namespace remesh
{
Status SettledProposal::edit(
  SiteCandidate& candidate, int edit, const RunControl& control, bool& done)
{
  done = this->change(candidate, edit, control);
  if (done && edit < m_settledEdits && !candidate.othersStay())
  {
    return candidate.settle(control);
  }
  return control.cancelled() ? Status::cancelled() : Status::success();
}

namespace
{
constexpr int editsBetweenCuts = 4;   // of tips
constexpr double shrinking = 0.9;     // of what fails, to come nearer
constexpr double smallestSize = 1e-4; // in mean cells: a hundredth of the sites' spacing

/** The sections of curves that these reach. */
Offset countSections(const std::vector<Intrusion>& intrusions)
{
  std::set<std::pair<Index, Index>> sections;
  for (const Intrusion& intrusion : intrusions)
  {
    sections.emplace(intrusion.curve, intrusion.section);
  }
  return static_cast<Offset>(sections.size());
}

class JoinCurves : public SettledProposal
{
public:
  using SettledProposal::SettledProposal;

  bool answers(const SiteCandidate& candidate) const override
  {
    return candidate.verdict().intrusions > 0;
  }

  /** Unless there are too few points for the surface beside them. */
  bool change(SiteCandidate& candidate, int /*edit*/, const RunControl& control) override
  {
    const std::vector<Intrusion>& intrusions = candidate.result().seams.intrusions;
    return candidate.hasRoomOnCurves(countSections(intrusions)) &&
      candidate.refineCurves(intrusions, control);
  }
};

class RefineFaults : public SettledProposal
{
public:
  RefineFaults(Refining how, int settledEdits)
    : SettledProposal(settledEdits)
    , m_how(how)
  {
  }

  bool answers(const SiteCandidate& candidate) const override
  {
    const Offset faults = candidate.verdict().faults;
    switch (m_how)
    {
      case Refining::AddSites:
        return faults > 0;
      case Refining::CutTips:
        return faults > 0 && !candidate.isHopeless(faults);
      case Refining::BeyondNumber:
        break;
    }
    const Offset extra = candidate.task().options.maximumExtraPoints;
    return faults > 0 && extra > candidate.extraPoints() &&
      (!candidate.isHopeless(faults) || extra > faults);
  }

  /**
   * A handle far smaller than the cells takes many sites before it is seen: they close in on it.
   * Beyond the number the faults are to become fewer against the cells: where nothing helps, what
   * fails shrinks for ever.
   */
  bool nears(const SiteCandidate& candidate) override
  {
    const double size = m_how == Refining::BeyondNumber
      ? static_cast<double>(candidate.verdict().faults) /
        static_cast<double>(candidate.result().components.count())
      : candidate.faultSize();
    const bool isNearer = size < shrinking * m_leastSize && size > smallestSize;
    m_leastSize = isNearer ? size : m_leastSize;
    return isNearer;
  }

  bool learn(const SiteCandidate& /*candidate*/) override
  {
    m_leastSize = std::numeric_limits<double>::infinity();
    return false;
  }

  bool change(SiteCandidate& candidate, int edit, const RunControl& /*control*/) override
  {
    const bool cuts = m_how == Refining::CutTips && edit % editsBetweenCuts == 0;
    Refinement refinement = refineTopology(candidate.dual(), candidate.certificate(), cuts);
    return m_how == Refining::BeyondNumber ? candidate.reviseBeyond(std::move(refinement))
                                           : candidate.revise(std::move(refinement),
                                               candidate.certificate(), candidate.wantedVertices());
  }

private:
  Refining m_how;
  double m_leastSize = std::numeric_limits<double>::infinity(); ///< of what failed, so far
};

class DivideCurves : public SettledProposal
{
public:
  using SettledProposal::SettledProposal;

  bool answers(const SiteCandidate& candidate) const override
  {
    return candidate.verdict().faults > 0 && !candidate.result().seams.encroachments.empty();
  }

  /** Unless it takes more vertices than asked for, or they all do. */
  bool change(SiteCandidate& candidate, int /*edit*/, const RunControl& control) override
  {
    const std::vector<Index> failing = failingComponents(candidate.certificate());
    const std::vector<Intrusion>& all = candidate.result().seams.encroachments;
    std::vector<Intrusion> found;
    std::copy_if(all.begin(), all.end(), std::back_inserter(found),
      [&](const Intrusion& intrusion)
      { return std::binary_search(failing.begin(), failing.end(), intrusion.component); });
    const RemeshOptions& options = candidate.task().options;
    const Offset least = candidate.minVertices();
    const bool fits = !options.exactNumber || least > options.numberOfSites ||
      least + countSections(found) <= options.numberOfSites + candidate.extraPoints();
    return fits && !found.empty() && candidate.refineCurves(found, control);
  }
};

class AdjustNumber : public SettledProposal
{
public:
  using SettledProposal::SettledProposal;

  bool answers(const SiteCandidate& candidate) const override
  {
    return candidate.task().options.exactNumber &&
      candidate.result().components.count() != candidate.wantedVertices();
  }

  bool change(SiteCandidate& candidate, int /*edit*/, const RunControl& /*control*/) override
  {
    // Without hope for the topology at least the number shall be right.
    const bool keepsAdded = !candidate.verdict().isUnproven;
    return candidate.revise({}, candidate.certificate(), nextNumber(candidate), keepsAdded);
  }

private:
  /**
   * The number of vertices to aim at on the way to the one that is wanted, counting one for each
   * site that goes: with cells of several parts, more vertices go than that.
   */
  static Offset nextNumber(const SiteCandidate& candidate)
  {
    const RemeshResult& result = candidate.result();
    const Offset count = result.components.count();
    const Offset surplus = count - candidate.wantedVertices();
    const Offset free = result.sites.count() - result.sites.fixed;
    const Offset parts = count - result.featureSites.numberOfPoints(); // of their cells, about
    return surplus > 1 && parts > free ? count - std::max(surplus * free / parts, Offset(1))
                                       : candidate.wantedVertices();
  }
};

std::vector<Triple> dualTriangles(const SiteCandidate& candidate, const std::vector<Index>& some)
{
  std::vector<Triple> triangles;
  for (const Index t : some)
  {
    triangles.push_back(candidate.result().dual.triangles[t]);
  }
  return triangles;
}

class DivideCurvesAtInverted : public SettledProposal
{
public:
  using SettledProposal::SettledProposal;

  bool answers(const SiteCandidate& candidate) const override
  {
    const Offset inverted = candidate.verdict().inverted;
    return candidate.task().features && inverted > 0 && !candidate.isHopeless(inverted);
  }

  /** Unless that takes more vertices than there may be, or free sites that stay. */
  bool change(SiteCandidate& candidate, int /*edit*/, const RunControl& control) override
  {
    const RemeshResult& result = candidate.result();
    const std::vector<Intrusion> coarse =
      coarseSections(dualTriangles(candidate, candidate.invertedTriangles()), result.seams,
        candidate.task().featured(), result.featureSites, control);
    return !control.cancelled() && candidate.hasRoomOnCurves(countSections(coarse)) &&
      candidate.refineCurves(coarse, control);
  }
};

/** Sites for triangles; others are taken away. It ends where two edits do not halve their number.
 */
class RefineTriangles : public SettledProposal
{
public:
  explicit RefineTriangles(bool strays)
    : SettledProposal(0)
    , m_strays(strays)
  {
  }

  bool answers(const SiteCandidate& candidate) const override
  {
    const Offset count = this->count(candidate);
    const bool helps = m_counts.size() < 2 || 2 * count <= m_counts[m_counts.size() - 2];
    const auto triangles = static_cast<Offset>(candidate.result().dual.triangles.size());
    return helps && count > 0 &&
      (m_strays ? count <= maxStrays(triangles) : !candidate.isHopeless(count));
  }

  bool change(SiteCandidate& candidate, int /*edit*/, const RunControl& /*control*/) override
  {
    m_counts.push_back(this->count(candidate));
    const std::vector<Index> wrong = this->wrongTriangles(candidate);
    Certificate failures;
    failures.vertices = dualTriangles(candidate, wrong);
    Refinement refinement = refineTriangles(candidate.dual(), wrong);
    return !refinement.added.empty() &&
      candidate.revise(std::move(refinement), failures, candidate.wantedVertices());
  }

private:
  Offset count(const SiteCandidate& candidate) const
  {
    return m_strays ? candidate.verdict().strays : candidate.verdict().inverted;
  }

  std::vector<Index> wrongTriangles(const SiteCandidate& candidate) const
  {
    std::vector<Index> wrong = candidate.invertedTriangles();
    if (m_strays)
    {
      const std::vector<Index>& strays = candidate.strayTriangles();
      wrong.insert(wrong.end(), strays.begin(), strays.end());
      std::sort(wrong.begin(), wrong.end());
    }
    return wrong;
  }

  bool m_strays;
  std::vector<Offset> m_counts; ///< before each edit
};
}

std::unique_ptr<SiteProposal> joinCurves(int settledEdits)
{
  return std::make_unique<JoinCurves>(settledEdits);
}

std::unique_ptr<SiteProposal> refineFaults(Refining how, int settledEdits)
{
  return std::make_unique<RefineFaults>(how, settledEdits);
}

std::unique_ptr<SiteProposal> divideCurves()
{
  return std::make_unique<DivideCurves>(0);
}

std::unique_ptr<SiteProposal> adjustNumber(int settledEdits)
{
  return std::make_unique<AdjustNumber>(settledEdits);
}

std::unique_ptr<SiteProposal> divideCurvesAtInverted()
{
  return std::make_unique<DivideCurvesAtInverted>(0);
}

std::unique_ptr<SiteProposal> refineInverted()
{
  return std::make_unique<RefineTriangles>(false);
}

std::unique_ptr<SiteProposal> refineStrays()
{
  return std::make_unique<RefineTriangles>(true);
}
}
