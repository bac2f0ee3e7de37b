/**
 * @file SolutionMetricInput.h
 * @brief From a filter's point arrays to what a metric is made for.
 */
#ifndef remesh_SolutionMetricInput_h
#define remesh_SolutionMetricInput_h

#include "Adaptors/FieldSurface.h"
#include "Metric/SolutionMetric.h"

namespace remesh
{
/** Names of point arrays. */
struct SolutionMetricArrays
{
  std::vector<std::string> solutions;
  std::vector<std::string> hessians;
  std::vector<std::string> metrics;
  TensorOrder order = TensorOrder::Vtk; ///< of hessians and metrics
  std::string distance;                 ///< "": none
  double distanceSize = 0.0;            ///< length of edges at distance 0
  double distanceGrowth = 0.0;          ///< and by how much it grows with the distance
};

/** @return InvalidInput with the array's name, and the first point where a value cannot be used. */
Status readSolutionMetricInput(
  const FieldSurface& surface, const SolutionMetricArrays& arrays, SolutionMetricInput& input);

/** Makes the metric and adds it to the output. Warnings go to the surface's. */
Status addSolutionMetric(
  FieldSurface& surface, const SolutionMetricArrays& arrays, const SolutionMetricOptions& options);
}

#endif
