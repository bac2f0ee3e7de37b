/**
 * @file RemeshResult.h
 * @brief What a run on an embedded surface has made.
 */
#ifndef remesh_RemeshResult_h
#define remesh_RemeshResult_h

#include "Comparison/SurfaceDistance.h"
#include "Delaunay/Components.h"
#include "Delaunay/Dual.h"
#include "Delaunay/SurfaceLocation.h"
#include "Delaunay/TopologyResult.h"
#include "Features/FeatureSites.h"
#include "Optimization/Convergence.h"
#include "Run/PlacedVertices.h"
#include "Run/RemeshOptions.h"
#include "Run/Verdict.h"
#include "Voronoi/CellSums.h"
#include "Voronoi/Diagram.h"
#include "Voronoi/PlainSums.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace remesh
{
/** What is in R^d has the scaled units of the embedded surface; what is in R^3, the points'. */
struct RemeshResult
{
  Sites sites;
  CellSums sums;
  PlainSums plainSums;          ///< of the sites, not weighted by a density; empty if there is none
  PlainSums plainComponentSums; ///< of the components, likewise
  Diagram diagram;
  Components components;
  FeatureSites featureSites;      ///< the first sites; none without features
  Offset wantedVertices = 0;      ///< how many vertices the mesh should have
  Offset neededFeaturePoints = 0; ///< vertices that corners and bends of features take at least
  double shareApart = 1.0;        ///< of the surface: farther than the spacing from all features
  bool curvesAreApart = false;    ///< whether all curves were kept apart; false: no room for it
  Seams seams;                    ///< the mesh's edges along features, and faults there
  std::vector<SurfaceLocation> locations; ///< K, points of the surface closest to the vertices
  Dual dual;                              ///< the mesh: its triangles after all repairs
  PlacedVertices placement;               ///< the mesh: positions of its vertices
  std::vector<Index> numbersOfNeighbors;  ///< n
  std::vector<int> cellColors;            ///< n, few, those of neighbours differ
  std::vector<double> cellAreas;          ///< n, in R^3
  Convergence convergence;
  TopologyResult topology;
  std::optional<TwoSidedDistance> distance; ///< of mesh and surface, where it was measured
  Index emptyCells = 0;                     ///< free sites without a cell
  Index movedSites = 0;    ///< sites that repairs changed; `convergence` ends before repairs
  int evaluations = 0;     ///< how often the cells of the whole surface were computed
  bool fallsApart = false; ///< cells fell apart: the run ended at its first diagram

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

  /** Vertices if each cell is connected: all sites, the copies of one vertex counted once. */
  Offset numberOfVertexSites() const
  {
    return static_cast<Offset>(this->sites.count()) - this->featureSites.sites.count() +
      this->featureSites.numberOfPoints();
  }

  /** Vertices beyond `wantedVertices`; below 0 if there are fewer. */
  Offset extraVertices() const { return this->components.count() - this->wantedVertices; }

  /**
   * Whether there are more extra vertices than allowed. If features alone take more points than
   * were asked for, those are not counted.
   */
  bool hasTooManyVertices(const RemeshOptions& options) const
  {
    const Offset beyond = std::max(this->neededFeaturePoints - options.numberOfSites, Offset(0));
    return this->extraVertices() - beyond > options.maximumExtraPoints;
  }
};

/**
 * What is wrong with the placed mesh, when two whole runs are compared. Repairs have done what they
 * could for the number of vertices, so a small difference is of no weight: `pointsOff` counts
 * halves of the wanted number, and is 0 within what is allowed. `pointsForced` is the difference.
 */
Verdict verdictOf(const RemeshResult& result, const RemeshOptions& options);
}

#endif
