#include "Placement/StarSums.h"

namespace remesh
{
namespace
{
using FloatLanes = float __attribute__((vector_size(4 * lanes)));

struct Summation
{
  [[gnu::always_inline]] static inline int next(int corner) { return corner < 2 ? corner + 1 : 0; }

  [[gnu::always_inline]] static inline void widen(const float* from, Lanes& to)
  {
    FloatLanes narrow;
    std::memcpy(&narrow, from, sizeof narrow);
    to = __builtin_convertvector(narrow, Lanes);
  }

  [[gnu::always_inline]] static inline void multiply(
    const double (&a)[3], const Lanes (&b)[3], Lanes& product)
  {
    product = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  /** What is multiplied by b_i b_j, then what is multiplied by b_i; each column of eight samples.
   */
  using Terms = double[2 * lanes][lanes];

  [[gnu::always_inline]] static inline void findTerms(
    const Lanes (&normal)[3], const Lanes& weight, const Lanes& residual, Terms& terms)
  {
    const Lanes x = weight * normal[0];
    const Lanes y = weight * normal[1];
    const Lanes z = weight * normal[2];
    store(x * normal[0], terms[0]);
    store(x * normal[1], terms[1]);
    store(x * normal[2], terms[2]);
    store(y * normal[1], terms[3]);
    store(y * normal[2], terms[4]);
    store(z * normal[2], terms[5]);
    store(weight, terms[6]);
    store(Lanes{}, terms[7]);
    store(x * residual, terms[8]);
    store(y * residual, terms[9]);
    store(z * residual, terms[10]);
    store(x, terms[11]);
    store(y, terms[12]);
    store(z, terms[13]);
    store(weight * residual * residual, terms[14]);
    store(weight, terms[15]);
  }

  [[gnu::always_inline]] static inline void addProduct(
    double factor, const Lanes& terms, double (&sums)[lanes])
  {
    Lanes sum;
    load(sums, sum);
    sum += factor * terms;
    store(sum, sums);
  }

  /** One sample, whose terms are in `lane` of their columns. */
  [[gnu::always_inline]] static inline void add(
    const Terms& terms, double residual, int lane, const double (&b)[3], TriangleSums& sums)
  {
    const double squared = residual * residual;
    sums.farthest = squared > sums.farthest ? squared : sums.farthest;
    Lanes quadratic;
    Lanes linear;
    for (int k = 0; k < lanes; ++k)
    {
      quadratic[k] = terms[k][lane];
      linear[k] = terms[lanes + k][lane];
    }
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
  struct Feet
  {
    Lanes nearest = Lanes{} + std::numeric_limits<double>::infinity(); ///< squared height
    Lanes first{};
    Lanes second{};
    Lanes residual{};
    LaneBits triangle{};
  };

  [[gnu::always_inline]] static inline void findFeet(
    const StarTask& task, const Lanes (&way)[3], const Lanes (&normal)[3], Feet& feet)
  {
    feet.triangle += task.triangles.size();
    unsigned long long number = 0;
    for (const StarTriangle& triangle : task.triangles)
    {
      Lanes u;
      Lanes v;
      Lanes height;
      Lanes facing;
      multiply(triangle.first, way, u);
      multiply(triangle.second, way, v);
      multiply(triangle.normal, way, height);
      multiply(triangle.normal, normal, facing);
      LaneBits outside;
      LaneBits negative;
      findNegative(u, outside);
      findNegative(v, negative);
      outside |= negative;
      findNegative(1.0 - u - v, negative);
      outside |= negative;
      findNegative(0.0 - facing, negative);
      outside |= ~negative; // where it does not face along
      const Lanes squared = height * height;
      findNegative(squared - feet.nearest, negative);
      const LaneBits nearer = negative & ~outside;
      replaceChosen(squared, nearer, feet.nearest);
      replaceChosen(u, nearer, feet.first);
      replaceChosen(v, nearer, feet.second);
      replaceChosen(height * facing, nearer, feet.residual);
      feet.triangle = (feet.triangle & ~nearer) | (nearer & number);
      ++number;
    }
  }

  /** Adds the first `size` samples of a group and lists the others; `begin` is the first's number.
   */
  [[gnu::always_inline]] static inline void addAll(const StarTask& task, const Lanes (&normal)[3],
    const Lanes& weight, const Feet& feet, Index begin, int size, Index& others)
  {
    Terms terms;
    findTerms(normal, weight, feet.residual, terms);
    double firsts[lanes];
    double seconds[lanes];
    double residuals[lanes];
    unsigned long long triangles[lanes];
    store(feet.first, firsts);
    store(feet.second, seconds);
    store(feet.residual, residuals);
    std::memcpy(triangles, &feet.triangle, sizeof triangles);
    for (int lane = 0; lane < size; ++lane)
    {
      if (triangles[lane] == task.triangles.size())
      {
        task.others[others++] = begin + lane;
        continue;
      }
      const StarTriangle& triangle = task.triangles[triangles[lane]];
      double b[3];
      b[triangle.corner] = 1.0 - firsts[lane] - seconds[lane];
      b[next(triangle.corner)] = firsts[lane];
      b[next(next(triangle.corner))] = seconds[lane];
      add(terms, residuals[lane], lane, b, task.sums[triangle.sums]);
    }
  }

  [[gnu::always_inline]] static inline Index run(const StarTask& task)
  {
    Index others = 0;
    for (Index begin = 0; begin < task.count; begin += lanes)
    {
      const SampleGroup& group = task.groups[begin / lanes];
      Lanes way[3];
      Lanes normal[3];
      Lanes weight;
      for (int k = 0; k < 3; ++k)
      {
        widen(group.offset[k], way[k]);
        way[k] = task.unit * way[k] + task.shift[k];
        widen(group.normal[k], normal[k]);
      }
      widen(group.weight, weight);
      Feet feet;
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
  return CompiledFor<Summation, const StarTask&>::select(set);
}

void addSample(
  const double normal[3], double weight, const double b[3], double residual, TriangleSums& sums)
{
  const Lanes around[3] = { Lanes{} + normal[0], Lanes{} + normal[1], Lanes{} + normal[2] };
  Summation::Terms terms;
  Summation::findTerms(around, Lanes{} + weight, Lanes{} + residual, terms);
  const double weights[3] = { b[0], b[1], b[2] };
  Summation::add(terms, residual, 0, weights, sums);
}
}
