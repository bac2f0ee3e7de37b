// Mesh/BorderGaps: slits between triangles that nearly meet, and the width that closes them.

#include "Mesh/BorderGaps.h"
#include "TestSupport.h"

#include <cmath>
#include <tuple>

using namespace remesh;

namespace
{
/** Triangles without common points, each moved a little along a line, by up to `gap`. */
TriangleSoup loosened(const TriangleSoup& soup, double gap)
{
  TriangleSoup loose;
  const double corners = 3.0 * static_cast<double>(soup.triangles.size());
  for (const auto& triangle : soup.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double shift = gap * static_cast<double>(loose.points.size()) / corners;
      loose.points.push_back(soup.points[triangle[k]] + Point3(shift, -shift, 0.5 * shift));
    }
    const auto last = static_cast<Offset>(loose.points.size());
    loose.triangles.push_back({ last - 3, last - 2, last - 1 });
    loose.inputCells.push_back(static_cast<Offset>(loose.inputCells.size()));
  }
  return loose;
}

/** A sphere of radius 1, by circles of latitude: at its poles triangles are thin. */
TriangleSoup globe(int around, int circles)
{
  TriangleSoup soup;
  for (int j = 0; j <= circles; ++j)
  {
    const double latitude = EIGEN_PI * j / circles;
    const bool isPole = j == 0 || j == circles;
    for (int i = 0; i < (isPole ? 1 : around); ++i)
    {
      const double longitude = 2.0 * EIGEN_PI * i / around;
      soup.points.emplace_back(std::sin(latitude) * std::cos(longitude),
        std::sin(latitude) * std::sin(longitude), std::cos(latitude));
    }
  }
  const auto at = [&](int i, int j)
  {
    return j == 0    ? 0
      : j == circles ? 1 + around * (circles - 1)
                     : 1 + around * (j - 1) + i % around;
  };
  const auto add = [&](int a, int b, int c)
  {
    soup.triangles.push_back({ a, b, c });
    soup.inputCells.push_back(static_cast<Offset>(soup.inputCells.size()));
  };
  for (int j = 0; j < circles; ++j)
  {
    for (int i = 0; i < around; ++i)
    {
      if (j > 0)
      {
        add(at(i, j), at(i, j + 1), at(i + 1, j));
      }
      if (j + 1 < circles)
      {
        add(at(i + 1, j), at(i, j + 1), at(i + 1, j + 1));
      }
    }
  }
  return soup;
}

/** Triangles that nearly meet: how far they are apart, from single triangles to one long slit. */
void testBorderGaps()
{
  const auto gapsOf = [](const TriangleSoup& soup)
  {
    SurfaceMesh mesh;
    IntakeReport report;
    CHECK(test::takeIn(soup, mesh, report).ok());
    return report.gaps;
  };
  const TriangleSoup grid = test::gridPatch(8, 8);
  CHECK_EQUAL(gapsOf(grid).points, 0);
  CHECK_EQUAL(gapsOf(test::icosphere(2)).points, 0);
  for (const double gap : { 1e-9, 1e-6, 1e-4, 3e-4 })
  {
    const TriangleSoup loose = loosened(grid, gap);
    const BorderGaps gaps = gapsOf(loose);
    CHECK_EQUAL(gaps.points, 384 - 81);
    CHECK(gaps.width * std::sqrt(2.0) > 0.1 * gap && gaps.width * std::sqrt(2.0) < 20.0 * gap);
    // The width closes them, as it says.
    SurfaceMesh mesh;
    IntakeReport report;
    IntakeOptions options;
    options.mergeDistance = gaps.width * std::sqrt(2.0);
    CHECK(buildSurfaceMesh(loose, options, RunControl(), mesh, report).ok());
    CHECK_EQUAL(mesh.numberOfPoints(), 81);
    CHECK_EQUAL(report.boundaryEdges, 32);
    CHECK_EQUAL(report.gaps.points, 0);
  }
}

/** Gaps that are a tenth of the thinnest triangles' width, and half of it. */
void testGapsOfSlivers()
{
  for (const auto& [around, circles, gap] :
    { std::tuple(60, 30, 1e-3), std::tuple(60, 30, 5e-3), std::tuple(200, 100, 5e-4) })
  {
    const TriangleSoup loose = loosened(globe(around, circles), gap);
    SurfaceMesh mesh;
    IntakeReport report;
    CHECK(test::takeIn(loose, mesh, report).ok());
    CHECK(report.gaps.points > 0);
    IntakeOptions options;
    options.mergeDistance = report.gaps.width * std::sqrt(12.0);
    CHECK(buildSurfaceMesh(loose, options, RunControl(), mesh, report).ok());
    CHECK(report.boundaryEdges < static_cast<Offset>(loose.triangles.size()) / 30);
  }
}
}

int TestBorderGaps(int, char*[])
{
  testBorderGaps();
  testGapsOfSlivers();
  return test::result();
}
