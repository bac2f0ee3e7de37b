#include "Adaptors/SitesInput.h"

#include "Adaptors/ArrayHelpers.h"
#include "Embedding/CornerReader.h"
#include "Mesh/ClosestPoint.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkStaticCellLocator.h"

#include <cmath>
#include <string>

namespace remesh
{
namespace
{
/** The surface after intake, for a locator. */
vtkSmartPointer<vtkPolyData> makePolyData(const SurfaceMesh& mesh)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(
    makePoints(mesh.numberOfPoints(), [&](Offset k) -> const Point3& { return mesh.points[k]; }));
  vtkNew<vtkCellArray> cells;
  for (const Triple& facet : mesh.facetPoints)
  {
    cells->InsertNextCell({ facet[0], facet[1], facet[2] });
  }
  data->SetPolys(cells);
  return data;
}

/** In scaled units, of which the surface is 1 in size: squares stay far from overflow. */
constexpr double farthestSite = 1e30;

/** Row by row from the array, centred and scaled. */
void takeEmbedding(vtkDataArray* embedding, const EmbeddedSurface& surface, Sites& sites)
{
  const int d = surface.dimension;
  for (Offset i = 0; i < sites.count(); ++i)
  {
    double* x = sites.site(static_cast<Index>(i));
    embedding->GetTuple(i, x);
    for (int c = 0; c < d; ++c)
    {
      x[c] = surface.toScaled(x[c], c);
    }
  }
}

/** At the closest point of the surface. */
void projectOnSurface(
  const std::vector<Point3>& places, const PreparedSurface& prepared, Sites& sites)
{
  const SurfaceMesh& mesh = prepared.mesh;
  const EmbeddedSurface& surface = prepared.surface;
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(makePolyData(mesh));
  locator->BuildLocator();
  CornerReader<Eigen::Dynamic> reader(surface);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    double closest[3], squared = 0.0;
    vtkIdType facet = 0;
    int subId = 0;
    locator->FindClosestPoint(places[i].data(), closest, facet, subId, squared);
    const Triple& points = mesh.facetPoints[facet];
    const ClosestPoint at = closestOnTriangle(
      places[i], mesh.points[points[0]], mesh.points[points[1]], mesh.points[points[2]]);
    const auto corners = reader.facet(static_cast<Index>(facet));
    double* x = sites.site(static_cast<Index>(i));
    for (int c = 0; c < surface.dimension; ++c)
    {
      x[c] = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        x[c] += at.b[k] * corners[k][c];
      }
    }
  }
}
}

Status readSites(vtkPointSet* input, const PreparedSurface& prepared, GivenSites& given)
{
  const Offset count = input->GetNumberOfPoints();
  const int d = prepared.surface.dimension;
  if (count < 1 || count > maximumIndex)
  {
    return Status::invalid("The sites must be 1 to " + std::to_string(maximumIndex) +
      " points; the input has " + std::to_string(count) + ".");
  }
  given.places.resize(static_cast<std::size_t>(count));
  for (Offset i = 0; i < count; ++i)
  {
    input->GetPoint(i, given.places[i].data());
    if (!given.places[i].allFinite())
    {
      return Status::invalid(
        "Site " + std::to_string(i) + " has a coordinate that is not a finite number.");
    }
  }
  given.sites.dimension = d;
  given.sites.coordinates.resize(static_cast<std::size_t>(count) * static_cast<std::size_t>(d));
  vtkDataArray* embedding = input->GetPointData()->GetArray("Embedding");
  if (!embedding || embedding->GetNumberOfComponents() != d ||
    embedding->GetNumberOfTuples() != count)
  {
    if (embedding)
    {
      given.warning = "The sites' array \"Embedding\" has not the " + std::to_string(d) +
        " components of the surface's embedding: the sites are put on the surface instead.";
    }
    projectOnSurface(given.places, prepared, given.sites);
    return Status::success();
  }
  takeEmbedding(embedding, prepared.surface, given.sites);
  for (std::size_t k = 0; k < given.sites.coordinates.size(); ++k)
  {
    if (!std::isfinite(given.sites.coordinates[k]))
    {
      return Status::invalid("The embedding of site " + std::to_string(k / d) +
        " has a value that is not a finite number.");
    }
    if (std::abs(given.sites.coordinates[k]) > farthestSite)
    {
      return Status::invalid(
        "The embedding of site " + std::to_string(k / d) + " is too far from the surface's.");
    }
  }
  return Status::success();
}
}
