#include "Voronoi/DiagramBlocks.h"

#include <algorithm>
#include <string>

namespace remesh
{
namespace
{
/** Room for `more` values now and, if there is none, for as many as are to be expected. */
template <class T>
void makeRoom(std::vector<T>& values, std::size_t more, double share)
{
  constexpr double margin = 1.05;
  const std::size_t needed = values.size() + more;
  if (needed > values.capacity())
  {
    const auto expected = static_cast<std::size_t>(margin * static_cast<double>(needed) / share);
    values.reserve(std::max(needed, expected));
  }
}

template <class T>
void append(const std::vector<T>& from, std::vector<T>& to)
{
  to.insert(to.end(), from.begin(), from.end());
}
}

void DiagramBlock::add(Index facet, Index site, const PieceIntegral& integral,
  const Polygon& polygon, const FacetTiling& tiling)
{
  this->sites.push_back(site);
  this->facets.push_back(facet);
  this->weights.push_back(integral);
  this->energies.push_back(integral.energy);
  this->sizes.push_back(static_cast<Index>(polygon.size()));
  for (const PieceVertex& vertex : polygon)
  {
    this->across.push_back(vertex.edge < 0 ? vertex.edge : tiling.site(vertex.edge).id);
  }
}

void DiagramBlock::clear()
{
  this->sites.clear();
  this->facets.clear();
  this->weights.clear();
  this->energies.clear();
  this->sizes.clear();
  this->across.clear();
}

Status checkNumberOfVertices(std::size_t vertices)
{
  return vertices <= static_cast<std::size_t>(maximumIndex)
    ? Status::success()
    : Status::invalid("The pieces of the diagram have more vertices than the " +
        std::to_string(maximumIndex) + " that can be held.");
}

void beginDiagram(Diagram& diagram)
{
  diagram = Diagram{};
  diagram.vertexBegin.push_back(0);
}

Status appendBlocks(std::vector<DiagramBlock>& blocks, double share, Diagram& diagram)
{
  std::size_t pieces = 0;
  std::size_t vertices = 0;
  for (const DiagramBlock& block : blocks)
  {
    pieces += block.sites.size();
    vertices += block.across.size();
  }
  // There are more vertices than pieces.
  if (Status status = checkNumberOfVertices(diagram.across.size() + vertices); !status.ok())
  {
    return status;
  }
  makeRoom(diagram.sites, pieces, share);
  makeRoom(diagram.facets, pieces, share);
  makeRoom(diagram.weights, pieces, share);
  makeRoom(diagram.energies, pieces, share);
  makeRoom(diagram.vertexBegin, pieces, share);
  makeRoom(diagram.across, vertices, share);
  for (DiagramBlock& block : blocks)
  {
    append(block.sites, diagram.sites);
    append(block.facets, diagram.facets);
    append(block.weights, diagram.weights);
    append(block.energies, diagram.energies);
    append(block.across, diagram.across);
    for (const Index size : block.sizes)
    {
      diagram.vertexBegin.push_back(diagram.vertexBegin.back() + size);
    }
    block.clear();
  }
  return Status::success();
}

void finishDiagram(Index numberOfFacets, Diagram& diagram)
{
  diagram.facetBegin.assign(static_cast<std::size_t>(numberOfFacets) + 1, 0);
  for (const Index facet : diagram.facets)
  {
    ++diagram.facetBegin[static_cast<std::size_t>(facet) + 1];
  }
  for (std::size_t f = 1; f < diagram.facetBegin.size(); ++f)
  {
    diagram.facetBegin[f] += diagram.facetBegin[f - 1];
  }
}
}
