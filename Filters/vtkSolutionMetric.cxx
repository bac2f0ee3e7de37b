#include "vtkSolutionMetric.h"

#include "Adaptors/ParameterCheck.h"
#include "Adaptors/SolutionMetricInput.h"

#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <string>
#include <vector>

vtkStandardNewMacro(vtkSolutionMetric);

/** Names of arrays, in the order in which they were added. */
struct vtkSolutionMetric::vtkNames
{
  using List = std::vector<std::string>;
  List Solutions;
  List Hessians;
  List Metrics;

  static const char* At(const List& list, int index)
  {
    const bool isThere = index >= 0 && index < static_cast<int>(list.size());
    return isThere ? list[index].c_str() : nullptr;
  }

  static bool Add(vtkSolutionMetric* self, List& list, const char* name)
  {
    if (name && *name)
    {
      list.emplace_back(name);
      self->Modified();
    }
    return name && *name;
  }

  static void Clear(vtkSolutionMetric* self, List& list)
  {
    if (!list.empty())
    {
      list.clear();
      self->Modified();
    }
  }

  static void Print(ostream& os, vtkIndent indent, const char* title, const List& list)
  {
    os << indent << title << ": " << list.size() << "\n";
    for (const std::string& name : list)
    {
      os << indent.GetNextIndent() << name << "\n";
    }
  }
};

vtkSolutionMetric::vtkSolutionMetric()
  : Names(new vtkNames)
{
}

vtkSolutionMetric::~vtkSolutionMetric()
{
  this->SetDistanceArray(nullptr);
}

#define vtkSolutionMetricListMacro(kind)                                                           \
  void vtkSolutionMetric::Add##kind##Array(const char* name)                                       \
  {                                                                                                \
    if (!vtkNames::Add(this, this->Names->kind##s, name))                                          \
    {                                                                                              \
      vtkErrorMacro("An array needs a name.");                                                     \
    }                                                                                              \
  }                                                                                                \
  void vtkSolutionMetric::Clear##kind##Arrays()                                                    \
  {                                                                                                \
    vtkNames::Clear(this, this->Names->kind##s);                                                   \
  }                                                                                                \
  int vtkSolutionMetric::GetNumberOf##kind##Arrays() const                                         \
  {                                                                                                \
    return static_cast<int>(this->Names->kind##s.size());                                          \
  }                                                                                                \
  const char* vtkSolutionMetric::Get##kind##ArrayName(int index) const                             \
  {                                                                                                \
    return vtkNames::At(this->Names->kind##s, index);                                              \
  }

vtkSolutionMetricListMacro(Solution);
vtkSolutionMetricListMacro(Hessian);
vtkSolutionMetricListMacro(Metric);

bool vtkSolutionMetric::HasDistanceArray() const
{
  const std::string name = this->DistanceArray ? this->DistanceArray : "";
  return !name.empty() && name != "None";
}

bool vtkSolutionMetric::IsAnythingChosen() const
{
  return !this->Names->Solutions.empty() || !this->Names->Hessians.empty() ||
    !this->Names->Metrics.empty() || this->HasDistanceArray() || this->ChordTolerance > 0.0;
}

remesh::Status vtkSolutionMetric::CheckParameters()
{
  remesh::ParameterCheck check;
  check.within("MetricOrder", this->MetricOrder, METRIC_VTK, METRIC_SOL)
    .within("ErrorNorm", this->ErrorNorm, L1, MAXIMUM)
    .within("NumberOfPoints", this->NumberOfPoints, 1, VTK_ID_MAX)
    .within("MinimumSize", this->MinimumSize, 0.0, VTK_DOUBLE_MAX)
    .within("MaximumSize", this->MaximumSize, 0.0, VTK_DOUBLE_MAX)
    .within("MaximumRatio", this->MaximumRatio, 1.0, 1e6)
    .within("ChordTolerance", this->ChordTolerance, 0.0, VTK_DOUBLE_MAX)
    .within("DistanceSize", this->DistanceSize, 0.0, VTK_DOUBLE_MAX)
    .within("DistanceGrowth", this->DistanceGrowth, 0.0, VTK_DOUBLE_MAX);
  if (this->MaximumSize > 0.0)
  {
    check.within("MinimumSize", this->MinimumSize, 0.0, this->MaximumSize);
  }
  if (!check.status().ok())
  {
    return check.status();
  }
  if (this->HasDistanceArray() && !(this->DistanceSize > 0.0))
  {
    return remesh::Status::invalid(
      "DistanceSize must be above 0 where there is a distance array, but is 0.");
  }
  return remesh::Status::success();
}

remesh::Status vtkSolutionMetric::AddField(remesh::FieldSurface& surface)
{
  remesh::SolutionMetricArrays arrays;
  arrays.solutions = this->Names->Solutions;
  if (!this->IsAnythingChosen())
  {
    vtkDataArray* active = surface.input->GetPointData()->GetScalars();
    if (!active || !active->GetName())
    {
      return remesh::Status::invalid(
        "There is nothing to make a metric from: choose a solution, a Hessian, a metric, a "
        "distance, or a ChordTolerance above 0, or give points active scalars.");
    }
    arrays.solutions.emplace_back(active->GetName());
  }
  arrays.hessians = this->Names->Hessians;
  arrays.metrics = this->Names->Metrics;
  arrays.order = static_cast<remesh::TensorOrder>(this->MetricOrder);
  arrays.distance = this->HasDistanceArray() ? this->DistanceArray : "";
  arrays.distanceSize = this->DistanceSize;
  arrays.distanceGrowth = this->DistanceGrowth;
  remesh::SolutionMetricOptions options;
  options.norm = static_cast<remesh::ErrorNorm>(this->ErrorNorm);
  options.numberOfPoints = static_cast<double>(this->NumberOfPoints);
  options.minimumSize = this->MinimumSize;
  options.maximumSize = this->MaximumSize;
  options.maximumRatio = this->MaximumRatio;
  options.chordTolerance = this->ChordTolerance;
  return remesh::addSolutionMetric(surface, arrays, options);
}

void vtkSolutionMetric::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  vtkNames::Print(os, indent, "SolutionArrays", this->Names->Solutions);
  vtkNames::Print(os, indent, "HessianArrays", this->Names->Hessians);
  vtkNames::Print(os, indent, "MetricArrays", this->Names->Metrics);
  os << indent << "MetricOrder: " << this->MetricOrder << "\n";
  os << indent << "ErrorNorm: " << this->ErrorNorm << "\n";
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
  os << indent << "MinimumSize: " << this->MinimumSize << "\n";
  os << indent << "MaximumSize: " << this->MaximumSize << "\n";
  os << indent << "MaximumRatio: " << this->MaximumRatio << "\n";
  os << indent << "ChordTolerance: " << this->ChordTolerance << "\n";
  os << indent << "DistanceArray: " << (this->DistanceArray ? this->DistanceArray : "(none)")
     << "\n";
  os << indent << "DistanceSize: " << this->DistanceSize << "\n";
  os << indent << "DistanceGrowth: " << this->DistanceGrowth << "\n";
}
