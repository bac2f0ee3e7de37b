// DistanceTolerance: kept, with few points; told where it cannot be; the same bytes; abort.

#include "Support/Random.h"
#include "TestBytes.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkSurfaceMeshComparison.h"

#include <limits>

using namespace remesh;
using namespace remesh::test;

namespace
{
constexpr double noCreases = 170.0; // degrees, but borders

vtkSmartPointer<vtkAnisotropicRemesher> filterOf(vtkPolyData* input, double tolerance)
{
  auto filter = vtkSmartPointer<vtkAnisotropicRemesher>::New();
  filter->SetInputData(input);
  filter->SetDistanceTolerance(tolerance);
  return filter;
}

/** A field value of port 0. */
double fact(vtkAnisotropicRemesher* filter, const char* name)
{
  const auto array = arrayOf(filter->GetOutput()->GetFieldData(), name);
  return array->GetNumberOfTuples() == 1 ? array->GetComponent(0, 0)
                                         : std::numeric_limits<double>::quiet_NaN();
}

double diagonalOf(vtkPolyData* input)
{
  double bounds[6];
  input->GetBounds(bounds);
  return Point3(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]).norm();
}

/** What the comparison finds: reached distance, its bound, RMS. */
Point3 comparison(vtkPolyData* mesh, vtkPolyData* reference)
{
  vtkNew<vtkSurfaceMeshComparison> filter;
  filter->SetInputData(mesh);
  filter->SetReferenceData(reference);
  filter->Update();
  vtkTable* summary = filter->GetSummaryOutput();
  const auto value = [&](const char* column)
  { return summary->GetValueByName(0, column).ToDouble(); };
  return { value("MaximumDistance"), value("MaximumDistanceBound"), value("RMSDistance") };
}

/** Kept as the comparison measures it, without a warning; returns the number of points. */
vtkIdType checkKept(
  vtkPolyData* input, double tolerance, double featureAngle = 35.0, double anisotropy = 0.04)
{
  const auto filter = filterOf(input, tolerance);
  filter->SetFeatureAngle(featureAngle);
  filter->SetAnisotropy(anisotropy);
  Messages messages(filter);
  filter->Update();
  CHECK(messages.errors().empty());
  check(messages.warnings().empty(), __FILE__, __LINE__,
    messages.warnings().empty() ? "" : messages.warnings()[0]);
  const double limit = tolerance * diagonalOf(input);
  const Point3 found = comparison(filter->GetOutput(), input);
  CHECK(found[0] <= limit);
  CHECK(found[1] <= limit * 1.01); // a bound, good to a hundredth
  CHECK(fact(filter, "MaximumDistance") <= limit);
  CHECK(fact(filter, "MaximumDistance") >= found[0] * (1.0 - 1e-9));
  CHECK(anisotropy == 0.0 ||
    fact(filter, "NormalSmoothingRadius") >= 0.0); // for a number that was not asked for
  CHECK_NEAR(fact(filter, "RMSDistance"), found[2], 0.05 * found[2] + 1e-6 * limit);
  return filter->GetOutput()->GetNumberOfPoints();
}

/**
 * A sphere needs the same spacing everywhere: no points are saved by putting them where they count,
 * and a third less of them, spread evenly, do not keep the tolerance.
 */
void testSphere()
{
  constexpr double tolerance = 2e-3;
  const auto input = polyDataOf(icosphere(4));
  const vtkIdType points = checkKept(input, tolerance);
  const auto fewer = filterOf(input, 0.0);
  fewer->SetNumberOfPoints(points * 2 / 3);
  fewer->Update();
  CHECK(comparison(fewer->GetOutput(), input)[0] > tolerance * diagonalOf(input));
  // Triangles of circumradius r have a sagitta of r^2 / 2, half of it to either side of the sphere
  // at best, and a point has 3 / 2 sqrt(3) r^2 of the area.
  CHECK(points > 0.9 * 4.0 * pi / (6.0 * std::sqrt(3.0) * tolerance * diagonalOf(input)));
}

