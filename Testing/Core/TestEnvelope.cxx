// Voronoi/Envelope and BisectorValues: parts traced with rounding against those clipped exactly,
// and the same bits whatever the instructions.

#include "Support/Random.h"
#include "TestInstructionSets.h"
#include "TestSupport.h"
#include "Voronoi/BisectorPacks.h"
#include "Voronoi/BisectorValues.h"
#include "Voronoi/Envelope.h"
#include "Voronoi/FacetTiling.h"
#include "Voronoi/PieceIntegral.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <set>

using namespace remesh;

namespace
{
/** Sites as a facet sees them, and the same for the tracing. */
std::vector<FacetSite> randomSites(int count, std::uint64_t seed, double steps)
{
  std::vector<FacetSite> sites;
  for (Index id = 0; id < count; ++id)
  {
    FacetSite site{ id, {} };
    for (int k = 0; k < 3; ++k)
    {
      const double h = 1.0 + uniform01(seed, id, k);
      site.h[k] = steps > 0.0 ? std::floor(h * steps) / steps : h;
    }
    sites.push_back(site);
  }
  return sites;
}

void fill(Envelope& envelope, const std::vector<FacetSite>& sites)
{
  envelope.clear();
  for (const FacetSite& site : sites)
  {
    const double values[3] = { site.h[0] - sites[0].h[0], site.h[1] - sites[0].h[1],
      site.h[2] - sites[0].h[2] };
    envelope.add(values);
  }
}

bool sameResults(const Envelope& a, const Envelope& b)
{
  bool same = a.numberOfVertices == b.numberOfVertices &&
    std::memcmp(a.moments, b.moments, sizeof(a.moments[0]) * a.count) == 0;
  for (int v = 0; same && v < a.numberOfVertices; ++v)
  {
    same = std::memcmp(a.vertices[v].b, b.vertices[v].b, sizeof a.vertices[v].b) == 0 &&
      std::equal(a.vertices[v].sites, a.vertices[v].sites + 3, b.vertices[v].sites);
  }
  return same;
}

/** Any instructions give the same bits, and refuse the same. */
void testTracingSets()
{
  const auto baseline = std::make_unique<Envelope>();
  const auto other = std::make_unique<Envelope>();
  int traced = 0;
  int different = 0;
  for (std::uint64_t seed = 0; seed < 600; ++seed)
  {
    const int count = 1 + static_cast<int>(uniform01(seed, 0, 9) * Envelope::maxSites);
    const std::vector<FacetSite> sites = randomSites(count, seed, seed % 3 == 0 ? 16.0 : 0.0);
    fill(*baseline, sites);
    const bool success = envelopeTracing(InstructionSet::Baseline)(*baseline);
    traced += success;
    for (const InstructionSet set : test::availableSets())
    {
      fill(*other, sites);
      different += envelopeTracing(set)(*other) != success;
      different += success && !sameResults(*baseline, *other);
    }
  }
  CHECK(traced > 400);
  CHECK_EQUAL(different, 0);
}

void testEvaluationSets()
{
  for (const int d : { 1, 3, 6, 8, 13 })
  {
    constexpr int stride = 48;
    std::vector<double> offsets(static_cast<std::size_t>(d + 1) * stride);
    std::vector<double> points(static_cast<std::size_t>(3) * d);
    for (std::size_t k = 0; k < offsets.size(); ++k)
    {
      offsets[k] = uniform01(d, k, 0) - 0.5;
    }
    for (std::size_t k = 0; k < points.size(); ++k)
    {
      points[k] = uniform01(d, k, 1) - 0.5;
    }
    const double limits[2][3] = { { 0.0, 0.1, -0.1 }, { 0.2, -0.3, 0.0 } };
    std::vector<double> expected;
    std::vector<std::uint8_t> expectedBits;
    for (const InstructionSet set : test::availableSets())
    {
      std::vector<double> values(3 * stride, 7.0);
      std::vector<std::uint8_t> chosen(stride / 8, 0);
      bisectorEvaluation(set)(
        { offsets.data(), stride, 37, points.data(), d, limits, 2, values.data(), chosen.data() });
      expected = expected.empty() ? values : expected;
      expectedBits = expectedBits.empty() ? chosen : expectedBits;
      CHECK(std::memcmp(values.data(), expected.data(), values.size() * sizeof(double)) == 0);
      CHECK(chosen == expectedBits);
    }
    for (int lane = 0; lane < 37; ++lane)
    {
      bool below[2] = { false, false };
      for (int k = 0; k < 3; ++k)
      {
        double value = offsets[static_cast<std::size_t>(d) * stride + lane];
        for (int m = 0; m < d; ++m)
        {
          value -= 2.0 * points[k * d + m] * offsets[static_cast<std::size_t>(m) * stride + lane];
        }
        CHECK_NEAR(expected[k * stride + lane], value, 1e-14);
        below[0] = below[0] || value < limits[0][k];
        below[1] = below[1] || value < limits[1][k];
      }
      CHECK_EQUAL((expectedBits[lane / 8] >> (lane % 8) & 1) != 0, below[0] && below[1]);
    }
  }
}

void testPackingSets()
{
  const std::vector<Index> listed = { 4, 0, 7, 11, 2, 9, 5, 10, 1, 3, 8 };
  constexpr int stride = 24;
  for (const int d : { 1, 3, 6, 13 })
  {
    std::vector<double> sites(static_cast<std::size_t>(12) * d);
    for (std::size_t k = 0; k < sites.size(); ++k)
    {
      sites[k] = uniform01(d, k, 2) - 0.5;
    }
    const double* x = sites.data() + static_cast<std::size_t>(6) * d;
    std::vector<double> expected;
    for (const InstructionSet set : test::availableSets())
    {
      std::vector<double> packed(static_cast<std::size_t>(d + 1) * stride, 7.0);
      for (const int first : { 0, 8 }) // bit by bit, as it is wanted
      {
        bisectorPacking(set)({ x, sites.data(), listed.data(), static_cast<int>(listed.size()),
          first, first + 8, d, stride, packed.data() });
      }
      expected = expected.empty() ? packed : expected;
      CHECK(std::memcmp(packed.data(), expected.data(), packed.size() * sizeof(double)) == 0);
    }
    for (std::size_t lane = 0; lane < stride; ++lane)
    {
      double squared = 0.0;
      for (int m = 0; m < d; ++m)
      {
        const double found = expected[static_cast<std::size_t>(m) * stride + lane];
        const double offset =
          lane < listed.size() ? sites[static_cast<std::size_t>(listed[lane]) * d + m] - x[m] : 0.0;
        CHECK_EQUAL(found, lane < 16 ? offset : 7.0);
        squared += offset * offset;
      }
      const double found = expected[static_cast<std::size_t>(d) * stride + lane];
      CHECK(lane < listed.size() ? std::abs(found - squared) < 1e-15
          : lane < 16            ? found == Envelope::unreachable
                                 : found == 7.0);
    }
  }
}

/** Shares and centroids of the traced parts, against all sites clipped by all. */
void testTracing()
{
  const auto envelope = std::make_unique<Envelope>();
  double worst = 0.0;
  int refused = 0;
  int ofCorners[4] = {}; // facets of 1, 2 or 3 owners without another site's part
  for (std::uint64_t seed = 0; seed < 1200; ++seed)
  {
    const int count = seed % 3 == 0 ? 1 + static_cast<int>(uniform01(seed, 1, 9) * 30)
                                    : 2 + static_cast<int>(uniform01(seed, 1, 9) * 7);
    const std::vector<FacetSite> sites = randomSites(count, seed, 0.0);
    fill(*envelope, sites);
    if (!envelopeTracing(InstructionSet::Baseline)(*envelope))
    {
      ++refused;
      continue;
    }
    FacetTiling tiling;
    tiling.begin({ 5, 9, 2 }, FacetConstants());
    for (const FacetSite& site : sites)
    {
      tiling.addSite(site);
    }
    int parts = 0;
    for (int i = 0; i < count; ++i)
    {
      Polygon polygon;
      tiling.wholeFacet(polygon);
      for (int q = 0; q < count && !polygon.empty(); ++q)
      {
        if (q != i)
        {
          tiling.clip(polygon, i, q);
        }
      }
      const PieceIntegral exact =
        polygon.empty() ? PieceIntegral() : integratePiece(tiling, FacetConstants(), polygon, i);
      const double* moments = envelope->moments[i];
      worst = std::max({ worst, std::abs(moments[0] - exact.fraction()),
        std::abs(moments[1] - exact.weights[1]), std::abs(moments[2] - exact.weights[2]) });
      parts += exact.fraction() > 0.0;
    }
    const std::set<int> owners(envelope->owners, envelope->owners + 3);
    ofCorners[owners.size()] += static_cast<int>(owners.size()) == parts;
  }
  CHECK_NEAR(worst, 0.0, 1e-12);
  CHECK(refused <= 6);
  CHECK(ofCorners[2] > 100 && ofCorners[3] > 100);
}
}

int TestEnvelope(int, char*[])
{
  testTracingSets();
  testEvaluationSets();
  testPackingSets();
  testTracing();
  return test::result();
}
