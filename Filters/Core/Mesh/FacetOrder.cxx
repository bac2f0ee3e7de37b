#include "Mesh/FacetOrder.h"

#include "Mesh/SpatialOrder.h"
#include "Support/Grouping.h"

#include <algorithm>
#include <tuple>

namespace remesh
{
namespace
{
/** Below 0: facet `a` comes first, by the coordinates of its corners. */
int compareCorners(const Draft& draft, Index a, Index b)
{
  for (int k = 0; k < 3; ++k)
  {
    const Point3& first = draft.points[draft.facets[a][k]];
    const Point3& second = draft.points[draft.facets[b][k]];
    if (isBefore(first, second) || isBefore(second, first))
    {
      return isBefore(first, second) ? -1 : 1;
    }
  }
  return 0;
}

/** Likewise, then by what the caller's data has there, then by number. */
bool comesBefore(const TriangleSoup& soup, const Draft& draft, Index a, Index b)
{
  int order = compareCorners(draft, a, b);
  if (order == 0 && a != b && soup.compareValues)
  {
    order = soup.compareValues(soup.inputCells[draft.facetTriangles[a]], draft.inputsOf(soup, a),
      soup.inputCells[draft.facetTriangles[b]], draft.inputsOf(soup, b));
  }
  return order != 0 ? order < 0 : a < b;
}

/** `values[k]` becomes what `values[order[k]]` was. */
template <class Value>
bool gather(const std::vector<Index>& order, const RunControl& control, std::vector<Value>& values)
{
  std::vector<Value> moved(order.size());
  const bool done = forEachItem(static_cast<Offset>(order.size()), control.silent(),
    [&](Offset k) { moved[k] = values[order[k]]; });
  values.swap(moved);
  return done;
}
}

bool isBefore(const Point3& a, const Point3& b)
{
  return std::tie(a[0], a[1], a[2]) < std::tie(b[0], b[1], b[2]);
}

bool turnFacets(const RunControl& control, Draft& draft)
{
  return forEachItem(static_cast<Offset>(draft.facets.size()), control.silent(),
    [&](Offset f)
    {
      Triple& facet = draft.facets[f];
      int first = 0;
      for (const int k : { 1, 2 })
      {
        first = isBefore(draft.points[facet[k]], draft.points[facet[first]]) ? k : first;
      }
      if (first == 0)
      {
        return;
      }
      std::rotate(facet.begin(), facet.begin() + first, facet.end());
      if (draft.facetInputs.empty())
      {
        draft.facetTurns[f] = static_cast<unsigned char>((draft.facetTurns[f] + first) % 3);
      }
      else
      {
        auto& inputs = draft.facetInputs[f];
        std::rotate(inputs.begin(), inputs.begin() + first, inputs.end());
      }
    });
}

std::vector<Index> orderFacets(
  const TriangleSoup& soup, const Draft& draft, const RunControl& control)
{
  std::vector<Point3> centroids(draft.facets.size());
  if (!forEachItem(static_cast<Offset>(centroids.size()), control.silent(),
        [&](Offset f)
        {
          const auto& [a, b, c] = draft.facets[f];
          centroids[f] = (draft.points[a] + draft.points[b] + draft.points[c]) / 3.0;
        }))
  {
    return std::vector<Index>(centroids.size());
  }
  return orderAlongHilbertCurve(
    centroids, control, [&](Index a, Index b) { return comesBefore(soup, draft, a, b); });
}

bool moveFacets(const std::vector<Index>& order, const RunControl& control, Draft& draft,
  std::vector<unsigned char>& marked)
{
  return gather(order, control, draft.facets) && gather(order, control, draft.facetTriangles) &&
    gather(order, control, draft.facetTurns) && gather(order, control, marked) &&
    (draft.facetInputs.empty() || gather(order, control, draft.facetInputs));
}
}
