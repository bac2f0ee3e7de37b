#include "Spectrum/SurfaceLaplacian.h"

#include "Mesh/EdgeTable.h"
#include "Mesh/FacetGeometry.h"
#include "Support/DisjointSets.h"

#include <vector>

namespace remesh
{
namespace
{
using Entries = std::vector<Eigen::Triplet<double, Index>>;

/** V, whether a point is on an edge of one facet. */
std::vector<char> findBorderPoints(const SurfaceMesh& mesh, const RunControl& control)
{
  std::vector<char> isBorder(mesh.points.size(), 0);
  const EdgeTable edges = buildEdgeTable(mesh.facetPoints, control);
  for (std::size_t facet = 0; facet < edges.facetEdges.size(); ++facet)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (edges.valence(edges.facetEdges[facet][k]) == 1)
      {
        isBorder[mesh.facetPoints[facet][k]] = 1;
        isBorder[mesh.facetPoints[facet][(k + 1) % 3]] = 1;
      }
    }
  }
  return isBorder;
}

/** Components joined by edges; those that have a fixed point have no constants. */
void findConstants(const SurfaceMesh& mesh, SurfaceLaplacian& laplacian)
{
  DisjointSets sets(mesh.points.size());
  for (const Triple& points : mesh.facetPoints)
  {
    sets.unite(points[0], points[1]);
    sets.unite(points[1], points[2]);
  }
  constexpr Index fixed = -2;
  std::vector<Index> numbers(mesh.points.size(), noIndex);
  for (Index point = 0; point < mesh.numberOfPoints(); ++point)
  {
    if (laplacian.unknowns[point] == noIndex)
    {
      numbers[sets.find(point)] = fixed;
    }
  }
  laplacian.constants.assign(static_cast<std::size_t>(laplacian.size), noIndex);
  for (Index point = 0; point < mesh.numberOfPoints(); ++point)
  {
    Index& number = numbers[sets.find(point)];
    if (number == noIndex)
    {
      number = laplacian.numberOfConstants++;
    }
    if (number != fixed)
    {
      laplacian.constants[laplacian.unknowns[point]] = number;
    }
  }
}

void addFacet(const SurfaceMesh& mesh, Index facet, MassMatrix mass, SurfaceLaplacian& laplacian,
  Entries& stiffness, Entries& masses)
{
  const Triple& points = mesh.facetPoints[facet];
  const double area = facetArea(mesh, facet);
  laplacian.area += area;
  for (int k = 0; k < 3; ++k)
  {
    const Index i = laplacian.unknowns[points[k]];
    const Index j = laplacian.unknowns[points[(k + 1) % 3]];
    const Point3& apex = mesh.points[points[(k + 2) % 3]];
    const Point3 first = mesh.points[points[k]] - apex;
    const Point3 second = mesh.points[points[(k + 1) % 3]] - apex;
    const double weight = 0.25 * first.dot(second) / area; // half the cotangent
    const bool isLumped = mass == MassMatrix::Lumped;
    for (const Index own : { i, j })
    {
      if (own != noIndex)
      {
        stiffness.emplace_back(own, own, weight);
        masses.emplace_back(own, own, area / (isLumped ? 6.0 : 12.0)); // each corner twice
      }
    }
    if (i != noIndex && j != noIndex)
    {
      for (const auto& [row, column] : { std::pair(i, j), std::pair(j, i) })
      {
        stiffness.emplace_back(row, column, -weight);
        masses.emplace_back(row, column, isLumped ? 0.0 : area / 12.0);
      }
    }
  }
}
}

Status buildLaplacian(const SurfaceMesh& mesh, MassMatrix mass, BorderCondition border,
  const RunControl& control, SurfaceLaplacian& laplacian)
{
  laplacian = SurfaceLaplacian{};
  laplacian.unknowns.assign(mesh.points.size(), noIndex);
  const std::vector<char> isBorder = border == BorderCondition::Fixed
    ? findBorderPoints(mesh, control.silent())
    : std::vector<char>(mesh.points.size(), 0);
  if (control.cancelled())
  {
    return Status::cancelled();
  }
  for (Index point = 0; point < mesh.numberOfPoints(); ++point)
  {
    laplacian.unknowns[point] = isBorder[point] ? noIndex : laplacian.size++;
  }
  if (laplacian.size == 0)
  {
    return Status::invalid("All points are on borders, where the functions are fixed: there is no "
                           "function. Take natural borders.");
  }
  findConstants(mesh, laplacian);
  Entries stiffness;
  Entries masses;
  stiffness.reserve(12 * mesh.facetPoints.size());
  masses.reserve(12 * mesh.facetPoints.size());
  for (Index facet = 0; facet < mesh.numberOfFacets(); ++facet)
  {
    addFacet(mesh, facet, mass, laplacian, stiffness, masses);
  }
  laplacian.stiffness.resize(laplacian.size, laplacian.size);
  laplacian.stiffness.setFromTriplets(stiffness.begin(), stiffness.end());
  laplacian.mass.resize(laplacian.size, laplacian.size);
  laplacian.mass.setFromTriplets(masses.begin(), masses.end());
  return control.cancelled() ? Status::cancelled() : Status::success();
}
}
