#include "Surfaces.h"

#include "Adaptors/PointArrays.h"
#include "Adaptors/SurfaceIntake.h"

#include <vtkCellArray.h>
#include <vtkLoopSubdivisionFilter.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPLYWriter.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataWriter.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <vector>

namespace remesh::benchmark
{
namespace
{
constexpr double pi = 3.14159265358979323846;

EmbeddedSurface prepared(vtkPolyData* surface, PreparationRequest request)
{
  request.source = sourceOf(surface);
  PreparedSurface result;
  if (Status status = prepareSurface(request, RunControl(), result); !status.ok())
  {
    throw std::runtime_error(status.message);
  }
  return std::move(result.surface);
}

/** Angles that do not repeat: the fractional parts of multiples of the golden ratio. */
double phase(int k)
{
  const double turns = 0.6180339887498949 * k;
  return 2.0 * pi * (turns - std::floor(turns));
}

/** Distance from the ring: waves around both circles, of 3 to 19 periods. */
double tubeRadius(double u, double v)
{
  return 0.4 *
    (1.0 + 0.12 * std::sin(3.0 * u + 2.0 * v) + 0.05 * std::sin(7.0 * u - 5.0 * v + 1.0) +
      0.02 * std::sin(19.0 * u + 11.0 * v + 2.0));
}

/** Of a torus without waves. */
double plainRadius(double, double)
{
  return 0.4;
}

/**
 * Toruses inside each other, of about so many triangles each.
 *
 * @param factors of their tubes' radii; where one is negative, the inside is the front.
 * @param radius of the tube at the angles around the ring and around the tube.
 */
vtkSmartPointer<vtkPolyData> torusOf(
  double triangles, const std::vector<double>& factors, double (*radius)(double, double))
{
  // nu x nv squares of two triangles each, twice as many around as across.
  const int nv = std::max(8, static_cast<int>(std::lround(std::sqrt(0.25 * triangles))));
  const int nu = 2 * nv;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const double factor : factors)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    const auto id = [=](int i, int j) { return first + vtkIdType{ i % nu } * nv + j % nv; };
    for (int i = 0; i < nu; ++i)
    {
      for (int j = 0; j < nv; ++j)
      {
        const double u = 2.0 * pi * i / nu;
        const double v = 2.0 * pi * j / nv;
        const double r = std::abs(factor) * radius(u, v);
        const double ring = 1.0 + r * std::cos(v);
        points->InsertNextPoint(ring * std::cos(u), ring * std::sin(u), r * std::sin(v));
        const int beside = factor < 0.0 ? j : j + 1;
        const int along = factor < 0.0 ? j + 1 : j;
        cells->InsertNextCell({ id(i, along), id(i + 1, along), id(i + 1, beside) });
        cells->InsertNextCell({ id(i, along), id(i + 1, beside), id(i, beside) });
      }
    }
  }
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

/** The metric of torusWithMetric() at a point of the plain torus. */
Eigen::Matrix3d gradedMetric(const Eigen::Vector3d& point)
{
  constexpr double ratio = 3.0;
  const double u = std::atan2(point[1], point[0]);
  const Eigen::Vector3d ring(std::cos(u), std::sin(u), 0.0);
  const Eigen::Vector3d around(-std::sin(u), std::cos(u), 0.0);
  const Eigen::Vector3d normal = (point - ring).normalized();
  const double v = std::atan2(normal[2], normal.dot(ring));
  const Eigen::Vector3d across =
    std::cos(3.0 * u) * around + std::sin(3.0 * u) * normal.cross(around);
  const double density = 1.0 + 0.7 * std::sin(2.0 * u + v);
  return density * density *
    (Eigen::Matrix3d::Identity() + (ratio * ratio - 1.0) * across * across.transpose());
}

/** The metric of gridWithLayer(). */
Eigen::Matrix3d bentMetric(const Eigen::Vector3d& point)
{
  constexpr double thin = 1e-4;
  constexpr double most = 0.1;
  constexpr double growth = 0.3;
  const Eigen::Vector3d slope(-0.4 * pi * std::cos(2.0 * pi * point[0]), 1.0, 0.0);
  const double height = point[1] - 0.2 * std::sin(2.0 * pi * point[0]);
  const double size = std::min(most, thin + growth * std::abs(height) / slope.norm());
  const Eigen::Vector3d across = slope.normalized();
  return Eigen::Matrix3d::Identity() / (most * most) +
    (1.0 / (size * size) - 1.0 / (most * most)) * across * across.transpose();
}

Surface withMetric(const std::string& name, vtkPolyData* data,
  Eigen::Matrix3d (*metricAt)(const Eigen::Vector3d& point))
{
  vtkNew<vtkDoubleArray> metric;
  metric->SetName("Metric");
  metric->SetNumberOfComponents(6);
  for (vtkIdType k = 0; k < data->GetNumberOfPoints(); ++k)
  {
    const Eigen::Matrix3d m = metricAt(Eigen::Map<const Eigen::Vector3d>(data->GetPoint(k)));
    metric->InsertNextTuple6(m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(0, 2));
  }
  data->GetPointData()->AddArray(metric);
  return { name, data, "" };
}
}

