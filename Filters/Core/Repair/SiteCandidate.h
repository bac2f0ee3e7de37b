/**
 * @file SiteCandidate.h
 * @brief Sites with their diagram and dual, as repairs see and change them.
 */
#ifndef remesh_SiteCandidate_h
#define remesh_SiteCandidate_h

#include "Delaunay/TopologyRepair.h"
#include "Repair/Improve.h"
#include "Run/Task.h"
#include "Run/Verdict.h"

#include <memory>
#include <vector>

namespace remesh
{
/** A copy of all sites, held once for all that need it. */
using SharedSites = std::shared_ptr<const Sites>;

/**
 * The candidate of Improve.h that repairs of sites make better. To judge it, the diagram, its
 * components, its dual and the certificate are made, and the verdict is read from them.
 */
class SiteCandidate
{
public:
  /** All that edits change. */
  struct State
  {
    SharedSites sites;
    FeatureSites featureSites;
    Index added = 0;        ///< sites that repairs added: the last so many, or nearly so
    Offset extraPoints = 0; ///< vertices that repairs need beyond those asked for
  };

  /**
   * @param othersStay whether edits change nothing but what they must (completeMesh in Remesh.h).
   * @param result has the sites; `judge` fills in the rest. Both must outlive the candidate.
   */
  SiteCandidate(const Task& task, bool othersStay, RemeshResult& result);

  /**
   * Counts triangles that face the wrong way, now and whenever the candidate is judged. They are
   * not counted where an entry before them has become worse, as they would not matter then.
   */
  Status countFacing(const RunControl& control);

  /** Makes diagram, components, dual and certificate of the sites, and the verdict. */
  Status judge(const RunControl& control);
  const Verdict& verdict() const { return m_verdict; }
  State state() const;
  void restore(const State& state);

  /**
   * Whether repairs may change sites: the run iterates, and the surface has no non-manifold edge or
   * its features are kept.
   */
  bool mayChange() const;
  /** Whether cells fall into more parts than RemeshOptions::maxComponents allows. */
  bool fallsApart() const;

  const Task& task() const { return m_task; }
  const RemeshResult& result() const { return m_result; }
  VertexPlaces places() const { return { m_task.surface, m_result.sites, m_result.diagram }; }
  DiagramDual dual() const { return { this->places(), m_result.components, m_result.dual }; }
  const Certificate& certificate() const { return m_result.topology.certificate; }
  bool othersStay() const { return m_othersStay; }
  /** As in State. */
  Index added() const { return m_added; }
  /** As in State. */
  Offset extraPoints() const { return m_extraPoints; }
  /** Inverted triangles of the dual that placement will not turn back (Facing.h); ascending. */
  const std::vector<Index>& invertedTriangles() const { return m_inverted; }
  /** Strays, likewise. */
  const std::vector<Index>& strayTriangles() const { return m_strays; }

  /** Vertices less the free sites: those on features, and one for each further part of a cell. */
  Offset minVertices() const;
  /**
   * How many vertices the mesh is to have now. If a number is asked for: that number, or more if
   * too few free sites would be left, and `extraPoints`. If not: as many as there are.
   */
  Offset wantedVertices() const;
  /**
   * Whether more than a tenth of the vertices have a fault: then the sites are far too few, and to
   * change some is of no use.
   */
  bool isHopeless(Offset faults) const;
  /** Mass of the cells at which the certificate fails, over the mass of a mean cell. */
  double faultSize() const;
  /** Sites at which the certificate fails, or whose cells reach a curve of others; ascending. */
  std::vector<Index> failingSites() const;
  /** Whether curves may get so many places more: enough free sites stay, and the number is kept. */
  bool hasRoomOnCurves(Offset places) const;

  /**
   * Makes the changes of `refinement`. Then adds or removes other sites, so that the mesh comes to
   * the wanted number of vertices (SiteRevision.h).
   *
   * @param failures sites near these are not removed.
   * @param wanted vertices.
   * @param keepAdded whether sites that repairs added are not removed, either.
   * @return whether any site was added or removed.
   */
  bool revise(
    Refinement refinement, const Certificate& failures, Offset wanted, bool keepAdded = true);

  /** The same, but no sites are removed for those added, as far as extra points are allowed. */
  bool reviseBeyond(Refinement refinement);

  /**
   * Gives curves new places where cells reach them, and brings the number of vertices to the wanted
   * one. Returns whether there are new places.
   */
  bool refineCurves(const std::vector<Intrusion>& intrusions, const RunControl& control);

  /** Replaces all sites. `added` and `extraPoints` as in State. */
  void replaceSites(Sites sites, Index added, Offset extraPoints);

  /** Two of Lloyd's steps for the sites around those that changed since the last judgement. */
  Status settle(const RunControl& control);

private:
  Status findDiagram(const RunControl& control);
  Status findDual(const RunControl& control);
  bool isWorthCounting() const;
  Status countWrong(const RunControl& control);
  Status measureSurface(const RunControl& control);
  void findVerdict();

  const Task& m_task;
  RemeshResult& m_result;
  bool m_othersStay;
  bool m_countsFacing = false;
  Verdict m_start;             ///< before triangles that face the wrong way were first counted
  Offset m_leastFree;          ///< free sites that stay, see Task::minFreeSites
  FacetJoins m_joins;          ///< of the surface, as it is cut open
  std::vector<Index> m_owners; ///< C, the site nearest to each corner, in the present diagram
  SharedSites m_judged; ///< sites of the present diagram; nullptr: none, or sites never change
  Index m_added = 0;
  Offset m_extraPoints = 0;
  std::vector<Index> m_inverted;
  std::vector<Index> m_strays;
  Verdict m_verdict;
};

/** The phase of a run that follows its first diagram, with all repairs of sites. */
RunControl afterDiagram(const RunControl& control);

/** All components that a failure of the certificate names; ascending. */
std::vector<Index> failingComponents(const Certificate& certificate);

using SiteProposal = Proposal<SiteCandidate>;
using SiteTable = std::vector<Row<SiteCandidate>>;
}

#endif
