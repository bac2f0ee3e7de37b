#include "Repair/Untangling.h"

#include "Mesh/FacetGeometry.h"
#include "Placement/TriangleShape.h"
#include "Support/SortUnique.h"

#include <Eigen/Dense>

#include <algorithm>
#include <vector>

namespace remesh
{
namespace
{
constexpr int maxRounds = 12;    // each with the surface's normals anew
constexpr int sweeps = 6;        // over the vertices, in a round
constexpr double minArea = 0.05; // of the mean
constexpr double damping = 1e-3; // of the gradients' squares
constexpr double maxError = 1.5; // of the error before
constexpr double noError = 1e-6; // as if the triangles were a thousandth of their size away

/** The vertices that may move, and the triangles that change with them. */
class Patch
{
public:
  Patch(const NearbySurface& surface, Index triangle, int rings, RepairedMesh& mesh)
    : m_surface(surface)
    , m_mesh(mesh)
  {
    const Triple& corners = mesh.triangles()[triangle];
    m_vertices.assign(corners.begin(), corners.end());
    for (int ring = 1; ring < rings; ++ring)
    {
      for (const Index vertex : std::vector<Index>(m_vertices))
      {
        const std::vector<Index> around = mesh.neighbours(vertex);
        m_vertices.insert(m_vertices.end(), around.begin(), around.end());
      }
      sortUnique(m_vertices);
    }
    const auto isFixed = [&](Index v)
    { return surface.problem().isFixed(static_cast<std::size_t>(v)); };
    m_vertices.erase(
      std::remove_if(m_vertices.begin(), m_vertices.end(), isFixed), m_vertices.end());
    for (const Index vertex : m_vertices)
    {
      m_stars.push_back(mesh.star(vertex));
      m_triangles.insert(m_triangles.end(), m_stars.back().begin(), m_stars.back().end());
    }
    sortUnique(m_triangles);
    for (const Index vertex : m_vertices)
    {
      const Point3& start = mesh.positions()[vertex];
      m_starts.push_back(start);
      m_offsets.push_back(start - mesh.onSurface(vertex, start));
    }
    for (std::vector<Index>& star : m_stars)
    {
      for (Index& t : star)
      {
        t = static_cast<Index>(
          std::lower_bound(m_triangles.begin(), m_triangles.end(), t) - m_triangles.begin());
      }
    }
  }

  void restore()
  {
    for (std::size_t k = 0; k < m_vertices.size(); ++k)
    {
      m_mesh.positions()[m_vertices[k]] = m_starts[k];
    }
  }

  Offset numberOfVertices() const { return static_cast<Offset>(m_vertices.size()); }

  /** Looks first at the triangle that was inverted last time. */
  bool hasInverted()
  {
    const auto isInverted = [&](Index t) { return m_mesh.isInverted(m_mesh.triangles()[t]); };
    if (m_inverted != noIndex && isInverted(m_inverted))
    {
      return true;
    }
    const auto found = std::find_if(m_triangles.begin(), m_triangles.end(), isInverted);
    m_inverted = found == m_triangles.end() ? noIndex : *found;
    return m_inverted != noIndex;
  }

  /** An integral of squared distances that is as good as none. */
  double negligibleError() const
  {
    const double area = this->area();
    return noError * area * area / static_cast<double>(m_triangles.size());
  }

  /** The integral of the triangles' squared distances to the surface, roughly. */
  double error() const
  {
    double sum = 0.0;
    for (const Index t : m_triangles)
    {
      const Triple& triangle = m_mesh.triangles()[t];
      const Corners corners = cornersOf(triangle, m_mesh.positions());
      const Point3 center = (corners[0] + corners[1] + corners[2]) / 3.0;
      const Point3 foot = m_surface.closestPoint(triangle.data(), triangle.data() + 3, center);
      sum += facetArea(corners[0], corners[1], corners[2]) * (foot - center).squaredNorm();
    }
    return sum;
  }

  /**
   * Brings the vertices back as far off the surface as they were, and looks up its normals where
   * the triangles are now, and the area that each should have.
   */
  void look()
  {
    for (std::size_t k = 0; k < m_vertices.size(); ++k)
    {
      m_mesh.positions()[m_vertices[k]] = this->along(k, m_mesh.positions()[m_vertices[k]]);
    }
    m_normals.clear();
    for (const Index t : m_triangles)
    {
      const Triple& triangle = m_mesh.triangles()[t];
      m_normals.push_back(m_surface.normalNear(triangle, cornersOf(triangle, m_mesh.positions())));
    }
    m_wanted = minArea * this->area() / static_cast<double>(m_triangles.size());
  }

