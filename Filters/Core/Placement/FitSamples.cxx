#include "Placement/FitSamples.h"

#include "Mesh/Extent.h"
#include "Placement/SurfaceSamples.h"

#include <cmath>

namespace remesh
{
namespace
{
constexpr Offset verticesPerBlock = 512;

double powerOfTwoBelow(double value)
{
  int exponent = 0;
  std::frexp(value, &exponent);
  return std::ldexp(1.0, exponent - 1);
}

void setLane(float (&columns)[3][lanes], std::size_t lane, const Point3& value)
{
  for (int k = 0; k < 3; ++k)
  {
    columns[k][lane] = static_cast<float>(value[k]);
  }
}
}

void SampleBlock::clear()
{
  this->groups.clear();
  this->begins.assign(1, 0);
  this->counts.clear();
}

FitSamples::FitSamples(const PlacementProblem& problem, int samples, double maxBytes)
  : m_problem(problem)
  , m_samples(samples)
  , m_unit(powerOfTwoBelow(boundingBoxDiagonal(problem.mesh)))
  , m_blocks{ problem.numberOfVertices(), verticesPerBlock }
{
  const double groups =
    (static_cast<double>(samples) / lanes + 0.5) * static_cast<double>(problem.numberOfVertices());
  if (groups * sizeof(SampleGroup) <= maxBytes)
  {
    m_kept.resize(static_cast<std::size_t>(m_blocks.count()));
  }
}

const SampleBlock& FitSamples::of(Offset block, SampleBlock& scratch)
{
  if (m_kept.empty())
  {
    this->make(block, scratch);
    return scratch;
  }
  SampleBlock& kept = m_kept[static_cast<std::size_t>(block)];
  if (kept.begins.empty())
  {
    this->make(block, scratch);  // whose memory is there already
    kept = SampleBlock(scratch); // as a whole, or if memory runs out not at all
  }
  return kept;
}

void FitSamples::make(Offset block, SampleBlock& made) const
{
  made.clear();
  const double inverse = 1.0 / m_unit; // exact, as the unit is
  for (auto vertex = static_cast<Index>(m_blocks.begin(block));
       vertex < static_cast<Index>(m_blocks.end(block)); ++vertex)
  {
    const Point3& origin = m_problem.components.centroids[vertex];
    std::size_t count = 0;
    forEachSample(m_problem, vertex, m_samples,
      [&](const SurfaceSample& sample)
      {
        const std::size_t lane = count++ % lanes;
        if (lane == 0)
        {
          made.groups.push_back({});
        }
        SampleGroup& group = made.groups.back();
        setLane(group.offset, lane, inverse * (sample.point - origin));
        setLane(group.normal, lane, sample.normal);
        group.weight[lane] = static_cast<float>(inverse * inverse * sample.weight);
      });
    made.begins.push_back(static_cast<Index>(made.groups.size()));
    made.counts.push_back(static_cast<Index>(count));
  }
}
}
