/**
 * @file TestMeasures.h
 * @brief Sums, areas, volumes and topology of what the filters give.
 */
#ifndef TestMeasures_h
#define TestMeasures_h

#include "TestHelpers.h"

#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"

#include <functional>
#include <map>
#include <set>
#include <utility>

namespace remesh::test
{
/** Sum with a running compensation: what is compared is the filter's rounding, not the test's. */
class ExactSum
{
public:
  void add(double value)
  {
    const double sum = m_sum + value;
    m_rest += std::abs(m_sum) >= std::abs(value) ? (m_sum - sum) + value : (value - sum) + m_sum;
    m_sum = sum;
  }
  double value() const { return m_sum + m_rest; }

private:
  double m_sum = 0.0;
  double m_rest = 0.0;
};

inline double sumOf(vtkDataArray* array)
{
  ExactSum sum;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    sum.add(array->GetComponent(i, 0));
  }
  return sum.value();
}

/** Calls `visit(cell, ids)` for each polygon; the cell is counted from 0 among the polygons. */
template <class Visit>
void forEachPolygon(vtkPolyData* data, const Visit& visit)
{
  auto cells = vtk::TakeSmartPointer(data->GetPolys()->NewIterator());
  vtkIdType cell = 0;
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell(), ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    visit(cell, std::vector<vtkIdType>(ids, ids + size));
  }
}

/** Area of a planar, convex polygon. */
inline double polygonArea(vtkPolyData* data, const std::vector<vtkIdType>& ids)
{
  double area = 0.0;
  const Point3 first = pointOf(data, ids[0]);
  for (std::size_t k = 1; k + 1 < ids.size(); ++k)
  {
    const Point3 a = pointOf(data, ids[k]) - first;
    const Point3 b = pointOf(data, ids[k + 1]) - first;
    area += 0.5 * a.cross(b).norm();
  }
  return area;
}

inline double areaOf(vtkPolyData* data)
{
  ExactSum sum;
  forEachPolygon(
    data, [&](vtkIdType, const std::vector<vtkIdType>& ids) { sum.add(polygonArea(data, ids)); });
  return sum.value();
}

/** Number of triangles along each directed edge of a triangle mesh. */
inline std::map<std::pair<vtkIdType, vtkIdType>, int> directedEdgesOf(vtkPolyData* mesh)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges;
  forEachPolygon(mesh,
    [&](vtkIdType, const std::vector<vtkIdType>& ids)
    {
      for (std::size_t k = 0; k < ids.size(); ++k)
      {
        ++edges[{ ids[k], ids[(k + 1) % ids.size()] }];
      }
    });
  return edges;
}

/** How many triangles each edge of a triangle mesh has. */
inline std::map<std::pair<vtkIdType, vtkIdType>, int> valencesOf(vtkPolyData* mesh)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> valences;
  for (const auto& [edge, count] : directedEdgesOf(mesh))
  {
    valences[std::minmax(edge.first, edge.second)] += count;
  }
  return valences;
}

/** Used points - edges + triangles. */
inline vtkIdType eulerCharacteristicOf(vtkPolyData* mesh)
{
  const auto directed = directedEdgesOf(mesh);
  std::set<vtkIdType> points;
  vtkIdType edges = 0;
  for (const auto& [ends, count] : directed)
  {
    points.insert({ ends.first, ends.second });
    edges += ends.first < ends.second || !directed.count({ ends.second, ends.first });
  }
  return static_cast<vtkIdType>(points.size()) - edges + mesh->GetNumberOfPolys();
}

/** Closed, manifold and consistently oriented: each directed edge once, with its opposite. */
inline bool isClosedManifold(vtkPolyData* mesh)
{
  const auto directed = directedEdgesOf(mesh);
  for (const auto& [ends, count] : directed)
  {
    if (count != 1 || !directed.count({ ends.second, ends.first }))
    {
      return false;
    }
  }
  return !directed.empty();
}

/** Positive if a closed mesh faces outward. */
inline double volumeOf(vtkPolyData* mesh)
{
  double volume = 0.0;
  forEachPolygon(mesh,
    [&](vtkIdType, const std::vector<vtkIdType>& ids) {
      volume += pointOf(mesh, ids[0]).dot(pointOf(mesh, ids[1]).cross(pointOf(mesh, ids[2]))) / 6.0;
    });
  return volume;
}

/** Length of the mesh's edges of so many triangles with both ends and the middle on a line. */
inline double lengthAlong(
  vtkPolyData* mesh, int triangles, const std::function<bool(const Point3&)>& onLine, int& edges)
{
  double length = 0.0;
  edges = 0;
  for (const auto& [edge, valence] : valencesOf(mesh))
  {
    const Point3 a = pointOf(mesh, edge.first);
    const Point3 b = pointOf(mesh, edge.second);
    if (valence == triangles && onLine(a) && onLine(b) && onLine(0.5 * (a + b)))
    {
      length += (b - a).norm();
      ++edges;
    }
  }
  return length;
}

/** Length of the lines of each `EdgeType`, of port 4. */
inline std::map<int, double> lengthsOfEdges(vtkPolyData* edges)
{
  const auto types = arrayOf(edges->GetCellData(), "EdgeType");
  std::map<int, double> lengths;
  auto lines = vtk::TakeSmartPointer(edges->GetLines()->NewIterator());
  for (lines->GoToFirstCell(); !lines->IsDoneWithTraversal(); lines->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    lines->GetCurrentCell(size, ids);
    CHECK_EQUAL(size, 2);
    lengths[static_cast<int>(types->GetComponent(lines->GetCurrentCellId(), 0))] +=
      (pointOf(edges, ids[1]) - pointOf(edges, ids[0])).norm();
  }
  return lengths;
}
}

#endif
