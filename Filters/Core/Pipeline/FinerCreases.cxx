#include "Pipeline/FinerCreases.h"

#include "Features/CurveSampling.h"
#include "Features/FeatureGraph.h"
#include "Mesh/NormalFlow.h"

#include <algorithm>

namespace remesh
{
namespace
{
constexpr Offset growth = 4;     // of the sites, from one look to the next
constexpr double minShare = 0.9; // of the far cells, with creases that are new

/** F: whether a facet has a point on an edge that is a feature among the fine ones alone. */
std::vector<char> facetsAtNewFeatures(
  const SurfaceMesh& mesh, const Features* coarse, const Features& fine)
{
  std::vector<char> isNew(mesh.points.size(), 0);
  for (Index facet = 0; facet < mesh.numberOfFacets(); ++facet)
  {
    for (int k = 0; k < 3; ++k)
    {
      const bool wasThere = coarse && coarse->kind(facet, k) != FeatureKind::None;
      if (fine.kind(facet, k) != FeatureKind::None && !wasThere)
      {
        isNew[mesh.facetPoints[facet][k]] = 1;
        isNew[mesh.facetPoints[facet][(k + 1) % 3]] = 1;
      }
    }
  }
  std::vector<char> found(mesh.facetPoints.size(), 0);
  for (Index facet = 0; facet < mesh.numberOfFacets(); ++facet)
  {
    const Triple& points = mesh.facetPoints[facet];
    found[facet] = isNew[points[0]] || isNew[points[1]] || isNew[points[2]];
  }
  return found;
}

/** Share of these cells that meet such facets. */
double shareOn(
  const std::vector<char>& facets, const RunOutcome& outcome, const std::vector<Index>& cells)
{
  const Components& components = outcome.result.components;
  const Diagram& diagram = outcome.result.diagram;
  const auto isOn = [&](Index cell)
  {
    return std::any_of(components.pieces.begin() + components.pieceBegin[cell],
      components.pieces.begin() + components.pieceBegin[cell + 1],
      [&](Offset piece)
      { return facets[outcome.prepared.inputFacet(diagram.facets[piece])] != 0; });
  };
  return static_cast<double>(std::count_if(cells.begin(), cells.end(), isOn)) /
    static_cast<double>(std::max<std::size_t>(cells.size(), 1));
}
}

Status findFinerCreases(const RunRequest& request, const RunOutcome& outcome,
  const std::vector<Index>& farCells, const RunControl& control, FinerCreases& finer)
{
  const PreparedSurface& prepared = outcome.prepared;
  const SurfaceMesh& whole = prepared.inputMesh();
  const Features* coarse = prepared.inputFeatures() ? &*prepared.inputFeatures() : nullptr;
  FeatureOptions options = featureOptions(request.preparation, whole);
  finer = FinerCreases{};
  Offset sites = request.preparation.sitesForFeatures;
  for (Index dropped = prepared.dropped.edges; finer.sites == 0 && dropped > 0;)
  {
    sites *= growth;
    options.spacing = meanSpacing(whole, sites);
    if (!(options.spacing > request.tolerance.tolerance))
    {
      break;
    }
    SurfaceMesh mesh = whole; // to be cut open elsewhere
    const Features fine = findFeatures(mesh, options, control);
    if (control.cancelled())
    {
      return Status::cancelled();
    }
    if (fine.dropped.edges < dropped &&
      shareOn(facetsAtNewFeatures(mesh, coarse, fine), outcome, farCells) >= minShare)
    {
      EmbeddedSurface surface; // bends do not depend on more than the place
      if (Status status = embedSurface(mesh, positionCoordinates(mesh), control, surface);
          !status.ok())
      {
        return status;
      }
      finer.sites = sites;
      CurveSampler sampler({ mesh, surface, fine },
        { outcome.result.components.count(), request.options.maxCurveError });
      finer.neededPoints = sampler.limitBends(control);
    }
    dropped = fine.dropped.edges;
  }
  return control.cancelled() ? Status::cancelled() : Status::success();
}
}
