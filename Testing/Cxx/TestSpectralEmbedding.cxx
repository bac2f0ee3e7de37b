// vtkSpectralEmbedding: eigenvalues and functions as arrays, remeshing with them, errors, threads.

#include "TestBytes.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkFieldData.h"
#include "vtkSpectralEmbedding.h"

#include <cmath>

using namespace remesh;
using namespace remesh::test;

namespace
{
vtkSmartPointer<vtkSpectralEmbedding> spectrumOf(vtkPolyData* input, int dimension)
{
  auto filter = vtkSmartPointer<vtkSpectralEmbedding>::New();
  filter->SetInputData(input);
  filter->SetDimension(dimension);
  return filter;
}

/** A square: cosines, 0 on its border where that is fixed, and zeros at points of no polygon. */
void testSquare()
{
  TriangleSoup soup = gridPatch(40, 30);
  soup.points.emplace_back(7.0, 7.0, 7.0);
  const auto input = polyDataOf(soup);
  const auto filter = spectrumOf(input, 5);
  filter->SetScaling(vtkSpectralEmbedding::NONE);
  filter->Update();
  CHECK(input->GetPointData()->GetArray("Embedding") == nullptr);
  const auto values = arrayOf(filter->GetOutput()->GetFieldData(), "Eigenvalues");
  CHECK_EQUAL(values->GetNumberOfTuples(), 5);
  const int known[] = { 1, 1, 2, 4, 4 };
  for (int k = 0; k < 5; ++k)
  {
    CHECK_NEAR(values->GetComponent(k, 0) / (known[k] * pi * pi), 1.0, 0.01);
  }
  const auto places = arrayOf(filter->GetOutput()->GetPointData(), "Embedding");
  for (vtkIdType i = 0; i + 1 < input->GetNumberOfPoints(); ++i)
  {
    // The third one is 2 cos(pi x) cos(pi y): it has the mean square 1.
    const Point3 p = pointOf(input, i);
    CHECK_NEAR(std::abs(places->GetComponent(i, 2)),
      std::abs(2.0 * std::cos(pi * p[0]) * std::cos(pi * p[1])), 0.02);
  }
  for (int k = 0; k < 5; ++k)
  {
    CHECK_EQUAL(places->GetComponent(input->GetNumberOfPoints() - 1, k), 0.0);
  }
  filter->SetBorderCondition(vtkSpectralEmbedding::FIXED);
  filter->Update();
  const auto fixed = arrayOf(filter->GetOutput()->GetPointData(), "Embedding");
  CHECK_EQUAL(fixed->GetComponent(0, 0), 0.0);
  CHECK_NEAR(arrayOf(filter->GetOutput()->GetFieldData(), "Eigenvalues")->GetComponent(0, 0),
    2.0 * pi * pi, 0.2);
}

void testRemeshing()
{
  const auto spectrum = spectrumOf(polyDataOf(torus(3.0, 1.0, 90, 40)), 12);
  vtkNew<vtkAnisotropicRemesher> remesher;
  remesher->SetInputConnection(spectrum->GetOutputPort());
  remesher->SetNumberOfPoints(400);
  remesher->SetEmbeddingArray("Embedding");
  Messages messages(remesher);
  remesher->Update();
  CHECK(messages.errors().empty());
  CHECK_EQUAL(remesher->GetDimension(), 12);
  CHECK_EQUAL(remesher->GetOutput()->GetNumberOfPoints(), 400);
}

void testErrors()
{
  const auto filter = spectrumOf(polyDataOf(icosphere(1)), 42);
  Messages messages(filter);
  filter->Update();
  CHECK_EQUAL(messages.errors().size(), 1u);
  CHECK(messages.errors()[0].find("41 eigenfunctions beside constants, but 42 are asked for.") !=
    std::string::npos);
  CHECK(outputsAreEmpty(filter));
}

void testThreads()
{
  const auto input = polyDataOf(icosphere(4));
  std::vector<Content> contents;
  for (const int backend : { vtkSpectralEmbedding::SMP_SEQUENTIAL,
         vtkSpectralEmbedding::SMP_STDTHREAD, vtkSpectralEmbedding::SMP_AUTOMATIC })
  {
    const auto filter = spectrumOf(input, 30);
    filter->SetSMPBackend(backend);
    filter->Update();
    contents.push_back(contentOf(filter->GetOutput()));
    CHECK(contents.back() == contents.front());
  }
}
}

int TestSpectralEmbedding(int, char*[])
{
  testSquare();
  testRemeshing();
  testErrors();
  testThreads();
  return result();
}
