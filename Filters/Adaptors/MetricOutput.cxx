/**
 * @file MetricOutput.cxx
 *
 * The points of the output are those of the input, under their ids, and then the new ones, in the
 * order in which facets have them. A new point of the mesh becomes several where the facets around
 * it have different points of the input, as along the seams of textures.
 */
#include "Adaptors/MetricOutput.h"

#include "Adaptors/ArrayHelpers.h"
#include "Adaptors/BlockNames.h"
#include "Adaptors/CarriedArrays.h"
#include "Adaptors/PointArrays.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkPointData.h"

#include <map>
#include <optional>
#include <utility>

namespace remesh
{
namespace
{
constexpr Names ownPointNames = { "Embedding", "LimitedMetric" };
constexpr Names ownCellNames = { "LeastStretch", "LargestStretch" };
constexpr Names ownFactNames = { "MetricUnit", "MetricLimit", "MetricShare", "MetricPoints",
  "StretchQuantiles" };

/** The points and triangles of the output. */
class OutputPoints
{
public:
  OutputPoints(const FieldSurface& field, const MetricSurface& surface)
    : Field(field)
    , Surface(surface)
    , Triangles(this->mesh().facetPoints.size())
  {
    const Offset given = field.input->GetNumberOfPoints();
    this->MeshPoints.assign(static_cast<std::size_t>(given), noIndex);
    for (Offset point = 0; point < given; ++point)
    {
      this->Places.push_back({ { point, point, point }, { 1.0, 0.0, 0.0 } });
    }
    std::vector<Offset> numbers(this->mesh().points.size(), noNumber);
    for (std::size_t f = 0; f < this->Triangles.size(); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        this->Triangles[f][k] = this->NumberOf(f, k, numbers);
      }
    }
  }

  const SurfaceMesh& mesh() const
  {
    return this->Surface.refined ? this->Surface.refined->mesh : this->Field.mesh;
  }
  Offset count() const { return static_cast<Offset>(this->Places.size()); }
  const InputPlace& place(Offset point) const { return this->Places[point]; }
  const std::array<Offset, 3>& triangle(Offset facet) const { return this->Triangles[facet]; }
  /** noIndex: no polygon uses it. */
  Index meshPoint(Offset point) const { return this->MeshPoints[point]; }
  Point3 position(Offset point) const
  {
    Point3 position;
    if (point < this->Field.input->GetNumberOfPoints())
    {
      this->Field.input->GetPoint(point, position.data());
      return position;
    }
    return this->mesh().points[this->MeshPoints[point]];
  }

private:
  static constexpr Offset noNumber = -1;
  using Key = std::array<std::pair<Offset, double>, 3>;

  InputPlace PlaceOf(std::size_t facet, int corner) const
  {
    if (!this->Surface.refined)
    {
      InputPlace place{ this->Field.mesh.facetInputPoints[facet], { 0.0, 0.0, 0.0 } };
      place.weights[corner] = 1.0;
      return place;
    }
    const FacetOrigin& origin = this->Surface.refined->origins[facet];
    const auto& [a, b, c] = origin.corners[corner];
    return { this->Field.mesh.facetInputPoints[static_cast<std::size_t>(origin.facet)],
      { a, b, c } };
  }

  Offset NumberOf(std::size_t facet, int corner, std::vector<Offset>& numbers)
  {
    const Index point = this->mesh().facetPoints[facet][corner];
    const InputPlace place = this->PlaceOf(facet, corner);
    for (int k = 0; k < 3; ++k)
    {
      if (place.weights[k] == 1.0)
      {
        this->MeshPoints[place.points[k]] = point;
        return place.points[k];
      }
    }
    Offset& number =
      this->Field.mesh.facetInputPoints.differ() ? this->SeamNumber(place) : numbers[point];
    if (number == noNumber)
    {
      number = this->count();
      this->Places.push_back(place);
      this->MeshPoints.push_back(point);
    }
    return number;
  }

  /** That of a place, whichever facet it is seen from: weights of middles are exact. */
  Offset& SeamNumber(const InputPlace& place)
  {
    Key key;
    for (int k = 0; k < 3; ++k)
    {
      const bool counts = place.weights[k] > 0.0;
      key[k] = { counts ? place.points[k] : noNumber, place.weights[k] };
    }
    std::sort(key.begin(), key.end());
    return this->SeamNumbers.emplace(key, noNumber).first->second;
  }

