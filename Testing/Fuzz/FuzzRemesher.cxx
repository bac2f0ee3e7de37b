// The whole filter on small, nasty surfaces: valid outputs, or one error in words.

#include "FuzzSupport.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{
using Algorithm = vtkAnisotropicRemesher;

void collect(vtkObject* object, unsigned long event, std::vector<std::string>& texts)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&texts);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* list, void* text) {
      static_cast<std::vector<std::string>*>(list)->emplace_back(static_cast<const char*>(text));
    });
  object->AddObserver(event, command);
}

double sumOf(vtkPointData* data, const char* name)
{
  vtkDataArray* array = data->GetArray(name);
  FUZZ_CHECK(array != nullptr);
  double sum = 0.0;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    FUZZ_CHECK(array->GetComponent(i, 0) >= 0.0);
    sum += array->GetComponent(i, 0);
  }
  return sum;
}

/** All finite, all ids in range. */
void checkPolyData(vtkPolyData* data)
{
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double p[3];
    data->GetPoint(i, p);
    FUZZ_CHECK(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]));
  }
  for (vtkCellArray* cells : { data->GetVerts(), data->GetLines(), data->GetPolys() })
  {
    vtkDataArray* ids = cells->GetConnectivityArray();
    for (vtkIdType k = 0; k < ids->GetNumberOfTuples(); ++k)
    {
      FUZZ_CHECK(
        ids->GetComponent(k, 0) >= 0 && ids->GetComponent(k, 0) < data->GetNumberOfPoints());
    }
  }
  for (vtkFieldData* arrays : { static_cast<vtkFieldData*>(data->GetPointData()),
         static_cast<vtkFieldData*>(data->GetCellData()) })
  {
    for (int k = 0; k < arrays->GetNumberOfArrays(); ++k)
    {
      vtkDataArray* array = arrays->GetArray(k);
      for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
      {
        for (int c = 0; c < array->GetNumberOfComponents(); ++c)
        {
          FUZZ_CHECK(std::isfinite(array->GetComponent(i, c)));
        }
      }
    }
  }
}

double fact(vtkAnisotropicRemesher* filter, const char* name)
{
  vtkDataArray* array = filter->GetOutput()->GetFieldData()->GetArray(name);
  FUZZ_CHECK(array != nullptr && array->GetNumberOfTuples() == 1);
  return array->GetComponent(0, 0);
}

/** What the field data tell of the mesh, counted. */
void checkFacts(vtkAnisotropicRemesher* filter)
{
  vtkPolyData* mesh = filter->GetOutput();
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges;
  std::set<vtkIdType> used;
  vtkNew<vtkIdList> corners;
  for (vtkIdType t = 0; t < mesh->GetNumberOfCells(); ++t)
  {
    mesh->GetCellPoints(t, corners);
    for (int k = 0; k < 3; ++k)
    {
      used.insert(corners->GetId(k));
      ++edges[std::minmax(corners->GetId(k), corners->GetId((k + 1) % 3))];
    }
  }
  const auto nonManifold =
    std::count_if(edges.begin(), edges.end(), [](const auto& edge) { return edge.second > 2; });
  const auto euler = static_cast<double>(used.size()) - static_cast<double>(edges.size()) +
    static_cast<double>(mesh->GetNumberOfCells());
  FUZZ_CHECK(fact(filter, "NumberOfNonManifoldEdges") == static_cast<double>(nonManifold));
  FUZZ_CHECK(fact(filter, "EulerCharacteristic") == euler);
  const bool preserved = fact(filter, "TopologyPreserved") == 1.0;
  FUZZ_CHECK(preserved == std::string(filter->GetTopologyReport()).empty());
  FUZZ_CHECK(!preserved ||
    (nonManifold == 0 && static_cast<vtkIdType>(used.size()) == mesh->GetNumberOfPoints()));
  const double flipped = fact(filter, "NumberOfFlippedTriangles");
  FUZZ_CHECK(flipped >= 0.0 && flipped <= static_cast<double>(mesh->GetNumberOfCells()));
  vtkFieldData* facts = mesh->GetFieldData(); // no distances of a mesh without area
  FUZZ_CHECK(!facts->HasArray("MaximumDistance") == !facts->HasArray("RMSDistance"));
  FUZZ_CHECK(!facts->HasArray("MaximumDistance") ||
    (fact(filter, "MaximumDistance") >= 0.0 && fact(filter, "RMSDistance") >= 0.0));
}

