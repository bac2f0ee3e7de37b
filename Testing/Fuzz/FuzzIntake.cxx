// Any vtkPolyData goes through the intake: a clean mesh or a refusal in words, never a crash.

#include "FuzzSupport.h"

#include "Adaptors/SurfaceIntake.h"
#include "Mesh/Intake.h"

#include <algorithm>
#include <set>

using namespace remesh;

namespace
{
void checkMesh(const SurfaceMesh& mesh, const TriangleSoup& soup, const IntakeReport& report)
{
  FUZZ_CHECK(mesh.numberOfFacets() > 0);
  FUZZ_CHECK(mesh.numberOfFacets() + report.dropped() ==
    static_cast<Offset>(soup.triangles.size()) + report.addedBySplits);
  FUZZ_CHECK(mesh.facetCorners == mesh.facetPoints);
  FUZZ_CHECK(mesh.cornerPoints.size() == mesh.points.size());
  FUZZ_CHECK(mesh.facetInputCells.size() == mesh.facetPoints.size());
  FUZZ_CHECK(mesh.facetInputPoints.size() == mesh.facetPoints.size());
  FUZZ_CHECK(report.components >= 1);
  std::vector<bool> used(mesh.points.size(), false);
  std::set<std::set<Index>> seen;
  for (std::size_t f = 0; f < mesh.facetPoints.size(); ++f)
  {
    const auto& [a, b, c] = mesh.facetPoints[f];
    FUZZ_CHECK(a != b && b != c && c != a);
    FUZZ_CHECK(seen.insert({ a, b, c }).second);
    for (const Index point : mesh.facetPoints[f])
    {
      FUZZ_CHECK(point >= 0 && point < mesh.numberOfPoints());
      FUZZ_CHECK(mesh.points[point].allFinite());
      used[point] = true;
    }
    for (const Offset point : mesh.facetInputPoints[f])
    {
      FUZZ_CHECK(point >= 0 && point < static_cast<Offset>(soup.points.size()));
    }
  }
  for (const bool isUsed : used)
  {
    FUZZ_CHECK(isUsed);
  }
}

void takeIn(const TriangleSoup& soup, double mergeDistance)
{
  IntakeOptions options;
  options.mergeDistance = mergeDistance;
  SurfaceMesh mesh;
  IntakeReport report;
  const Status status = buildSurfaceMesh(soup, options, RunControl(), mesh, report);
  FUZZ_CHECK(status.ok() == status.message.empty());
  if (status.ok())
  {
    checkMesh(mesh, soup, report);
  }
  else
  {
    FUZZ_CHECK(mesh.points.empty() && mesh.facetPoints.empty());
    FUZZ_CHECK(status.code == StatusCode::InvalidInput || status.code == StatusCode::EmptyInput);
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Bytes bytes(data, size);
  const bool wild = bytes.below(2) == 0;
  const double distances[5] = { 0.0, 1e-9, 0.1, 10.0, -1.0 };
  const double mergeDistance = distances[bytes.below(5)];
  const auto input = fuzz::polyData(bytes, 40, 60, wild);
  TriangleSoup soup;
  const Status status = readTriangleSoup(input, soup);
  FUZZ_CHECK(status.ok() == status.message.empty());
  if (status.ok())
  {
    FUZZ_CHECK(soup.inputCells.size() == soup.triangles.size());
    for (const Offset cell : soup.inputCells)
    {
      FUZZ_CHECK(cell >= 0 && cell < input->GetNumberOfCells());
    }
    takeIn(soup, mergeDistance);
    // And a soup with ids that no reader has checked.
    if (wild && !soup.triangles.empty())
    {
      const int triangle =
        bytes.below(static_cast<int>(std::min<std::size_t>(soup.triangles.size(), 256)));
      soup.triangles[triangle][bytes.below(3)] = bytes.below(256) - 128;
      takeIn(soup, mergeDistance);
    }
  }
  else
  {
    FUZZ_CHECK(soup.points.empty() && soup.triangles.empty());
  }
  return 0;
}