/** Creases are no matter where they are kept: a few points do. */
void testBox()
{
  TriangleSoup soup = cube();
  CHECK(checkKept(polyDataOf(soup), 1e-4) < 100);
}

/** A round sheet that few points follow that closely. */
void testFine()
{
  TriangleSoup soup = gridPatch(30, 30);
  for (Point3& p : soup.points)
  {
    p[2] = 0.03 * p[0] * p[0];
  }
  CHECK(checkKept(polyDataOf(soup), 1e-4) < 400);
}

/** Few, flat sides that meet in a tip, all without creases: far places wander from cell to cell. */
void testTips()
{
  for (const auto& [sides, tolerance] : { std::pair(20, 1e-3), std::pair(28, 3e-3) })
  {
    TriangleSoup cone;
    cone.points = { { 1.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } };
    for (Index k = 0; k < sides; ++k)
    {
      const double angle = 2.0 * pi * k / sides;
      cone.points.push_back({ 0.0, 0.5 * std::cos(angle), 0.5 * std::sin(angle) });
      const Index next = 2 + (k + 1) % sides;
      cone.triangles.push_back({ 0, 2 + k, next });
      cone.triangles.push_back({ 1, next, 2 + k });
    }
    CHECK(checkKept(polyDataOf(cone), tolerance) < 1000);
  }
}

/**
 * A long rod of needles, isotropic: by halves, the needles are cut into so many parts that the
 * bound stays above the tolerance, and the run is long.
 */
void testRod()
{
  constexpr int sides = 12;
  constexpr double length = 200.0;
  TriangleSoup rod;
  rod.points = { { 0.0, 0.0, 0.0 }, { length, 0.0, 0.0 } };
  for (Index k = 0; k < sides; ++k)
  {
    const double angle = 2.0 * pi * k / sides;
    const Point3 at(0.0, 0.5 * std::cos(angle), 0.5 * std::sin(angle));
    rod.points.insert(rod.points.end(), { at, at + Point3(length, 0.0, 0.0) });
    const Index low = 2 + 2 * k;
    const Index next = 2 + 2 * ((k + 1) % sides);
    rod.triangles.insert(rod.triangles.end(),
      { { 0, low, next }, { 1, next + 1, low + 1 }, { low, low + 1, next },
        { next, low + 1, next + 1 } });
  }
  CHECK(checkKept(polyDataOf(rod), 1e-3, 35.0, 0.0) < 2000);
}

/** A unit square with count x count square studs on it, in a grid; each cell a quadrilateral. */
TriangleSoup studs(int count, double width, double height)
{
  std::vector<double> steps{ 0.0 };
  for (int k = 0; k < count; ++k)
  {
    steps.push_back((k + 0.5) / count - 0.5 * width);
    steps.push_back((k + 0.5) / count + 0.5 * width);
  }
  steps.push_back(1.0);
  TriangleSoup soup;
  const auto addQuadrilateral =
    [&](const Point3& a, const Point3& b, const Point3& c, const Point3& d)
  {
    const auto first = static_cast<Index>(soup.points.size());
    soup.points.insert(soup.points.end(), { a, b, c, d });
    soup.triangles.push_back({ first, first + 1, first + 2 });
    soup.triangles.push_back({ first, first + 2, first + 3 });
  };
  for (std::size_t i = 0; i + 1 < steps.size(); ++i)
  {
    for (std::size_t j = 0; j + 1 < steps.size(); ++j)
    {
      const double top = i % 2 == 1 && j % 2 == 1 ? height : 0.0;
      const Point3 corners[4] = { { steps[i], steps[j], 0.0 }, { steps[i + 1], steps[j], 0.0 },
        { steps[i + 1], steps[j + 1], 0.0 }, { steps[i], steps[j + 1], 0.0 } };
      const Point3 up(0.0, 0.0, top);
      addQuadrilateral(corners[0] + up, corners[1] + up, corners[2] + up, corners[3] + up);
      for (int k = 0; k < 4 && top > 0.0; ++k)
      {
        const Point3& from = corners[k];
        const Point3& to = corners[(k + 1) % 4];
        addQuadrilateral(from, to, to + up, from + up);
      }
    }
  }
  return soup;
}

