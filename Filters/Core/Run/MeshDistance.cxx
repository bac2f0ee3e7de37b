#include "Run/MeshDistance.h"

#include "Comparison/SharedDistance.h"
#include "Run/Task.h"

#include <algorithm>
#include <optional>
#include <stdexcept>

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

Offset samplesFor(std::size_t triangles)
{
  const auto count = static_cast<Offset>(triangles);
  return minSamples + std::min(samplesOfTriangle * count, std::max(manySamples, count));
}

/** Triangles, and those of them that are sampled. */
class Side
{
public:
  explicit Side(const Triangles& whole)
    : m_whole(whole)
    , m_some(examinedOf(whole.triangles))
    , m_sampled(sampledTriangles({ whole.points, m_some }, samplesFor(m_some.size())))
  {
  }

  Side(const Side&) = delete;
  Side& operator=(const Side&) = delete;

  const Triangles& whole() const { return m_whole; }
  const SampledTriangles& sampled() const { return m_sampled; }

private:
  Triangles m_whole;
  std::vector<Triple> m_some;
  SampledTriangles m_sampled;
};

/** One tree at a time: they are large. */
Status measure(
  const Side& from, const Side& to, const RunControl& control, OneSidedDistance& distance)
{
  return measureSamples(from.sampled(), TriangleTree(to.whole(), control), control, distance);
}

/** The others measure how far the surface is while this rank measures how far the mesh is. */
Status measureBoth(const Side& made, const Side& surface, Ranks* ranks, const RunControl& control,
  TwoSidedDistance& distance)
{
  const bool shares = ranks && ranks->count() > 1;
  try
  {
    std::optional<OtherRanks> others;
    if (shares)
    {
      others.emplace(*ranks);
      tellToMeasure(*others, surface.sampled(), made.whole());
    }
    Status status = measure(made, surface, control, distance.forward);
    if (!status.ok())
    {
      return status;
    }
    status = shares ? takeMeasured(*others, distance.backward) : status;
    if (shares && status.code != StatusCode::OutOfMemory)
    {
      return status;
    }
    // Alone, or the others have no room for it, which is no reason to lose a finished mesh.
    return measure(surface, made, control, distance.backward);
  }
  catch (const std::runtime_error& error)
  {
    return Status::invalid(error.what());
  }
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

Status findDistance(
  const SurfaceMesh& mesh, Ranks* ranks, const RunControl& control, RemeshResult& result)
{
  Stopwatch watch;
  const Side made(trianglesOf(result));
  const Side surface(trianglesOf(mesh));
  Status status;
  if (made.sampled().hasArea() && surface.sampled().hasArea())
  {
    TwoSidedDistance distance;
    status = measureBoth(made, surface, ranks, control, distance);
    if (status.ok())
    {
      result.distance = distance;
    }
  }
  result.seconds.distance = watch.lap();
  return control.cancelled() ? Status::cancelled() : status;
}
}
