// vtkGaussMapEmbedding: values by formula, and the same mesh from its output.

#include "TestBytes.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkGaussMapEmbedding.h"

#include "vtkFloatArray.h"

using namespace remesh;
using namespace remesh::test;

namespace
{
vtkSmartPointer<vtkPolyData> embed(vtkGaussMapEmbedding* filter, vtkPolyData* input)
{
  filter->SetInputData(input);
  filter->Update();
  return filter->GetOutput();
}

vtkDataArray* embeddingOf(vtkPolyData* data)
{
  vtkDataArray* array = data->GetPointData()->GetArray("Embedding");
  CHECK(array != nullptr);
  CHECK_EQUAL(array->GetNumberOfTuples(), data->GetNumberOfPoints());
  CHECK_EQUAL(std::string(array->GetClassName()), "vtkDoubleArray");
  return array;
}

/** A sphere of radius 2 with its own normals, of any length. */
vtkSmartPointer<vtkPolyData> sphereWithNormals(const char* name)
{
  TriangleSoup soup = icosphere(2);
  for (Point3& point : soup.points)
  {
    point = 2.0 * point + Point3(1, 2, 3);
  }
  auto data = polyDataOf(soup);
  addPointArray<vtkDoubleArray>(data, name, 3,
    [](const Point3& p, int c) { return (c == 2 ? 7.0 : 3.0) * (p - Point3(1, 2, 3))[c]; });
  return data;
}

/** (x, y, z, s n), s = Anisotropy times the diagonal, for the given normals. */
void testFormula()
{
  for (const bool active : { true, false })
  {
    const auto input = sphereWithNormals("N");
    vtkNew<vtkGaussMapEmbedding> filter;
    filter->SetAnisotropy(0.07);
    if (active)
    {
      input->GetPointData()->SetActiveNormals("N");
    }
    else
    {
      filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "N");
    }
    const auto output = embed(filter, input);
    double bounds[6];
    input->GetBounds(bounds);
    const double diagonal =
      Point3(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]).norm();
    vtkDataArray* array = embeddingOf(output);
    CHECK_EQUAL(array->GetNumberOfComponents(), 6);
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      Point3 n;
      input->GetPointData()->GetArray("N")->GetTuple(i, n.data());
      n.normalize();
      for (int c = 0; c < 3; ++c)
      {
        CHECK_EQUAL(array->GetComponent(i, c), pointOf(input, i)[c]);
        CHECK_NEAR(array->GetComponent(i, 3 + c), 0.07 * diagonal * n[c], 1e-15);
      }
    }
    // Geometry and arrays are the input's.
    Content rest = contentOf(output);
    rest.erase("point Embedding");
    checkSame(rest, contentOf(input), "what is not the embedding");
  }
}

/** Arrays chosen as the active ones of a type: what their names give. */
void testAttributes()
{
  const int points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  const auto input = sphereWithNormals("N");
  addPointArray<vtkDoubleArray>(
    input, "V", 3, [](const Point3& p, int c) { return p[c] + (c == 1 ? 0.5 : 0.0); });
  vtkNew<vtkGaussMapEmbedding> named;
  named->SetInputArrayToProcess(0, 0, 0, points, "V");
  const std::string normals = bytesOf(embeddingOf(embed(named, input)));
  named->SetEmbeddingArray("V");
  const std::string embedding = bytesOf(embeddingOf(embed(named, input)));

  input->GetPointData()->SetActiveNormals("N");
  input->GetPointData()->SetActiveVectors("V");
  vtkNew<vtkGaussMapEmbedding> filter;
  CHECK(bytesOf(embeddingOf(embed(filter, input))) != normals);
  filter->SetInputArrayToProcess(0, 0, 0, points, vtkDataSetAttributes::VECTORS);
  CHECK_EQUAL(bytesOf(embeddingOf(embed(filter, input))), normals);
  filter->SetInputArrayToProcess(1, 0, 0, points, vtkDataSetAttributes::VECTORS);
  CHECK_EQUAL(bytesOf(embeddingOf(embed(filter, input))), embedding);
  CHECK_EQUAL(embedding, bytesOf(input->GetPointData()->GetArray("V")));
}

void testModes()
{
  const auto input = sphereWithNormals("N");
  vtkNew<vtkGaussMapEmbedding> filter;
  filter->SetAnisotropy(0.0);
  const Content isotropic = contentOf(embed(filter, input));
  filter->SetAnisotropy(0.5);
  filter->SetEmbeddingMode(vtkGaussMapEmbedding::POSITION);
  const auto output = embed(filter, input);
  checkSame(contentOf(output), isotropic, "POSITION and Anisotropy 0");
  CHECK_EQUAL(embeddingOf(output)->GetNumberOfComponents(), 3);
  CHECK_EQUAL(bytesOf(embeddingOf(output)), bytesOf(input->GetPoints()->GetData()));
}

void testCoordinateArrays()
{
  const auto input = sphereWithNormals("N");
  addPointArray<vtkFloatArray>(input, "Heat", 1, [](const Point3& p, int) { return p[0] * p[1]; });
  addPointArray<vtkDoubleArray>(
    input, "Pair", 2, [](const Point3& p, int c) { return p[c] + 10.0 * c; });
  vtkNew<vtkGaussMapEmbedding> filter;
  filter->SetEmbeddingMode(vtkGaussMapEmbedding::POSITION);
  filter->AddCoordinateArray("Heat", 0.25);
  filter->AddCoordinateArray("Pair", -2.0);
  const auto output = embed(filter, input);
  vtkDataArray* array = embeddingOf(output);
  CHECK_EQUAL(array->GetNumberOfComponents(), 6);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    vtkPointData* data = input->GetPointData();
    CHECK_EQUAL(array->GetComponent(i, 3), 0.25 * data->GetArray("Heat")->GetComponent(i, 0));
    CHECK_EQUAL(array->GetComponent(i, 4), -2.0 * data->GetArray("Pair")->GetComponent(i, 0));
    CHECK_EQUAL(array->GetComponent(i, 5), -2.0 * data->GetArray("Pair")->GetComponent(i, 1));
  }
  filter->ClearCoordinateArrays();
  filter->SetEmbeddingMode(vtkGaussMapEmbedding::GAUSS_MAP);
  filter->AddCoordinateArray("Heat", 1.0);
  CHECK_EQUAL(embeddingOf(embed(filter, input))->GetNumberOfComponents(), 7);
}

