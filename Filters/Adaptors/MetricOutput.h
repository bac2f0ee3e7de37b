/**
 * @file MetricOutput.h
 * @brief A surface with the embedding of its metric as VTK's data.
 */
#ifndef remesh_MetricOutput_h
#define remesh_MetricOutput_h

#include "Adaptors/FieldSurface.h"

#include <string>

namespace remesh
{
struct MetricRequest
{
  std::string array;
  TensorOrder order = TensorOrder::Vtk;
  MetricOptions options;
  bool isUnit = false;     ///< whether edges of the length 1 are asked for, not a number of sites
  double complexity = 0.0; ///< then the area that the metric is scaled to; 0: as it is
};

/**
 * Embeds the metric, and writes the output: the surface in triangles, as vtkMetricEmbedding tells.
 * Warnings go to the surface's.
 *
 * @return InvalidInput with the array's name where it is no metric, or cannot be worked on.
 */
Status addMetricEmbedding(const MetricRequest& request, FieldSurface& surface);
}

#endif
