// How good meshes are: cells near regular hexagons, triangles near regular ones where they are to
// be, distances near the least that is known, and less of them with anisotropy.

#include "Support/Random.h"
#include "TestTrials.h"

#include <cmath>

using namespace remesh;
using namespace remesh::test;

namespace
{
/** Noise is a share of the distance from the centre. */
vtkSmartPointer<vtkPolyData> ellipsoidOf(int levels, const Point3& axes, double noise = 0.0)
{
  TriangleSoup soup = icosphere(levels);
  for (std::size_t i = 0; i < soup.points.size(); ++i)
  {
    soup.points[i] = (1.0 + noise * (uniform01(1, i, 0) - 0.5)) * soup.points[i].cwiseProduct(axes);
  }
  return polyDataOf(soup);
}

/** Twice the inscribed circle's radius over that of the circumscribed one, in R^d. */
double meanRadiusRatio(vtkPolyData* mesh)
{
  const auto places = arrayOf(mesh->GetPointData(), "Embedding");
  double sum = 0.0;
  forEachPolygon(mesh,
    [&](vtkIdType, const std::vector<vtkIdType>& ids)
    {
      double lengths[3];
      for (int k = 0; k < 3; ++k)
      {
        lengths[k] = (tupleOf(places, ids[k]) - tupleOf(places, ids[(k + 1) % 3])).norm();
      }
      const auto& [a, b, c] = lengths;
      sum += (b + c - a) * (c + a - b) * (a + b - c) / (a * b * c);
    });
  return sum / static_cast<double>(mesh->GetNumberOfCells());
}

/** The dimensionless second moment of the cells, over that of the regular hexagon. */
double momentOverHexagons(vtkPolyData* mesh)
{
  const double hexagon = 5.0 / (18.0 * std::sqrt(3.0));
  const double mass = sumOf(arrayOf(mesh->GetPointData(), "CellMass"));
  const double energy = sumOf(arrayOf(mesh->GetPointData(), "CellEnergy"));
  return energy * static_cast<double>(mesh->GetNumberOfPoints()) / (mass * mass) / hexagon;
}

/** Centroidal cells, with the points at their centroids. */
void testCells()
{
  auto remesher = vtkSmartPointer<vtkAnisotropicRemesher>::New();
  remesher->SetNumberOfPoints(1000);
  remesher->SetVertexPlacement(vtkAnisotropicRemesher::CENTROID);
  Messages messages(remesher);
  const auto ring = polyDataOf(torus(1.0, 0.4, 90, 45));
  for (const auto& surface : { ellipsoidOf(5, { 1.0, 0.6, 0.5 }), ring })
  {
    remesher->SetInputData(surface);
    for (const double anisotropy : { 0.0, 0.02 })
    {
      remesher->SetAnisotropy(anisotropy);
      remesher->Update();
      CHECK(momentOverHexagons(remesher->GetOutput()) < 1.015);
      CHECK(momentOverHexagons(remesher->GetOutput()) > 0.999); // 1 is the least in a plane
      CHECK(meanRadiusRatio(remesher->GetOutput()) > 0.97);
    }
  }
  CHECK(messages.errors().empty() && messages.warnings().empty());
}

/**
 * The least RMS distance of a mesh with 1000 points to this ellipsoid is 7.28e-5 of the diagonal:
 * by the formula that TestPlacement has, with the cube root of the Gaussian curvature integrated
 * over the whole ellipsoid.
 */
void testEllipsoid()
{
  const Trial trial = checkedMesh(ellipsoidOf(6, { 1.0, 0.6, 0.2 }), 1000, 0.08);
  CHECK(trial.value("RelativeRMSDistance") < 1.4 * 7.28e-5);
  CHECK(trial.value("MeanMinimumAngle") > 40.0);
}

/** The RMS distance of a mesh with 400 points, in the unit of the surface. */
double distanceOf(vtkPolyData* surface, double anisotropy, int smoothingPasses)
{
  auto remesher = vtkSmartPointer<vtkAnisotropicRemesher>::New();
  remesher->SetInputData(surface);
  remesher->SetNumberOfPoints(400);
  remesher->SetAnisotropy(anisotropy);
  remesher->SetNormalSmoothingPasses(smoothingPasses);
  Messages messages(remesher); // of the topology, without smoothing
  remesher->Update();
  return arrayOf(remesher->GetOutput()->GetFieldData(), "RMSDistance")->GetComponent(0, 0);
}

/** As the normals are smoothed unless asked otherwise, anisotropy pays on noise, too. */
void testNoise()
{
  const auto surface = ellipsoidOf(5, { 1.0, 0.6, 0.2 }, 0.02);
  const double smoothed = distanceOf(surface, 0.05, -1);
  CHECK(smoothed < 0.95 * distanceOf(surface, 0.0, -1));
  CHECK(smoothed < 0.75 * distanceOf(surface, 0.05, 0));
}
}

int TestMeshQuality(int, char*[])
{
  testCells();
  testEllipsoid();
  testNoise();
  return result();
}
