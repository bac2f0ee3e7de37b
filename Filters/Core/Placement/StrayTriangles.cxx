#include "Placement/StrayTriangles.h"

#include "Placement/TriangleShape.h"
#include "Support/Parallel.h"

namespace remesh
{
Status findSuspects(const PlacementProblem& problem, const WholeSurface& whole,
  const Triangles& mesh, const RunControl& control, std::vector<char>& suspects)
{
  suspects.assign(mesh.triangles.size(), 0);
  const bool done =
    forEachItem(Blocks::cut(static_cast<Offset>(mesh.triangles.size()), 64, 4096), control,
      [&](Offset t)
      {
        const Triple& triangle = mesh.triangles[t];
        const auto [a, b, c] = cornersOf(triangle, mesh.points);
        const Offset piece = problem.components.pieceBegin[triangle[0]];
        const Index nearby = problem.diagram.facets[problem.components.pieces[piece]];
        suspects[t] = whole.minCosine((a + b + c) / 3.0, facetNormal(a, b, c), nearby) < 0.0;
      });
  return done ? Status::success() : Status::cancelled();
}
}
