/**
 * @file Remesh.h
 * @brief The whole pipeline on one page.
 *
 * surface -> sites -> Lloyd -> quasi-Newton -> restricted Voronoi diagram -> components -> dual
 * -> vertices placed
 *
 * With features, the sites on them come first and stay (Features/), as far apart as the others will
 * be (CurveSampling.h), and so many that curves close to each other are kept apart
 * (CurveSeparation.h); the others are drawn patch by patch, and the patches' duals are sewn
 * together along the curves (Delaunay/Collar.h). Their vertices are fitted to the curves
 * (CurveFit.h).
 *
 * Where the dual is not proven to be like the surface (Delaunay/Certificate.h), or triangles are
 * flipped, sites are moved there; where a cell reaches a feature curve, its site joins the curve;
 * and the end is run again.
 */
#ifndef remesh_Remesh_h
#define remesh_Remesh_h

#include "Comparison/SurfaceDistance.h"
#include "Delaunay/Components.h"
#include "Delaunay/Dual.h"
#include "Delaunay/SurfaceLocation.h"
#include "Delaunay/TopologyResult.h"
#include "Embedding/EmbeddedSurface.h"
#include "Features/FeatureSites.h"
#include "Optimization/Convergence.h"
#include "Optimization/QuasiNewton.h"
#include "Optimization/Sampling.h"
#include "Placement/Placement.h"
#include "Repair/PlacedMesh.h"
#include "Voronoi/CellSums.h"
#include "Voronoi/Diagram.h"
#include "Voronoi/PlainSums.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace remesh
{
struct RemeshOptions
{
  Offset numberOfSites = 10000;
  SamplingMethod sampling = SamplingMethod::Stratified;
  std::uint64_t seed = 0;
  /** Whether the first sites are grown from fewer, see RemeshStart.h. */
  bool coarseStart = true;
  int lloydIterations = 5;
  QuasiNewtonOptions quasiNewton;
  /** False: the given sites are final, whatever their cells. */
  bool optimize = true;
  VertexPlacement placement = VertexPlacement::Fit;
  /** Sites to start from instead of sampling; n x d, scaled units of the surface. */
  Sites initialSites;
  /** Whether to take away or add sites until the mesh has `numberOfSites` vertices. */
  bool exactNumber = false;
  /**
   * By how many vertices the mesh may exceed the wanted number, where its topology cannot be that
   * of the surface otherwise.
   */
  Offset maximumExtraPoints = 0;
  /** With more components for each vertex's site, the run ends at its first diagram (`fallsApart`).
   */
  double mostComponents = std::numeric_limits<double>::infinity();
  /** How far curves of the mesh may be from those of the surface at most; unit of the points. */
  double mostCurveError = std::numeric_limits<double>::infinity();
  /** Whether features get more points where they bend; else embedded length alone decides. */
  bool curvesFollowBends = true;
  /** False: the diagram is freed when the vertices are placed, which leaves room for the rest. */
  bool keepDiagram = true;
};

/** Everything in the scaled units of the embedded surface, but what is in R^3. */
struct RemeshResult
{
  Sites sites;
  CellSums sums;
  PlainSums plainSums;          ///< of the sites, where the surface has a density; else none
  PlainSums plainComponentSums; ///< of the components, likewise
  Diagram diagram;
  Components components;
  FeatureSites featureSites;      ///< the first sites; none without features
  Offset wantedVertices = 0;      ///< that there should be
  Offset neededFeaturePoints = 0; ///< that corners and bends of the features take alone
  double shareApart = 1.0;        ///< of the surface, farther than the spacing from features
  bool curvesAreApart = false;    ///< as far as that was possible; else there was no room for it
  Seams seams;                    ///< edges of the mesh along features among it
  std::vector<SurfaceLocation> locations; ///< of the placed vertices
  Dual dual;                              ///< its triangles after placement
  PlacedVertices placement;               ///< of its vertices
  std::vector<Index> numbersOfNeighbors;  ///< n
  std::vector<int> cellColors;            ///< n, few, those of neighbours differ
  std::vector<double> cellAreas;          ///< n, in R^3
  Convergence convergence;
  TopologyResult topology;
  std::optional<TwoSidedDistance> distance; ///< of mesh and surface, where it was measured
  Index emptyCells = 0;                     ///< of sites that are not on features
  Index movedSites = 0;                     ///< in repairs; `convergence` ends before them
  int evaluations = 0;                      ///< diagrams of the whole surface
  bool fallsApart = false;                  ///< nothing after the first diagram was done then

  struct Seconds
  {
    double sampling = 0.0;
    double lloyd = 0.0;
    double newton = 0.0;
    double repair = 0.0;
    double diagram = 0.0;
    double placement = 0.0;
    double distance = 0.0; ///< of findDistance (MeshDistance.h)

    Seconds& operator+=(const Seconds& other);
  } seconds; ///< wall time of the phases

  /** Sites, the copies of one vertex counted once: as many vertices as there should be. */
  Offset numberOfVertexSites() const
  {
    return static_cast<Offset>(this->sites.count()) - this->featureSites.sites.count() +
      this->featureSites.numberOfPoints();
  }

  /** Vertices beyond those that there should be; below 0 if there are fewer. */
  Offset extraVertices() const { return this->components.count() - this->wantedVertices; }

  /** Whether these are more than allowed; where features alone take more, they count from there. */
  bool hasTooManyVertices(const RemeshOptions& options) const
  {
    const Offset beyond = std::max(this->neededFeaturePoints - options.numberOfSites, Offset(0));
    return this->extraVertices() - beyond > options.maximumExtraPoints;
  }
};

/**
 * Runs the pipeline on an embedded surface. Deterministic in surface and options.
 *
 * @param features along which `mesh` was cut open, or nullptr. If there are several patches, they
 *        must be separated in `surface`.
 */
Status remesh(const SurfaceMesh& mesh, const EmbeddedSurface& surface, const RemeshOptions& options,
  RunControl control, RemeshResult& result, const Features* features = nullptr);

/**
 * Ends a run again, from the diagram on, after its sites were moved or others added behind them.
 * Repairs leave all sites alone that they need not change, so that the mesh stays as it is
 * elsewhere.
 *
 * @param result of the run, with the same surface, options and features.
 */
Status completeMesh(const SurfaceMesh& mesh, const EmbeddedSurface& surface,
  const RemeshOptions& options, RunControl control, RemeshResult& result,
  const Features* features = nullptr);
}

#endif
