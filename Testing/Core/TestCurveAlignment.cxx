// Features/CurveAlignment: the rims of thin plates have their places opposite each other, as few as
// each has for itself, also where the rims are not of the same length.

#include "Features/CurveAlignment.h"
#include "Features/CurveSeparation.h"
#include "Features/FeatureGraph.h"
#include "TestEmbeddings.h"
#include "TestSurfaces.h"

using namespace remesh;

namespace
{
struct Part
{
  SurfaceMesh mesh;
  Features features;
  EmbeddedSurface surface;

  explicit Part(const TriangleSoup& soup)
    : mesh(test::meshOf(soup))
    , features(findFeatures(this->mesh, FeatureOptions()))
    , surface(test::embedded(this->mesh, 3))
  {
    separatePatches(this->features.facetPatches, this->features.numberOfPatches, this->surface);
  }

  FeaturedSurface view() const { return { this->mesh, this->surface, this->features }; }
};

/** A flat ring between two circles of these radii. */
TriangleSoup ring(double inner, double outer, int segments)
{
  return test::flatRing(segments, inner, [outer](const Point3&) { return outer; });
}

/** What separateCurves() has to add, with the curves aligned or not. */
Index addedTo(const Part& part, Offset points, bool align, Index& sampled)
{
  CurveSampler sampler(part.view(), { points });
  sampler.limitBends(RunControl());
  sampler.findSpacing(0, RunControl());
  FeatureSites sites = makeFeatureSites(part.view(), sampler.stations());
  const Index before = sites.numberOfPoints();
  if (align)
  {
    alignCurves(part.view(), RunControl(), sampler, sites);
    CHECK(sites.stations == sampler.stations());
  }
  sampled = sites.numberOfPoints();
  CHECK(sampled <= before + before / 20);
  return separateCurves(part.view(), std::vector<char>(part.features.curves.size(), 1),
    { points, sampler.spacing() }, RunControl(), sites);
}

/** Narrow, and the outer circle longer than the inner one by up to some sections. */
void testRings()
{
  for (const double inner : { 0.97, 0.98, 0.985, 0.99 })
  {
    const Part part(ring(inner, 1.0, 360));
    const double area = std::acos(-1.0) * (1.0 - inner * inner);
    const double spacing = 2.5 * (1.0 - inner);
    const auto points =
      static_cast<Offset>(2.0 * 2.0 * std::acos(-1.0) / spacing + 0.1 * area / (spacing * spacing));
    Index sampled = 0;
    const Index aligned = addedTo(part, points, true, sampled);
    CHECK(aligned <= sampled / 20);
    const Index alone = addedTo(part, points, false, sampled);
    CHECK(alone == 0 || alone > 4 * aligned);
  }
}

/** Far apart nothing changes. */
void testWideRing()
{
  const Part part(ring(0.3, 1.0, 360));
  CurveSampler sampler(part.view(), { 500 });
  sampler.limitBends(RunControl());
  sampler.findSpacing(0, RunControl());
  const Stations before = sampler.stations();
  FeatureSites sites = makeFeatureSites(part.view(), before);
  alignCurves(part.view(), RunControl(), sampler, sites);
  CHECK(sampler.stations() == before);
  CHECK(sites.stations == before);
}
}

int TestCurveAlignment(int, char*[])
{
  testRings();
  testWideRing();
  return test::result();
}
