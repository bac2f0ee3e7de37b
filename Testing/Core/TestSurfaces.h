/**
 * @file TestSurfaces.h
 * @brief Small surfaces with known areas, volumes and topology.
 */
#ifndef remesh_TestSurfaces_h
#define remesh_TestSurfaces_h

#include "Mesh/SurfaceMesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace remesh::test
{
using remesh::pi;

/** Triangle t comes from cell t. */
inline TriangleSoup makeSoup(
  std::vector<Point3> points, std::vector<std::array<Offset, 3>> triangles)
{
  TriangleSoup soup;
  soup.points = std::move(points);
  soup.triangles = std::move(triangles);
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
  {
    soup.inputCells.push_back(static_cast<Offset>(t));
  }
  return soup;
}

/** The corner of the unit cube: 4 points, 4 triangles, outward. */
inline TriangleSoup tetrahedron()
{
  return makeSoup({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } });
}

/** The unit cube: 8 points, 12 triangles, outward. */
inline TriangleSoup cube()
{
  std::vector<Point3> points;
  for (int i = 0; i < 8; ++i)
  {
    points.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
  }
  return makeSoup(points,
    { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 }, { 2, 6, 7 },
      { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } });
}

/** The unit square in z = 0, moved: nx x ny squares of two triangles each, facing +z. */
inline TriangleSoup gridPatch(int nx, int ny, const Point3& origin = Point3::Zero())
{
  std::vector<Point3> points;
  std::vector<std::array<Offset, 3>> triangles;
  for (int j = 0; j <= ny; ++j)
  {
    for (int i = 0; i <= nx; ++i)
    {
      points.push_back(origin + Point3(double(i) / nx, double(j) / ny, 0.0));
      if (i < nx && j < ny)
      {
        const Offset p = Offset(j) * (nx + 1) + i;
        triangles.push_back({ p, p + 1, p + nx + 2 });
        triangles.push_back({ p, p + nx + 2, p + nx + 1 });
      }
    }
  }
  return makeSoup(std::move(points), std::move(triangles));
}

/** A sheet in narrow waves along a direction, with or without ripples in all directions. */
inline TriangleSoup wavyPatch(int n, double angle, double ripples)
{
  TriangleSoup soup = gridPatch(n, n);
  for (Point3& p : soup.points)
  {
    const double along = std::cos(angle) * p[0] + std::sin(angle) * p[1];
    p[2] = 0.01 * std::sin(40.0 * along) + ripples * std::sin(60.0 * p[1]) * std::sin(70.0 * p[0]);
  }
  return soup;
}

/** A quad grid closed in u (and in v if asked): point (i, j) is `place(i, j)`. */
template <class Place>
TriangleSoup wrappedGrid(int nu, int nv, bool closedInV, const Place& place)
{
  std::vector<Point3> points;
  std::vector<std::array<Offset, 3>> triangles;
  const int rows = closedInV ? nv : nv + 1;
  for (int i = 0; i < nu; ++i)
  {
    for (int j = 0; j < rows; ++j)
    {
      points.push_back(place(i, j));
      if (j < nv)
      {
        const auto id = [&](int u, int v) { return Offset(u % nu) * rows + v % rows; };
        triangles.push_back({ id(i, j), id(i + 1, j), id(i + 1, j + 1) });
        triangles.push_back({ id(i, j), id(i + 1, j + 1), id(i, j + 1) });
      }
    }
  }
  return makeSoup(std::move(points), std::move(triangles));
}

/** A flat ring from the circle of this radius to what `outer` tells for each direction. */
template <class Outer>
TriangleSoup flatRing(int segments, double inner, const Outer& outer)
{
  std::vector<Point3> points;
  std::vector<std::array<Offset, 3>> triangles;
  for (int k = 0; k < segments; ++k)
  {
    const double angle = 2.0 * std::acos(-1.0) * k / segments;
    const Point3 direction(std::cos(angle), std::sin(angle), 0.0);
    points.push_back(inner * direction);
    points.push_back(outer(direction) * direction);
    const Offset a = 2 * k;
    const Offset b = 2 * ((k + 1) % segments);
    triangles.push_back({ a, a + 1, b + 1 });
    triangles.push_back({ a, b + 1, b });
  }
  return makeSoup(std::move(points), std::move(triangles));
}