/** Another array instead of all that. */
void testReplacement()
{
  const auto input = sphereWithNormals("N");
  const auto own = addPointArray<vtkFloatArray>(
    input, "Own", 2, [](const Point3& p, int c) { return p[c] / 3.0; });
  addPointArray<vtkDoubleArray>(input, "Heat", 1, [](const Point3& p, int) { return p[0]; });
  vtkNew<vtkGaussMapEmbedding> filter;
  filter->AddCoordinateArray("Heat", 1.0);
  filter->SetEmbeddingArray("Own");
  const auto output = embed(filter, input);
  vtkDataArray* array = embeddingOf(output);
  CHECK_EQUAL(array->GetNumberOfComponents(), 2);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    CHECK_EQUAL(array->GetComponent(i, 0), own->GetComponent(i, 0));
    CHECK_EQUAL(array->GetComponent(i, 1), own->GetComponent(i, 1));
  }
  filter->SetEmbeddingArray(nullptr);
  CHECK_EQUAL(embeddingOf(embed(filter, input))->GetNumberOfComponents(), 7);
}

/** The fewer points, the smoother the estimated normals; given ones stay, and so do passes. */
void testNumberOfPoints()
{
  const auto spreadOf = [](vtkIdType points, int passes, bool given)
  {
    const auto input = given ? sphereWithNormals("N") : bumpyPlate(30, 0.05, 20.0);
    if (given)
    {
      input->GetPointData()->SetActiveNormals("N");
    }
    vtkNew<vtkGaussMapEmbedding> filter;
    filter->SetNumberOfPoints(points);
    filter->SetNormalSmoothingPasses(passes);
    return contentOf(embed(filter, input));
  };
  CHECK(spreadOf(50, -1, false) != spreadOf(5000, -1, false));
  checkSame(spreadOf(50, 2, false), spreadOf(5000, 2, false), "passes");
  checkSame(spreadOf(50, -1, true), spreadOf(5000, -1, true), "given normals");
}

/** Points that no polygon uses, and coincident ones. */
void testOddPoints()
{
  TriangleSoup soup = tetrahedron();
  soup.points.emplace_back(5, 6, 7); // not used
  soup.points.push_back(soup.points[3]);
  soup.triangles[3][1] = 5; // as point 3
  const auto input = polyDataOf(soup);
  vtkNew<vtkGaussMapEmbedding> filter;
  const auto output = embed(filter, input);
  vtkDataArray* array = embeddingOf(output);
  const double unused[6] = { 5, 6, 7, 0, 0, 0 };
  for (int c = 0; c < 6; ++c)
  {
    CHECK_EQUAL(array->GetComponent(4, c), unused[c]);
    CHECK_EQUAL(array->GetComponent(5, c), array->GetComponent(3, c));
  }
  CHECK_EQUAL(filter->GetNumberOfMergedPoints(), 1);
  CHECK(std::abs(array->GetComponent(3, 5)) > 0.0);
}

/**
 * The remesher on the embedded surface gives, to the byte, what it gives with the same parameters:
 * the core sees the same numbers. Only the input's point arrays differ: port 0's `Embedding` is
 * the sites' in both. (But for the fit, which holds points in an embedding of the caller's.)
 */
void testRoundTrip(vtkPolyData* input, double anisotropy, const char* where)
{
  vtkNew<vtkGaussMapEmbedding> embedding;
  embedding->SetInputData(input);
  embedding->SetAnisotropy(anisotropy);
  embedding->SetNumberOfPoints(200);
  vtkNew<vtkAnisotropicRemesher> direct;
  direct->SetInputData(input);
  direct->SetAnisotropy(anisotropy);
  vtkNew<vtkAnisotropicRemesher> indirect;
  indirect->SetInputConnection(embedding->GetOutputPort());
  indirect->SetEmbeddingArray("Embedding");
  indirect->SetAnisotropy(0.9); // not used
  for (vtkAnisotropicRemesher* remesher : { direct.Get(), indirect.Get() })
  {
    remesher->SetNumberOfPoints(200);
    remesher->SetNumberOfLloydIterations(5);
    remesher->SetVertexPlacement(vtkAnisotropicRemesher::QUADRIC);
    remesher->Update();
  }
  CHECK_EQUAL(indirect->GetDimension(), 6);
  std::vector<Content> expected = contentsOf(direct);
  expected[0].erase("field NormalSmoothingRadius"); // the array's normals are given
  checkSame(contentsOf(indirect), expected, where);
}
}

int TestGaussMapEmbedding(int, char*[])
{
  testFormula();
  testAttributes();
  testModes();
  testCoordinateArrays();
  testReplacement();
  testNumberOfPoints();
  testOddPoints();
  testRoundTrip(polyDataOf(ellipsoid(3)), 0.05, "estimated normals");
  const auto sphere = sphereWithNormals("N");
  sphere->GetPointData()->SetActiveNormals("N");
  testRoundTrip(sphere, 0.1, "given normals");
  return result();
}
