// CellColor: cells that share a side have different colours, all ports the same ones, few in all.

#include "TestHelpers.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkRestrictedVoronoiDiagram.h"

#include "vtkCellData.h"

#include <map>
#include <set>

using namespace remesh;
using namespace remesh::test;

namespace
{
using Remesher = vtkAnisotropicRemesher;

vtkIdType valueOf(vtkFieldData* data, const char* name, vtkIdType tuple)
{
  return static_cast<vtkIdType>(arrayOf(data, name)->GetTuple1(tuple));
}

/** The colour of each vertex's cell, by its first site; the same on the three ports. */
std::map<vtkIdType, vtkIdType> colorsOf(vtkRestrictedVoronoiAlgorithm* filter)
{
  std::map<vtkIdType, vtkIdType> colors;
  const auto note = [&](vtkFieldData* data, const char* site, vtkIdType tuples)
  {
    for (vtkIdType i = 0; i < tuples; ++i)
    {
      const vtkIdType color = valueOf(data, "CellColor", i);
      CHECK_EQUAL(colors.emplace(valueOf(data, site, i), color).first->second, color);
    }
  };
  vtkPolyData* sites = filter->GetSitesOutput();
  note(sites->GetPointData(), "MergedSiteId", sites->GetNumberOfPoints());
  const std::size_t all = colors.size();
  vtkPolyData* cells = filter->GetVoronoiCellsOutput();
  note(cells->GetCellData(), "MergedSiteId", cells->GetNumberOfCells());
  note(filter->GetOutput()->GetPointData(), "SiteId", filter->GetOutput()->GetNumberOfPoints());
  CHECK_EQUAL(colors.size(), all);
  return colors;
}

/** Pairs of polygons' sites on both sides of each edge, by the edge's points. */
void checkSides(vtkPolyData* cells, const std::string& where)
{
  std::map<std::pair<vtkIdType, vtkIdType>, std::vector<vtkIdType>> polygonsOf;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    const auto ids = cells->GetCell(cell)->GetPointIds();
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      const auto ends = std::minmax({ ids->GetId(k), ids->GetId((k + 1) % ids->GetNumberOfIds()) });
      polygonsOf[ends].push_back(cell);
    }
  }
  vtkIdType borders = 0;
  vtkIdType equal = 0;
  for (const auto& [ends, polygons] : polygonsOf)
  {
    for (const vtkIdType a : polygons)
    {
      for (const vtkIdType b : polygons)
      {
        if (valueOf(cells->GetCellData(), "MergedSiteId", a) <
          valueOf(cells->GetCellData(), "MergedSiteId", b))
        {
          ++borders;
          equal += valueOf(cells->GetCellData(), "CellColor", a) ==
            valueOf(cells->GetCellData(), "CellColor", b);
        }
      }
    }
  }
  check(borders > 0, __FILE__, __LINE__, where + ": no two cells touch");
  check(equal == 0, __FILE__, __LINE__, described(where.c_str(), "sides of one colour", equal, 0));
}

void checkColors(
  const std::string& where, vtkPolyData* input, int points, double anisotropy, std::size_t most)
{
  vtkNew<Remesher> filter;
  filter->SetInputData(input);
  filter->SetNumberOfPoints(points);
  filter->SetAnisotropy(anisotropy);
  filter->SetNumberOfNewtonIterations(5);
  filter->Update();
  std::set<vtkIdType> used;
  for (const auto& [site, color] : colorsOf(filter))
  {
    used.insert(color);
  }
  check(used.size() <= most && *used.begin() == 0 &&
      *used.rbegin() == static_cast<vtkIdType>(used.size()) - 1,
    __FILE__, __LINE__, described(where.c_str(), "colours", used.size(), most));
  checkSides(filter->GetVoronoiCellsOutput(), where);

  vtkPolyData* cells = filter->GetVoronoiCellsOutput();
  CHECK_EQUAL(cells->GetCellData()->GetScalars(), cells->GetCellData()->GetArray("CellColor"));
  vtkPolyData* edges = filter->GetEdgesOutput();
  CHECK_EQUAL(edges->GetCellData()->GetScalars(), edges->GetCellData()->GetArray("EdgeType"));
  CHECK(filter->GetOutput()->GetPointData()->GetScalars() == nullptr);

  // The colours do not depend on which ports are filled.
  vtkNew<Remesher> alone;
  alone->SetInputData(input);
  alone->SetNumberOfPoints(points);
  alone->SetAnisotropy(anisotropy);
  alone->SetNumberOfNewtonIterations(5);
  alone->GenerateVoronoiCellsOff();
  alone->GenerateEdgesOff();
  alone->Update();
  for (vtkIdType i = 0; i < alone->GetOutput()->GetNumberOfPoints(); ++i)
  {
    CHECK_EQUAL(valueOf(alone->GetOutput()->GetPointData(), "CellColor", i),
      valueOf(filter->GetOutput()->GetPointData(), "CellColor", i));
  }
}

/** A cell nobody touches, and sites whose cells are empty, have colours, too. */
void testGivenSites()
{
  vtkNew<vtkRestrictedVoronoiDiagram> diagram;
  diagram->SetInputData(polyDataOf(icosphere(3)));
  diagram->SetSitesData(pointsOnly({ Point3(0, 0, 1), Point3(0, 0, 1), Point3(0, 0, -1) }));
  diagram->Update();
  CHECK_EQUAL(colorsOf(diagram).size(), std::size_t(3));
  checkSides(diagram->GetVoronoiCellsOutput(), "three sites");
}
}

int TestCellColors(int, char*[])
{
  checkColors("a sphere", polyDataOf(icosphere(3)), 300, 0.0, 6);
  checkColors("a sphere, anisotropic", polyDataOf(ellipsoid(3)), 300, 0.1, 6);
  checkColors("a cube", polyDataOf(cube()), 200, 0.04, 6);
  checkColors("an open plate", bumpyPlate(20, 0.1, 2.0), 150, 0.04, 6);
  checkColors("a torus", polyDataOf(torus(1.0, 0.3, 40, 20)), 60, 0.0, 7);
  checkColors("three sheets", polyDataOf(threeSheets()), 100, 0.0, 7);
  testGivenSites();
  return result();
}
