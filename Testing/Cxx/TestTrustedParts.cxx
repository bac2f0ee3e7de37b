// Meshes of parts with walls, bores and bolt holes: topology kept, nothing flipped, outlines where
// they were.

#include "TestTrials.h"
#include "TestWalls.h"

#include <cmath>

using namespace remesh;
using namespace remesh::test;

namespace
{
/** A gear with a bore: sharp teeth, a round crease on each side, genus 1. */
void testGear()
{
  constexpr int teeth = 12;
  const auto outer = profileOf(6 * teeth, [](int k) { return k % 6 < 3 ? 1.0 : 0.8; });
  const auto bore = profileOf(6 * teeth, [](int) { return 0.3; });
  TriangleSoup soup;
  addWall(outer, 0.3, 3, true, soup);
  addWall(bore, 0.3, 3, false, soup);
  addRing(bore, outer, 0.0, false, soup);
  addRing(bore, outer, 0.3, true, soup);
  const auto surface = polyDataOf(soup);
  const double volume = volumeOf(surface);
  double outline = 0.0;
  for (std::size_t k = 0; k < outer.size(); ++k)
  {
    outline += (outer[(k + 1) % outer.size()] - outer[k]).norm();
  }
  const auto onOutline = [](double z)
  {
    return [z](const Point3& p)
    { return std::abs(p[2] - z) < 1e-9 && std::hypot(p[0], p[1]) > 0.75; };
  };
  for (const double anisotropy : { 0.0, 0.04, 0.2 })
  {
    const Trial trial = checkedMesh(surface, 1000, anisotropy);
    CHECK(isClosedManifold(trial.mesh));
    CHECK_NEAR(volumeOf(trial.mesh), volume, 2e-3 * volume);
    // Other edges lie in the same planes, but the mean distance sees what is cut off.
    int edges = 0;
    CHECK(lengthAlong(trial.mesh, 2, onOutline(0.0), edges) > outline * (1.0 - 1e-9));
    CHECK(lengthAlong(trial.mesh, 2, onOutline(0.3), edges) > outline * (1.0 - 1e-9));
    CHECK(trial.value("RelativeRMSDistance") < 1e-3);
  }
}

/** A ring with bolt holes of this radius, close to its rim; of star-shaped sectors around them. */
vtkSmartPointer<vtkPolyData> flange(int holes, double radius)
{
  constexpr int steps = 12; // on each side of a sector
  constexpr double inner = 0.5;
  constexpr double gap = 0.005;
  constexpr double height = 0.3;
  const int around = holes * steps;
  const auto at = [&](int turn, int out)
  {
    const double angle = 2.0 * pi * (turn % around) / around;
    const double r = inner + (1.0 - inner) * out / steps;
    return Point3(r * std::cos(angle), r * std::sin(angle), 0.0);
  };
  TriangleSoup soup;
  for (int sector = 0; sector < holes; ++sector)
  {
    const int begin = sector * steps;
    const int end = begin + steps;
    std::vector<Point3> outline;
    for (int k = 0; k < steps; ++k)
    {
      outline.push_back(at(begin + k, steps));
    }
    for (int k = 0; k < steps; ++k)
    {
      outline.push_back(at(end, steps - k));
    }
    for (int k = 0; k < steps; ++k)
    {
      outline.push_back(at(end - k, 0));
    }
    for (int k = 0; k < steps; ++k)
    {
      outline.push_back(at(begin, k));
    }
    const double angle = 2.0 * pi * (sector + 0.5) / holes;
    const Point3 center = (1.0 - gap - radius) * Point3(std::cos(angle), std::sin(angle), 0.0);
    std::vector<Point3> hole;
    for (const Point3& p : outline)
    {
      hole.push_back(center + radius * (p - center).normalized());
    }
    addRing(hole, outline, 0.0, false, soup);
    addRing(hole, outline, height, true, soup);
    addWall(hole, height, 1, false, soup);
  }
  std::vector<Point3> rim;
  std::vector<Point3> bore;
  for (int k = 0; k < around; ++k)
  {
    rim.push_back(at(k, steps));
    bore.push_back(at(k, 0));
  }
  addWall(rim, height, 1, true, soup);
  addWall(bore, height, 1, false, soup);
  return polyDataOf(soup);
}

/** Few points: chords of the rim would cross the holes, were it not divided there. */
void testBoltHoles()
{
  for (const double radius : { 0.1, 0.14 })
  {
    const Trial trial = keepingMesh(flange(8, radius), 300, 0.1);
    CHECK(trial.value("RelativeRMSDistance") < 1.4e-3);
    CHECK_EQUAL(
      trial.mesh->GetFieldData()->GetArray("NumberOfFlippedTriangles")->GetComponent(0, 0), 0.0);
  }
}
}

int TestTrustedParts(int, char*[])
{
  testGear();
  testBoltHoles();
  return result();
}
