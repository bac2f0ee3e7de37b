#include "Adaptors/ArrayHelpers.h"
#include "Adaptors/CarriedArrays.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace remesh
{
namespace
{
/** The input points around a vertex, and their weights. */
struct Corners : InputPlace
{
  int nearest = 0; ///< of the largest weight

  explicit Corners(const InputPlace& place)
    : InputPlace(place)
  {
    for (const int k : { 1, 2 })
    {
      const bool equal = this->weights[k] == this->weights[this->nearest];
      if (this->weights[k] > this->weights[this->nearest] ||
        (equal && this->points[k] < this->points[this->nearest]))
      {
        this->nearest = k;
      }
    }
  }

  Offset nearestPoint() const { return this->points[this->nearest]; }

  /** Linear; where all three values are equal, exactly that. Weightless corners have no say. */
  template <class Value>
  double interpolate(const Value& value) const
  {
    const double base = value(this->points[this->nearest]);
    double plain = 0.0;
    double relative = base;
    for (int k = 0; k < 3; ++k)
    {
      if (this->weights[k] > 0.0)
      {
        const double here = value(this->points[k]);
        plain += this->weights[k] * here;
        relative += this->weights[k] * (here - base);
      }
    }
    return std::isfinite(relative) ? relative : plain;
  }
};

/** Makes the three values a unit vector, unless they are none. */
template <class Tuple>
void normalize(Tuple tuple)
{
  Point3 vector(
    static_cast<double>(tuple[0]), static_cast<double>(tuple[1]), static_cast<double>(tuple[2]));
  vector.stableNormalize();
  for (int c = 0; vector.allFinite() && c < 3; ++c)
  {
    tuple[c] = vector[c];
  }
}

struct Interpolate
{
  const PlacedPoints& points;
  bool areNormals;

  template <class From, class To>
  void operator()(From* from, To* to) const
  {
    using Value = vtk::GetAPIType<To>;
    const auto tuplesFrom = vtk::DataArrayTupleRange(from);
    auto tuplesTo = vtk::DataArrayTupleRange(to);
    const int components = from->GetNumberOfComponents();
    fillItems(to->GetNumberOfTuples(), this->points.control,
      [&](Offset vertex)
      {
        const Corners corners(this->points.placeOf(vertex));
        auto tuple = tuplesTo[vertex];
        for (int c = 0; c < components; ++c)
        {
          const double value = corners.interpolate(
            [&](Offset point) { return static_cast<double>(tuplesFrom[point][c]); });
          tuple[c] = static_cast<Value>(std::is_integral<Value>::value ? std::round(value) : value);
        }
        if (this->areNormals)
        {
          normalize(tuple);
        }
      });
  }
};

/** The interpolated values of an array; false if this kind of array has none. */
bool interpolateArray(const PlacedPoints& points, const CarriedArray& array)
{
  auto* from = vtkDataArray::SafeDownCast(array.source);
  auto* to = vtkDataArray::SafeDownCast(array.target);
  if (!from || !to || !hasMeans(from))
  {
    return false;
  }
  using Types = vtkTypeList::Create<unsigned char, float, double>;
  using Dispatcher = vtkArrayDispatch::Dispatch2BySameValueType<Types>;
  const bool areNormals =
    array.is(vtkDataSetAttributes::NORMALS) && from->GetNumberOfComponents() == 3;
  const Interpolate work{ points, areNormals };
  if (!Dispatcher::Execute(from, to, work))
  {
    work(from, to); // a layout that the dispatcher does not know
  }
  return true;
}
}

bool hasMeans(vtkAbstractArray* array)
{
  const int components = array->GetNumberOfComponents();
  const bool isColor =
    vtkUnsignedCharArray::SafeDownCast(array) != nullptr && (components == 3 || components == 4);
  return isColor || array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
}

void carryPointArrays(vtkPolyData* input, const OwnArrays& own, const PlacedPoints& points,
  vtkPolyData* output, LostArrays& lost)
{
  const std::vector<CarriedArray> arrays = makeCarriedArrays(input->GetPointData(),
    input->GetNumberOfPoints(), own, points.count, output->GetPointData(), lost);
  vtkNew<vtkIdList> nearest;
  for (const CarriedArray& array : arrays)
  {
    if (interpolateArray(points, array))
    {
      continue;
    }
    if (nearest->GetNumberOfIds() != points.count)
    {
      nearest->SetNumberOfIds(points.count);
      vtkIdType* ids = nearest->GetPointer(0);
      fillItems(points.count, points.control,
        [&](Offset vertex) { ids[vertex] = Corners(points.placeOf(vertex)).nearestPoint(); });
    }
    if (!points.control.cancelled())
    {
      array.source->GetTuples(nearest, array.target);
    }
  }
}

void carryPointArrays(const DiagramSource& source, const std::vector<SurfaceLocation>& places,
  vtkPolyData* output, LostArrays& lost)
{
  const auto placeOf = [&](Offset vertex) -> InputPlace
  {
    const SurfaceLocation& place = places[vertex];
    return { source.prepared.inputMesh().facetInputPoints[source.prepared.inputFacet(place.facet)],
      source.prepared.inputPlace(place.facet, place.b) };
  };
  const PlacedPoints points{ static_cast<Offset>(places.size()), placeOf, source.control };
  carryPointArrays(
    source.input, OwnArrays{ meshPointNames, source.prepared.usedArrays }, points, output, lost);
}
}
