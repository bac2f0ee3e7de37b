/**
 * @file NormalFlow.cxx
 *
 * 1. The heat equation of the surface in linear elements: lumped masses (a third of the facets'
 *    areas) and cotangent weights (U. Pinkall, K. Polthier, "Computing discrete minimal surfaces
 *    and their conjugates", 1993). A cotangent counts between 0 and that of a sliver, so that each
 *    new normal is a mean of old ones with weights that are not negative, and slivers stiffen
 *    nothing.
 * 2. A few implicit steps (M + t L) n' = M n, normals normalised after each: the time is not
 *    bound to the facets' sizes as that of averaging is. Heat spreads over sqrt(4 t) in time t.
 * 3. Each step by conjugate gradients with Jacobi's preconditioner, to two digits: more
 *    is of no use. So the solver works in single precision, on what the step changes alone: that
 *    is bound by memory. The fields themselves are of doubles.
 */
#include "Mesh/NormalFlow.h"

#include "Mesh/FacetGeometry.h"
#include "Support/ConjugateGradients.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace remesh
{
namespace
{
constexpr int numberOfSteps = 3;
constexpr double largestCotangent = 100.0;
/**
 * Of a normal after a step: where all directions are within reach, as on a small part that is
 * closed, what is left of their sum tells the solver's error and no direction.
 */
constexpr double minLength = 0.1;
/** Of the residual; its rest is long waves, which move a normal by less than a hundredth of what
 * the step moves it. */
constexpr double wantedReduction = 1e-2;
constexpr std::size_t facetsBetweenQuestions = 1 << 14;
/** Rows of more entries, as of a fan's tip, are not put in order by insertion. */
constexpr Offset longestInserted = 64;

using FloatVector = Eigen::Vector4f; ///< of R^3; the last number is 0

/** M + t L by rows: the off-diagonal entries are -t times the weights. */
struct FlowMatrix
{
  std::vector<Offset> begins; ///< C + 1, into the entries
  std::vector<Index> columns;
  std::vector<float> weights; ///< t times the cotangents' half sum, >= 0
  std::vector<double> masses; ///< C
  /** C, sums of masses and weights: where all normals are the same, they stay as they are. */
  std::vector<double> diagonal;

  FloatVector row(const std::vector<FloatVector>& x, std::size_t i) const
  {
    FloatVector value = static_cast<float>(this->diagonal[i]) * x[i];
    for (Offset e = this->begins[i]; e < this->begins[i + 1]; ++e)
    {
      value -= this->weights[e] * x[this->columns[e]];
    }
    return value;
  }
  FloatVector precondition(const FloatVector& r, std::size_t i) const
  {
    return this->diagonal[i] > 0.0 ? FloatVector(r / static_cast<float>(this->diagonal[i])) : r;
  }
  /** M x - (M + t L) x. */
  Point3 slope(const VectorField& x, std::size_t i) const
  {
    Point3 value = Point3::Zero();
    for (Offset e = this->begins[i]; e < this->begins[i + 1]; ++e)
    {
      value += static_cast<double>(this->weights[e]) * (x[this->columns[e]] - x[i]);
    }
    return value;
  }
};

/** One direction of a facet's edge, as an entry of the matrix. */
struct Entry
{
  Index column;
  float weight;
};

using Triangle = std::array<Point3, 3>;

/** Half the cotangent at each corner of a facet. */
std::array<double, 3> halfCotangents(const Triangle& triangle, double doubleArea)
{
  std::array<double, 3> halves{ 0.0, 0.0, 0.0 };
  for (int k = 0; k < 3 && doubleArea > 0.0; ++k)
  {
    const Point3 u = triangle[(k + 1) % 3] - triangle[k];
    const Point3 v = triangle[(k + 2) % 3] - triangle[k];
    halves[k] = 0.5 * std::clamp(u.dot(v) / doubleArea, 0.0, largestCotangent);
  }
  return halves;
}

/** Puts a row's entries in the order of their columns; equal ones stay in theirs. */
void orderRow(Entry* row, Offset count)
{
  if (count > longestInserted)
  {
    std::stable_sort(
      row, row + count, [](const Entry& a, const Entry& b) { return a.column < b.column; });
    return;
  }
  for (Offset k = 1; k < count; ++k)
  {
    const Entry entry = row[k];
    Offset place = k;
    for (; place > 0 && row[place - 1].column > entry.column; --place)
    {
      row[place] = row[place - 1];
    }
    row[place] = entry;
  }
}

/** Joins a row's entries of equal columns, in the order of these. Returns how many are left. */
Offset mergeRow(Entry* row, Offset count)
{
  orderRow(row, count);
  Offset merged = 0;
  for (Offset k = 0; k < count; ++k)
  {
    if (merged > 0 && row[merged - 1].column == row[k].column)
    {
      row[merged - 1].weight += row[k].weight;
    }
    else
    {
      row[merged++] = row[k];
    }
  }
  return merged;
}

/** Joins the entries of all rows that have the same column. False when cancelled. */
bool mergeEntries(const std::vector<Offset>& begins, std::vector<Entry>& entries,
  const RunControl& control, FlowMatrix& matrix)
{
  const auto rows = static_cast<Offset>(begins.size()) - 1;
  const Blocks blocks = Blocks::cut(rows, 64, 1 << 15);
  matrix.begins.assign(begins.size(), 0);
  if (!forEachRange(blocks, control,
        [&](Offset begin, Offset end)
        {
          for (Offset row = begin; row < end; ++row)
          {
            matrix.begins[row + 1] =
              mergeRow(entries.data() + begins[row], begins[row + 1] - begins[row]);
          }
        }))
  {
    return false;
  }
  std::partial_sum(matrix.begins.begin(), matrix.begins.end(), matrix.begins.begin());
  matrix.columns.resize(static_cast<std::size_t>(matrix.begins.back()));
  matrix.weights.resize(matrix.columns.size());
  return forEachRange(blocks, control,
    [&](Offset begin, Offset end)
    {
      for (Offset row = begin; row < end; ++row)
      {
        const Entry* from = entries.data() + begins[row];
        matrix.diagonal[row] = matrix.masses[row];
        for (Offset e = matrix.begins[row]; e < matrix.begins[row + 1]; ++e, ++from)
        {
          matrix.columns[e] = from->column;
          matrix.weights[e] = from->weight;
          matrix.diagonal[row] += static_cast<double>(from->weight);
        }
      }
    });
}

/** In units of the radius, so that areas and times are of moderate size. False when cancelled. */
bool buildMatrix(const SurfaceMesh& mesh, double radius, double time, const RunControl& control,
  FlowMatrix& matrix)
{
  const auto count = mesh.cornerPoints.size();
  matrix.masses.assign(count, 0.0);
  matrix.diagonal.assign(count, 0.0);
  std::vector<Offset> begins(count + 1, 0);
  for (const Triple& corners : mesh.facetCorners)
  {
    for (const Index corner : corners)
    {
      begins[corner + 1] += 2;
    }
  }
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  std::vector<Offset> next(begins.begin(), begins.end() - 1);
  std::vector<Entry> entries(static_cast<std::size_t>(begins.back()));
  for (std::size_t f = 0; f < mesh.facetCorners.size(); ++f)
  {
    if (f % facetsBetweenQuestions == 0 && control.cancelled())
    {
      return false;
    }
    const auto& [a, b, c] = mesh.facetPoints[f];
    const Triangle triangle{ mesh.points[a] / radius, mesh.points[b] / radius,
      mesh.points[c] / radius };
    const double doubleArea = doubleAreaVector(triangle[0], triangle[1], triangle[2]).norm();
    const std::array<double, 3> halves = halfCotangents(triangle, doubleArea);
    for (int k = 0; k < 3; ++k)
    {
      const Index i = mesh.facetCorners[f][k];
      const Index j = mesh.facetCorners[f][(k + 1) % 3];
      const auto weight = static_cast<float>(time * halves[(k + 2) % 3]);
      matrix.masses[i] += doubleArea / 6.0;
      entries[next[i]++] = { j, weight };
      entries[next[j]++] = { i, weight };
    }
  }
  return mergeEntries(begins, entries, control, matrix);
}

/** False where nothing flows: without corners, over a radius that says nothing; when cancelled. */
bool prepareFlow(
  const SurfaceMesh& mesh, double radius, const RunControl& control, FlowMatrix& matrix)
{
  return radius > 0.0 && std::isfinite(radius) && !mesh.cornerPoints.empty() &&
    buildMatrix(mesh, radius, 0.25 / numberOfSteps, control.silent(), matrix);
}

/** Lets a field flow; `accept(smoothed, field)` takes over each step. Ends early when cancelled. */
template <class Accept>
void flow(
  const FlowMatrix& matrix, const RunControl& control, VectorField& field, const Accept& accept)
{
  ConjugateGradientsLimits limits;
  limits.reduction = wantedReduction;
  const Blocks blocks = Blocks::cut(static_cast<Offset>(field.size()), 64, 1 << 15);
  std::vector<FloatVector> residual(field.size());
  for (int step = 0; step < numberOfSteps; ++step)
  {
    VectorField smoothed = field;
    // The step starts at the field itself.
    const bool started = forEachRange(blocks, control.silent(),
      [&](Offset begin, Offset end)
      {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
        {
          residual[i] = FloatVector::Zero();
          residual[i].head<3>() = matrix.slope(field, i).cast<float>();
        }
      });
    if (!started || !solveConjugateGradients(matrix, limits, control, residual, smoothed))
    {
      return;
    }
    accept(smoothed, field);
    control.report((step + 1.0) / numberOfSteps);
  }
}

void flowNormals(const FlowMatrix& matrix, const RunControl& control, std::vector<Point3>& normals)
{
  flow(matrix, control, normals,
    [](const VectorField& smoothed, VectorField& field)
    {
      for (std::size_t i = 0; i < field.size(); ++i)
      {
        const double length = smoothed[i].norm();
        if (length > minLength)
        {
          field[i] = smoothed[i] / length;
        }
      }
    });
}

void flowPlaces(const FlowMatrix& matrix, const RunControl& control, std::vector<Point3>& places)
{
  flow(matrix, control, places,
    [](VectorField& smoothed, VectorField& field) { field.swap(smoothed); });
}

std::vector<Point3> placesOfCorners(const SurfaceMesh& mesh)
{
  std::vector<Point3> places;
  places.reserve(mesh.cornerPoints.size());
  for (const Index point : mesh.cornerPoints)
  {
    places.push_back(mesh.points[point]);
  }
  return places;
}
}

void smoothNormalsOver(
  const SurfaceMesh& mesh, double radius, const RunControl& control, std::vector<Point3>& normals)
{
  FlowMatrix matrix;
  if (prepareFlow(mesh, radius, control, matrix))
  {
    flowNormals(matrix, control, normals);
  }
}

std::vector<Point3> smoothNormalsAndPlacesOver(
  const SurfaceMesh& mesh, double radius, const RunControl& control, std::vector<Point3>& normals)
{
  std::vector<Point3> places = placesOfCorners(mesh);
  FlowMatrix matrix;
  if (prepareFlow(mesh, radius, control, matrix))
  {
    flowNormals(matrix, control.step(0, 2), normals);
    flowPlaces(matrix, control.step(1, 2), places);
  }
  return places;
}

double meanSpacing(const SurfaceMesh& mesh, Offset sites)
{
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.facetPoints)
  {
    area += facetArea(mesh.points[a], mesh.points[b], mesh.points[c]);
  }
  return sites > 0 ? std::sqrt(area / static_cast<double>(sites)) : 0.0;
}

double smoothingRadius(const SurfaceMesh& mesh, Offset sites)
{
  return 1.5 * meanSpacing(mesh, sites);
}
}
