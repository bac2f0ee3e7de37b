// vtkAnisotropicRemesher: ports 1, 2 and 4 against the definition of the restricted diagram.

#include "TestMeasures.h"

#include "vtkAnisotropicRemesher.h"

using namespace remesh;
using namespace remesh::test;

namespace
{
constexpr int dimension = 6;
constexpr vtkIdType numberOfSites = 300;

using Vector = Eigen::VectorXd;

/** Mass, energy and centroid of a triangle of R^d, seen from x. */
struct Moments
{
  double area = 0.0;
  double mass = 0.0;
  double energy = 0.0;
  Vector moment = Vector::Zero(dimension);

  void add(const Vector& a, const Vector& b, const Vector& c)
  {
    const double ab2 = (b - a).squaredNorm();
    const double ac2 = (c - a).squaredNorm();
    const double dot = (b - a).dot(c - a);
    const double triangle = 0.5 * std::sqrt(std::max(0.0, ab2 * ac2 - dot * dot));
    const Vector sum = a + b + c;
    this->mass += triangle;
    this->energy +=
      triangle / 12.0 * (sum.squaredNorm() + a.squaredNorm() + b.squaredNorm() + c.squaredNorm());
    this->moment += triangle / 3.0 * sum;
  }
};

/** Integrates over the polygons of port 1 and compares with the arrays of ports 1 and 2. */
void testCells(vtkAnisotropicRemesher* filter, vtkPolyData* input)
{
  vtkPolyData* cells = filter->GetVoronoiCellsOutput();
  vtkPolyData* sites = filter->GetSitesOutput();
  const auto places = arrayOf(cells->GetPointData(), "Embedding");
  const auto siteIds = arrayOf(cells->GetCellData(), "SiteId");
  const auto inputCells = arrayOf(cells->GetCellData(), "InputCellId");
  const auto embedding = arrayOf(sites->GetPointData(), "Embedding");

  std::vector<Moments> ofSites(numberOfSites);
  std::vector<double> ofInputCells(input->GetNumberOfCells(), 0.0);
  forEachPolygon(cells,
    [&](vtkIdType cell, const std::vector<vtkIdType>& ids)
    {
      const auto site = static_cast<vtkIdType>(siteIds->GetComponent(cell, 0));
      const auto inputCell = static_cast<vtkIdType>(inputCells->GetComponent(cell, 0));
      CHECK(site >= 0 && site < numberOfSites);
      CHECK(inputCell >= 0 && inputCell < input->GetNumberOfCells());
      const double area = polygonArea(cells, ids);
      ofSites[site].area += area;
      ofInputCells[inputCell] += area;
      const Vector x = tupleOf(embedding, site);
      const Vector first = tupleOf(places, ids[0]) - x;
      for (std::size_t k = 1; k + 1 < ids.size(); ++k)
      {
        ofSites[site].add(first, tupleOf(places, ids[k]) - x, tupleOf(places, ids[k + 1]) - x);
      }
    });
  forEachPolygon(input,
    [&](vtkIdType cell, const std::vector<vtkIdType>& ids)
    { CHECK_NEAR(ofInputCells[cell], polygonArea(input, ids), 1e-14); });

  const auto area = arrayOf(sites->GetPointData(), "CellArea");
  const auto mass = arrayOf(sites->GetPointData(), "CellMass");
  const auto energy = arrayOf(sites->GetPointData(), "CellEnergy");
  const auto centroid = arrayOf(sites->GetPointData(), "Centroid");
  for (vtkIdType i = 0; i < numberOfSites; ++i)
  {
    const Moments& expected = ofSites[i];
    CHECK_NEAR(area->GetComponent(i, 0), expected.area, 1e-12 * expected.area);
    CHECK_NEAR(mass->GetComponent(i, 0), expected.mass, 1e-9 * expected.mass);
    CHECK_NEAR(energy->GetComponent(i, 0), expected.energy, 1e-9 * expected.energy);
    const Vector expectedCentroid = tupleOf(embedding, i) + expected.moment / expected.mass;
    CHECK((tupleOf(centroid, i) - expectedCentroid).norm() < 1e-10);
  }
  for (const char* name : { "CellArea", "CellMass", "CellEnergy", "MergedSiteId", "PatchId" })
  {
    const auto ofCells = arrayOf(cells->GetCellData(), name);
    const auto ofSite = arrayOf(sites->GetPointData(), name);
    bool agree = true;
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
    {
      agree = agree &&
        ofCells->GetComponent(cell, 0) ==
          ofSite->GetComponent(static_cast<vtkIdType>(siteIds->GetComponent(cell, 0)), 0);
    }
    check(agree, __FILE__, __LINE__, std::string(name) + " differs between ports 1 and 2");
  }
}

/** No vertex of a piece is nearer to another site, by brute force. */
void testNearestSites(vtkAnisotropicRemesher* filter)
{
  vtkPolyData* cells = filter->GetVoronoiCellsOutput();
  const auto places = arrayOf(cells->GetPointData(), "Embedding");
  const auto siteIds = arrayOf(cells->GetCellData(), "SiteId");
  const auto embedding = arrayOf(filter->GetSitesOutput()->GetPointData(), "Embedding");
  Eigen::MatrixXd x(dimension, numberOfSites);
  for (vtkIdType i = 0; i < numberOfSites; ++i)
  {
    x.col(i) = tupleOf(embedding, i);
  }
  double worst = 0.0;
  forEachPolygon(cells,
    [&](vtkIdType cell, const std::vector<vtkIdType>& ids)
    {
      for (const vtkIdType point : ids)
      {
        const Vector p = tupleOf(places, point);
        const double own =
          (x.col(static_cast<Eigen::Index>(siteIds->GetComponent(cell, 0))) - p).squaredNorm();
        worst = std::max(worst, own - (x.colwise() - p).colwise().squaredNorm().minCoeff());
        CHECK_NEAR((p.head<3>() - pointOf(cells, point)).norm(), 0.0, 1e-14);
      }
    });
  CHECK(worst < 1e-13);
}

void testSites(vtkAnisotropicRemesher* filter)
{
  vtkPolyData* sites = filter->GetSitesOutput();
  vtkPointData* data = sites->GetPointData();
  vtkPolyData* edges = filter->GetEdgesOutput();
  const auto types = arrayOf(edges->GetCellData(), "EdgeType");
  const auto pairs = arrayOf(edges->GetCellData(), "SiteId");
  std::vector<std::set<vtkIdType>> neighbors(numberOfSites);
  for (vtkIdType k = 0; k < edges->GetNumberOfCells(); ++k)
  {
    // The surface is closed and smooth: there are only borders between cells.
    CHECK_EQUAL(types->GetComponent(k, 0), 0.0);
    const auto a = static_cast<vtkIdType>(pairs->GetComponent(k, 0));
    const auto b = static_cast<vtkIdType>(pairs->GetComponent(k, 1));
    CHECK(a >= 0 && a < numberOfSites && b >= 0 && b < numberOfSites && a != b);
    neighbors[a].insert(b);
    neighbors[b].insert(a);
  }
  const auto numbers = arrayOf(data, "NumberOfNeighbors");
  for (vtkIdType i = 0; i < numberOfSites; ++i)
  {
    CHECK_EQUAL(arrayOf(data, "SiteId")->GetComponent(i, 0), static_cast<double>(i));
    CHECK_EQUAL(arrayOf(data, "MergedSiteId")->GetComponent(i, 0), static_cast<double>(i));
    CHECK_EQUAL(arrayOf(data, "PatchId")->GetComponent(i, 0), 0.0);
    CHECK_EQUAL(arrayOf(data, "Weight")->GetComponent(i, 0), 0.0);
    CHECK_EQUAL(numbers->GetComponent(i, 0), static_cast<double>(neighbors[i].size()));
    CHECK(arrayOf(data, "CellArea")->GetComponent(i, 0) > 0.0);
  }
}
}

int TestRemesherDiagram(int, char*[])
{
  const auto input = polyDataOf(ellipsoid(4));
  vtkNew<vtkAnisotropicRemesher> filter;
  filter->SetInputData(input);
  filter->SetNumberOfPoints(numberOfSites);
  filter->SetNumberOfLloydIterations(5);
  filter->SetNumberOfNewtonIterations(5);
  filter->SetAnisotropy(0.1);
  filter->Update();
  testCells(filter, input);
  testNearestSites(filter);
  testSites(filter);
  return result();
}
