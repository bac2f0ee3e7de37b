// Unusable input: one error that says what is wrong, empty outputs, and no harm to the next run.

#include "TestHelpers.h"

#include "vtkAnisotropicRemesher.h"
#include "vtkGaussMapEmbedding.h"
#include "vtkRestrictedVoronoiDiagram.h"

#include "vtkStringArray.h"

#include <functional>
#include <limits>

using namespace remesh;
using namespace remesh::test;

namespace
{
const double nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

using Input = vtkSmartPointer<vtkPolyData>;

Input goodInput()
{
  return polyDataOf(icosphere(2));
}

Input withPoint(vtkIdType id, double x)
{
  const Input input = goodInput();
  input->GetPoints()->SetPoint(id, 0.0, x, 0.0);
  return input;
}

/** A good input with a point array of one value, but for one tuple. */
Input withArray(const char* name, int components, double value, double odd)
{
  const Input input = goodInput();
  const auto array = addPointArray<vtkDoubleArray>(
    input, name, components, [=](const Point3&, int) { return value; });
  array->SetComponent(7, components - 1, odd);
  return input;
}

/** One error with these words, nothing else, and empty outputs. */
void checkFails(vtkAlgorithm* filter, const std::string& words, const std::string& where)
{
  Messages messages(filter);
  filter->Update();
  check(messages.errors().size() == 1, __FILE__, __LINE__,
    where + ": " + std::to_string(messages.errors().size()) + " errors");
  check(messages.warnings().empty(), __FILE__, __LINE__, where + ": a warning");
  // The executive's own message tells that RequestData returned 0.
  check(messages.executiveErrors().size() == 1, __FILE__, __LINE__, where + ": did not fail");
  for (const std::string& text : messages.errors())
  {
    check(text.find(words) != std::string::npos, __FILE__, __LINE__,
      where + ": \"" + words + "\" is not in: " + text);
  }
  check(outputsAreEmpty(filter), __FILE__, __LINE__, where + ": the outputs are not empty");
}

/** Fails with `input` and what `spoil` does to the filter; then works after `repair`. */
template <class Filter>
void checkCase(
  const std::string& where, vtkPolyData* input, const std::string& words,
  const std::function<void(Filter*)>& spoil = [](Filter*) {},
  const std::function<void(Filter*)>& repair = [](Filter*) {})
{
  vtkNew<Filter> filter;
  if (auto* remesher = vtkAnisotropicRemesher::SafeDownCast(filter))
  {
    remesher->SetNumberOfPoints(50);
    remesher->SetNumberOfLloydIterations(2);
  }
  filter->SetInputData(input);
  spoil(filter);
  checkFails(filter, words, where);

  repair(filter);
  filter->SetInputData(goodInput());
  Messages messages(filter);
  filter->Update();
  check(messages.errors().empty() && filter->GetOutput()->GetNumberOfPoints() > 0, __FILE__,
    __LINE__, where + ": a good input fails afterwards");
}

/** For the filters that take no sites. */
void checkBoth(
  const std::string& where, vtkPolyData* input, const std::string& words,
  const std::function<void(vtkEmbeddedSurfaceAlgorithm*)>& spoil =
    [](vtkEmbeddedSurfaceAlgorithm*) {},
  const std::function<void(vtkEmbeddedSurfaceAlgorithm*)>& repair =
    [](vtkEmbeddedSurfaceAlgorithm*) {})
{
  checkCase<vtkAnisotropicRemesher>(where + " (remesher)", input, words, spoil, repair);
  checkCase<vtkGaussMapEmbedding>(where + " (embedding)", input, words, spoil, repair);
}

void testSurfaces()
{
  Input noPolygons = goodInput();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  noPolygons->SetPolys(nullptr);
  checkBoth("points alone", noPolygons, "no polygons");
  noPolygons->SetLines(lines);
  checkBoth("lines", noPolygons, "1 lines");

  checkBoth("NaN", withPoint(3, nan), "not finite");
  checkBoth("infinity", withPoint(3, infinity), "not finite");
  checkBoth("minus infinity", withPoint(3, -infinity), "not finite");
  checkBoth("a point beyond all bounds", withPoint(3, 1e200), "too far away");

  Input tiny = goodInput();
  for (vtkIdType i = 0; i < tiny->GetNumberOfPoints(); ++i)
  {
    const Point3 p = 1e-200 * pointOf(tiny, i);
    tiny->GetPoints()->SetPoint(i, p.data());
  }
  checkBoth("a surface too small to square", tiny, "too small");

  Input badIds = goodInput();
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 100000 });
  badIds->SetPolys(polygons);
  checkBoth("a point id out of range", badIds, "refers to point 100000");
}

