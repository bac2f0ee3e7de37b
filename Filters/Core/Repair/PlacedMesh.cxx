#include "Repair/PlacedMesh.h"

#include "Mesh/Extent.h"
#include "Placement/StrayTriangles.h"
#include "Placement/WholeSurface.h"
#include "Repair/CrossingRepair.h"
#include "Repair/MeshRepair.h"
#include "Repair/PartableCrossings.h"
#include "Repair/RepairedMesh.h"
#include "Repair/StarRepair.h"
#include "Run/Verdict.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace remesh
{
namespace
{
/** What all repairs of the placed mesh read and change. */
struct Repair
{
  const PlacementProblem& problem;
  const RunControl& control;
  const std::vector<Point3>& start;     ///< K, before vertices were placed
  const std::vector<Point3>& onSurface; ///< K, the surface's points closest to these
  const WholeSurface& whole;
  std::vector<Triple>& triangles;
  PlacedVertices& placed;

  /** Turns back what faces against a surface, in copies of the mesh or in itself. */
  Status refill(const NearbySurface& surface, InvertedSearch& search, std::vector<Triple>& some,
    PlacedVertices& vertices) const
  {
    return repairMesh({ this->problem, surface, this->onSurface, this->start, this->control },
      MeshSteps::Refill, search, some, vertices);
  }

  Status turnInverted(const NearbySurface& own)
  {
    InvertedSearch search(own);
    return this->refill(own, search, this->triangles, this->placed);
  }

  Verdict verdict() const
  {
    Verdict verdict;
    verdict.inverted = this->placed.edits.inverted;
    verdict.strays = this->placed.strays;
    return verdict;
  }

  /** Turns strays back, if they are few; keeps nothing that makes the verdict worse. */
  Status turnStrays(const NearbySurface& own)
  {
    std::vector<char> suspects;
    Status status = findSuspects(this->problem, this->whole,
      { this->placed.positions, this->triangles }, this->control.silent(), suspects);
    if (!status.ok() || std::none_of(suspects.begin(), suspects.end(), [](char s) { return s; }))
    {
      return status;
    }
    const NearbySurface surface(this->problem, minHeight(this->problem.mesh), &this->whole);
    InvertedSearch search(surface);
    std::vector<Index> wrong;
    // Where none faces against its own cells, only the suspects can be inverted.
    const bool faceOwnCells = this->placed.edits.inverted == 0;
    status = search.find(this->triangles, this->placed.positions, this->control, wrong,
      faceOwnCells ? &suspects : nullptr);
    const auto count = static_cast<Offset>(wrong.size());
    this->placed.strays = std::max(count - this->placed.edits.inverted, Offset(0));
    if (!status.ok() || this->placed.strays == 0 ||
      count > maxStrays(static_cast<Offset>(this->triangles.size())))
    {
      return status;
    }
    std::vector<Triple> others = this->triangles;
    PlacedVertices moved = this->placed;
    status = this->refill(surface, search, others, moved);
    return status.ok() ? this->keepIfBetter(own, std::move(others), std::move(moved)) : status;
  }

  /** @param other inverted triangles and strays together are counted as inverted. */
  Status keepIfBetter(const NearbySurface& own, std::vector<Triple> others, PlacedVertices other)
  {
    std::vector<Index> inverted;
    const Status status =
      InvertedSearch(own).find(others, other.positions, this->control, inverted);
    other.strays = other.edits.inverted - static_cast<Offset>(inverted.size());
    other.edits.inverted = static_cast<Offset>(inverted.size());
    other.edits.movedVertices += this->placed.edits.movedVertices;
    other.edits.flippedEdges += this->placed.edits.flippedEdges;
    other.edits.refilled += this->placed.edits.refilled;
    const Repair after{ this->problem, this->control, this->start, this->onSurface, this->whole,
      this->triangles, other };
    if (status.ok() && after.verdict() < this->verdict())
    {
      this->triangles = std::move(others);
      this->placed = std::move(other);
    }
    return status;
  }

  /** Parts triangles that go through each other, if they are few; inverts none for that. */
  Status partCrossings()
  {
    CrossingSearch search(this->triangles, this->placed.positions, this->control);
    std::vector<std::pair<Index, Index>> pairs;
    const Offset most = maxStrays(static_cast<Offset>(this->triangles.size()));
    Status status = findPartable(this->problem, search, most, this->control, pairs);
    this->placed.crossings = static_cast<Offset>(pairs.size());
    if (!status.ok() || pairs.empty() || this->placed.crossings > most)
    {
      return status;
    }
    const NearbySurface surface(this->problem, minHeight(this->problem.mesh), &this->whole);
    RepairedMesh mesh(this->problem, surface, this->start, this->triangles, this->placed.positions);
    repairCrossings({ this->problem, this->onSurface, this->control, true, 0.0 }, pairs, search,
      mesh, this->placed.edits);
    this->placed.crossings = std::count_if(pairs.begin(), pairs.end(),
      [&](const std::pair<Index, Index>& pair)
      {
        return areCrossing(
          this->triangles[pair.first], this->triangles[pair.second], this->placed.positions);
      });
    return this->control.cancelled() ? Status::cancelled() : Status::success();
  }
};
}

Status repairPlacedMesh(const PlacementProblem& problem, VertexPlacement way,
  const RunControl& control, std::vector<SurfaceLocation>& locations,
  std::vector<Triple>& triangles, PlacedVertices& placed)
{
  const std::vector<Point3> start = startingPlaces(problem, placed.positions);
  const std::vector<Point3> onSurface = placesOnSurface(problem, locations, start);
  const RunControl silent = control.silent();
  std::optional<WholeSurface> made;
  if (!problem.whole)
  {
    made.emplace(problem.mesh, silent);
  }
  Repair repair{ problem, silent, start, onSurface, problem.whole ? *problem.whole : *made,
    triangles, placed };
  const NearbySurface own(problem, minHeight(problem.mesh));
  Status status = repair.turnInverted(own);
  if (status.ok())
  {
    status = repair.turnStrays(own);
  }
  if (status.ok())
  {
    status = repair.partCrossings();
  }
  if (!status.ok())
  {
    return status;
  }
  const std::vector<Point3> known =
    way == VertexPlacement::Surface ? onSurface : std::vector<Point3>();
  return locatePlaces(
    own, way == VertexPlacement::Centroid ? start : known, placed.positions, control, locations);
}
}
