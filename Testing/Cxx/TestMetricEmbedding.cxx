// vtkMetricEmbedding: the remesher's own embedding, lengths, carried arrays and seams, borders,
// components, a Moebius strip, blocks, warnings, errors, threads.

#include "TestMetrics.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

using namespace remesh;
using namespace remesh::test;

namespace
{
/** A layer across the square: 0.2 along it, from 0.01 on across it. */
Eigen::Matrix3d layer(const Point3& p)
{
  const double size = std::min(0.2, 0.01 + 0.3 * std::abs(p[0] - 0.5));
  return Point3(1.0 / (size * size), 25.0, 1.0).asDiagonal();
}

/** Twice as long along x as along y at one side, and the other way round at the other. */
Eigen::Matrix3d gentle(const Point3& p)
{
  return Point3(1.0 + 3.0 * p[0], 4.0 - 3.0 * p[0], 1.0).asDiagonal();
}

vtkSmartPointer<vtkPolyData> square(int n, const Tensor& tensor)
{
  auto input = polyDataOf(gridPatch(n, n));
  addMetric(input, tensor);
  return input;
}

double fact(vtkPolyData* mesh, const char* name)
{
  return arrayOf(mesh->GetFieldData(), name)->GetComponent(0, 0);
}

/** The share of edges whose length in R^d is within a factor of sqrt 2 of the mean. */
double evenShare(vtkPolyData* mesh)
{
  const auto places = arrayOf(mesh->GetPointData(), "Embedding");
  std::vector<double> logarithms;
  double sum = 0.0;
  forEachSide(mesh,
    [&](vtkIdType p, vtkIdType q)
    {
      double squared = 0.0;
      for (int c = 0; c < places->GetNumberOfComponents(); ++c)
      {
        squared += std::pow(places->GetComponent(q, c) - places->GetComponent(p, c), 2);
      }
      logarithms.push_back(0.5 * std::log(squared));
      sum += logarithms.back();
    });
  const double mean = sum / static_cast<double>(logarithms.size());
  const auto within = std::count_if(logarithms.begin(), logarithms.end(),
    [&](double length) { return std::abs(length - mean) < 0.5 * std::log(2.0); });
  return static_cast<double>(within) / static_cast<double>(logarithms.size());
}

/**
 * What the remesher makes of a metric, and of this filter's embedding of it: where no triangle is
 * split, the same mesh; else the triangles come in another order, and the mesh is as good.
 */
void testRemeshing()
{
  for (const bool refines : { false, true })
  {
    const auto input = refines ? square(20, layer) : square(90, gentle);
    vtkNew<vtkAnisotropicRemesher> remesher;
    remesher->SetInputData(input);
    remesher->SetNumberOfPoints(500);
    // The fit holds vertices in place for embeddings of the caller's own, and less for metrics.
    remesher->SetVertexPlacement(vtkAnisotropicRemesher::CENTROID);
    remesher->SetMetricArray("Metric");
    remesher->Update();
    vtkNew<vtkPolyData> direct;
    direct->DeepCopy(remesher->GetOutput());
    const auto filter = embeddingOf(input, 500);
    filter->Update();
    CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints() > input->GetNumberOfPoints(), refines);
    remesher->SetMetricArray(nullptr);
    remesher->SetEmbeddingArray("Embedding");
    remesher->SetInputConnection(filter->GetOutputPort());
    Messages messages(remesher);
    remesher->Update();
    CHECK(messages.warnings().empty());
    vtkPolyData* mesh = remesher->GetOutput();
    if (refines)
    {
      CHECK_NEAR(evenShare(mesh), evenShare(direct), 0.005);
      CHECK(evenShare(mesh) > 0.99);
    }
    else
    {
      CHECK(bytesOf(mesh->GetPolys()->GetConnectivityArray()) ==
        bytesOf(direct->GetPolys()->GetConnectivityArray()));
      for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
      {
        CHECK(pointOf(mesh, p) == pointOf(direct, p));
      }
    }
    for (const char* name : { "MetricUnit", "MetricLimit", "MetricShare" })
    {
      CHECK_EQUAL(fact(direct, name), fact(filter->GetOutput(), name));
    }
    CHECK_NEAR(fact(filter->GetOutput(), "MetricPoints") / 500.0, 1.0, 0.15);
  }
}

