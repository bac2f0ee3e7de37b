#include "Features/PatchSampling.h"

#include "Embedding/Distance.h"
#include "Features/SpareSites.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace remesh
{
namespace
{
constexpr double halfRow = 0.43301270189221932338; // height of a border cell, over the spacing
constexpr Offset minClosed = SpareSites::minOfClosed;
constexpr int halvingsOfSize = 60;
}

PatchSizes measurePatches(const FeaturedSurface& featured)
{
  const auto& [mesh, surface, features] = featured;
  PatchSizes sizes;
  sizes.area.assign(static_cast<std::size_t>(features.numberOfPatches), 0.0);
  sizes.border = sizes.area;
  for (Index f = 0; f < mesh.numberOfFacets(); ++f)
  {
    const Index patch = features.facetPatches[f];
    sizes.area[patch] += surface.siteMeasureOf(f);
    for (int k = 0; k < 3; ++k)
    {
      if (features.kind(f, k) != FeatureKind::None)
      {
        sizes.border[patch] += surface.lengthScale(f) * std::sqrt(surface.constants[f].edge2[k]);
      }
    }
  }
  return sizes;
}

double PatchSizes::demand(std::size_t patch, double spacing) const
{
  const double rows = halfRow * spacing * this->border[patch];
  return std::max(0.0, (this->area[patch] - rows) / (cellArea * spacing * spacing));
}

double PatchSizes::totalDemand(double spacing) const
{
  double sum = 0.0;
  for (std::size_t p = 0; p < this->area.size(); ++p)
  {
    sum += this->demand(p, spacing);
  }
  return sum;
}

namespace
{
/** The free sites that each patch cannot do without. */
std::vector<Offset> minCounts(
  const PatchSizes& sizes, const EmbeddedSurface& surface, const FeatureSites& featureSites)
{
  std::vector<std::vector<Index>> vertices(sizes.area.size()); // of each patch, ascending
  for (Index site = 0; site < featureSites.sites.count(); ++site)
  {
    std::vector<Index>& own = vertices[surface.patches.patchOf(featureSites.sites.site(site))];
    const Index point = featureSites.pointOfSite[site];
    if (own.empty() || own.back() != point)
    {
      own.push_back(point);
    }
  }
  std::vector<Offset> least(sizes.area.size(), 0);
  std::set<std::vector<Index>> seen;
  for (std::size_t p = 0; p < least.size(); ++p)
  {
    const bool closed = !(sizes.border[p] > 0.0);
    least[p] = closed ? minClosed : seen.insert(vertices[p]).second ? 0 : 1;
  }
  return least;
}

/** At which the patches take n sites or hardly less. */
double commonSpacing(const PatchSizes& sizes, const EmbeddedSurface& surface, double n)
{
  double high = std::sqrt(surface.siteMeasure / (cellArea * std::max(n, 1.0))); // less than n fit
  double low = high;
  for (int k = 0; k < halvingsOfSize && sizes.totalDemand(low) < n; ++k)
  {
    low *= 0.5;
  }
  for (int k = 0; k < halvingsOfSize; ++k)
  {
    const double middle = 0.5 * (low + high);
    (sizes.totalDemand(middle) < n ? high : low) = middle;
  }
  return high;
}

/** Closed patches took more than their share: the largest give it back. */
void giveBack(Offset surplus, std::vector<Offset>& counts)
{
  for (std::size_t k = 0; surplus > 0 && k < counts.size(); ++k)
  {
    Offset& most = *std::max_element(counts.begin(), counts.end());
    const Offset spare = std::min(surplus, most / 2);
    if (most - spare < minClosed)
    {
      break;
    }
    most -= spare;
    surplus -= spare;
  }
}
}

std::vector<Offset> shareOutSites(
  const FeaturedSurface& featured, const FeatureSites& featureSites, Offset wanted)
{
  const PatchSizes sizes = measurePatches(featured);
  const auto n = static_cast<double>(std::max(wanted, Offset(0)));
  const double spacing = commonSpacing(sizes, featured.surface, n);
  // Rounded down, then up where the most was lost; lower patches first at a tie.
  const std::size_t patches = sizes.area.size();
  std::vector<Offset> counts(patches, 0);
  std::vector<double> lost(patches, 0.0);
  const std::vector<Offset> least = minCounts(sizes, featured.surface, featureSites);
  Offset given = 0;
  for (std::size_t p = 0; p < patches; ++p)
  {
    const double exact = n > 0.0 ? sizes.demand(p, spacing) : 0.0;
    counts[p] = static_cast<Offset>(exact);
    lost[p] = exact - static_cast<double>(counts[p]);
    if (counts[p] < least[p])
    {
      counts[p] = least[p];
      lost[p] = 0.0;
    }
    given += counts[p];
  }
  std::vector<std::size_t> order(patches);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(
    order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return lost[a] > lost[b]; });
  for (std::size_t k = 0; given < wanted; k = (k + 1) % patches)
  {
    ++counts[order[k]];
    ++given;
  }
  giveBack(given - wanted, counts);
  return counts;
}

Status samplePatches(const FeaturedSurface& featured, const std::vector<Offset>& counts,
  const SiteDrawing& drawing, Sites& sites, const RunControl& control)
{
  const Features& features = featured.features;
  const std::size_t patches = counts.size();
  std::vector<Offset> begin(patches + 1, 0);
  for (const Index patch : features.facetPatches)
  {
    ++begin[static_cast<std::size_t>(patch) + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Index> facets(features.facetPatches.size());
  std::vector<Offset> next(begin.begin(), begin.end() - 1);
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    facets[next[features.facetPatches[f]]++] = static_cast<Index>(f);
  }
  for (std::size_t p = 0; p < patches; ++p)
  {
    if (counts[p] > 0)
    {
      const std::vector<Index> own(facets.begin() + begin[p], facets.begin() + begin[p + 1]);
      if (Status status = drawSites(
            siteSampler(featured.surface, own), counts[p], drawing, sites, control.silent());
          !status.ok())
      {
        return status;
      }
    }
  }
  return Status::success();
}
}
