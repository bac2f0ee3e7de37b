// Edges along creases and borders are as long as those of the mesh beside them; shorter only where
// bends take it, and not for bends where the embedding is given.

#include "TestMeasures.h"

#include "vtkAnisotropicRemesher.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

using namespace remesh;
using namespace remesh::test;

namespace
{
using Place = std::function<Point3(double, double)>;
using Line = std::vector<Point3>;

/** A surface, and the curves that it has. */
struct Part
{
  const char* name;
  TriangleSoup soup;
  std::vector<Line> curves;
};

void addGrid(int columns, int rows, const Place& place, TriangleSoup& soup)
{
  const TriangleSoup grid = gridPatch(columns, rows);
  const auto first = static_cast<Offset>(soup.points.size());
  for (const Point3& p : grid.points)
  {
    soup.points.push_back(place(p[0], p[1]));
  }
  for (auto triangle : grid.triangles)
  {
    for (Offset& point : triangle)
    {
      point += first;
    }
    soup.triangles.push_back(triangle);
  }
}

Line lineOf(int segments, const std::function<Point3(double)>& place)
{
  Line line;
  for (int k = 0; k <= segments; ++k)
  {
    line.push_back(place(static_cast<double>(k) / segments));
  }
  return line;
}

/** A profile of corners (radius, height) turned about an axis; closed, or from axis to axis. */
Part revolved(const char* name, const std::vector<std::array<double, 2>>& profile)
{
  constexpr int around = 144;
  Part part{ name, {}, {} };
  const auto turned = [](double r, double z, double turns)
  {
    const double angle = 2.0 * pi * (turns == 1.0 ? 0.0 : turns);
    return Point3(r * std::cos(angle), r * std::sin(angle), z);
  };
  for (std::size_t k = 0; k + 1 < profile.size(); ++k)
  {
    const auto [r, z] = profile[k];
    const auto [nextR, nextZ] = profile[k + 1];
    const int rows = std::max(static_cast<int>(20.0 * std::hypot(nextR - r, nextZ - z)), 3);
    const double dr = nextR - r;
    const double dz = nextZ - z;
    addGrid(
      around, rows,
      [&, r = r, z = z](double u, double v) { return turned(r + v * dr, z + v * dz, u); },
      part.soup);
    if (r > 0.0)
    {
      part.curves.push_back(
        lineOf(around, [&, r = r, z = z](double u) { return turned(r, z, u); }));
    }
  }
  return part;
}

/** A section of three corners, swept along; flat at both ends. */
Part swept(const char* name, const std::function<Point3(double, int)>& corner)
{
  constexpr int steps = 90;
  constexpr int across = 24;
  Part part{ name, {}, {} };
  const auto between = [](const Point3& a, const Point3& b, double t) {
    return t == 0.0 ? a : t == 1.0 ? b : Point3(a + t * (b - a));
  };
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    addGrid(
      steps, across, [&](double u, double t) { return between(corner(u, k), corner(u, next), t); },
      part.soup);
    part.curves.push_back(lineOf(steps, [&](double u) { return corner(u, k); }));
    for (const double end : { 0.0, 1.0 })
    {
      const Point3 middle = (corner(end, 0) + corner(end, 1) + corner(end, 2)) / 3.0;
      const auto onCap = [&](double t, double s)
      { return between(between(corner(end, k), corner(end, next), t), middle, s); };
      if (end == 0.0)
      {
        addGrid(
          12, across, [&](double s, double t) { return onCap(t, s); }, part.soup);
      }
      else
      {
        addGrid(across, 12, onCap, part.soup);
      }
      part.curves.push_back(
        lineOf(across, [&](double t) { return between(corner(end, k), corner(end, next), t); }));
    }
  }
  return part;
}

/** Bent, and broad in the middle. */
Point3 hullCorner(double u, int k)
{
  const double angle = 1.4 * (u - 0.5);
  const double half = 0.3 + 0.35 * std::sin(pi * u);
  const double depth = k == 2 ? 0.7 : 0.0;
  const double side = k == 0 ? -half : k == 1 ? half : 0.0;
  return { (2.0 + depth) * std::sin(angle), side, -(2.0 + depth) * std::cos(angle) };
}

Point3 twistedCorner(double u, int k)
{
  const double angle = 1.2 * u + 2.0 * pi * k / 3.0;
  return { 0.6 * std::cos(angle), 0.6 * std::sin(angle), 3.0 * u };
}

double distanceToCurves(const Part& part, const Point3& p)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Line& line : part.curves)
  {
    for (std::size_t k = 0; k + 1 < line.size(); ++k)
    {
      const Point3 along = line[k + 1] - line[k];
      const double t = std::clamp((p - line[k]).dot(along) / along.squaredNorm(), 0.0, 1.0);
      least = std::min(least, (p - line[k] - t * along).squaredNorm());
    }
  }
  return std::sqrt(least);
}

double lengthOfCurves(const Part& part)
{
  double length = 0.0;
  for (const Line& line : part.curves)
  {
    for (std::size_t k = 0; k + 1 < line.size(); ++k)
    {
      length += (line[k + 1] - line[k]).norm();
    }
  }
  return length;
}