/** Creases that are too small for the pilot's points, but not for the next run's: a few do, too. */
void testSmallCreases()
{
  const auto input = polyDataOf(studs(16, 0.02, 0.01));
  // 8 corners a stud, which may take three fifths of the points.
  CHECK(checkKept(input, 1e-3) < 1.1 * 16 * 16 * 8 / 0.6);
}

/** Creases that are not kept: at first ever more cells are too large, as they are divided. */
void testManyRounds()
{
  checkKept(polyDataOf(studs(6, 0.1 / 6, 0.06 / 6)), 1.2e-3, noCreases);
}

/**
 * Creases that cost far more when they are refined as round ones than points that keep them, and
 * that are much smaller than the spacing of as few points.
 */
void testShallowCreases()
{
  constexpr int count = 5;
  const vtkIdType points = checkKept(polyDataOf(studs(count, 0.0125, 0.0025)), 3e-4);
  CHECK(points < 1.1 * (count * count * 8 + 4) / 0.6);
}

/** Creases that take more points than allowed are left out, and that is told. */
void testTooManyCreases()
{
  constexpr int most = 150;
  const auto filter = filterOf(polyDataOf(studs(5, 0.0125, 0.0025)), 3e-4);
  filter->SetMaximumNumberOfPoints(most);
  Messages messages(filter);
  filter->Update();
  CHECK(messages.errors().empty());
  CHECK_EQUAL(messages.warnings().size(), std::size_t(1));
  CHECK(!messages.warnings().empty() &&
    messages.warnings()[0].find("more than the 150 points allowed") != std::string::npos);
  CHECK(filter->GetOutput()->GetNumberOfPoints() < 1.1 * most); // of 204 corners
}

/** Creases of noise, which are everywhere, are not kept for the sake of the distance. */
void testNoise()
{
  TriangleSoup soup = icosphere(4);
  std::uint64_t counter = 0;
  for (Point3& point : soup.points)
  {
    point *= 1.0 + 0.06 * uniform01(1, counter++, 0);
  }
  const auto input = polyDataOf(soup);
  CHECK(checkKept(input, 4e-3) < 1.1 * checkKept(input, 4e-3, noCreases));
}

void testAbsolute()
{
  const auto input = polyDataOf(ellipsoid(4));
  const auto relative = filterOf(input, 2e-3);
  relative->Update();
  const auto absolute = filterOf(input, 2e-3 * diagonalOf(input));
  absolute->DistanceToleranceIsAbsoluteOn();
  absolute->SetNumberOfThreads(1);
  absolute->SetSMPBackend(vtkAnisotropicRemesher::SMP_SEQUENTIAL);
  absolute->SetNumberOfPoints(3); // does not count
  absolute->Update();
  checkSame(contentsOf(absolute), contentsOf(relative), "absolute, one thread");
  const auto loose = filterOf(input, 2e-2);
  loose->Update();
  CHECK(loose->GetOutput()->GetNumberOfPoints() < relative->GetOutput()->GetNumberOfPoints());
}

/**
 * A thin disk, which needs further points for its topology: by one percent of what the runs have,
 * whatever number was asked for. Neither is that told to be too low for the creases of a box.
 */
void testNumberDoesNotCount()
{
  TriangleSoup disk = icosphere(4);
  for (Point3& point : disk.points)
  {
    point[2] *= 0.02;
  }
  const auto input = polyDataOf(disk);
  std::vector<Content> expected;
  for (const vtkIdType points : { 4, 1000000 })
  {
    const auto filter = filterOf(input, 1e-2);
    filter->PreserveFeaturesOff();
    filter->SetNumberOfPoints(points);
    filter->Update();
    CHECK(fact(filter, "NumberOfExtraPoints") > 0.0);
    const std::vector<Content> contents = contentsOf(filter);
    expected = expected.empty() ? contents : expected;
    checkSame(contents, expected, std::to_string(points) + " points asked for");
  }
  TriangleSoup soup = cube();
  const auto box = filterOf(polyDataOf(soup), 1e-2);
  box->SetNumberOfPoints(4);
  Messages messages(box);
  box->Update();
  CHECK(messages.errors().empty() && messages.warnings().empty());
}

