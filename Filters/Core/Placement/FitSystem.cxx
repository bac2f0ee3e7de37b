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
#include "Placement/ShapeTerm.h"
#include "Support/Grouping.h"

#include <Eigen/LU>

#include <algorithm>
#include <utility>

namespace remesh
{
namespace
{
constexpr Offset blocksPerGroup = 32;         // their sums take up to 1 MB each
constexpr Offset trianglesPerGroup = 1 << 15; // their terms take 4 MB
/**
 * What the shapes of triangles count against distances, in proportion to how much normals vary
 * within cells: so a surface is fitted alike with any number of points. (measured, armadillo,
 * 10 000 points, s = 0.02: RMS distance in 1e-4 of the diagonal and mean least angle in R^6 are
 * 1.61 and 43.9 with 0.008, 1.64 and 45.2 with 0.012, 1.68 and 46.3 with 0.016. In proportion to
 * each vertex's own variation it is 1.68 and 45.2.)
 */
constexpr double shapeWeight = 0.012;
/**
 * What holds a vertex where it is in a round, as a share of its own weight, likewise: where the
 * surface says little about moves along it, that leads rounds to their end. (measured: without, an
 * ellipsoid of 1000 points is fitted 27 % worse; with 0.05, scans 1 %.)
 */
constexpr double dampingPerVariation = 0.02;
constexpr double minDamping = 1e-6; // the system stays definite (FitSystem.h)

void addToDiagonal(double value, Symmetric3<double>& block)
{
  block[0] += value;
  block[3] += value;
  block[5] += value;
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
    system.errors.farthest = std::max(system.errors.farthest, sums.farthest);
    for (int k = 0; k < 3; ++k)
    {
      system.vertexBlocks[triangle[k]] += symmetric(sums.pairs[k]);
      system.weights[triangle[k]] += sums.pairs[k][6];
      system.slopes[triangle[k]] += Eigen::Map<const Point3>(sums.slopes[k]);
      system.errors.squared[triangle[k]] += sums.slopes[k][6];
      system.errors.weights[triangle[k]] += sums.slopes[k][7];
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
bool sumSamples(const FitTask& task, const std::vector<Point3>& positions, FitSamples& samples,
  const RunControl& control, FitSystem& system)
{
  const PlacementProblem& problem = task.problem;
  ScratchPool<StarFit> pool(
    [&]() { return std::make_unique<StarFit>(problem, task.stars, positions); });
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

/** What holds a vertex along the surface. */
void addTie(const FitTask& task, std::size_t vertex, const Point3& position, FitSystem& system)
{
  const Point3 normal = task.cells.normals[vertex].stableNormalized();
  Symmetric3<double> tie = -symmetricProduct(normal, normal);
  addToDiagonal(1.0, tie);
  tie *= task.hold * system.weights[vertex];
  system.vertexBlocks[vertex] += tie;
  system.slopes[vertex] -= multiply(tie, Point3(position - (*task.anchors)[vertex]));
}

/** Of vertices alone: ties, damping, and what preconditions. */
bool addToCenters(const FitTask& task, const std::vector<Point3>& positions,
  const RunControl& control, FitSystem& system)
{
  const double damping = minDamping + dampingPerVariation * task.cells.variation;
  return forEachItem(static_cast<Offset>(positions.size()), control.silent(),
    [&](Offset item)
    {
      const auto v = static_cast<std::size_t>(item);
      if (task.anchors)
      {
        addTie(task, v, positions[v], system);
      }
      addToDiagonal(damping * system.weights[v], system.vertexBlocks[v]);
      if (system.frozen[v])
      {
        system.slopes[v].setZero();
        system.inverses[v].setZero();
      }
      else
      {
        system.inverses[v] = symmetricOf(matrixOf(system.vertexBlocks[v]).inverse());
      }
    });
}

/** Its shape's, times its weight. */
ShapeTerm shapeOf(
  const FitTask& task, const Triple& triangle, const std::vector<Point3>& positions, double weight)
{
  Symmetric3<double> metric = Symmetric3<double>::Zero();
  double area = 0.0; // about, but never of a sliver
  for (const Index vertex : triangle)
  {
    area += task.problem.components.area[vertex] / 6.0;
    if (!task.problem.isFixed(static_cast<std::size_t>(vertex)))
    {
      metric += task.cells.metrics[vertex];
    }
  }
  ShapeTerm term;
  if (findShapeTerm(cornersOf(triangle, positions), metric, term))
  {
    term.block *= weight * area * area;
    for (Point3& slope : term.slopes)
    {
      slope *= weight * area * area;
    }
  }
  return term;
}

/** The terms of triangles from `first` on, to the vertices and to the edges. */
bool addTerms(const PlacementProblem& problem, const std::vector<ShapeTerm>& terms, Offset first,
  const RunControl& control, FitSystem& system)
{
  return forEachBlock(2, control.silent(),
    [&](Offset kind)
    {
      for (std::size_t t = 0; t < terms.size(); ++t)
      {
        const auto triangle = static_cast<std::size_t>(first) + t;
        for (int k = 0; k < 3; ++k)
        {
          if (kind == 1)
          {
            system.edgeBlocks[system.triangleEdges[triangle][k]] -= terms[t].block.cast<float>();
            continue;
          }
          const Index vertex = problem.triangles[triangle][k];
          system.vertexBlocks[vertex] += 2.0 * terms[t].block;
          system.slopes[vertex] += terms[t].slopes[k];
        }
      }
    });
}

/** The shapes of the triangles, group by group. */
bool addShapes(const FitTask& task, const std::vector<Point3>& positions, double unit,
  const RunControl& control, FitSystem& system)
{
  const double weight = shapeWeight * task.cells.variation / unit / unit;
  const auto count = static_cast<Offset>(task.problem.triangles.size());
  std::vector<ShapeTerm> terms;
  for (Offset first = 0; first < count; first += trianglesPerGroup)
  {
    terms.resize(static_cast<std::size_t>(std::min(trianglesPerGroup, count - first)));
    const auto size = static_cast<Offset>(terms.size());
    if (!forEachItem(size, control.silent(),
          [&](Offset t)
          { terms[t] = shapeOf(task, task.problem.triangles[first + t], positions, weight); }) ||
      !addTerms(task.problem, terms, first, control, system))
    {
      return false;
    }
  }
  return true;
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

namespace
{
/** The edges at each vertex, in the order of the triangles. */
void listLinks(const PlacementProblem& problem, const EdgeTable& edges, FitSystem& system)
{
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
}
}

FitSystem makeFitSystem(const PlacementProblem& problem)
{
  EdgeTable edges = buildEdgeTable(problem.triangles);
  FitSystem system;
  listLinks(problem, edges, system);
  system.edgeBlocks.resize(static_cast<std::size_t>(edges.numberOfEdges()));
  system.triangleEdges = std::move(edges.facetEdges);
  return system;
}

bool assembleFit(const FitTask& task, const std::vector<Point3>& positions, FitSamples& samples,
  const RunControl& control, FitSystem& system)
{
  const PlacementProblem& problem = task.problem;
  const auto vertices = static_cast<std::size_t>(problem.numberOfVertices());
  system.vertexBlocks.assign(vertices, Symmetric3<double>::Zero());
  system.inverses.resize(vertices);
  system.edgeBlocks.assign(system.edgeBlocks.size(), Symmetric3<float>::Zero());
  system.slopes.assign(vertices, Point3::Zero());
  system.weights.assign(vertices, 0.0);
  system.errors.squared.assign(vertices, 0.0);
  system.errors.weights.assign(vertices, 0.0);
  system.errors.farthest = 0.0;
  system.triangleNormals.assign(problem.triangles.size(), Point3::Zero());
  if (!sumSamples(task, positions, samples, control, system))
  {
    return false;
  }
  system.frozen.assign(vertices, 0);
  for (std::size_t v = 0; v < vertices; ++v)
  {
    system.frozen[v] = problem.isFixed(v) || !(system.weights[v] > 0.0);
  }
  return addShapes(task, positions, samples.unit(), control, system) &&
    addToCenters(task, positions, control, system);
}
}
