#include "Repair/SiteCandidate.h"

#include "Delaunay/FeatureRepair.h"
#include "Delaunay/SiteRevision.h"
#include "Embedding/Embedding.h"
#include "Features/CurveSeparation.h"
#include "Features/FeatureGraph.h"
#include "Optimization/FixedSites.h"
#include "Optimization/LocalRelaxation.h"
#include "Repair/Facing.h"
#include "Support/SortUnique.h"
#include "Voronoi/RestrictedVoronoi.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace remesh
{
namespace
{
constexpr int settlingSteps = 2;     // of Lloyd, after an edit
constexpr double maxFailures = 0.1;  // of the vertices
constexpr double fewInverted = 5e-5; // of the triangles: edge flips may mend them all

/** So few of the triangles that edge flips may mend them all. */
bool areFew(std::size_t some, const RemeshResult& result)
{
  return static_cast<double>(some) <=
    fewInverted * static_cast<double>(result.dual.triangles.size());
}
}

std::vector<Index> failingComponents(const Certificate& certificate)
{
  std::vector<Index> failing = certificate.cells;
  for (const auto& [a, b] : certificate.edges)
  {
    failing.insert(failing.end(), { a, b });
  }
  for (const Triple& vertex : certificate.vertices)
  {
    failing.insert(failing.end(), vertex.begin(), vertex.end());
  }
  sortUnique(failing);
  return failing;
}

RunControl afterDiagram(const RunControl& control)
{
  return control.named("Dual mesh and repairs");
}

SiteCandidate::SiteCandidate(const Task& task, bool othersStay, RemeshResult& result)
  : m_task(task)
  , m_result(result)
  , m_othersStay(othersStay)
  , m_leastFree(task.minFreeSites(result.shareApart))
{
}

Status SiteCandidate::judge(const RunControl& control)
{
  Stopwatch watch;
  Status status = this->findDiagram(control.step(0, 2));
  if (status.ok())
  {
    const RunControl rest = afterDiagram(control.step(1, 2)); // the diagram's scratch is free
    status = this->measureSurface(control.silent());
    status = status.ok() ? this->findDual(rest) : status;
  }
  m_result.seconds.diagram += watch.lap();
  if (status.ok() && this->mayChange())
  {
    m_judged = std::make_shared<const Sites>(m_result.sites); // now that the dual's memory is free
  }
  m_inverted.clear();
  m_strays.clear();
  this->findVerdict();
  if (status.ok() && this->isWorthCounting())
  {
    status = this->countWrong(control.silent());
  }
  this->findVerdict();
  return status;
}

Status SiteCandidate::countFacing(const RunControl& control)
{
  m_countsFacing = true;
  m_joins = FacetJoins{}; // found again where sites change, which is rare from now on
  m_start = m_verdict;
  m_start.reserve = std::numeric_limits<Offset>::max();
  const Status status = this->countWrong(control);
  this->findVerdict();
  return status;
}

/** Where what counts more is worse than at first, this would not be looked at. */
bool SiteCandidate::isWorthCounting() const
{
  return m_countsFacing && !(m_start < m_verdict);
}

SiteCandidate::State SiteCandidate::state() const
{
  return { m_judged, m_result.featureSites, m_added, m_extraPoints };
}

void SiteCandidate::restore(const State& state)
{
  m_result.sites = *state.sites;
  m_result.featureSites = state.featureSites;
  m_added = state.added;
  m_extraPoints = state.extraPoints;
}

/** The exact diagram of the sites. */
Status SiteCandidate::findDiagram(const RunControl& control)
{
  std::optional<EarlierSites> earlier;
  if (m_judged && m_task.surface.dimension < manyDimensions)
  {
    earlier.emplace(EarlierSites{ *m_judged, m_owners });
  }
  // The last dual makes room for the diagram, and the diagram's lists and sums for its dual.
  m_result.components = Components{};
  m_result.dual = Dual{};
  RestrictedVoronoi voronoi(m_task.surface);
  Status status = voronoi.decompose(
    m_result.sites, control, m_result.sums, m_result.diagram, earlier ? &*earlier : nullptr);
  if (status.ok())
  {
    m_result.emptyCells = countEmptyFree(m_result.sites, m_result.sums);
    m_result.evaluations += voronoi.evaluations();
    m_owners = voronoi.owners();
  }
  return status;
}

/** How the facets hang together, if that is not held, and its topology, if that is not known yet.
 */
Status SiteCandidate::measureSurface(const RunControl& control)
{
  if (m_joins.bits.empty())
  {
    m_joins =
      joinFacets(m_task.surface, buildCutEdgeTable(m_task.mesh, m_task.features, control), control);
  }
  MeshTopology& surface = m_result.topology.surface;
  if (control.cancelled() || surface.triangles > 0)
  {
    return control.cancelled() ? Status::cancelled() : Status::success();
  }
  return measureConnectivity(m_task.mesh.facetPoints,
    m_task.features ? m_task.features->edges : m_joins.edges, m_task.mesh.numberOfPoints(), control,
    surface);
}

/** The dual of the diagram, and whether it is proven to be like the surface. */
Status SiteCandidate::findDual(const RunControl& control)
{
  const JoinedDiagram joined{ m_task.mesh, this->places(), m_joins.edges, m_owners,
    m_task.features ? &m_result.featureSites : nullptr };
  Seams* seams = m_task.features ? &m_result.seams : nullptr;
  Components& components = m_result.components;
  Status status = findComponents(joined, control.step(0, 3), components);
  if (status.ok() && seams)
  {
    *seams = sewAlongFeatures(joined.places, components, m_task.featured(), m_result.featureSites);
  }
  if (status.ok())
  {
    status = buildDual(m_result.diagram, components, control.step(1, 3), m_result.dual, seams);
  }
  if (status.ok() && seams)
  {
    status = dropHangingTriangles(components, *seams, control, m_result.dual);
    components.apexes = componentsAt(joined, m_task.features->apexes, components);
  }
  return status.ok() ? certify({ m_joins, m_result.diagram, components, seams }, m_result.dual,
                         control.step(2, 3), m_result.topology.certificate)
                     : status;
}

/** Triangles that face the wrong way and that placement does not turn back. */
Status SiteCandidate::countWrong(const RunControl& control)
{
  WrongTriangles wrong = findWrongTriangles(m_task, MeshSteps::Move, control, m_result);
  if (!wrong.inverted.empty() && areFew(wrong.inverted.size(), m_result))
  {
    wrong.inverted = findWrongTriangles(m_task, MeshSteps::MoveAndFlip, control, m_result).inverted;
  }
  if (areFew(wrong.inverted.size() + wrong.strays.size(), m_result))
  {
    wrong.strays.clear();
  }
  m_inverted = std::move(wrong.inverted);
  m_strays = std::move(wrong.strays);
  return control.cancelled() ? Status::cancelled() : Status::success();
}

double SiteCandidate::faultSize() const
{
  const std::vector<double>& masses = m_result.components.mass;
  const double whole = std::accumulate(masses.begin(), masses.end(), 0.0);
  double failing = 0.0;
  for (const Index component : failingComponents(this->certificate()))
  {
    failing += masses[component];
  }
  return failing > 0.0 ? failing / whole * static_cast<double>(masses.size()) : 0.0;
}

void SiteCandidate::findVerdict()
{
  const Offset count = m_result.components.count();
  const Offset beyond = count - m_task.options.numberOfSites;
  m_verdict = {};
  m_verdict.isUnproven = !this->certificate().holds();
  m_verdict.intrusions = static_cast<Offset>(m_result.seams.intrusions.size());
  m_verdict.faults = this->certificate().violations();
  m_verdict.inverted = static_cast<Offset>(m_inverted.size());
  m_verdict.strays = static_cast<Offset>(m_strays.size());
  m_verdict.reserve = m_added;
  if (m_task.options.exactNumber)
  {
    m_verdict.pointsOff = std::max({ Offset(0), -beyond, count - this->wantedVertices() });
    m_verdict.pointsForced = std::max(Offset(0), beyond - m_extraPoints);
  }
}

bool SiteCandidate::mayChange() const
{
  return m_task.options.optimize &&
    m_task.options.lloydIterations + m_task.options.quasiNewton.iterations > 0 &&
    (m_task.features || m_result.topology.surface.nonManifoldEdges == 0);
}

bool SiteCandidate::fallsApart() const
{
  return static_cast<double>(m_result.components.count()) >
    m_task.options.maxComponents * static_cast<double>(m_result.numberOfVertexSites());
}

Offset SiteCandidate::minVertices() const
{
  return m_result.components.count() - (m_result.sites.count() - m_result.sites.fixed);
}

Offset SiteCandidate::wantedVertices() const
{
  return m_task.options.exactNumber
    ? std::max(m_task.options.numberOfSites, this->minVertices() + m_leastFree) + m_extraPoints
    : m_result.components.count();
}

bool SiteCandidate::isHopeless(Offset faults) const
{
  return static_cast<double>(faults) >
    maxFailures * static_cast<double>(m_result.components.count());
}

std::vector<Index> SiteCandidate::failingSites() const
{
  std::vector<Index> failing = failingComponents(this->certificate());
  for (Index& component : failing)
  {
    component = m_result.components.sites[component];
  }
  for (const Intrusion& intrusion : m_result.seams.intrusions)
  {
    failing.push_back(intrusion.site);
  }
  sortUnique(failing);
  return failing;
}

bool SiteCandidate::hasRoomOnCurves(Offset places) const
{
  const RemeshOptions& options = m_task.options;
  return !options.exactNumber ||
    this->minVertices() + m_leastFree + places <= options.numberOfSites + m_extraPoints;
}

bool SiteCandidate::revise(
  Refinement refinement, const Certificate& failures, Offset wanted, bool keepAdded)
{
  const Revision revision = reviseSites(this->dual(), m_result.sums, std::move(refinement),
    { failures, wanted, m_added, keepAdded }, m_result.sites);
  m_added += revision.added - revision.removedLast;
  m_result.movedSites += revision.added + revision.removed;
  roundToCaller(m_task.surface, m_result.sites);
  return revision.added + revision.removed > 0;
}

bool SiteCandidate::reviseBeyond(Refinement refinement)
{
  const Offset wanted = this->wantedVertices();
  const auto count = static_cast<Offset>(refinement.added.size()) / m_task.surface.dimension;
  // More than wanted, as components and patches take some each, none of which can be taken away.
  const Offset surplus = std::max(Offset(0), m_result.components.count() - wanted);
  const Offset extra = std::min(count + surplus, m_task.options.maximumExtraPoints - m_extraPoints);
  const bool revised = this->revise(std::move(refinement), this->certificate(), wanted + extra);
  m_extraPoints += revised ? extra : 0;
  return revised;
}

bool SiteCandidate::refineCurves(
  const std::vector<Intrusion>& intrusions, const RunControl& control)
{
  const Offset before = m_result.featureSites.numberOfPoints();
  const Offset vertices = std::max(m_task.options.numberOfSites, m_result.numberOfVertexSites());
  const Offset most = m_task.maxPointsOnFeatures(vertices, m_result.shareApart);
  const FeaturedSurface featured = m_task.featured();
  RefinedCurves refined = refinedCurves(featured, intrusions, m_result.featureSites);
  if (refined.places == 0)
  {
    return false;
  }
  if (!m_result.curvesAreApart)
  {
    refined.curves.assign(refined.curves.size(), 1);
  }
  const double spacing = std::sqrt(m_task.surface.siteMeasure / m_result.sites.count());
  refined.places += separateCurves(featured, std::move(refined.curves), { most, spacing }, control,
    m_result.featureSites); // no free site goes for these
  Refinement refinement;
  refinement.removed = std::move(refined.joining);
  // What is new on curves is no vertex of the diagram yet.
  const Offset onCurves = m_result.featureSites.numberOfPoints() - before;
  const Offset wanted = m_task.options.exactNumber
    ? std::max(m_task.options.numberOfSites - onCurves, this->minVertices()) + m_extraPoints
    : m_result.components.count() - static_cast<Offset>(refinement.removed.size());
  this->revise(std::move(refinement), this->certificate(), wanted);
  replaceFixed(m_result.featureSites, m_result.sites);
  m_result.movedSites += refined.places;
  roundToCaller(m_task.surface, m_result.sites);
  return true;
}

void SiteCandidate::replaceSites(Sites sites, Index added, Offset extraPoints)
{
  m_result.sites = std::move(sites);
  m_added = added;
  m_extraPoints = extraPoints;
  roundToCaller(m_task.surface, m_result.sites);
}

Status SiteCandidate::settle(const RunControl& control)
{
  const SiteChanges changes = compareSites(*m_judged, m_result.sites);
  Status status = relaxAround({ m_task.surface, *m_judged, m_result.diagram }, changes,
    { settlingSteps, m_task.options.seed }, control, m_result.sites);
  roundToCaller(m_task.surface, m_result.sites);
  return status;
}
}