  const FieldSurface& Field;
  const MetricSurface& Surface;
  std::vector<InputPlace> Places;
  std::vector<Index> MeshPoints;
  std::vector<std::array<Offset, 3>> Triangles;
  std::map<Key, Offset> SeamNumbers;
};

void writePoints(
  const OutputPoints& points, const MetricSurface& surface, const FieldSurface& field)
{
  const auto d = static_cast<int>(surface.embedding.places.cols());
  const Columns columns{ field.output->GetPointData(), points.count(), field.control.silent() };
  columns.addTuples<vtkDoubleArray>("Embedding", d,
    [&](Offset point, double* tuple)
    {
      const Index from = points.meshPoint(point);
      for (int k = 0; k < d; ++k)
      {
        tuple[k] = from == noIndex ? 0.0 : surface.embedding.places(from, k);
      }
    });
  columns.addTuples<vtkDoubleArray>("LimitedMetric", 6,
    [&](Offset point, double* tuple)
    {
      const Index from = points.meshPoint(point);
      const Eigen::Matrix3d m =
        from == noIndex ? Eigen::Matrix3d(Eigen::Matrix3d::Zero()) : surface.metric.tensors[from];
      const double entries[6] = { m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(0, 2) };
      std::copy_n(entries, 6, tuple);
    });
}

/** What each triangle has from its cell, and its own. */
void writeCells(const OutputPoints& points, const MetricSurface& surface, const FieldSurface& field,
  LostArrays& lost)
{
  const std::vector<Offset>& cells = points.mesh().facetInputCells;
  const auto count = static_cast<Offset>(cells.size());
  vtkCellData* input = field.input->GetCellData();
  vtkCellData* output = field.output->GetCellData();
  vtkNew<vtkIdList> ids;
  ids->SetNumberOfIds(count);
  std::copy(cells.begin(), cells.end(), ids->GetPointer(0));
  const OwnArrays own{ ownCellNames, { ownCellNames.begin(), ownCellNames.end() } };
  for (const CarriedArray& array :
    makeCarriedArrays(input, field.input->GetNumberOfCells(), own, count, output, lost))
  {
    array.source->GetTuples(ids, array.target);
  }
  if (vtkAbstractArray* blocks = input->GetAbstractArray(blockName))
  {
    const auto target = makeLike(blocks, count);
    blocks->GetTuples(ids, target);
    output->AddArray(target);
  }
  const Columns columns{ output, count, field.control.silent() };
  int column = 0;
  for (const char* name : ownCellNames)
  {
    columns.add<vtkFloatArray>(
      name, [&](Offset f) { return surface.embedding.stretches[f][column]; });
    ++column;
  }
}

void writeFacts(const MetricSurface& surface, const MetricSize& size, const FieldSurface& field)
{
  const MetricFit fit = fitOf(surface);
  addFact(field, "MetricUnit", fit.unit);
  addFact(field, "MetricLimit", fit.limit);
  addFact(field, "MetricShare", fit.within);
  addFact(field, "MetricPoints", size.points(fit.unit));
  const std::vector<double> shares = { 0.01, 0.05, 0.5, 0.95, 0.99 };
  const auto quantiles = stretchQuantiles(surface, shares);
  const Columns columns{ field.output->GetFieldData(), static_cast<Offset>(shares.size()),
    field.control.silent() };
  columns.addTuples<vtkDoubleArray>("StretchQuantiles", 3,
    [&](Offset q, double* tuple)
    {
      tuple[0] = shares[q];
      std::copy_n(quantiles[q].begin(), 2, tuple + 1);
    });
}

void writeSurface(const MetricSurface& surface, const MetricSize& size, FieldSurface& field)
{
  const RunControl control = field.control.silent();
  const OutputPoints points(field, surface);
  vtkPolyData* output = field.output;
  output->Initialize();
  output->SetPoints(makePoints(
    points.count(), [&](Offset p) { return points.position(p); }, control));
  output->SetPolys(makeCells(points.mesh().numberOfFacets(), 3, control,
    [&](Offset f, vtkIdType* ids)
    { std::copy(points.triangle(f).begin(), points.triangle(f).end(), ids); }));
  LostArrays lost;
  const OwnArrays own{ ownPointNames, { ownPointNames.begin(), ownPointNames.end() } };
  const PlacedPoints places{ points.count(), [&](Offset p) { return points.place(p); }, control };
  carryPointArrays(field.input, own, places, output, lost);
  writePoints(points, surface, field);
  writeCells(points, surface, field, lost);
  output->GetFieldData()->ShallowCopy(field.input->GetFieldData());
  removeReserved(ownFactNames, output->GetFieldData());
  writeFacts(surface, size, field);
  if (const std::string sentence = lost.describe(); !sentence.empty())
  {
    field.warnings.push_back(sentence);
  }
}
}

Status addMetricEmbedding(const MetricRequest& request, FieldSurface& surface)
{
  vtkDataArray* array = nullptr;
  MetricField metric;
  Status status = findNamedArray(surface, request.array, "the metric", array);
  if (status.ok())
  {
    status = readMetric(
      surface.mesh, *lentArray(array), request.order, surface.input->GetNumberOfPoints(), metric);
  }
  MetricOptions options = request.options;
  if (status.ok() && request.isUnit)
  {
    status = findComplexityUnit(
      surface.mesh, metric, request.complexity, surface.control.silent(), options.unit);
  }
  if (status.ok() && request.isUnit)
  {
    MetricSize size;
    status = measureMetric(surface.mesh, metric, options, surface.control.silent(), size);
    options.sites = static_cast<Offset>(size.points(options.unit));
  }
  MetricSurface embedded;
  if (status.ok())
  {
    status = embedMetric(surface.mesh, nullptr, metric, options, surface.control, embedded);
  }
  if (!status.ok())
  {
    return status;
  }
  const SurfaceMesh& mesh = embedded.refined ? embedded.refined->mesh : surface.mesh;
  writeSurface(embedded, sizeOf(mesh, embedded.shapes, surface.control.silent()), surface);
  tellFit(fitOf(embedded), surface.warnings);
  return surface.control.cancelled() ? Status::cancelled() : Status::success();
}
}
