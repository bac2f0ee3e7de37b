#include "Adaptors/ArrayHelpers.h"
#include "Adaptors/DiagramOutput.h"

#include "vtkPointData.h"
#include "vtkTable.h"

#include <cmath>

namespace remesh
{
namespace
{
/** The centroid of each cell in R^3, over all its components; given places of empty cells. */
std::vector<Point3> placeSites(const DiagramSource& source)
{
  const RemeshResult& result = source.result;
  const Components& components = result.components;
  const auto count = static_cast<std::size_t>(result.sites.count());
  std::vector<Point3> places(count, Point3::Zero());
  std::vector<double> weights(count, 0.0);
  for (Index k = 0; k < components.count(); ++k)
  {
    const double mass = components.mass[k];
    places[components.sites[k]] += mass * components.centroids[k];
    weights[components.sites[k]] += mass;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    if (weights[i] > 0.0)
    {
      places[i] /= weights[i];
    }
    else if (i < source.givenPlaces.size())
    {
      places[i] = source.givenPlaces[i];
    }
  }
  return places;
}

/** The site's centroid (its own place where the cell is empty) and the site itself, d values. */
void addPlaces(const DiagramSource& source, vtkPointData* data)
{
  const RemeshResult& result = source.result;
  const int d = source.surface().dimension;
  const Offset count = result.sites.count();
  const auto embedding = addArray<vtkDoubleArray>(data, "Embedding", count, d);
  const auto centroid = addArray<vtkDoubleArray>(data, "Centroid", count, d);
  for (Offset i = 0; i < count; ++i)
  {
    const double* x = result.sites.site(static_cast<Index>(i));
    const double mass = result.sums.mass[i];
    for (int c = 0; c < d; ++c)
    {
      const double shift = mass > 0.0 ? result.sums.moment[i * d + c] / mass : 0.0;
      embedding->SetTypedComponent(i, c, source.surface().toCaller(x[c], c));
      centroid->SetTypedComponent(i, c, source.surface().toCaller(x[c] + shift, c));
    }
  }
}
}

void writeSites(const DiagramSource& source, vtkPolyData* output)
{
  const RemeshResult& result = source.result;
  const CellSums& sums = result.sums;
  const Offset count = result.sites.count();
  const std::vector<Point3> places = placeSites(source);
  output->SetPoints(makePoints(count, [&](Offset i) -> const Point3& { return places[i]; }));
  vtkNew<vtkCellArray> vertices;
  vertices->AllocateExact(count, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    vertices->InsertNextCell({ i });
  }
  output->SetVerts(vertices);

  vtkPointData* data = output->GetPointData();
  addColumn<vtkIdTypeArray>(data, "SiteId", count, [](Offset i) { return i; });
  addColumn<vtkIdTypeArray>(data, "MergedSiteId", count, [](Offset i) { return i; });
  addColumn<vtkIdTypeArray>(data, "PatchId", count, [](Offset) { return 0; });
  addColumn<vtkDoubleArray>(data, "Weight", count, [](Offset) { return 0.0; });
  addPlaces(source, data);
  addColumn<vtkDoubleArray>(data, "CellArea", count, [&](Offset i) { return sums.area[i]; });
  addColumn<vtkDoubleArray>(
    data, "CellMass", count, [&](Offset i) { return sums.mass[i] * source.massUnit(); });
  addColumn<vtkDoubleArray>(
    data, "CellEnergy", count, [&](Offset i) { return sums.energy[i] * source.energyUnit(); });
  addColumn<vtkIdTypeArray>(
    data, "NumberOfNeighbors", count, [&](Offset i) { return result.numbersOfNeighbors[i]; });
}

void writeConvergence(const DiagramSource& source, vtkTable* output)
{
  const auto& rows = source.result.convergence.rows;
  const auto count = static_cast<Offset>(rows.size());
  vtkFieldData* data = output->GetRowData();
  addColumn<vtkIdTypeArray>(data, "Iteration", count, [&](Offset k) { return rows[k].iteration; });
  addColumn<vtkDoubleArray>(
    data, "Energy", count, [&](Offset k) { return rows[k].energy * source.energyUnit(); });
  const double gradientUnit = source.massUnit() * source.surface().unit;
  addColumn<vtkDoubleArray>(
    data, "GradientNorm", count, [&](Offset k) { return rows[k].gradientNorm * gradientUnit; });
  addColumn<vtkDoubleArray>(
    data, "StepLength", count, [&](Offset k) { return rows[k].stepLength; });
  addColumn<vtkDoubleArray>(data, "Time", count, [&](Offset k) { return rows[k].seconds; });
}
}