/** The unit square around the origin with a round hole; a multiple of 8 segments. */
inline TriangleSoup ringInSquare(int segments, double radius)
{
  return flatRing(segments, radius,
    [](const Point3& direction) { return 0.5 / direction.cwiseAbs().maxCoeff(); });
}

/** A grid patch without the squares (column, row) of two triangles each. */
inline TriangleSoup patchWithHoles(int n, const std::vector<std::pair<int, int>>& holes)
{
  TriangleSoup soup = gridPatch(n, n);
  std::vector<std::array<Offset, 3>> kept;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
  {
    const std::pair<int, int> square(static_cast<int>(t / 2) % n, static_cast<int>(t / 2) / n);
    if (std::find(holes.begin(), holes.end(), square) == holes.end())
    {
      kept.push_back(soup.triangles[t]);
    }
  }
  soup.triangles = kept;
  soup.inputCells.resize(kept.size());
  return soup;
}

/** A flat patch, in which the edge between two triangles opens to a flap that stands up. */
inline TriangleSoup patchWithFlap()
{
  TriangleSoup soup = gridPatch(4, 4);
  const std::array<Offset, 3> opened = soup.triangles[14];
  const auto tip = static_cast<Offset>(soup.points.size());
  soup.points.push_back(
    0.5 * (soup.points[opened[0]] + soup.points[opened[1]]) + Point3(0, 0, 0.01));
  soup.triangles[14] = { opened[0], tip, opened[2] };
  soup.triangles.push_back({ tip, opened[1], opened[2] });
  soup.triangles.push_back({ opened[0], opened[1], tip });
  soup.inputCells.resize(soup.triangles.size());
  return soup;
}

/** Torus around z: nu x nv points, 2 nu nv triangles, outward, Euler characteristic 0. */
inline TriangleSoup torus(double major, double minor, int nu, int nv)
{
  return wrappedGrid(nu, nv, true,
    [=](int i, int j)
    {
      const double u = 2.0 * pi * i / nu;
      const double v = 2.0 * pi * j / nv;
      const double ring = major + minor * std::cos(v);
      return Point3(ring * std::cos(u), ring * std::sin(u), minor * std::sin(v));
    });
}

/** Moebius strip of radius 1 and half-width 0.3: 2 n points, 2 n triangles, one border loop. */
inline TriangleSoup moebiusStrip(int n)
{
  TriangleSoup soup = wrappedGrid(n, 1, false,
    [=](int i, int j)
    {
      const double u = 2.0 * pi * i / n;
      const double v = 0.6 * j - 0.3;
      const double ring = 1.0 + v * std::cos(0.5 * u);
      return Point3(ring * std::cos(u), ring * std::sin(u), v * std::sin(0.5 * u));
    });
  // The last square meets the first one upside down.
  const Offset last = 2 * Offset(n) - 2;
  soup.triangles[soup.triangles.size() - 2] = { last, 1, 0 };
  soup.triangles[soup.triangles.size() - 1] = { last, 0, last + 1 };
  return soup;
}

/** Three unit squares on the edge x = y = 0: 8 points, 6 triangles, one edge of three facets. */
inline TriangleSoup threeSheets()
{
  std::vector<Point3> points = { { 0, 0, 0 }, { 0, 0, 1 } };
  std::vector<std::array<Offset, 3>> triangles;
  for (int sheet = 0; sheet < 3; ++sheet)
  {
    const double angle = 2.0 * pi * sheet / 3.0;
    const auto p = static_cast<Offset>(points.size());
    points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    points.emplace_back(std::cos(angle), std::sin(angle), 1.0);
    triangles.push_back({ 0, p, p + 1 });
    triangles.push_back({ 0, p + 1, 1 });
  }
  return makeSoup(std::move(points), std::move(triangles));
}

