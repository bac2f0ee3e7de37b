#include "Adaptors/ArrayHelpers.h"
#include "Adaptors/BlockNames.h"
#include "Adaptors/DiagramOutput.h"
#include "Adaptors/MeshBlocks.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <cmath>

namespace remesh
{
namespace
{
/**
 * The centroid of each cell in R^3, over all its components; given places of empty cells; places of
 * sites on features.
 */
std::vector<Point3> placeSites(const DiagramSource& source)
{
  const RemeshResult& result = source.result;
  const Components& components = result.components;
  const FeatureSites& features = result.featureSites;
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
    if (i < features.pointOfSite.size())
    {
      places[i] = features.points[features.pointOfSite[i]].place;
    }
    else if (weights[i] > 0.0)
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
void addPlaces(const DiagramSource& source, const Columns& columns)
{
  const RemeshResult& result = source.result;
  const int d = source.dimension();
  columns.addTuples<vtkDoubleArray>("Embedding", d,
    [&](Offset i, double* values)
    { source.surface().toCaller(result.sites.site(static_cast<Index>(i)), values); });
  columns.addTuples<vtkDoubleArray>("Centroid", d,
    [&](Offset i, double* values)
    {
      source.surface().toCaller(result.sites.site(static_cast<Index>(i)), values);
      const double mass = source.siteMass()[i];
      if (mass > 0.0)
      {
        for (int c = 0; c < d; ++c)
        {
          values[c] += source.siteMoment()[i * d + c] / mass * source.surface().unit;
        }
      }
    });
}
}

void writeSites(const DiagramSource& source, vtkPolyData* output)
{
  const RemeshResult& result = source.result;
  const CellSums& sums = result.sums;
  const Offset count = result.sites.count();
  const std::vector<Point3> places = placeSites(source);
  output->SetPoints(makePoints(
    count, [&](Offset i) -> const Point3& { return places[i]; }, source.control));
  output->SetVerts(
    makeCells(count, 1, source.control, [](Offset i, vtkIdType* ids) { ids[0] = i; }));

  const Columns columns{ output->GetPointData(), count, source.control };
  columns.add<vtkIdTypeArray>("SiteId", [](Offset i) { return i; });
  columns.add<vtkIdTypeArray>("MergedSiteId",
    [&](Offset i) { return result.featureSites.mergedSite(static_cast<Index>(i)); });
  columns.add<vtkIdTypeArray>(
    "PatchId", [&](Offset i) { return source.patchOfSite(static_cast<Index>(i)); });
  columns.add<vtkIntArray>("CellColor", [&](Offset i) { return result.cellColors[i]; });
  columns.add<vtkDoubleArray>("Weight", [](Offset) { return 0.0; });
  addPlaces(source, columns);
  columns.add<vtkDoubleArray>("CellArea", [&](Offset i) { return result.cellAreas[i]; });
  columns.add<vtkDoubleArray>(
    "CellMass", [&](Offset i) { return source.siteMass()[i] * source.massUnit(); });
  columns.add<vtkDoubleArray>(
    "CellEnergy", [&](Offset i) { return source.siteEnergy()[i] * source.energyUnit(); });
  if (source.hasDensity())
  {
    columns.add<vtkDoubleArray>("CellWeightedMass",
      [&](Offset i) { return sums.mass[i] * source.massUnit() * source.densityUnit(); });
  }
  columns.add<vtkIdTypeArray>(
    "NumberOfNeighbors", [&](Offset i) { return result.numbersOfNeighbors[i]; });
  if (source.cellBlocks)
  {
    const std::vector<int> blocks = findSiteBlocks(source, places);
    const auto block = [&](Offset i) { return blocks[i]; };
    columns.add<vtkIntArray>(blockName, block);
    Columns{ output->GetCellData(), count, source.control }.add<vtkIntArray>(blockName, block);
  }
}

void writeConvergence(const DiagramSource& source, vtkTable* output)
{
  const auto& rows = source.result.convergence.rows;
  const Columns columns{ output->GetRowData(), static_cast<Offset>(rows.size()), source.control };
  columns.add<vtkIdTypeArray>("Iteration", [&](Offset k) { return rows[k].iteration; });
  columns.add<vtkDoubleArray>("Energy",
    [&](Offset k) { return rows[k].energy * source.energyUnit() * source.densityUnit(); });
  const double gradientUnit = source.massUnit() * source.surface().unit * source.densityUnit();
  columns.add<vtkDoubleArray>(
    "GradientNorm", [&](Offset k) { return rows[k].gradientNorm * gradientUnit; });
  columns.add<vtkDoubleArray>("StepLength", [&](Offset k) { return rows[k].stepLength; });
  columns.add<vtkDoubleArray>("Seconds", [&](Offset k) { return rows[k].seconds; });
}
}
