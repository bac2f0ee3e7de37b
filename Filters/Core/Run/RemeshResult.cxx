#include "Run/RemeshResult.h"

#include <cstdlib>

namespace remesh
{
RemeshResult::Seconds& RemeshResult::Seconds::operator+=(const Seconds& other)
{
  this->sampling += other.sampling;
  this->lloyd += other.lloyd;
  this->newton += other.newton;
  this->repair += other.repair;
  this->diagram += other.diagram;
  this->placement += other.placement;
  this->distance += other.distance;
  return *this;
}

Verdict verdictOf(const RemeshResult& result, const RemeshOptions& options)
{
  const Offset extra = result.extraVertices();
  const bool areTooMany = extra < 0 || result.hasTooManyVertices(options);
  Verdict verdict;
  verdict.pointsOff =
    areTooMany ? 2 * std::abs(extra) / std::max(result.wantedVertices, Offset(1)) : 0;
  verdict.isUnproven = !result.topology.preserved();
  verdict.pointsForced = std::abs(extra);
  verdict.faults = result.topology.certificate.violations();
  verdict.inverted = result.placement.edits.inverted;
  verdict.strays = result.placement.strays;
  verdict.crossings = result.placement.crossings;
  verdict.refilled = result.placement.edits.refilled;
  return verdict;
}
}
