#include "Placement/StrayTriangles.h"

#include "Placement/TriangleShape.h"
#include "Support/Parallel.h"

namespace remesh
{
Status findSuspects(const PlacementProblem& problem, const WholeSurface& whole,
  const std::vector<Triple>& triangles, const std::vector<Point3>& positions,
  const RunControl& control, std::vector<char>& suspects)
{
  suspects.assign(triangles.size(), 0);
  const bool done =
    forEachRange(Blocks::cut(static_cast<Offset>(triangles.size()), 64, 4096), control,
      [&](Offset begin, Offset end)
      {
        for (Offset t = begin; t < end; ++t)
        {
          const auto [a, b, c] = cornersOf(triangles[t], positions);
          const Offset piece = problem.components.pieceBegin[triangles[t][0]];
          const Index nearby = problem.diagram.facets[problem.components.pieces[piece]];
          suspects[t] = whole.leastCosine((a + b + c) / 3.0, facetNormal(a, b, c), nearby) < 0.0;
        }
      });
  return done ? Status::success() : Status::cancelled();
}
}