void checkOutputs(vtkAnisotropicRemesher* filter, vtkIdType sites)
{
  for (const int port :
    { Algorithm::SURFACE, Algorithm::VORONOI_CELLS, Algorithm::SITES, Algorithm::EDGES })
  {
    checkPolyData(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(port)));
  }
  vtkDataArray* merged = filter->GetSitesOutput()->GetPointData()->GetArray("MergedSiteId");
  std::set<double> vertices;
  for (vtkIdType i = 0; i < merged->GetNumberOfTuples(); ++i)
  {
    vertices.insert(merged->GetComponent(i, 0));
    FUZZ_CHECK(merged->GetComponent(i, 0) <= static_cast<double>(i));
  }
  if (!filter->GetPreserveFeatures() && filter->GetDistanceTolerance() == 0.0)
  {
    const vtkIdType added = static_cast<vtkIdType>(vertices.size()) - sites;
    const vtkIdType most = filter->GetMaximumNumberOfExtraPoints(); // one percent is none
    FUZZ_CHECK(
      added >= 0 && (most == Algorithm::UNLIMITED || added <= std::max(most, vtkIdType(0))));
  }
  checkFacts(filter);
  for (const char* name : { "CellArea", "CellMass", "CellEnergy" })
  {
    const double total = sumOf(filter->GetSitesOutput()->GetPointData(), name);
    const double overMesh = sumOf(filter->GetOutput()->GetPointData(), name);
    FUZZ_CHECK(std::abs(total - overMesh) <= 1e-12 * total);
  }
  // The energy never rises.
  vtkDataArray* energy =
    vtkDataArray::SafeDownCast(filter->GetConvergenceOutput()->GetColumnByName("Energy"));
  for (vtkIdType k = 1; k < energy->GetNumberOfTuples(); ++k)
  {
    const double before = energy->GetComponent(k - 1, 0);
    FUZZ_CHECK(energy->GetComponent(k, 0) <= before * (1.0 + 1e-12) + 1e-300);
  }
}

/** What is not as it was asked for is told. */
void checkWarnings(
  vtkAnisotropicRemesher* filter, vtkIdType sites, const std::vector<std::string>& warnings)
{
  vtkPolyData* mesh = filter->GetOutput();
  if (filter->GetDistanceTolerance() > 0.0)
  {
    double bounds[6];
    filter->GetPolyDataInput(0)->GetBounds(bounds); // points of no cell count here
    const double diagonal =
      std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
    FUZZ_CHECK(!warnings.empty() || !mesh->GetFieldData()->HasArray("MaximumDistance") ||
      fact(filter, "MaximumDistance") <= filter->GetDistanceTolerance() * diagonal * (1.0 + 1e-9));
  }
  else if (filter->GetPreserveFeatures())
  {
    const vtkIdType most = filter->GetMaximumNumberOfExtraPoints(); // one percent is none
    FUZZ_CHECK(!warnings.empty() || most == Algorithm::UNLIMITED ||
      mesh->GetNumberOfPoints() <= sites + std::max(most, vtkIdType(0)));
  }
}

bool outputsAreEmpty(vtkAnisotropicRemesher* filter)
{
  return filter->GetOutput()->GetNumberOfPoints() == 0 &&
    filter->GetVoronoiCellsOutput()->GetNumberOfPoints() == 0 &&
    filter->GetSitesOutput()->GetNumberOfPoints() == 0 &&
    filter->GetEdgesOutput()->GetNumberOfPoints() == 0 &&
    filter->GetConvergenceOutput()->GetNumberOfRows() == 0;
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Bytes bytes(data, size);
  const double anisotropies[5] = { 0.0, 0.04, 0.2, 1.0, 1e-9 };
  const vtkIdType sites = 4 + bytes.below(30);
  vtkNew<vtkAnisotropicRemesher> filter;
  filter->SetNumberOfPoints(sites);
  filter->SetAnisotropy(anisotropies[bytes.below(5)]);
  filter->SetNumberOfLloydIterations(bytes.below(4));
  filter->SetNumberOfNewtonIterations(bytes.below(4));
  filter->SetSamplingMethod(bytes.below(2));
  filter->SetPreserveFeatures(bytes.below(4) > 0);
  filter->SetFeatureAngle(bytes.below(2) > 0 ? 35.0 : 90.0);
  filter->SetSeed(bytes.below(256));
  filter->SetMergeTolerance(bytes.below(4) == 0 ? 0.05 : 0.0);
  filter->SetVertexPlacement(bytes.below(8)); // the default from 3
  filter->SetMaximumNumberOfExtraPoints(bytes.below(4) - 2);
  filter->SetNormalSmoothingPasses(bytes.below(4) - 1);
  filter->SetDistanceTolerance(bytes.below(16) == 0 ? 0.05 : 0.0);
  filter->SetMaximumNumberOfPoints(60);
  filter->SetInputData(fuzz::polyData(bytes, 24, 32, bytes.below(8) == 0));

  std::vector<std::string> errors;
  std::vector<std::string> warnings;
  std::vector<std::string> fromExecutive;
  collect(filter, vtkCommand::ErrorEvent, errors);
  collect(filter, vtkCommand::WarningEvent, warnings);
  collect(filter->GetExecutive(), vtkCommand::ErrorEvent, fromExecutive);
  filter->Update();
  if (!errors.empty())
  {
    FUZZ_CHECK(errors.size() == 1 && errors[0].size() > 20);
    FUZZ_CHECK(fromExecutive.size() == 1);
  }
  if (!errors.empty() || filter->GetSitesOutput()->GetNumberOfPoints() == 0)
  {
    FUZZ_CHECK(outputsAreEmpty(filter));
    return 0;
  }
  FUZZ_CHECK(fromExecutive.empty());
  checkOutputs(filter, sites);
  checkWarnings(filter, sites, warnings);
  return 0;
}