/** Edges are as long as in the limited metric, and the stretches tell by how much they are not. */
void testLengths()
{
  const auto filter = embeddingOf(square(20, layer), 500);
  filter->SetDimension(4);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  const auto places = arrayOf(output->GetPointData(), "Embedding");
  const auto limited = arrayOf(output->GetPointData(), "LimitedMetric");
  const auto least = arrayOf(output->GetCellData(), "LeastStretch");
  const auto largest = arrayOf(output->GetCellData(), "LargestStretch");
  CHECK_EQUAL(places->GetNumberOfComponents(), 4);
  const auto tensorAt = [&](vtkIdType p)
  {
    const auto at = [&](int k) { return limited->GetComponent(p, k); };
    Eigen::Matrix3d tensor;
    tensor << at(0), at(3), at(5), at(3), at(1), at(4), at(5), at(4), at(2);
    return tensor;
  };
  int wrong = 0;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    output->GetCellPoints(cell, ids);
    const Eigen::Matrix3d mean =
      (tensorAt(ids->GetId(0)) + tensorAt(ids->GetId(1)) + tensorAt(ids->GetId(2))) / 3.0;
    for (int k = 0; k < 3; ++k)
    {
      const vtkIdType p = ids->GetId(k);
      const vtkIdType q = ids->GetId((k + 1) % 3);
      const Point3 edge = pointOf(output, q) - pointOf(output, p);
      double squared = 0.0;
      for (int c = 0; c < 4; ++c)
      {
        squared += std::pow(places->GetComponent(q, c) - places->GetComponent(p, c), 2);
      }
      const double stretch = std::sqrt(squared / edge.dot(mean * edge));
      wrong += stretch < 0.999 * least->GetComponent(cell, 0) ||
        stretch > 1.001 * largest->GetComponent(cell, 0);
    }
  }
  CHECK_EQUAL(wrong, 0);
  const auto quantiles = arrayOf(output->GetFieldData(), "StretchQuantiles");
  CHECK_EQUAL(quantiles->GetNumberOfTuples(), 5);
  CHECK_EQUAL(quantiles->GetComponent(2, 0), 0.5);
  for (int k = 1; k < 5; ++k)
  {
    CHECK(quantiles->GetComponent(k, 1) >= quantiles->GetComponent(k - 1, 1));
    CHECK(quantiles->GetComponent(k, 2) >= quantiles->GetComponent(k, 1));
  }
  CHECK(quantiles->GetComponent(1, 1) > 0.9 && quantiles->GetComponent(3, 2) < 1.1);
}

