#include "Run/MeshDistance.h"

#include "Run/Task.h"

#include <algorithm>

namespace remesh
{
namespace
{
constexpr std::size_t maxExamined = 100000;
constexpr Offset minSamples = 20000; // of each surface, however few its triangles
constexpr Offset samplesOfTriangle = 3;
constexpr Offset manySamples = 60000; // beyond which one of each triangle does

/** Every k-th triangle, so that there are `maxExamined` at most. */
std::vector<Triple> examinedOf(const std::vector<Triple>& triangles)
{
  const std::size_t step = (triangles.size() + maxExamined - 1) / maxExamined;
  std::vector<Triple> some;
  for (std::size_t t = 0; t < triangles.size(); t += step)
  {
    some.push_back(triangles[t]);
  }
  return some;
}
}

Triangles trianglesOf(const SurfaceMesh& mesh)
{
  return { mesh.points, mesh.facetPoints };
}

Triangles trianglesOf(const RemeshResult& result)
{
  return { result.placement.positions, result.dual.triangles };
}

Status findDistance(const SurfaceMesh& mesh, const RunControl& control, RemeshResult& result)
{
  Stopwatch watch;
  DistanceOptions options;
  options.boundTolerance = -1.0;
  // One tree at a time: they are large.
  const auto measure = [&](const Triangles& from, const Triangles& to, OneSidedDistance& distance)
  {
    const std::vector<Triple> some = examinedOf(from.triangles);
    const auto count = static_cast<Offset>(some.size());
    options.numberOfSamples =
      minSamples + std::min(samplesOfTriangle * count, std::max(manySamples, count));
    const TriangleTree tree(to, control);
    return !tree.empty() &&
      measureOneSidedDistance({ from.points, some }, tree, options, control, distance).ok();
  };
  TwoSidedDistance distance;
  if (measure(trianglesOf(result), trianglesOf(mesh), distance.forward) &&
    measure(trianglesOf(mesh), trianglesOf(result), distance.backward))
  {
    result.distance = distance;
  }
  result.seconds.distance = watch.lap();
  return control.cancelled() ? Status::cancelled() : Status::success();
}
}
