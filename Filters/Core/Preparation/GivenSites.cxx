#include "Preparation/GivenSites.h"

#include "Embedding/CornerReader.h"
#include "Mesh/TriangleTree.h"
#include "Support/Parallel.h"

#include <cmath>
#include <string>

namespace remesh
{
namespace
{
/** In scaled units, of which the surface is 1 in size: squares stay far from overflow. */
constexpr double farthestSite = 1e30;

/** Row by row from the array, centred and scaled. */
Status takeEmbedding(const PointArray& embedding, const EmbeddedSurface& surface, Sites& sites)
{
  for (Index i = 0; i < sites.count(); ++i)
  {
    double* x = sites.site(i);
    embedding.read(i, x);
    for (int c = 0; c < surface.dimension; ++c)
    {
      x[c] = surface.toScaled(x[c], c);
      if (!std::isfinite(x[c]))
      {
        return Status::invalid("The embedding of site " + std::to_string(i) +
          " has a value that is not a finite number.");
      }
      if (std::abs(x[c]) > farthestSite)
      {
        return Status::invalid(
          "The embedding of site " + std::to_string(i) + " is too far from the surface's.");
      }
    }
  }
  return Status::success();
}

/** Each at the closest point of the surface. */
Status projectOnSurface(const std::vector<Point3>& places, const PreparedSurface& prepared,
  const RunControl& control, Sites& sites)
{
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (places[i].cwiseAbs().maxCoeff() > largestCoordinate)
    {
      return Status::invalid("Site " + std::to_string(i) + " is too far away.");
    }
  }
  const EmbeddedSurface& surface = prepared.surface;
  const TriangleTree tree({ prepared.mesh.points, prepared.mesh.facetPoints }, control);
  if (control.cancelled())
  {
    return Status::cancelled();
  }
  const Blocks blocks = Blocks::cut(static_cast<Offset>(places.size()), 256, 1024);
  const bool done = forEachRange(blocks, control,
    [&](Offset begin, Offset end)
    {
      CornerReader<Eigen::Dynamic> reader(surface);
      TriangleTree::Place place;
      for (Offset i = begin; i < end; ++i)
      {
        place = tree.closest(places[i], place.slot);
        const auto corners = reader.facet(tree.triangleOf(place.slot));
        double* x = sites.site(static_cast<Index>(i));
        for (int c = 0; c < surface.dimension; ++c)
        {
          x[c] = place.at.b[0] * corners[0][c] + place.at.b[1] * corners[1][c] +
            place.at.b[2] * corners[2][c];
        }
      }
    });
  return done ? Status::success() : Status::cancelled();
}
}

Status placeSites(const GivenSites& given, const RunControl& control, PreparedSurface& prepared,
  PlacedSites& placed)
{
  const Offset count = given.places.count;
  const int d = prepared.surface.dimension;
  if (count < 1 || count > maximumIndex)
  {
    return Status::invalid("The sites must be 1 to " + std::to_string(maximumIndex) +
      " points; the input has " + std::to_string(count) + ".");
  }
  placed.places.resize(static_cast<std::size_t>(count));
  for (Offset i = 0; i < count; ++i)
  {
    given.places.read(i, placed.places[i].data());
    if (!placed.places[i].allFinite())
    {
      return Status::invalid(
        "Site " + std::to_string(i) + " has a coordinate that is not a finite number.");
    }
  }
  placed.sites.dimension = d;
  placed.sites.coordinates.resize(static_cast<std::size_t>(count) * static_cast<std::size_t>(d));
  const std::optional<PointArray>& embedding = given.embedding;
  if (!embedding || embedding->dimension != d || embedding->count != count)
  {
    if (embedding)
    {
      prepared.warnings.push_back("The sites' array \"Embedding\" has not the " +
        std::to_string(d) +
        " components of the surface's embedding: the sites are put on the surface instead.");
    }
    RunControl progress = control;
    progress.enterPhase("Sites", 0.0, 1.0);
    return projectOnSurface(placed.places, prepared, progress, placed.sites);
  }
  return takeEmbedding(*embedding, prepared.surface, placed.sites);
}
}