/** Points keep their ids; new ones are between them; labels and seams stay. */
void testArrays()
{
  const auto input = square(20, layer);
  input->GetPoints()->InsertNextPoint(9.0, 9.0, 9.0); // of no polygon
  input->GetPointData()->Initialize();
  addMetric(input, layer);
  addPointArray<vtkDoubleArray>(input, "Height", 1, [](const Point3& p, int) { return p[0]; });
  addPointArray<vtkIntArray>(input, "Side", 1, [](const Point3& p, int) { return p[0] > 0.5; });
  vtkNew<vtkIntArray> label;
  label->SetName("Label");
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    label->InsertNextValue(static_cast<int>(cell));
  }
  input->GetCellData()->AddArray(label);
  const auto filter = embeddingOf(input, 500);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  CHECK(output->GetNumberOfPoints() > input->GetNumberOfPoints());
  for (vtkIdType p = 0; p < input->GetNumberOfPoints(); ++p)
  {
    CHECK(pointOf(output, p) == pointOf(input, p));
  }
  const auto height = arrayOf(output->GetPointData(), "Height");
  const auto side = arrayOf(output->GetPointData(), "Side");
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    CHECK_NEAR(height->GetComponent(p, 0), pointOf(output, p)[0], 1e-12);
    CHECK(side->GetComponent(p, 0) == 0.0 || side->GetComponent(p, 0) == 1.0);
  }
  const auto labels = arrayOf(output->GetCellData(), "Label");
  CHECK_EQUAL(labels->GetNumberOfTuples(), output->GetNumberOfCells());
  double area = 0.0;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    output->GetCellPoints(cell, ids);
    const Point3 a = pointOf(output, ids->GetId(0));
    const Point3 middle =
      (a + pointOf(output, ids->GetId(1)) + pointOf(output, ids->GetId(2))) / 3.0;
    area +=
      0.5 * (pointOf(output, ids->GetId(1)) - a).cross(pointOf(output, ids->GetId(2)) - a).norm();
    double box[6];
    input->GetCellBounds(static_cast<vtkIdType>(labels->GetComponent(cell, 0)), box);
    CHECK(middle[0] > box[0] && middle[0] < box[1] && middle[1] > box[2] && middle[1] < box[3]);
  }
  CHECK_NEAR(area, 1.0, 1e-12);
  const vtkIdType unused = input->GetNumberOfPoints() - 1;
  CHECK_EQUAL(arrayOf(output->GetPointData(), "Embedding")->GetComponent(unused, 0), 0.0);
}

/** Two halves whose points coincide along a line, with other values: split triangles keep both. */
void testSeams()
{
  TriangleSoup soup = gridPatch(20, 20);
  TriangleSoup other = soup;
  const auto count = static_cast<Offset>(soup.points.size());
  for (Point3& p : other.points)
  {
    p[1] = -p[1];
    soup.points.push_back(p);
  }
  for (const auto& [a, b, c] : other.triangles)
  {
    soup.triangles.push_back({ a + count, c + count, b + count });
    soup.inputCells.push_back(static_cast<Offset>(soup.inputCells.size()));
  }
  const auto input = polyDataOf(soup);
  addMetric(input, layer);
  vtkNew<vtkDoubleArray> half;
  half->SetName("Half");
  for (vtkIdType p = 0; p < input->GetNumberOfPoints(); ++p)
  {
    half->InsertNextValue(p < count ? 1.0 : -1.0);
  }
  input->GetPointData()->AddArray(half);
  const auto filter = embeddingOf(input, 500);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  const auto halves = arrayOf(output->GetPointData(), "Half");
  const auto places = arrayOf(output->GetPointData(), "Embedding");
  std::map<double, vtkIdType> onSeam[2];
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    const double value = halves->GetComponent(p, 0);
    CHECK(value == 1.0 || value == -1.0);
    if (pointOf(output, p)[1] == 0.0)
    {
      onSeam[value > 0.0][pointOf(output, p)[0]] = p;
    }
  }
  CHECK(onSeam[0].size() > 21 && onSeam[0].size() == onSeam[1].size());
  for (const auto& [x, p] : onSeam[0])
  {
    CHECK(onSeam[1].count(x) == 1);
    CHECK_EQUAL(places->GetComponent(p, 0), places->GetComponent(onSeam[1][x], 0));
  }
}

