#include "Adaptors/FinerCreases.h"

#include "Features/CurveSampling.h"
#include "Mesh/NormalFlow.h"

#include <algorithm>

namespace remesh
{
namespace
{
constexpr Offset growth = 4;       // of the sites, from one look to the next
constexpr double leastShare = 0.9; // of the far cells, with creases that are new

/** The same in R^3: what features there are does not depend on more. */
PreparationRequest inSpace(PreparationRequest preparation)
{
  preparation.gaussMap = false;
  preparation.normalSmoothingPasses = 0;
  preparation.normals = nullptr;
  preparation.embedding = nullptr;
  preparation.density = nullptr;
  preparation.coordinates.clear();
  return preparation;
}

/** F: whether a facet has a point on an edge that is a feature on one surface alone. */
std::vector<char> facetsAtNewFeatures(const PreparedSurface& coarse, const PreparedSurface& fine)
{
  const EdgeTable& edges = fine.features->edges;
  std::vector<char> isNew(fine.mesh.points.size(), 0);
  for (Index facet = 0; facet < fine.mesh.numberOfFacets(); ++facet)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index edge = edges.facetEdges[facet][k];
      const bool wasThere = coarse.features && coarse.features->kinds[edge] != FeatureKind::None;
      if (fine.features->kinds[edge] != FeatureKind::None && !wasThere)
      {
        isNew[fine.mesh.facetPoints[facet][k]] = 1;
        isNew[fine.mesh.facetPoints[facet][(k + 1) % 3]] = 1;
      }
    }
  }
  std::vector<char> found(fine.mesh.facetPoints.size(), 0);
  for (Index facet = 0; facet < fine.mesh.numberOfFacets(); ++facet)
  {
    const Triple& points = fine.mesh.facetPoints[facet];
    found[facet] = isNew[points[0]] || isNew[points[1]] || isNew[points[2]];
  }
  return found;
}

/** Share of these cells that meet such facets. */
double shareOn(
  const std::vector<char>& facets, const RemeshResult& result, const std::vector<Index>& cells)
{
  const Components& components = result.components;
  const auto isOn = [&](Index cell)
  {
    return std::any_of(components.pieces.begin() + components.pieceBegin[cell],
      components.pieces.begin() + components.pieceBegin[cell + 1],
      [&](Offset piece) { return facets[result.diagram.facets[piece]] != 0; });
  };
  return static_cast<double>(std::count_if(cells.begin(), cells.end(), isOn)) /
    static_cast<double>(std::max<std::size_t>(cells.size(), 1));
}
}

Status findFinerCreases(const NumberRequest& request, const NumberOutcome& outcome,
  const std::vector<Index>& farCells, double tolerance, double mostCurveError,
  const RunControl& control, FinerCreases& finer)
{
  const PreparedSurface& coarse = outcome.prepared;
  PreparationRequest preparation = inSpace(request.preparation);
  finer = FinerCreases{};
  for (Index dropped = coarse.droppedCreases; finer.sites == 0 && dropped > 0;)
  {
    preparation.sitesForFeatures *= growth;
    if (!(meanSpacing(coarse.mesh, preparation.sitesForFeatures) > tolerance))
    {
      break;
    }
    PreparedSurface fine;
    if (Status status = prepareSurface(request.input, preparation, control, fine); !status.ok())
    {
      return status;
    }
    if (fine.features && fine.droppedCreases < dropped &&
      shareOn(facetsAtNewFeatures(coarse, fine), outcome.result, farCells) >= leastShare)
    {
      finer.sites = preparation.sitesForFeatures;
      sampleCurves({ fine.mesh, fine.surface, *fine.features }, outcome.result.components.count(),
        mostCurveError, control, finer.neededPoints);
    }
    dropped = fine.droppedCreases;
  }
  return control.cancelled() ? Status::cancelled() : Status::success();
}
}
