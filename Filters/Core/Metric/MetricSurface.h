/**
 * @file MetricSurface.h
 * @brief From a metric on a surface to the surface in R^d: all steps.
 *
 * 1. Refine the surface where it is too coarse for the metric (MetricRefinement.h).
 * 2. Limit the metric to what straight edges can follow (StraightEdges.h).
 * 3. Limit how fast it grows and turns (Gradation.h).
 * 4. Embed it (IsometricEmbedding.h).
 */
#ifndef remesh_MetricSurface_h
#define remesh_MetricSurface_h

#include "Metric/IsometricEmbedding.h"
#include "Refinement/RefinedSurface.h"

#include <optional>

namespace remesh
{
struct MetricOptions
{
  int dimension = 6;
  Offset sites = 10000;  ///< whose spacing is the unit
  double unit = 0.0;     ///< length of edges in the metric; 0: what `sites` gives
  bool isLimited = true; ///< to what straight edges can follow, and by `growth`
  double growth = 5.0;   ///< above 1, of sizes over a unit, at most
  bool mayRefine = true;
  int iterations = 200;         ///< of the embedding, at most
  double energyDecrease = 0.15; ///< see IsometryOptions
};

struct MetricSurface
{
  std::optional<RefinedSurface> refined; ///< where the surface had to be
  MetricField metric;                    ///< V of the refined surface, as limited
  /**
   * V, in which triangles are to be even at their centres: between the metric as given and as
   * limited, a mean of logarithms. Where it was limited by a factor l, the given one has the share
   * 1 / l: there straight edges cannot be what it wants.
   */
  MetricField shapeMetric;
  std::vector<TargetShape> shapes; ///< F
  IsometricEmbedding embedding;
  double unit = 1.0; ///< length of edges in the metric
  /** Share of the area where the metric varies too much from one given point to the next. */
  double coarseShare = 0.0;
  /** V, at least 1: by how much sizes were made smaller in some direction; 1 where not limited. */
  std::vector<float> limits;
};

/**
 * @param features of the mesh, or nullptr.
 * @return Cancelled, or InvalidInput where the metric cannot be worked on.
 */
Status embedMetric(const SurfaceMesh& mesh, const Features* features, const MetricField& metric,
  const MetricOptions& options, const RunControl& control, MetricSurface& surface);

/** What a surface is in a metric as limited. */
struct MetricSize
{
  double area = 0.0;
  double border = 0.0; ///< length of the border; an edge of n facets counts 2 - n times
  double euler = 0.0;  ///< points less edges plus facets

  /** How many points a mesh has whose edges have that length: triangles of equal sides. */
  double points(double unit) const;
};

MetricSize sizeOf(
  const SurfaceMesh& mesh, const std::vector<TargetShape>& shapes, const RunControl& control);

/** As `embedMetric`, without the embedding. The unit must be given. */
Status measureMetric(const SurfaceMesh& mesh, const MetricField& metric,
  const MetricOptions& options, const RunControl& control, MetricSize& size);

/**
 * The length that edges must have in a metric as it is given, so that the surface's area in it is
 * `complexity` squares of such edges; 1 where the complexity is 0.
 */
Status findComplexityUnit(const SurfaceMesh& mesh, const MetricField& metric, double complexity,
  const RunControl& control, double& unit);

/** Edges of triangles of equal sides: n of the points on an area are that far apart. */
double unitOf(double area, Offset points);
}

#endif