/** A strip with a half twist, two components, and a surface that meets itself in an edge. */
void testKinds()
{
  TriangleSoup moebius = gridPatch(120, 12);
  for (Point3& p : moebius.points)
  {
    const bool isEnd = p[0] == 1.0;
    const double angle = isEnd ? 0.0 : 2.0 * pi * p[0];
    const double across = (isEnd ? -1.0 : 1.0) * (p[1] - 0.5);
    const double r = 2.0 + across * std::cos(0.5 * angle);
    p = { r * std::cos(angle), r * std::sin(angle), across * std::sin(0.5 * angle) };
  }
  TriangleSoup two = icosphere(3);
  const auto count = static_cast<Offset>(two.points.size());
  const TriangleSoup patch = gridPatch(20, 20);
  for (const Point3& p : patch.points)
  {
    two.points.emplace_back(p + Point3(5.0, 0.0, 0.0));
  }
  for (const auto& [a, b, c] : patch.triangles)
  {
    two.triangles.push_back({ a + count, b + count, c + count });
    two.inputCells.push_back(static_cast<Offset>(two.inputCells.size()));
  }
  TriangleSoup leaves = gridPatch(20, 20); // a third leaf on its left border
  const TriangleSoup leaf = leaves;
  const auto before = static_cast<Offset>(leaves.points.size());
  for (const Point3& p : leaf.points)
  {
    leaves.points.emplace_back(-0.5 * p[0], p[1], 0.5 * p[0]);
  }
  for (const Point3& p : leaf.points)
  {
    leaves.points.emplace_back(-0.5 * p[0], p[1], -0.5 * p[0]);
  }
  for (const Offset shift : { before, 2 * before })
  {
    for (const auto& [a, b, c] : leaf.triangles)
    {
      leaves.triangles.push_back({ a + shift, b + shift, c + shift });
      leaves.inputCells.push_back(static_cast<Offset>(leaves.inputCells.size()));
    }
  }
  const auto even = [](const Point3& p) -> Eigen::Matrix3d
  { return (4.0 + std::sin(p[1])) * Eigen::Matrix3d::Identity(); };
  for (const TriangleSoup& soup : { moebius, two, leaves })
  {
    const auto input = polyDataOf(soup);
    addMetric(input, even);
    const auto filter = embeddingOf(input, 100);
    Messages messages(filter);
    filter->Update();
    CHECK(messages.errors().empty());
    CHECK(messages.warnings().empty());
    CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), input->GetNumberOfPoints());
    const auto quantiles = arrayOf(filter->GetOutput()->GetFieldData(), "StretchQuantiles");
    check(quantiles->GetComponent(1, 1) > 0.9 && quantiles->GetComponent(3, 2) < 1.1, __FILE__,
      __LINE__, "stretch " + std::to_string(quantiles->GetComponent(1, 1)));
  }
}

/** The number of points that edges of the length 1 need is that of the remesher. */
void testUnit()
{
  const auto input = square(40, layer);
  for (const double complexity : { 0.0, 300.0 })
  {
    const auto filter = embeddingOf(input, 7);
    filter->UnitEdgesOn();
    filter->SetMetricComplexity(complexity);
    filter->Update();
    vtkNew<vtkAnisotropicRemesher> remesher;
    remesher->SetInputData(input);
    remesher->SetMetricArray("Metric");
    remesher->UnitEdgesOn();
    remesher->SetMetricComplexity(complexity);
    remesher->SetNumberOfNewtonIterations(5);
    remesher->Update();
    CHECK_NEAR(fact(filter->GetOutput(), "MetricPoints"),
      static_cast<double>(remesher->GetOutput()->GetNumberOfPoints()), 1.0);
    CHECK_EQUAL(fact(filter->GetOutput(), "MetricUnit"), fact(remesher->GetOutput(), "MetricUnit"));
  }
}

/** Each block gets its own triangles and arrays. */
void testBlocks()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  const auto first = square(20, layer);
  const auto second = square(20, layer);
  for (vtkIdType p = 0; p < second->GetNumberOfPoints(); ++p)
  {
    const Point3 place = pointOf(second, p);
    second->GetPoints()->SetPoint(p, place[0], place[1] - 1.0, 0.0);
  }
  blocks->SetBlock(0, first);
  blocks->SetBlock(1, second);
  const auto filter = embeddingOf(blocks, 800);
  filter->Update();
  const auto output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  for (unsigned int k = 0; k < 2; ++k)
  {
    const auto block = vtkPolyData::SafeDownCast(output->GetBlock(k));
    CHECK(block && block->GetNumberOfCells() > first->GetNumberOfCells());
    CHECK(
      block->GetPointData()->HasArray("Embedding") && block->GetPointData()->HasArray("Metric"));
    CHECK(block->GetCellData()->HasArray("LargestStretch"));
    double box[6];
    block->GetBounds(box);
    CHECK_EQUAL(box[2], k == 0 ? 0.0 : -1.0);
    CHECK_EQUAL(box[3], k == 0 ? 1.0 : 0.0);
  }
}

