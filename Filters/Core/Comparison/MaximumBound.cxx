#include "Comparison/MaximumBound.h"

#include "Comparison/SurfaceParts.h"
#include "Mesh/FacetGeometry.h"
#include "Support/Grouping.h"

#include <cmath>
#include <numeric>

namespace remesh
{
namespace
{
constexpr int maxLevels = 60; ///< halvings of a triangle's edges, or cuts
constexpr Offset maxPieces = 4;

struct BoundedPart
{
  SurfacePart part;
  double bound; ///< of the distance on this part
};

/** The state of the search, from level to level. */
struct Search
{
  const TriangleTree& to;
  const DistanceOptions& options;
  double largest;       ///< found
  double settled = 0.0; ///< largest bound of the parts that were left alone

  double target() const
  {
    return std::max(this->options.negligible, this->largest * (1.0 + this->options.boundTolerance));
  }

  /** Bounds one part; returns the distance of its centroid. */
  double examine(BoundedPart& bounded) const
  {
    SurfacePart& part = bounded.part;
    const TriangleTree::Place place = this->to.closest(part.centroid(), part.hint);
    const double distance = std::sqrt(place.at.squared);
    double convex = 0.0;
    for (const Point3& corner : part.corners)
    {
      convex = std::max(convex, this->to.closestOn(place.slot, corner).at.squared);
    }
    part.hint = place.slot;
    bounded.bound = std::min({ bounded.bound, distance + part.reach(), std::sqrt(convex) });
    return distance;
  }
};

/**
 * Calls `examineItem(item)`, which returns a distance, for each; raises the largest one. False if
 * cancelled.
 */
template <class ExamineItem>
bool examineAll(
  Offset count, const RunControl& control, const ExamineItem& examineItem, Search& search)
{
  const Blocks blocks = Blocks::cut(count, 1024, 4096);
  std::vector<double> largest(static_cast<std::size_t>(blocks.count()), 0.0);
  const bool done = forEachBlock(blocks.count(), control,
    [&](Offset block)
    {
      for (Offset item = blocks.begin(block); item < blocks.end(block); ++item)
      {
        largest[block] = std::max(largest[block], examineItem(item));
      }
    });
  search.largest = std::accumulate(largest.begin(), largest.end(), search.largest,
    [](double a, double b) { return std::max(a, b); });
  return done;
}

/** The triangles that the search goes on with. False if cancelled. */
bool examineTriangles(
  const Triangles& from, const RunControl& control, Search& search, std::vector<BoundedPart>& open)
{
  std::vector<double> bounds(static_cast<std::size_t>(from.count()), 0.0);
  std::vector<Index> hints(bounds.size(), noIndex);
  if (!examineAll(
        from.count(), control,
        [&](Offset t)
        {
          BoundedPart whole{ { from.corners(t) }, std::numeric_limits<double>::infinity() };
          const auto& [a, b, c] = whole.part.corners;
          if (!hasArea(a, b, c))
          {
            return 0.0;
          }
          const double distance = search.examine(whole);
          bounds[t] = whole.bound;
          hints[t] = whole.part.hint;
          return distance;
        },
        search))
  {
    return false;
  }
  const double target = search.target();
  for (std::size_t t = 0; t < bounds.size(); ++t)
  {
    if (bounds[t] > target)
    {
      open.push_back({ { from.corners(static_cast<Offset>(t)), hints[t] }, bounds[t] });
    }
    else
    {
      search.settled = std::max(search.settled, bounds[t]);
    }
  }
  return true;
}

/** Leaves alone the parts that cannot matter, and those beyond `most` with the least bounds. */
void settle(std::vector<BoundedPart>& open, Offset most, Search& search)
{
  const double target = search.target();
  double least = target;
  if (static_cast<Offset>(open.size()) > most)
  {
    std::vector<double> bounds(open.size());
    std::transform(
      open.begin(), open.end(), bounds.begin(), [](const BoundedPart& part) { return part.bound; });
    const auto place = bounds.begin() + most;
    std::nth_element(bounds.begin(), place, bounds.end(), std::greater<>());
    least = std::max(least, *place); // at most `most` parts are above it
  }
  const auto end = std::remove_if(open.begin(), open.end(),
    [&](const BoundedPart& part)
    {
      if (part.bound > least)
      {
        return false;
      }
      search.settled = std::max(search.settled, part.bound);
      return true;
    });
  open.erase(end, open.end());
}

/** @param most pieces of a part that is cut into slices. */
std::vector<BoundedPart> cutAll(
  const std::vector<BoundedPart>& open, Offset most, const Search& search)
{
  PartCutter cutter(search.to, search.target());
  std::vector<BoundedPart> cut;
  cut.reserve(maxPieces * open.size());
  std::vector<SurfacePart> pieces;
  for (const BoundedPart& each : open)
  {
    pieces.clear();
    if (!cutter.cutAcross(each.part.hint, each.part, most, pieces))
    {
      cutter.cut(each.part.hint, each.part, pieces);
    }
    for (const SurfacePart& piece : pieces)
    {
      cut.push_back({ piece, each.bound });
    }
  }
  return cut;
}
}

Status boundMaximum(const Triangles& from, const TriangleTree& to, const DistanceOptions& options,
  const RunControl& control, OneSidedDistance& distance)
{
  Search search{ to, options, distance.maximum };
  std::vector<BoundedPart> open;
  if (!examineTriangles(from, control.step(0, 2), search, open))
  {
    return Status::cancelled();
  }
  Offset budget = options.maximumParts;
  for (int level = 0; level < maxLevels; ++level)
  {
    settle(open, budget / maxPieces, search);
    if (open.empty())
    {
      break;
    }
    open = cutAll(open, budget / (2 * static_cast<Offset>(open.size())), search);
    budget -= static_cast<Offset>(open.size());
    if (!examineAll(
          static_cast<Offset>(open.size()), control.silent(),
          [&](Offset k) { return search.examine(open[k]); }, search))
    {
      return Status::cancelled();
    }
  }
  settle(open, 0, search);
  distance.maximum = search.largest;
  distance.maximumBound = std::max(search.largest, search.settled);
  return Status::success();
}
}
