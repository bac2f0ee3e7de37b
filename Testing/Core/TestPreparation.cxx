// From triangles and arrays to the surface in R^d: arrays count however they are held, and are lent
// where that can be.

#include "TestRequests.h"

#include <algorithm>
#include <cfloat>

using namespace remesh;

namespace
{
PreparedSurface preparedOf(const PreparationRequest& request)
{
  PreparedSurface prepared;
  CHECK(prepareSurface(request, RunControl(), prepared).ok());
  return prepared;
}

std::string messageOf(const PreparationRequest& request)
{
  PreparedSurface prepared;
  return prepareSurface(request, RunControl(), prepared).message;
}

/** The corners' coordinates, row by row. */
std::vector<double> rowsOf(const CornerCoordinates& coordinates)
{
  std::vector<double> rows(static_cast<std::size_t>(coordinates.count() * coordinates.dimension));
  for (Index corner = 0; corner < coordinates.count(); ++corner)
  {
    coordinates.read(corner, rows.data() + Offset(corner) * coordinates.dimension);
  }
  return rows;
}

/** Doubles, floats and whatever else holds the same numbers. */
void testArrays()
{
  const TriangleSoup soup = test::torus(1.0, 0.5, 32, 16);
  std::vector<float> floats;
  for (const double value : test::positionsOf(soup))
  {
    floats.push_back(static_cast<float>(value));
  }
  const std::vector<double> doubles(floats.begin(), floats.end());
  PreparationRequest request;
  request.source = test::sourceOf(soup);
  request.embedding = test::arrayOf(doubles, 3);
  const std::vector<double> expected = rowsOf(preparedOf(request).coordinates);
  request.embedding->doubles = nullptr;
  request.embedding->floats = floats.data();
  CHECK(rowsOf(preparedOf(request).coordinates) == expected);
  request.embedding->floats = nullptr;
  request.embedding->reader = [&](Offset row, double* values)
  { std::copy_n(doubles.data() + 3 * row, 3, values); };
  CHECK(rowsOf(preparedOf(request).coordinates) == expected);
}

/** Many dimensions are not copied, unless the array cannot be read in place. */
void testLent()
{
  const TriangleSoup soup = test::torus(1.0, 0.5, 32, 16);
  constexpr int dimension = 100;
  std::vector<double> values;
  for (const Point3& point : soup.points)
  {
    for (int k = 0; k < dimension; ++k)
    {
      values.push_back(point[k % 3] * (1 + k % 7));
    }
  }
  PreparationRequest request;
  request.source = test::sourceOf(soup);
  request.coordinates.emplace_back(test::arrayOf(values, dimension), 0.5);
  const PreparedSurface copied = preparedOf(request);
  CHECK(!copied.coordinates.isLent());
  request.mayLend = true;
  const PreparedSurface lent = preparedOf(request);
  CHECK(lent.coordinates.isLent());
  CHECK_EQUAL(lent.coordinates.lent[0].doubles, static_cast<const double*>(values.data()));
  CHECK(rowsOf(lent.coordinates) == rowsOf(copied.coordinates));
}

/** Labels of the caller's cells part the surface into patches. */
void testLabels()
{
  const TriangleSoup soup = test::gridPatch(8, 8);
  PreparationRequest request;
  request.source = test::sourceOf(soup);
  request.preserveFeatures = true;
  CHECK_EQUAL(preparedOf(request).features->numberOfPatches, 1);
  request.cellLabels.assign(soup.triangles.size(), 3);
  std::fill_n(request.cellLabels.begin(), 32, 1);
  CHECK_EQUAL(preparedOf(request).features->numberOfPatches, 2);
}

/** Values of an array that jump are a seam, or are told. */
void testJumps()
{
  TriangleSoup soup = test::gridPatch(8, 8);
  test::append(soup, test::gridPatch(8, 8), Point3(1.0, 0.0, 0.0)); // with points of its own
  std::vector<double> values(soup.points.size(), 0.0);
  std::fill(values.begin() + 81, values.end(), 1.0);
  PreparationRequest request;
  request.source = test::sourceOf(soup);
  request.preserveFeatures = true;
  request.carried.push_back(test::arrayOf(values, 1));
  CHECK_EQUAL(preparedOf(request).warnings.size(), 1u);
  request.seams = request.carried[0];
  const PreparedSurface prepared = preparedOf(request);
  CHECK(prepared.warnings.empty());
  CHECK_EQUAL(prepared.features->numberOfPatches, 2);
}

/** Large coordinates in single precision are told, as doubles, too; whole numbers are as meant. */
void testRounding()
{
  const auto isTold = [](const TriangleSoup& soup, double precision)
  {
    PreparationRequest request;
    request.source = test::sourceOf(soup);
    request.source.precision = precision;
    const auto warnings = preparedOf(request).warnings;
    return std::any_of(warnings.begin(), warnings.end(),
      [](const std::string& text) { return text.find("oordinates are rounded") < 6; });
  };
  TriangleSoup soup = test::torus(300.0, 100.0, 60, 20); // some 20 apart
  for (Point3& point : soup.points)
  {
    point += Point3(5e6, 4e6, 0.0);
  }
  CHECK(!isTold(soup, DBL_EPSILON));
  CHECK(isTold(soup, FLT_EPSILON));
  TriangleSoup singles = soup;
  TriangleSoup whole = soup;
  TriangleSoup lattice = soup; // of points half a unit apart, as terrain has it
  for (std::size_t p = 0; p < soup.points.size(); ++p)
  {
    singles.points[p] = soup.points[p].cast<float>().cast<double>();
    whole.points[p] = soup.points[p].array().round();
    lattice.points[p] = (soup.points[p] * 2.0).array().round() / 2.0;
    lattice.points[p][2] = soup.points[p][2];
  }
  CHECK(isTold(singles, DBL_EPSILON));
  CHECK(!isTold(whole, DBL_EPSILON));
  CHECK(!isTold(lattice, DBL_EPSILON));
}

void testErrors()
{
  const TriangleSoup soup = test::gridPatch(2, 2);
  const std::vector<double> few(12, 1.0);
  PreparationRequest request;
  request.source = test::sourceOf(soup);
  request.normals = test::arrayOf(few, 3);
  CHECK_EQUAL(preparedOf(request).warnings.size(), 1u); // estimated instead
  request.normalsRequired = true;
  CHECK_EQUAL(
    messageOf(request), std::string("The point array \"Values\" has 4 tuples for 9 points."));
  request.normals.reset();
  request.embedding = test::arrayOf(few, 1);
  CHECK(messageOf(request).find("has 1 component;") != std::string::npos);
}
}

int TestPreparation(int, char*[])
{
  testArrays();
  testLent();
  testLabels();
  testJumps();
  testRounding();
  testErrors();
  return test::result();
}