/** Creases that are cut across: not with so few points, and that is told. */
void testImpossible()
{
  TriangleSoup soup = cube();
  const auto filter = filterOf(polyDataOf(soup), 1e-4);
  filter->PreserveFeaturesOff();
  filter->SetMaximumNumberOfPoints(200);
  Messages messages(filter);
  filter->Update();
  CHECK(messages.errors().empty());
  CHECK_EQUAL(messages.warnings().size(), std::size_t(1));
  for (const std::string& warning : messages.warnings())
  {
    CHECK(warning.find("above the tolerance") != std::string::npos);
    CHECK(warning.find("more than the 200 points allowed") != std::string::npos);
  }
  CHECK(filter->GetOutput()->GetNumberOfPoints() > 100);
  const double reached = fact(filter, "MaximumDistance");
  const Point3 found = comparison(filter->GetOutput(), filter->GetPolyDataInput(0));
  CHECK(reached > 1e-4 * std::sqrt(3.0));
  CHECK(reached >= found[0] * (1.0 - 1e-9));
}

void testErrors()
{
  for (const double tolerance : { 1e-8, 1e-300 })
  {
    const auto filter = filterOf(polyDataOf(icosphere(2)), tolerance);
    Messages messages(filter);
    filter->Update();
    CHECK_EQUAL(messages.errors().size(), std::size_t(1));
    CHECK(!messages.errors().empty() &&
      messages.errors()[0].find("at least 1e-7") != std::string::npos);
    CHECK(outputsAreEmpty(filter));
  }
  // Without a tolerance, what is found at samples.
  const auto plain = filterOf(polyDataOf(icosphere(2)), 0.0);
  plain->SetNumberOfPoints(100);
  plain->Update();
  CHECK(plain->GetOutput()->GetFieldData()->HasArray("MaximumDistance"));
}

/** Progress rises to 1; an abort at any part of the search leaves nothing behind. */
void testProgressAndAbort(const TriangleSoup& soup, double tolerance)
{
  const auto filter = filterOf(polyDataOf(soup), tolerance);
  struct Watch
  {
    vtkAlgorithm* Algorithm;
    double Last = 0.0;
    double AbortAt = 2.0;
  } watch{ filter };
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&watch);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* data, void* value)
    {
      auto* self = static_cast<Watch*>(data);
      const double progress = *static_cast<double*>(value);
      CHECK(progress >= self->Last);
      self->Last = progress;
      if (progress >= self->AbortAt)
      {
        self->Algorithm->SetAbortExecute(1);
      }
    });
  filter->AddObserver(vtkCommand::ProgressEvent, command);
  filter->Update();
  CHECK_EQUAL(watch.Last, 1.0);
  CHECK(filter->GetOutput()->GetNumberOfPoints() > 0);
  for (const double moment : { 0.02, 0.08, 0.3, 0.61, 0.7, 0.95 })
  {
    watch.Last = 0.0;
    watch.AbortAt = moment;
    Messages messages(filter);
    filter->Modified();
    filter->Update();
    filter->SetAbortExecute(0);
    check(outputsAreEmpty(filter), __FILE__, __LINE__, "abort at " + std::to_string(moment));
    CHECK(messages.errors().empty() && messages.warnings().empty());
  }
}
}

int TestTolerance(int, char*[])
{
  testSphere();
  testBox();
  testFine();
  testRod();
  testTips();
  testSmallCreases();
  testManyRounds();
  testShallowCreases();
  testTooManyCreases();
  testNoise();
  testAbsolute();
  testNumberDoesNotCount();
  testImpossible();
  testErrors();
  testProgressAndAbort(ellipsoid(3), 2e-3);
  testProgressAndAbort(studs(4, 0.0125, 0.0025), 3e-4); // with finer creases
  return result();
}