void checkError(vtkMetricEmbedding* filter, const char* part, int line)
{
  Messages messages(filter);
  filter->Update();
  const auto& errors = messages.errors();
  check(errors.size() == 1 && errors[0].find(part) != std::string::npos, __FILE__, line,
    std::string(part) + ": " + (errors.empty() ? "none" : errors[0]));
  CHECK(outputsAreEmpty(filter));
}

void testErrors()
{
  const auto at = [](const Point3& p, double value)
  { return Point3(p[0] > 0.55 ? value : 1.0, 1.0, 1.0); };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto fails = [](const Tensor& tensor, const char* part, int line)
  { checkError(embeddingOf(square(10, tensor), 50), part, line); };
  fails([&](const Point3& p) -> Eigen::Matrix3d { return at(p, -1.0).asDiagonal(); },
    "\"Metric\" is not positive definite along the surface at point 6.", __LINE__);
  fails([&](const Point3& p) -> Eigen::Matrix3d { return at(p, nan).asDiagonal(); },
    "\"Metric\" is not finite at point 6.", __LINE__);
  fails(
    [](const Point3& p) -> Eigen::Matrix3d
    {
      Eigen::Matrix3d tensor = Eigen::Matrix3d::Identity();
      tensor(0, 1) = p[0] > 0.55 ? 0.5 : 0.0;
      return tensor;
    },
    "\"Metric\" is not symmetric at point 6.", __LINE__);
  const auto filter = embeddingOf(square(10, gentle), 50);
  filter->SetMetricArray("Absent");
  checkError(filter, "no numeric point array \"Absent\", chosen as the metric.", __LINE__);
  for (const char* none : { "None", "" })
  {
    filter->SetMetricArray(none);
    checkError(filter, "There is no metric to embed: choose a MetricArray.", __LINE__);
  }
}

/** A metric that turns far faster than the surface's triangles. */
void testWarning()
{
  const auto noise = [](const Point3& p) -> Eigen::Matrix3d
  {
    const double angle = 100.0 * std::sin(37.0 * p[0] + 91.0 * p[1]);
    const Point3 a(std::cos(angle), std::sin(angle), 0.0);
    return Eigen::Matrix3d::Identity() + 1e4 * a * a.transpose();
  };
  const auto filter = embeddingOf(square(20, noise), 100);
  filter->RefineOff();
  Messages messages(filter);
  filter->Update();
  CHECK_EQUAL(messages.warnings().size(), 1u);
  CHECK(!messages.warnings().empty() &&
    messages.warnings()[0].find("The metric is met on") != std::string::npos);
  CHECK(fact(filter->GetOutput(), "MetricShare") < 0.9);
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 441);
}

void testThreads()
{
  const auto input = square(60, layer);
  std::vector<Content> contents;
  for (const int backend : { vtkMetricEmbedding::SMP_SEQUENTIAL, vtkMetricEmbedding::SMP_STDTHREAD,
         vtkMetricEmbedding::SMP_AUTOMATIC })
  {
    const auto filter = embeddingOf(input, 3000);
    filter->SetSMPBackend(backend);
    filter->Update();
    contents.push_back(contentOf(filter->GetOutput()));
    CHECK(contents.back() == contents.front());
  }
}
}

int TestMetricEmbedding(int, char*[])
{
  testRemeshing();
  testLengths();
  testArrays();
  testSeams();
  testKinds();
  testUnit();
  testBlocks();
  testErrors();
  testWarning();
  testThreads();
  return result();
}