Surface scan(const std::string& folder)
{
  const std::string path = folder + "/armadillo.ply";
  if (!std::ifstream(path))
  {
    return bumpyTorus(scanTriangles);
  }
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  if (reader->GetOutput()->GetNumberOfPolys() == 0)
  {
    throw std::runtime_error("cannot read " + path);
  }
  return { "armadillo", reader->GetOutput(), path };
}

Surface bumpyTorus(double triangles)
{
  return { "bumpy torus", torusOf(triangles, { 1.0 }, tubeRadius), "" };
}

Surface thinShell(double triangles)
{
  return { "thin shell", torusOf(0.5 * triangles, { 1.0, -0.99 }, tubeRadius), "" };
}

Surface torusWithMetric(double points)
{
  return withMetric("torus", torusOf(2.0 * points, { 1.0 }, plainRadius), gradedMetric);
}

Surface gridWithLayer(double points)
{
  const int side = std::max(8, static_cast<int>(std::lround(std::sqrt(points))));
  vtkNew<vtkPlaneSource> plane; // from -0.5 to 0.5
  plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  plane->SetResolution(side - 1, side - 1);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(plane->GetOutputPort());
  triangles->Update();
  triangles->GetOutput()->GetPointData()->Initialize();
  return withMetric("square", triangles->GetOutput(), bentMetric);
}

Surface surfaceFor(const MetricRun& run)
{
  return run.isBent ? gridWithLayer(run.surfacePoints) : torusWithMetric(run.surfacePoints);
}

Surface subdivided(const Surface& surface)
{
  vtkNew<vtkLoopSubdivisionFilter> loop;
  loop->SetInputData(surface.data);
  loop->SetNumberOfSubdivisions(2);
  loop->Update();
  return { surface.name + ", subdivided twice", loop->GetOutput(), "" };
}

const char* extensionFor(vtkPolyData* surface)
{
  return surface->GetPointData()->HasArray("Metric") ? ".vtp" : ".ply";
}

void writeSurface(vtkPolyData* surface, const std::string& path)
{
  const auto write = [&](auto* writer)
  {
    writer->SetInputData(surface);
    writer->SetFileName(path.c_str());
    return writer->Write() != 0;
  };
  const bool isWritten = surface->GetPointData()->HasArray("Metric")
    ? write(vtkNew<vtkXMLPolyDataWriter>().Get())
    : write(vtkNew<vtkPLYWriter>().Get());
  if (!isWritten || !std::ifstream(path))
  {
    throw std::runtime_error("cannot write " + path);
  }
}

EmbeddedSurface gaussMapped(vtkPolyData* surface)
{
  PreparationRequest request;
  request.anisotropy = anisotropy;
  return prepared(surface, request);
}

vtkSmartPointer<vtkDoubleArray> smoothFunctions(vtkPolyData* surface, int count)
{
  const auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName("Smooth");
  array->SetNumberOfComponents(count);
  array->SetNumberOfTuples(surface->GetNumberOfPoints());
  std::vector<std::array<double, 4>> waves; // direction and phase
  for (int k = 0; k < count; ++k)
  {
    waves.push_back({ 3.0 * std::cos(phase(4 * k)), 3.0 * std::cos(phase(4 * k + 1)),
      3.0 * std::cos(phase(4 * k + 2)), phase(4 * k + 3) });
  }
  const double amplitude = 0.5 / std::sqrt(count);
  for (vtkIdType point = 0; point < surface->GetNumberOfPoints(); ++point)
  {
    double x[3];
    surface->GetPoint(point, x);
    for (int k = 0; k < count; ++k)
    {
      const auto& [a, b, c, shift] = waves[static_cast<std::size_t>(k)];
      array->SetTypedComponent(
        point, k, amplitude * std::sin(a * x[0] + b * x[1] + c * x[2] + shift));
    }
  }
  return array;
}

EmbeddedSurface embeddedIn(vtkPolyData* surface, int dimension)
{
  PreparationRequest request;
  request.gaussMap = false;
  const auto more = smoothFunctions(surface, std::max(1, dimension - 3));
  if (dimension > 3)
  {
    request.coordinates.emplace_back(*lentArray(more), 1.0);
  }
  return prepared(surface, request);
}
}