void testArrays()
{
  const auto chooseNormals = [](const char* name)
  {
    return [name](vtkEmbeddedSurfaceAlgorithm* filter)
    { filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name); };
  };
  const auto activeNormals = [](vtkEmbeddedSurfaceAlgorithm* filter)
  {
    filter->SetInputArrayToProcess(
      0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::NORMALS);
  };
  checkBoth("missing normals", goodInput(), "\"N\"", chooseNormals("N"), activeNormals);
  checkBoth("normals of two components", withArray("N", 2, 1.0, 1.0), "2 components",
    chooseNormals("N"), activeNormals);
  checkBoth("normals that are not finite", withArray("N", 3, 1.0, nan), "not finite",
    chooseNormals("N"), activeNormals);
  Input shortArray = goodInput();
  vtkNew<vtkDoubleArray> three;
  three->SetName("N");
  three->SetNumberOfComponents(3);
  three->SetNumberOfTuples(5);
  three->Fill(1.0);
  shortArray->GetPointData()->AddArray(three);
  checkBoth("too few normals", shortArray, "5 tuples", chooseNormals("N"), activeNormals);

  const auto chooseEmbedding = [](vtkEmbeddedSurfaceAlgorithm* filter)
  { filter->SetEmbeddingArray("E"); };
  const auto noEmbedding = [](vtkEmbeddedSurfaceAlgorithm* filter)
  { filter->SetEmbeddingArray(nullptr); };
  checkBoth("missing embedding", goodInput(), "\"E\"", chooseEmbedding, noEmbedding);
  checkBoth("an embedding of one component", withArray("E", 1, 1.0, 2.0), "at least 2",
    chooseEmbedding, noEmbedding);
  for (const double bad : { nan, infinity })
  {
    checkBoth("an embedding that is not finite", withArray("E", 4, 1.0, bad), "not a finite number",
      chooseEmbedding, noEmbedding);
  }
  Input words = goodInput();
  vtkNew<vtkStringArray> strings;
  strings->SetName("E");
  strings->SetNumberOfValues(words->GetNumberOfPoints());
  words->GetPointData()->AddArray(strings);
  checkBoth("an embedding of strings", words, "\"E\"", chooseEmbedding, noEmbedding);

  const auto chooseCoordinates = [](vtkEmbeddedSurfaceAlgorithm* filter)
  { filter->AddCoordinateArray("C", 1.0); };
  const auto noCoordinates = [](vtkEmbeddedSurfaceAlgorithm* filter)
  { filter->ClearCoordinateArrays(); };
  checkBoth("missing coordinates", goodInput(), "\"C\"", chooseCoordinates, noCoordinates);
  checkBoth("coordinates that are not finite", withArray("C", 1, 1.0, nan), "not a finite number",
    chooseCoordinates, noCoordinates);
  // A scale that cannot be is refused at once.
  vtkNew<vtkAnisotropicRemesher> filter;
  Messages messages(filter);
  filter->AddCoordinateArray("C", nan);
  filter->AddCoordinateArray("C", infinity);
  filter->AddCoordinateArray(nullptr, 1.0);
  CHECK_EQUAL(messages.errors().size(), std::size_t(3));
  CHECK_EQUAL(filter->GetNumberOfCoordinateArrays(), 0);

  // All points in one place, though the surface in R^3 is fine: valid arrays, nothing to divide.
  checkCase<vtkAnisotropicRemesher>("an embedding in one point", withArray("E", 4, 1.0, 1.0),
    "single point", chooseEmbedding, noEmbedding);
}

