#include "Pipeline/Pipeline.h"

#include "Pipeline/NumberRun.h"
#include "Pipeline/ToleranceRun.h"
#include "Run/MeshDistance.h"

namespace remesh
{
Status makeMesh(RunRequest request, const RunControl& control, RunOutcome& outcome)
{
  RemeshOptions& options = request.options;
  if (request.preparation.embedding || request.preparation.metric) // the spacing is the caller's
  {
    options.curvesFollowBends = false;
    if (options.placement == VertexPlacement::Fit)
    {
      options.placement =
        request.preparation.metric ? VertexPlacement::FirmFit : VertexPlacement::HeldFit;
    }
  }
  if (!request.hasNumber())
  {
    return remeshWithin(std::move(request), control, outcome);
  }
  request.preparation.numberOfSites =
    request.sites ? request.sites->places.count : options.numberOfSites;
  const bool measuresDistance = request.measuresDistance;
  Ranks* const ranks = options.ranks;
  Status status = remeshWithNumber(std::move(request), control, outcome);
  return status.ok() && measuresDistance
    ? findDistance(outcome.prepared.inputMesh(), ranks, control.silent(), outcome.result)
    : status;
}
}
