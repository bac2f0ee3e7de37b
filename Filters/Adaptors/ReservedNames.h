/**
 * @file ReservedNames.h
 * @brief The names of all arrays that a filter may add to what it carries over from its input.
 *
 * An array of the input that has one of them, perhaps from an earlier run, is never passed on: it
 * would be taken for a result of this run wherever this run does not write the array itself.
 */
#ifndef remesh_ReservedNames_h
#define remesh_ReservedNames_h

#include "Adaptors/BlockNames.h"

#include "vtkFieldData.h"

#include <algorithm>
#include <initializer_list>
#include <string>

namespace remesh
{
using Names = std::initializer_list<const char*>;

/** Point arrays of a diagram filter's mesh. ComputedFields.cxx of the command line has a copy. */
inline constexpr Names meshPointNames = { "SiteId", "ComponentId", "CellColor", "CellArea",
  "CellMass", "CellEnergy", "CellWeightedMass", "Embedding", "Normals" };

/** Field arrays of a diagram filter's mesh, which no other port has. */
inline constexpr Names meshFactNames = { "NumberOfFlippedTriangles", "NumberOfNonManifoldEdges",
  "NumberOfStrayTriangles", "NumberOfSelfIntersections", "EulerCharacteristic", "TopologyPreserved",
  "NumberOfExtraPoints", "Seed", "NormalSmoothingRadius", "MaximumDistance", "RMSDistance",
  "MetricUnit", "MetricLimit", "MetricShare" };

/** Those of them that vtkMetricEmbedding's output has, too: they are left out without a word. */
inline constexpr Names metricFactNames = { "MetricUnit", "MetricLimit", "MetricShare" };

/** Cell arrays of a compared mesh. */
inline constexpr Names comparedCellNames = { "Quality", "MinimumAngle", "RadiusRatio", "EdgeRatio",
  "NormalDeviation", "Flipped" };

/** Point arrays of a compared mesh and its reference. */
inline constexpr Names comparedPointNames = { "Distance", "SignedDistance" };

inline bool isReserved(Names names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

/** Those of some blocks, too (BlockNames.h). */
inline void removeReserved(Names names, vtkFieldData* data)
{
  for (int k = data->GetNumberOfArrays() - 1; k >= 0; --k)
  {
    const char* name = data->GetArrayName(k);
    if (name && isReserved(names, plainName(name)))
    {
      data->RemoveArray(name);
    }
  }
}
}

#endif
