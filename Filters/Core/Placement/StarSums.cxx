#include "Placement/StarSums.h"

#include "Support/CompiledInLanes.h"
#include "Support/LaneColumns.h"

#include <limits>

namespace remesh
{
namespace
{
struct Summation
{
  [[gnu::always_inline]] static inline int next(int corner) { return corner < 2 ? corner + 1 : 0; }

  template <class L>
  [[gnu::always_inline]] static inline void multiply(
    const double (&a)[3], const L (&b)[3], L& product)
  {
    product = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  /** What is multiplied by b_i b_j, then what is multiplied by b_i; each column of eight samples.
   */
  using Terms = double[2 * lanes][lanes];

  template <class L>
  [[gnu::always_inline]] static inline void findTerms(
    const L (&normal)[3], const L& weight, const L& residual, Terms& terms)
  {
    const L x = weight * normal[0];
    const L y = weight * normal[1];
    const L z = weight * normal[2];
    store(x * normal[0], terms[0]);
    store(x * normal[1], terms[1]);
    store(x * normal[2], terms[2]);
    store(y * normal[1], terms[3]);
    store(y * normal[2], terms[4]);
    store(z * normal[2], terms[5]);
    store(weight, terms[6]);
    store(L{}, terms[7]);
    store(x * residual, terms[8]);
    store(y * residual, terms[9]);
    store(z * residual, terms[10]);
    store(x, terms[11]);
    store(y, terms[12]);
    store(z, terms[13]);
    store(weight * residual * residual, terms[14]);
    store(weight, terms[15]);
  }

  template <class L>
  [[gnu::always_inline]] static inline void addProduct(
    double factor, const L& terms, double (&sums)[lanes])
  {
    L sum;
    load(sums, sum);
    sum += factor * terms;
    store(sum, sums);
  }

  /** One sample, whose terms are in `lane` of their columns. */
  template <class L>
  [[gnu::always_inline]] static inline void add(
    const Terms& terms, double residual, int lane, const double (&b)[3], TriangleSums& sums)
  {
    const double squared = residual * residual;
    sums.farthest = squared > sums.farthest ? squared : sums.farthest;
    const double* rows[2 * lanes];
    for (int k = 0; k < 2 * lanes; ++k)
    {
      rows[k] = terms[k];
    }
    L quadratic;
    L linear;
    readColumn(rows, lane, quadratic);
    readColumn(rows + lanes, lane, linear);
    addProduct(b[0] * b[0], quadratic, sums.pairs[0]);
    addProduct(b[1] * b[1], quadratic, sums.pairs[1]);
    addProduct(b[2] * b[2], quadratic, sums.pairs[2]);
    addProduct(b[0] * b[1], quadratic, sums.pairs[3]);
    addProduct(b[1] * b[2], quadratic, sums.pairs[4]);
    addProduct(b[2] * b[0], quadratic, sums.pairs[5]);
    addProduct(b[0], linear, sums.slopes[0]);
    addProduct(b[1], linear, sums.slopes[1]);
    addProduct(b[2], linear, sums.slopes[2]);
  }

  /** The triangle nearest to each sample, of those it lies right above; the number of all: none. */
  template <class L>
  struct Feet
  {
    L nearest = L(std::numeric_limits<double>::infinity()); ///< squared height
    L first{};
    L second{};
    L residual{};
    L triangle{}; ///< its number: a small whole one
  };

  template <class L>
  [[gnu::always_inline]] static inline void findFeet(
    const StarTask& task, const L (&way)[3], const L (&normal)[3], Feet<L>& feet)
  {
    feet.triangle += static_cast<double>(task.triangles.size());
    double number = 0.0;
    for (const StarTriangle& triangle : task.triangles)
    {
      L u;
      L v;
      L height;
      L facing;
      multiply(triangle.first, way, u);
      multiply(triangle.second, way, v);
      multiply(triangle.normal, way, height);
      multiply(triangle.normal, normal, facing);
      typename L::Bits outside;
      typename L::Bits facesAlong;
      typename L::Bits nearer;
      findNegative(u, outside);
      addNegative(v, outside);
      addNegative(1.0 - u - v, outside);
      findNegative(0.0 - facing, facesAlong);
      const L squared = height * height;
      findNegative(squared - feet.nearest, nearer);
      nearer = nearer & facesAlong & ~outside;
      replaceChosen(squared, nearer, feet.nearest);
      replaceChosen(u, nearer, feet.first);
      replaceChosen(v, nearer, feet.second);
      replaceChosen(height * facing, nearer, feet.residual);
      replaceChosen(L(number), nearer, feet.triangle);
      number += 1.0;
    }
  }

  /** Adds the first `size` samples of a group and lists the others; `begin` is the first's number.
   */
  template <class L>
  [[gnu::always_inline]] static inline void addAll(const StarTask& task, const L (&normal)[3],
    const L& weight, const Feet<L>& feet, Index begin, int size, Index& others)
  {
    Terms terms;
    findTerms(normal, weight, feet.residual, terms);
    double firsts[lanes];
    double seconds[lanes];
    double residuals[lanes];
    double triangles[lanes];
    store(feet.first, firsts);
    store(feet.second, seconds);
    store(feet.residual, residuals);
    store(feet.triangle, triangles);
    for (int lane = 0; lane < size; ++lane)
    {
      const auto number = static_cast<std::size_t>(triangles[lane]);
      if (number == task.triangles.size())
      {
        task.others[others++] = begin + lane;
        continue;
      }
      const StarTriangle& triangle = task.triangles[number];
      double b[3];
      b[triangle.corner] = 1.0 - firsts[lane] - seconds[lane];
      b[next(triangle.corner)] = firsts[lane];
      b[next(next(triangle.corner))] = seconds[lane];
      add<L>(terms, residuals[lane], lane, b, task.sums[triangle.sums]);
    }
  }

  template <class L>
  [[gnu::always_inline]] static inline Index run(const StarTask& task)
  {
    Index others = 0;
    for (Index begin = 0; begin < task.count; begin += lanes)
    {
      const SampleGroup& group = task.groups[begin / lanes];
      L way[3];
      L normal[3];
      L weight;
      for (int k = 0; k < 3; ++k)
      {
        load(group.offset[k], way[k]);
        way[k] = task.unit * way[k] + task.shift[k];
        load(group.normal[k], normal[k]);
      }
      load(group.weight, weight);
      Feet<L> feet;
      findFeet(task, way, normal, feet);
      const Index size = task.count - begin < lanes ? task.count - begin : lanes;
      addAll(task, normal, weight, feet, begin, static_cast<int>(size), others);
    }
    return others;
  }
};
}

StarSummation starSummation(InstructionSet set)
{
  return CompiledInLanes<Summation, const StarTask&>::select(set);
}

void addSample(
  const double normal[3], double weight, const double b[3], double residual, TriangleSums& sums)
{
  using L = Lanes<2>;
  const L around[3] = { L(normal[0]), L(normal[1]), L(normal[2]) };
  Summation::Terms terms;
  Summation::findTerms(around, L(weight), L(residual), terms);
  const double weights[3] = { b[0], b[1], b[2] };
  Summation::add<L>(terms, residual, 0, weights, sums);
}
}