/** Chosen by a type of attribute that the points have not, or that cannot be used. */
void testAttributes()
{
  using Filter = vtkEmbeddedSurfaceAlgorithm;
  const auto choose = [](int index, int association, int attribute)
  {
    return [=](Filter* filter)
    { filter->SetInputArrayToProcess(index, 0, 0, association, attribute); };
  };
  const auto none = [](int index)
  {
    return [=](Filter* filter)
    { filter->SetInputArrayToProcess(index, 0, 0, vtkDataObject::POINT, ""); };
  };
  const char* const roles[] = { "normals", "embedding", "labels", "density" };
  for (const int index : { 0, 1, 3 })
  {
    checkBoth(std::string("no scalars as ") + roles[index], goodInput(),
      std::string("points have no numeric active array of Scalars, chosen as the ") + roles[index],
      choose(index, vtkDataObject::POINT, vtkDataSetAttributes::SCALARS), none(index));
    checkBoth(std::string("cells' scalars as ") + roles[index], goodInput(),
      std::string(roles[index]) + ", must be a point array",
      choose(index, vtkDataObject::CELL, vtkDataSetAttributes::SCALARS), none(index));
  }
  checkBoth("no scalars as labels", goodInput(),
    "cells have no active array of Scalars, chosen as the labels",
    choose(2, vtkDataObject::CELL, vtkDataSetAttributes::SCALARS), none(2));
  const Input scalars = withArray("S", 1, 1.0, 2.0);
  scalars->GetPointData()->SetActiveScalars("S");
  scalars->GetPointData()->GetScalars()->SetName(nullptr);
  checkBoth("an embedding of nameless scalars", scalars, "at least 2",
    choose(1, vtkDataObject::POINT, vtkDataSetAttributes::SCALARS), none(1));
}

/** Labels that are missing, whether they would count or not. */
void testLabels()
{
  const auto chooseLabels = [](vtkAnisotropicRemesher* filter)
  { filter->SetFeatureLabelArray("L"); };
  const auto noLabels = [](vtkAnisotropicRemesher* filter)
  { filter->SetFeatureLabelArray(nullptr); };
  const char* const words = "no cell array \"L\", chosen as the labels";
  checkCase<vtkAnisotropicRemesher>("missing labels", goodInput(), words, chooseLabels, noLabels);
  checkCase<vtkAnisotropicRemesher>(
    "missing labels without features", goodInput(), words,
    [=](vtkAnisotropicRemesher* filter)
    {
      filter->PreserveFeaturesOff();
      chooseLabels(filter);
    },
    noLabels);
  checkCase<vtkAnisotropicRemesher>(
    "missing labels with sites", goodInput(), words,
    [=](vtkAnisotropicRemesher* filter)
    {
      filter->SetInitialSitesData(goodInput());
      chooseLabels(filter);
    },
    noLabels);
}

void testNumbersOfPoints()
{
  const auto good = [](vtkAnisotropicRemesher* filter) { filter->SetNumberOfPoints(50); };
  for (const vtkIdType n : { 0, 1, 3 })
  {
    checkCase<vtkAnisotropicRemesher>(
      "too few points", goodInput(), "at least 4 points",
      [n](vtkAnisotropicRemesher* filter) { filter->SetNumberOfPoints(n); }, good);
  }
  checkCase<vtkAnisotropicRemesher>(
    "points beyond the memory", goodInput(), "GB of memory",
    [](vtkAnisotropicRemesher* filter) { filter->SetNumberOfPoints(2000000000); }, good);
  for (const vtkIdType n : { vtkIdType(1) << 31, vtkIdType(VTK_ID_MAX) })
  {
    checkCase<vtkAnisotropicRemesher>(
      "too many points", goodInput(), std::to_string(n),
      [n](vtkAnisotropicRemesher* filter) { filter->SetNumberOfPoints(n); }, good);
  }
}