/** Unit sphere from the icosahedron: 20 4^levels triangles, outward. */
inline TriangleSoup icosphere(int levels)
{
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  std::vector<Point3> points = { { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 },
    { 0, -1, g }, { 0, 1, g }, { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 },
    { -g, 0, -1 }, { -g, 0, 1 } };
  std::vector<std::array<Offset, 3>> triangles = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 },
    { 0, 7, 10 }, { 0, 10, 11 }, { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 },
    { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 }, { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 },
    { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 }, { 9, 8, 1 } };
  for (int level = 0; level < levels; ++level)
  {
    std::map<std::pair<Offset, Offset>, Offset> middles;
    const auto middle = [&](Offset a, Offset b)
    {
      const auto [entry, isNew] =
        middles.try_emplace(std::minmax(a, b), static_cast<Offset>(points.size()));
      if (isNew)
      {
        const Point3 sum = points[a] + points[b];
        points.push_back(sum);
      }
      return entry->second;
    };
    std::vector<std::array<Offset, 3>> finer;
    for (const auto& [a, b, c] : triangles)
    {
      const Offset ab = middle(a, b);
      const Offset bc = middle(b, c);
      const Offset ca = middle(c, a);
      finer.insert(finer.end(), { { a, ab, ca }, { ab, b, bc }, { ca, bc, c }, { ab, bc, ca } });
    }
    triangles.swap(finer);
    for (Point3& point : points)
    {
      point.normalize();
    }
  }
  for (Point3& point : points)
  {
    point.normalize();
  }
  return makeSoup(std::move(points), std::move(triangles));
}

/** A closed sheet, thin and wavy, whose rim is sharp in places. Thickness against a radius of 1. */
inline TriangleSoup leaf(int levels, double thickness)
{
  TriangleSoup soup = icosphere(levels);
  for (Point3& p : soup.points)
  {
    const double x = p.x();
    const double y = 0.6 * p.y();
    p = Point3(x, y, thickness * p.z() + 0.15 * std::sin(6.0 * x) * std::cos(5.0 * y));
  }
  return soup;
}

/** The faces of unit voxels at (0, 0, 0) to (n - 1)^3, those inside; each with its own points. */
template <class Inside>
TriangleSoup voxelSurface(int n, const Inside& inside)
{
  std::vector<Point3> points;
  std::vector<std::array<Offset, 3>> triangles;
  const auto isInside = [&](const std::array<int, 3>& at)
  {
    return std::all_of(at.begin(), at.end(), [n](int k) { return k >= 0 && k < n; }) &&
      inside(at[0], at[1], at[2]);
  };
  for (int voxel = 0; voxel < n * n * n; ++voxel)
  {
    const std::array<int, 3> at{ voxel % n, voxel / n % n, voxel / n / n };
    for (int face = 0; face < 6 && isInside(at); ++face)
    {
      const int axis = face / 2;
      std::array<int, 3> beyond = at;
      beyond[axis] += face % 2 == 1 ? 1 : -1;
      if (isInside(beyond))
      {
        continue;
      }
      const auto first = static_cast<Offset>(points.size());
      for (int corner = 0; corner < 4; ++corner)
      {
        Point3 point(at[0], at[1], at[2]);
        point[axis] += face % 2;
        point[(axis + 1 + face % 2) % 3] += corner / 2;                 // around the face, as it is
        point[(axis + 2 - face % 2) % 3] += corner == 1 || corner == 2; // seen from outside
        points.push_back(point);
      }
      triangles.push_back({ first, first + 1, first + 2 });
      triangles.push_back({ first, first + 2, first + 3 });
    }
  }
  return makeSoup(std::move(points), std::move(triangles));
}

/** Turns a triangle round. */
inline void flip(TriangleSoup& soup, std::size_t triangle)
{
  std::swap(soup.triangles[triangle][1], soup.triangles[triangle][2]);
}

inline TriangleSoup scaled(TriangleSoup soup, double factor)
{
  for (Point3& point : soup.points)
  {
    point *= factor;
  }
  return soup;
}

/** Appends a copy of another soup, moved, with cell ids that go on. */
inline void append(TriangleSoup& soup, const TriangleSoup& other, const Point3& shift)
{
  const auto first = static_cast<Offset>(soup.points.size());
  for (const Point3& point : other.points)
  {
    soup.points.push_back(point + shift);
  }
  for (const auto& [a, b, c] : other.triangles)
  {
    soup.inputCells.push_back(static_cast<Offset>(soup.triangles.size()));
    soup.triangles.push_back({ first + a, first + b, first + c });
  }
}
}

#endif
