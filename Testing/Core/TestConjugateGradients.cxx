// Support/ConjugateGradients: the steps, on systems whose solutions and numbers of steps are known.

#include "Support/ConjugateGradients.h"
#include "TestChecks.h"

#include <algorithm>

using namespace remesh;

namespace
{
/** A matrix of a diagonal and one number on both sides of it, and the steps to its solution. */
struct System
{
  std::vector<double> diagonal; ///< n
  double beside = 0.0;          ///< left and right of the diagonal
  bool isPreconditioned = false;
  std::vector<double> x; ///< n, the solution so far
  std::vector<double> rest;
  std::vector<double> direction;
  std::vector<double> image;
  int steps = 0;

  /** A system of this solution; starts at 0. */
  System(std::vector<double> diagonals, double others, const std::vector<double>& solution)
    : diagonal(std::move(diagonals))
    , beside(others)
    , x(solution.size(), 0.0)
    , rest(solution.size())
    , direction(solution)
    , image(solution.size())
  {
    for (std::size_t i = 0; i < solution.size(); ++i)
    {
      this->rest[i] = this->row(i);
    }
  }

  double row(std::size_t i) const
  {
    const double left = i > 0 ? this->direction[i - 1] : 0.0;
    const double right = i + 1 < this->direction.size() ? this->direction[i + 1] : 0.0;
    return this->diagonal[i] * this->direction[i] + this->beside * (left + right);
  }
  double precondition(std::size_t i) const
  {
    return this->isPreconditioned ? this->rest[i] / this->diagonal[i] : this->rest[i];
  }

  double begin(std::size_t i)
  {
    this->direction[i] = this->precondition(i);
    return this->rest[i] * this->direction[i];
  }
  double apply(std::size_t i)
  {
    this->image[i] = this->row(i);
    return this->image[i] * this->direction[i];
  }
  double move(std::size_t i, double length)
  {
    if (i == 0) // others must not even write it: they run at the same time
    {
      ++this->steps;
    }
    this->x[i] += length * this->direction[i];
    this->rest[i] -= length * this->image[i];
    this->image[i] = this->precondition(i);
    return this->rest[i] * this->image[i];
  }
  void turn(std::size_t i, double factor)
  {
    this->direction[i] = this->image[i] + factor * this->direction[i];
  }
};

std::vector<double> waves(std::size_t size)
{
  std::vector<double> numbers(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    numbers[i] = 1.0 + std::sin(0.7 * static_cast<double>(i));
  }
  return numbers;
}

/** 2 on the diagonal and -1 beside it: the second difference. */
System differences(std::size_t size)
{
  return { std::vector<double>(size, 2.0), -1.0, waves(size) };
}

/** The numbers 1, 4 and 9 by turns on the diagonal, nothing beside it. */
System threeEigenvalues(std::size_t size)
{
  std::vector<double> diagonal(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    diagonal[i] = i % 3 == 0 ? 1.0 : i % 3 == 1 ? 4.0 : 9.0;
  }
  return { diagonal, 0.0, waves(size) };
}

bool descend(
  System& system, const ConjugateGradientsLimits& limits, const RunControl& control = RunControl())
{
  const Blocks blocks = Blocks::cut(static_cast<Offset>(system.x.size()), 64, 512);
  return descendConjugately(blocks, limits, control, system);
}

double errorOf(const System& system)
{
  const std::vector<double> solution = waves(system.x.size());
  double most = 0.0;
  for (std::size_t i = 0; i < solution.size(); ++i)
  {
    most = std::max(most, std::abs(system.x[i] - solution[i]));
  }
  return most;
}

double normOf(const std::vector<double>& vector)
{
  double sum = 0.0;
  for (const double number : vector)
  {
    sum += number * number;
  }
  return std::sqrt(sum);
}

/** As many steps as there are eigenvalues; one if the preconditioner is the inverse. */
void testNumberOfSteps()
{
  System plain = threeEigenvalues(600);
  CHECK(descend(plain, { 400, 1e-12 }));
  CHECK_EQUAL(plain.steps, 3);
  CHECK_NEAR(errorOf(plain), 0.0, 1e-12);
  System preconditioned = threeEigenvalues(600);
  preconditioned.isPreconditioned = true;
  CHECK(descend(preconditioned, { 400, 1e-12 }));
  CHECK_EQUAL(preconditioned.steps, 1);
  CHECK_NEAR(errorOf(preconditioned), 0.0, 1e-14);
  System full = differences(40);
  CHECK(descend(full, { 40, 1e-13 }));
  CHECK_NEAR(errorOf(full), 0.0, 1e-11);
}

/** Ends with the first step that brings the residual down far enough, or after so many. */
void testLimits()
{
  for (const double reduction : { 0.3, 1e-2, 1e-4 })
  {
    System ends = differences(500);
    const double before = normOf(ends.rest);
    CHECK(descend(ends, { 10000, reduction }));
    CHECK(normOf(ends.rest) <= reduction * before);
    System oneLess = differences(500);
    CHECK(descend(oneLess, { ends.steps - 1, reduction }));
    CHECK_EQUAL(oneLess.steps, ends.steps - 1);
    CHECK(normOf(oneLess.rest) > reduction * before);
  }
}

/** No step at the solution, nor along a direction without curvature: it would have no end. */
void testNothingToDo()
{
  System solved = differences(100);
  std::fill(solved.rest.begin(), solved.rest.end(), 0.0);
  CHECK(descend(solved, { 400, 1e-4 }));
  CHECK_EQUAL(solved.steps, 0);
  System none{ std::vector<double>(), 0.0, std::vector<double>() };
  CHECK(descend(none, { 400, 1e-4 }));
  System flat = differences(100);
  std::fill(flat.diagonal.begin(), flat.diagonal.end(), 0.0);
  flat.beside = 0.0;
  CHECK(descend(flat, { 400, 1e-4 }));
  CHECK_EQUAL(flat.steps, 0);
}

/** The same bits in blocks of any order and on any threads. */
void testSchedules()
{
  System first = differences(5000);
  CHECK(descend(first, { 50, 1e-9 }));
  CHECK_EQUAL(first.steps, 50);
  for (const Schedule schedule : { Schedule::ShuffledBlocks, Schedule::EightThreads })
  {
    RunControl control;
    control.schedule = schedule;
    System other = differences(5000);
    CHECK(descend(other, { 50, 1e-9 }, control));
    CHECK(other.x == first.x);
  }
}

void testCancel()
{
  System system = differences(5000);
  CHECK(!descend(system, { 400, 1e-9 }, RunControl(nullptr, []() { return true; })));
}
}

int TestConjugateGradients(int, char*[])
{
  testNumberOfSteps();
  testLimits();
  testNothingToDo();
  testSchedules();
  testCancel();
  return test::result();
}