  /** Moves each vertex back as far as nothing around it flips; tells how many stay away. */
  Offset comeBack()
  {
    Offset moved = 0;
    for (std::size_t k = 0; k < m_vertices.size(); ++k)
    {
      Point3& position = m_mesh.positions()[m_vertices[k]];
      const Point3 end = position;
      if (end == m_starts[k])
      {
        continue;
      }
      const auto fits = [&](double way)
      {
        position = this->along(k, m_starts[k] + way * (end - m_starts[k]));
        return std::none_of(m_stars[k].begin(), m_stars[k].end(),
          [&](Index t) { return m_mesh.isInverted(m_mesh.triangles()[m_triangles[t]]); });
      };
      const auto ways = { 0.0, 0.125, 0.25, 0.5, 0.75, 1.0 };
      const bool found = std::any_of(ways.begin(), ways.end(), fits);
      position = found ? position : end;
      moved += position != m_starts[k] ? 1 : 0;
    }
    return moved;
  }

  /** One step of each vertex, in their order. */
  void sweep()
  {
    for (std::size_t k = 0; k < m_vertices.size(); ++k)
    {
      this->moveVertex(k);
    }
  }

private:
  double area() const
  {
    double sum = 0.0;
    for (const Index t : m_triangles)
    {
      const Corners corners = cornersOf(m_mesh.triangles()[t], m_mesh.positions());
      sum += facetArea(corners[0], corners[1], corners[2]);
    }
    return sum;
  }

  /** The place as far off the surface as the vertex was at its start. */
  Point3 along(std::size_t index, const Point3& place) const
  {
    return place == m_starts[index]
      ? place
      : Point3(m_mesh.onSurface(m_vertices[index], place) + m_offsets[index]);
  }

  /** A damped Newton step for the areas around a vertex that are too small. */
  void moveVertex(std::size_t index)
  {
    const Index vertex = m_vertices[index];
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    Point3 slope = Point3::Zero();
    double size = 0.0;
    for (const Index t : m_stars[index])
    {
      const Triple& triangle = m_mesh.triangles()[m_triangles[t]];
      const auto k = std::find(triangle.begin(), triangle.end(), vertex) - triangle.begin();
      const Point3& apex = m_mesh.positions()[vertex];
      const Point3& from = m_mesh.positions()[triangle[(k + 1) % 3]];
      const Point3& to = m_mesh.positions()[triangle[(k + 2) % 3]];
      const Point3 gradient = 0.5 * m_normals[t].cross(to - from);
      size += gradient.squaredNorm();
      const double lack = m_wanted - gradient.dot(apex - from);
      if (lack > 0.0)
      {
        squares += gradient * gradient.transpose();
        slope += lack * gradient;
      }
    }
    if (!slope.isZero(0.0))
    {
      squares.diagonal().array() += damping * size;
      m_mesh.positions()[vertex] += squares.ldlt().solve(slope);
    }
  }

  const NearbySurface& m_surface;
  RepairedMesh& m_mesh;
  std::vector<Index> m_vertices;
  std::vector<Index> m_triangles;
  std::vector<std::vector<Index>> m_stars; ///< of the vertices; into `m_triangles`
  std::vector<Point3> m_normals;           ///< of the surface
  Index m_inverted = noIndex;              ///< of the triangles, one that was so last time
  double m_wanted = 0.0;
  std::vector<Point3> m_starts;  ///< of the vertices
  std::vector<Point3> m_offsets; ///< of those from the surface
};
}

Offset untangle(const NearbySurface& surface, Index triangle, int rings, const RunControl& control,
  RepairedMesh& mesh)
{
  Patch patch(surface, triangle, rings, mesh);
  if (patch.numberOfVertices() == 0)
  {
    return 0;
  }
  const double error = maxError * patch.error() + patch.negligibleError();
  for (int round = 0; round < maxRounds && !control.cancelled(); ++round)
  {
    patch.look();
    for (int k = 0; k < sweeps; ++k)
    {
      patch.sweep();
    }
    if (!patch.hasInverted())
    {
      const Offset moved = patch.comeBack();
      if (patch.error() <= error)
      {
        return moved;
      }
      break;
    }
  }
  patch.restore();
  return 0;
}
}
