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
 * What is wrong with the placed mesh. Its repairs have done what they could for the number of
 * points: `pointsOff` is in halves of those asked for, and the rest counts as forced.
 */
Verdict verdictOf(const RemeshResult& result, const RemeshOptions& options);
}

#endif