void testSites()
{
  const auto none = [](vtkAnisotropicRemesher* filter) { filter->SetInitialSitesData(nullptr); };
  const auto give = [](vtkPolyData* sites)
  {
    const Input kept = sites;
    return [kept](vtkAnisotropicRemesher* filter) { filter->SetInitialSitesData(kept); };
  };
  checkCase<vtkAnisotropicRemesher>(
    "no initial sites in the input", goodInput(), "at least 4 points", give(pointsOnly({})), none);
  checkCase<vtkAnisotropicRemesher>("three initial sites", goodInput(), "at least 4 points",
    give(pointsOnly({ { 0, 0, 1 }, { 0, 1, 0 }, { 1, 0, 0 } })), none);
  checkCase<vtkAnisotropicRemesher>("NaN in initial sites", goodInput(), "Site 3",
    give(pointsOnly({ { 0, 0, 1 }, { 0, 1, 0 }, { 1, 0, 0 }, { 0, nan, 1 } })), none);
  checkCase<vtkAnisotropicRemesher>("a place far away", goodInput(), "Site 2 is too far away",
    give(pointsOnly({ { 0, 0, 1 }, { 0, 1, 0 }, { 1, 0, 1e60 }, { 0, 1, 1 } })), none);
  Input sites = goodInput();
  const auto embedding = addPointArray<vtkDoubleArray>(
    sites, "Embedding", 6, [](const Point3& p, int c) { return p[c % 3]; });
  embedding->SetComponent(7, 5, 1e200);
  checkCase<vtkAnisotropicRemesher>(
    "a site far away", goodInput(), "embedding of site 7 is too far", give(sites), none);
  embedding->SetComponent(7, 5, infinity);
  checkCase<vtkAnisotropicRemesher>(
    "infinity in the embedding of sites", goodInput(), "site 7", give(sites), none);

  const auto giveGood = [](vtkRestrictedVoronoiDiagram* filter)
  { filter->SetSitesData(goodInput()); };
  checkCase<vtkRestrictedVoronoiDiagram>(
    "no sites", goodInput(), "has 0",
    [](vtkRestrictedVoronoiDiagram* filter) { filter->SetSitesData(pointsOnly({})); }, giveGood);
  checkCase<vtkRestrictedVoronoiDiagram>(
    "NaN in sites", goodInput(), "Site 0",
    [](vtkRestrictedVoronoiDiagram* filter) {
      filter->SetSitesData(pointsOnly({ { nan, 0, 0 } }));
    },
    giveGood);
  checkCase<vtkRestrictedVoronoiDiagram>(
    "a bad surface for sites", withPoint(3, nan), "not finite", giveGood);
}

/** Without a connection the executive complains, once for each, and the filter is not asked. */
void testNoConnection()
{
  const auto check = [](vtkAlgorithm* filter, std::size_t missing = 1)
  {
    Messages messages(filter);
    filter->Update();
    CHECK_EQUAL(messages.errors().size(), std::size_t(0));
    CHECK_EQUAL(messages.executiveErrors().size(), missing);
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      vtkDataObject* output = filter->GetOutputDataObject(port);
      CHECK(!output || output->GetNumberOfElements(vtkDataObject::POINT) == 0);
    }
  };
  vtkNew<vtkAnisotropicRemesher> remesher;
  check(remesher);
  vtkNew<vtkGaussMapEmbedding> embedding;
  check(embedding);
  vtkNew<vtkRestrictedVoronoiDiagram> diagram;
  check(diagram, 2);
  vtkNew<vtkRestrictedVoronoiDiagram> noSites;
  noSites->SetInputData(goodInput());
  check(noSites);
}