double medianOf(std::vector<double> values)
{
  CHECK(!values.empty());
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/** Lengths of the edges along the curves and of all others, and how far the former are from them.
 */
struct EdgeLengths
{
  std::vector<double> onCurves;
  std::vector<double> others;
  double rms = 0.0;
};

EdgeLengths measureEdges(const Part& part, vtkPolyData* mesh)
{
  const double spacing = std::sqrt(areaOf(mesh) / static_cast<double>(mesh->GetNumberOfPoints()));
  std::vector<char> near;
  for (vtkIdType k = 0; k < mesh->GetNumberOfPoints(); ++k)
  {
    near.push_back(distanceToCurves(part, pointOf(mesh, k)) < 0.1 * spacing);
  }
  EdgeLengths lengths;
  double squares = 0.0;
  for (const auto& [edge, valence] : valencesOf(mesh))
  {
    const Point3 a = pointOf(mesh, edge.first);
    const Point3 b = pointOf(mesh, edge.second);
    double square = 0.0; // mean over the edge
    double farthest = 0.0;
    for (int k = 0; k < 8 && near[edge.first] && near[edge.second]; ++k)
    {
      const double distance = distanceToCurves(part, a + (k + 0.5) / 8.0 * (b - a));
      square += distance * distance / 8.0;
      farthest = std::max(farthest, distance);
    }
    const double length = (b - a).norm();
    const bool isOn = near[edge.first] && near[edge.second] && farthest < 0.1 * length;
    (isOn ? lengths.onCurves : lengths.others).push_back(length);
    squares += isOn ? length * square : 0.0;
  }
  lengths.rms = std::sqrt(squares / lengthOfCurves(part));
  return lengths;
}

vtkSmartPointer<vtkAnisotropicRemesher> remesherOf(const TriangleSoup& soup, vtkIdType points)
{
  auto filter = vtkSmartPointer<vtkAnisotropicRemesher>::New();
  filter->SetInputData(polyDataOf(soup));
  filter->SetNumberOfPoints(points);
  filter->SetAnisotropy(0.0);
  return filter;
}

void testBalance(const Part& part, vtkIdType points, int euler, bool isBent = true)
{
  const auto filter = remesherOf(part.soup, points);
  filter->MeasureDistanceOn();
  Messages messages(filter);
  filter->Update();
  vtkPolyData* mesh = filter->GetOutput();
  check(messages.errors().empty() && messages.warnings().empty(), __FILE__, __LINE__, part.name);
  check(
    isClosedManifold(mesh) && eulerCharacteristicOf(mesh) == euler, __FILE__, __LINE__, part.name);
  const EdgeLengths lengths = measureEdges(part, mesh);
  const double ratio = medianOf(lengths.onCurves) / medianOf(lengths.others);
  check(ratio > 0.75 && ratio < 1.15, __FILE__, __LINE__, part.name);
  double kept = 0.0;
  for (const double length : lengths.onCurves)
  {
    kept += length;
  }
  CHECK_NEAR(kept, lengthOfCurves(part), 0.01 * kept);
  const double rms = arrayOf(mesh->GetFieldData(), "RMSDistance")->GetComponent(0, 0);
  // Where most of a part is flat, its mean distance tells little of what is bent.
  check(!isBent || lengths.rms <= 1.02 * rms, __FILE__, __LINE__, part.name);
}

/** A sheet with a small hole: so many of its points are on the hole's border. */
int pointsAround(bool isEmbedded)
{
  constexpr int around = 96;
  constexpr double radius = 0.03;
  const auto place = [&](double u, double v)
  {
    const double angle = 2.0 * pi * (u == 1.0 ? 0.0 : u);
    const double r = radius * std::pow(1.0 / radius, v);
    return Point3(r * std::cos(angle), r * std::sin(angle), 0.0);
  };
  TriangleSoup soup;
  addGrid(around, 40, place, soup);
  const auto filter = remesherOf(soup, 300);
  if (isEmbedded)
  {
    auto* input = vtkPolyData::SafeDownCast(filter->GetInput());
    addPointArray<vtkDoubleArray>(
      input, "Place", 3, [](const Point3& p, int component) { return p[component]; });
    filter->SetEmbeddingArray("Place");
  }
  Messages messages(filter);
  filter->Update();
  CHECK(messages.errors().empty() && messages.warnings().empty());
  vtkPolyData* mesh = filter->GetOutput();
  CHECK_EQUAL(eulerCharacteristicOf(mesh), 0);
  std::set<vtkIdType> points;
  for (const auto& [edge, valence] : valencesOf(mesh))
  {
    if (valence == 1 && pointOf(mesh, edge.first).norm() < 2.0 * radius)
    {
      points.insert({ edge.first, edge.second });
    }
  }
  return static_cast<int>(points.size());
}
}

int TestCreaseSpacing(int, char*[])
{
  for (const vtkIdType points : { 1000, 2500 })
  {
    testBalance(
      revolved("cylinder", { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 2.0 }, { 0.0, 2.0 } }), points, 2);
    testBalance(swept("hull", hullCorner), points, 2);
    testBalance(swept("prism", twistedCorner), points, 2);
  }
  // Thin enough for one rim to be beside the other.
  testBalance(
    revolved("washer", { { 0.5, 0.0 }, { 1.0, 0.0 }, { 1.0, 0.1 }, { 0.5, 0.1 }, { 0.5, 0.0 } }),
    1000, 0, false);
  CHECK_EQUAL(pointsAround(false), 16);
  CHECK(pointsAround(true) <= 4);
  return result();
}
