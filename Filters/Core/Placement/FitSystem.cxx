/**
 * @file FitSystem.cxx
 *
 * Blocks of vertices are summed in parallel, each into the triangles that it meets, group by group;
 * after each group its sums are added to the system one block after the other, in parallel only
 * what goes to vertices and what goes to edges and triangles. So memory is bounded by a group, and
 * no bit depends on the threads.
 */
#include "Placement/FitSystem.h"

#include "Mesh/EdgeTable.h"
#include "Mesh/FacetGeometry.h"
#include "Placement/TriangleShape.h"
#include "Support/Grouping.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <utility>

namespace remesh
{
namespace
{
constexpr Offset blocksPerGroup = 32; // their sums take up to 1 MB each
/**
 * The springs' stiffness, as shares of a vertex's own weight: in proportion to what the surface
 * says about moves along it, which on smooth surfaces is little, and on scans much noise.
 */
constexpr double stiffnessPerVariation = 0.022;
constexpr double leastStiffness = 3e-6;
constexpr double mostStiffness = 3e-3;
constexpr double dampingShare = 0.3; // of the stiffness

Eigen::Matrix3d matrixOf(const Symmetric3<double>& a)
{
  Eigen::Matrix3d matrix;
  matrix << a[0], a[1], a[2], a[1], a[3], a[4], a[2], a[4], a[5];
  return matrix;
}

template <class Real>
Point3 multiply(const Symmetric3<Real>& a, const Point3& x)
{
  return { a[0] * x[0] + a[1] * x[1] + a[2] * x[2], a[1] * x[0] + a[3] * x[1] + a[4] * x[2],
    a[2] * x[0] + a[4] * x[1] + a[5] * x[2] };
}

Symmetric3<double> symmetric(const double (&row)[lanes])
{
  return Eigen::Map<const Symmetric3<double>>(row);
}

/** What a block's samples add to the vertices' blocks and slopes. */
void addToVertices(const PlacementProblem& problem, const StarBlock& block, FitSystem& system)
{
  for (std::size_t s = 0; s < block.triangles.size(); ++s)
  {
    const Triple& triangle = problem.triangles[block.triangles[s]];
    const TriangleSums& sums = block.sums[s];
    for (int k = 0; k < 3; ++k)
    {
      system.vertexBlocks[triangle[k]] += symmetric(sums.pairs[k]);
      system.weights[triangle[k]] += sums.pairs[k][6];
      system.slopes[triangle[k]] += Eigen::Map<const Point3>(sums.slopes[k]);
    }
  }
}

/** What they add to the edges' blocks and the triangles' normals. */
void addToTriangles(const StarBlock& block, FitSystem& system)
{
  for (std::size_t s = 0; s < block.triangles.size(); ++s)
  {
    const Index t = block.triangles[s];
    const TriangleSums& sums = block.sums[s];
    for (int k = 0; k < 3; ++k)
    {
      system.edgeBlocks[system.triangleEdges[t][k]] += symmetric(sums.pairs[3 + k]).cast<float>();
      system.triangleNormals[t] += Eigen::Map<const Point3>(sums.slopes[k] + 3);
    }
  }
}

/** The sums of the first blocks of a group, each kind in the order of the blocks. */
bool addGroup(
  const PlacementProblem& problem, Offset blocks, const RunControl& control, FitSystem& system)
{
  return forEachBlock(2, control.silent(),
    [&](Offset kind)
    {
      for (Offset block = 0; block < blocks; ++block)
      {
        const StarBlock& sums = system.blockSums[block];
        kind == 0 ? addToVertices(problem, sums, system) : addToTriangles(sums, system);
      }
    });
}

/** What all samples add, group by group. */
bool sumSamples(const PlacementProblem& problem, const VertexStars& stars,
  const std::vector<Point3>& positions, FitSamples& samples, const RunControl& control,
  FitSystem& system)
{
  const std::vector<Point3> normals = normalsOf(problem.triangles, positions);
  ScratchPool<StarFit> pool(
    [&]() { return std::make_unique<StarFit>(problem, stars, positions, normals); });
  const Offset count = samples.blocks().count();
  system.blockSums.resize(static_cast<std::size_t>(std::min(blocksPerGroup, count)));
  for (Offset first = 0; first < count; first += blocksPerGroup)
  {
    const Offset size = std::min(blocksPerGroup, count - first);
    if (!forEachBlock(size, control.silent(),
          [&](Offset block)
          { pool.borrow()->sum(samples, first + block, system.blockSums[block]); }) ||
      !addGroup(problem, size, control, system))
    {
      return false;
    }
  }
  return true;
}

template <class Real>
void addToDiagonal(Real value, Symmetric3<Real>& block)
{
  block[0] += value;
  block[3] += value;
  block[5] += value;
}

/** How much the normals of a vertex's samples vary, 0 to 2/3: the eigenvalues but the largest. */
double variation(const Symmetric3<double>& a)
{
  const double trace = a[0] + a[3] + a[5];
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(matrixOf(a) / trace, Eigen::EigenvaluesOnly);
  return std::max(0.0, 1.0 - solver.eigenvalues()[2]);
}

bool findStiffness(const RunControl& control, FitSystem& system)
{
  system.stiffness.assign(system.weights.size(), 0.0);
  return forEachItem(static_cast<Offset>(system.weights.size()), control.silent(),
    [&](Offset v)
    {
      if (system.weights[v] > 0.0)
      {
        system.stiffness[v] = system.weights[v] *
          std::clamp(stiffnessPerVariation * variation(system.vertexBlocks[v]), leastStiffness,
            mostStiffness);
      }
    });
}

/**
 * The terms that do not come from the surface: springs along the edges, at rest where neighbours
 * lie to each other as in `shapes`, and damping.
 */
bool addStiffness(const std::vector<Point3>& positions, const std::vector<Point3>& shapes,
  const RunControl& control, FitSystem& system)
{
  return forEachItem(static_cast<Offset>(positions.size()), control.silent(),
    [&](Offset item)
    {
      const auto v = static_cast<std::size_t>(item);
      for (Offset k = system.linkBegins[v]; k < system.linkBegins[v + 1]; ++k)
      {
        const auto [other, edge] = system.links[k];
        const double spring = (system.stiffness[v] + system.stiffness[other]) / 6.0;
        addToDiagonal(spring, system.vertexBlocks[v]);
        if (static_cast<std::size_t>(other) > v) // once per edge
        {
          addToDiagonal(static_cast<float>(-spring), system.edgeBlocks[edge]);
        }
        system.slopes[v] -=
          spring * ((positions[v] - shapes[v]) - (positions[other] - shapes[other]));
      }
      addToDiagonal(dampingShare * system.stiffness[v], system.vertexBlocks[v]);
      if (system.frozen[v])
      {
        system.slopes[v].setZero();
      }
    });
}
}

Point3 FitSystem::row(const VectorField& x, std::size_t i) const
{
  if (this->frozen[i])
  {
    return x[i];
  }
  Point3 value = multiply(this->vertexBlocks[i], x[i]);
  for (Offset k = this->linkBegins[i]; k < this->linkBegins[i + 1]; ++k)
  {
    value += multiply(this->edgeBlocks[this->links[k].edge], x[this->links[k].vertex]);
  }
  return value;
}

Point3 FitSystem::precondition(const Point3& r, std::size_t i) const
{
  if (this->frozen[i])
  {
    return Point3::Zero();
  }
  const Eigen::Matrix3d inverse = matrixOf(this->vertexBlocks[i]).inverse();
  Symmetric3<double> upper; // alone: symmetric to the last bit
  upper << inverse(0, 0), inverse(0, 1), inverse(0, 2), inverse(1, 1), inverse(1, 2), inverse(2, 2);
  return multiply(upper, r);
}

FitSystem makeFitSystem(const PlacementProblem& problem)
{
  EdgeTable edges = buildEdgeTable(problem.triangles);
  FitSystem system;
  const auto count = static_cast<std::size_t>(problem.numberOfVertices());
  system.linkBegins.assign(count + 1, 0);
  const auto forEachLink = [&](const auto& visit)
  {
    for (std::size_t t = 0; t < problem.triangles.size(); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        const Index edge = edges.facetEdges[t][k];
        if (edges.edgeFacets[edges.edgeFacetsBegin[edge]] == static_cast<Index>(t))
        {
          visit(problem.triangles[t][k], problem.triangles[t][(k + 1) % 3], edge);
        }
      }
    }
  };
  forEachLink(
    [&](Index a, Index b, Index)
    {
      ++system.linkBegins[static_cast<std::size_t>(a) + 1];
      ++system.linkBegins[static_cast<std::size_t>(b) + 1];
    });
  for (std::size_t v = 0; v < count; ++v)
  {
    system.linkBegins[v + 1] += system.linkBegins[v];
  }
  system.links.resize(static_cast<std::size_t>(system.linkBegins.back()));
  std::vector<Offset> next(system.linkBegins.begin(), system.linkBegins.end() - 1);
  forEachLink(
    [&](Index a, Index b, Index edge)
    {
      system.links[next[a]++] = { b, edge };
      system.links[next[b]++] = { a, edge };
    });
  system.edgeBlocks.resize(static_cast<std::size_t>(edges.numberOfEdges()));
  system.triangleEdges = std::move(edges.facetEdges);
  return system;
}

bool assembleFit(const PlacementProblem& problem, const VertexStars& stars,
  const std::vector<Point3>& positions, const std::vector<Point3>& shapes, FitSamples& samples,
  const RunControl& control, FitSystem& system)
{
  const auto vertices = static_cast<std::size_t>(problem.numberOfVertices());
  system.vertexBlocks.assign(vertices, Symmetric3<double>::Zero());
  system.edgeBlocks.assign(system.edgeBlocks.size(), Symmetric3<float>::Zero());
  system.slopes.assign(vertices, Point3::Zero());
  system.weights.assign(vertices, 0.0);
  system.triangleNormals.assign(problem.triangles.size(), Point3::Zero());
  if (!sumSamples(problem, stars, positions, samples, control, system))
  {
    return false;
  }
  system.frozen.assign(vertices, 0);
  for (std::size_t v = 0; v < vertices; ++v)
  {
    system.frozen[v] = problem.isFixed(v) || !(system.weights[v] > 0.0);
  }
  return findStiffness(control, system) && addStiffness(positions, shapes, control, system);
}
}