/** Nothing in, nothing out, not a word. */
void testEmptyInput()
{
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkAnisotropicRemesher> remesher;
  vtkNew<vtkRestrictedVoronoiDiagram> diagram;
  diagram->SetSitesData(goodInput());
  vtkNew<vtkGaussMapEmbedding> embedding;
  for (vtkEmbeddedSurfaceAlgorithm* filter :
    std::initializer_list<vtkEmbeddedSurfaceAlgorithm*>{ remesher, diagram, embedding })
  {
    filter->SetInputData(empty);
    Messages messages(filter);
    filter->Update();
    CHECK(messages.errors().empty());
    CHECK(messages.warnings().empty());
    CHECK(messages.executiveErrors().empty());
    CHECK(outputsAreEmpty(filter));
  }
}

/** Polygons, but none with an area: nothing to remesh, and the user is told why. */
void testDegenerateInput()
{
  vtkNew<vtkAnisotropicRemesher> remesher;
  vtkNew<vtkGaussMapEmbedding> embedding;
  Input line = goodInput();
  for (vtkIdType i = 0; i < line->GetNumberOfPoints(); ++i)
  {
    line->GetPoints()->SetPoint(i, static_cast<double>(i), 0.0, 0.0);
  }
  for (vtkEmbeddedSurfaceAlgorithm* filter :
    std::initializer_list<vtkEmbeddedSurfaceAlgorithm*>{ remesher, embedding })
  {
    filter->SetInputData(line);
    Messages messages(filter);
    filter->Update();
    CHECK(messages.errors().empty());
    CHECK(messages.executiveErrors().empty());
    CHECK_EQUAL(messages.warnings().size(), std::size_t(1));
    CHECK(!messages.warnings().empty() &&
      messages.warnings()[0].find("has an area") != std::string::npos);
    CHECK(outputsAreEmpty(filter));
    CHECK_EQUAL(filter->GetNumberOfDroppedTriangles(), line->GetNumberOfPolys());
  }
}

/** Which normals are used follows from the input of each run, unless they are not to be used. */
void testChoiceOfNormals()
{
  const Input plain = goodInput();
  const Input given = withArray("N", 3, 1.0, 2.0);
  given->GetPointData()->SetActiveNormals("N");
  const auto normalOf = [](vtkEmbeddedSurfaceAlgorithm* filter, vtkPolyData* input)
  {
    filter->SetInputData(input);
    Messages messages(filter);
    filter->Update();
    CHECK(messages.errors().empty() && messages.warnings().empty());
    return tupleOf(arrayOf(filter->GetOutput()->GetPointData(), "Embedding"), 3);
  };
  vtkNew<vtkGaussMapEmbedding> filter;
  const auto estimated = normalOf(filter, plain);
  const auto used = normalOf(filter, given);
  CHECK(estimated != used);
  for (const char* name : { "Automatic", "N" })
  {
    filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
    CHECK(normalOf(filter, given) == used);
  }
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Automatic");
  CHECK(normalOf(filter, plain) == estimated);
  for (const bool byName : { true, false })
  {
    filter->SetInputArrayToProcess(
      0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, byName ? "None" : "Automatic");
    filter->SetEstimateNormals(!byName);
    CHECK(normalOf(filter, given) == estimated);
  }
}

/** Normals that came by themselves and are no good are replaced, with a warning. */
void testUnusableActiveNormals()
{
  const Input input = withArray("N", 3, 1.0, nan);
  input->GetPointData()->SetActiveNormals("N");
  vtkNew<vtkAnisotropicRemesher> filter;
  filter->SetNumberOfPoints(50);
  filter->SetInputData(input);
  Messages messages(filter);
  filter->Update();
  CHECK(messages.errors().empty());
  CHECK_EQUAL(messages.warnings().size(), std::size_t(1));
  CHECK_EQUAL(filter->GetOutput()->GetNumberOfPoints(), 50);
}
}

int TestErrors(int, char*[])
{
  testSurfaces();
  testArrays();
  testAttributes();
  testLabels();
  testNumbersOfPoints();
  testSites();
  testNoConnection();
  testEmptyInput();
  testDegenerateInput();
  testUnusableActiveNormals();
  testChoiceOfNormals();
  return result();
}
