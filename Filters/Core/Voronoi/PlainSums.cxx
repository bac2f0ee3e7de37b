#include "Voronoi/PlainSums.h"

#include "Embedding/CornerReader.h"

namespace remesh
{
namespace
{
constexpr Offset piecesBetweenQuestions = 4096;

/** Calls `add(piece, facet, integral)` for each piece; false if cancelled. */
template <class Add>
bool forEachPiece(const Diagram& diagram, const RunControl& control, const Add& add)
{
  for (Offset p = 0; p < diagram.numberOfPieces(); ++p)
  {
    if (p % piecesBetweenQuestions == 0 && control.cancelled())
    {
      return false;
    }
    add(p, diagram.facets[p], diagram.integralOf(p));
  }
  return true;
}
}

Status sumSitesPlainly(const EmbeddedSurface& surface, const Sites& sites, const Diagram& diagram,
  const RunControl& control, PlainSums& sums)
{
  const auto n = static_cast<std::size_t>(sites.count());
  const int d = surface.dimension;
  sums.mass.assign(n, 0.0);
  sums.energy.assign(n, 0.0);
  sums.moment.assign(n * static_cast<std::size_t>(d), 0.0);
  CornerReader<Eigen::Dynamic> reader(surface);
  const bool done = forEachPiece(diagram, control,
    [&](Offset piece, Index facet, const PieceIntegral& integral)
    {
      const Index site = diagram.sites[piece];
      const double area = surface.embeddedArea(facet);
      sums.mass[site] += integral.fraction() * area;
      sums.energy[site] += integral.energy / surface.density(facet);
      const auto corners = reader.facet(facet);
      const double* x = sites.site(site);
      double* moment = sums.moment.data() + static_cast<std::size_t>(site) * d;
      for (int c = 0; c < 3; ++c)
      {
        const double weight = integral.weights[c] * area;
        for (int k = 0; k < d; ++k)
        {
          moment[k] += weight * (corners[c][k] - x[k]);
        }
      }
    });
  return done ? Status::success() : Status::cancelled();
}

Status sumGroupsPlainly(const EmbeddedSurface& surface, const Diagram& diagram,
  const std::vector<Index>& groups, Index count, const RunControl& control, PlainSums& sums)
{
  sums.mass.assign(static_cast<std::size_t>(count), 0.0);
  sums.energy = sums.mass;
  const bool done = forEachPiece(diagram, control,
    [&](Offset piece, Index facet, const PieceIntegral& integral)
    {
      sums.mass[groups[piece]] += integral.fraction() * surface.embeddedArea(facet);
      sums.energy[groups[piece]] += integral.energy / surface.density(facet);
    });
  return done ? Status::success() : Status::cancelled();
}
}
