/**
 * @file SiteCandidate.h
 * @brief Sites with their diagram and dual, as repairs see and change them.
 */
#ifndef remesh_SiteCandidate_h
#define remesh_SiteCandidate_h

#include "Delaunay/TopologyRepair.h"
#include "Mesh/EdgeTable.h"
#include "Repair/Improve.h"
#include "Run/Task.h"
#include "Run/Verdict.h"

#include <memory>
#include <vector>

namespace remesh
{
/** A copy of all sites, held once for all that need it. */
using SharedSites = std::shared_ptr<const Sites>;

class SiteCandidate
{
public:
  /** All that edits change. */
  struct State
  {
    SharedSites sites;
    FeatureSites featureSites;
    Index added = 0;        ///< by repairs; about the last ones there are
    Offset extraPoints = 0; ///< that the mesh may have beyond those asked for
  };

  /**
   * @param othersStay whether nothing changes but what must.
   * @param result its sites are given. Both must outlive it.
   */
  SiteCandidate(const Task& task, bool othersStay, RemeshResult& result);

  /** From now on, triangles that face the wrong way are counted, too. */
  Status countFacing(const RunControl& control);

  /** Diagram, components, dual and certificate of the sites, and the verdict. */
  Status judge(const RunControl& control);
  const Verdict& verdict() const { return m_verdict; }
  State state() const;
  void restore(const State& state);

  /** Whether sites may be changed at all. */
  bool mayChange() const;
  /** Whether cells fall into so many parts that another surface in R^d is better. */
  bool fallsApart() const;

  const Task& task() const { return m_task; }
  const RemeshResult& result() const { return m_result; }
  VertexPlaces places() const { return { m_task.surface, m_result.sites, m_result.diagram }; }
  const Certificate& certificate() const { return m_result.topology.certificate; }
  bool othersStay() const { return m_othersStay; }
  Index added() const { return m_added; }
  Offset extraPoints() const { return m_extraPoints; }
  /** Triangles of the dual that face the wrong way; ascending. */
  const std::vector<Index>& invertedTriangles() const { return m_inverted; }
  const std::vector<Index>& strayTriangles() const { return m_strays; }

  /** Vertices that are not of free sites: on features, and for each further part of a cell. */
  Offset leastVertices() const;
  /**
   * As many as there shall be: those asked for if they can be reached without too few free sites,
   * and those added beyond; or those there are, where no number is asked for.
   */
  Offset wantedVertices() const;
  /** Whether so much of the mesh is wrong that other sites are no use: there are too few. */
  bool isHopeless(Offset faults) const;
  /** Mass of the cells at which the certificate fails, in mean cells. */
  double faultSize() const;
  /** The sites where cells reach curves that are not theirs, or the certificate fails; ascending.
   */
  std::vector<Index> failingSites() const;
  /** Whether curves may get so many places more: free sites stay, and the number is kept. */
  bool hasRoomOnCurves(Offset places) const;

  /**
   * Adds these sites, and others or none, so that the mesh has as many vertices as wanted.
   *
   * @param failures where sites are not to be taken away.
   * @param keepAdded whether sites that repairs added are no donors.
   * @return whether any came or went.
   */
  bool revise(
    Refinement refinement, const Certificate& failures, Offset wanted, bool keepAdded = true);

  /** The same, but none are taken away, as far as more points are allowed. */
  bool reviseBeyond(Refinement refinement);

  /**
   * Gives curves places where these reach them, and brings the number of vertices to what it shall
   * be. Returns whether there are any.
   */
  bool refineCurves(const std::vector<Intrusion>& intrusions, const RunControl& control);

  /** Other sites instead of the present ones, so many of which, the last, repairs added. */
  void replaceSites(Sites sites, Index added, Offset extraPoints);

  /** A few of Lloyd's steps around what the last edit changed. */
  Status settle(const RunControl& control);

private:
  Status findDiagram(const RunControl& control);
  Status findDual(const RunControl& control);
  bool isWorthCounting() const;
  Status countWrong(const RunControl& control);
  Status knowSurface(const RunControl& control);
  void findVerdict();

  const Task& m_task;
  RemeshResult& m_result;
  bool m_othersStay;
  bool m_countsFacing = false;
  Verdict m_start;             ///< when facing was first counted, without it
  Offset m_leastFree;          ///< free sites that stay, whatever the number of vertices
  EdgeTable m_edges;           ///< of the surface, as it is cut
  std::vector<Index> m_owners; ///< C, of the corners, in the diagram at hand
  SharedSites m_judged; ///< the sites of the diagram at hand; none as yet, or where none may change
  Index m_added = 0;
  Offset m_extraPoints = 0;
  std::vector<Index> m_inverted;
  std::vector<Index> m_strays;
  Verdict m_verdict;
};

/** Components at which the certificate fails; ascending. */
std::vector<Index> failingComponents(const Certificate& certificate);

using SiteProposal = Proposal<SiteCandidate>;
using SiteTable = std::vector<Row<SiteCandidate>>;
}

#endif
