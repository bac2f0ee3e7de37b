#include "Refinement/Refinement.h"

#include "Features/FeatureGraph.h"
#include "Support/Grouping.h"

#include <algorithm>

namespace remesh
{
namespace
{
/** The room that closing the marks takes, as a multiple of that of the marks. */
constexpr Offset shareOfClosing = 1;

/** Facets that are added where these edges are split. */
Offset addedBy(const EdgeTable& edges, const EdgesToSplit& wanted)
{
  Offset added = 0;
  for (Index e = 0; e < edges.numberOfEdges(); ++e)
  {
    added += wanted.marked[e] ? edges.valence(e) : 0;
  }
  return added;
}

/** Leaves the marks of the longest edges alone, for which there is room. */
void keepLongest(const EdgeTable& edges, Offset room, EdgesToSplit& wanted)
{
  std::vector<Index> marked;
  for (Index e = 0; e < edges.numberOfEdges(); ++e)
  {
    if (wanted.marked[e])
    {
      marked.push_back(e);
    }
  }
  std::sort(marked.begin(), marked.end(), [&](Index a, Index b) { return wanted.isLonger(a, b); });
  std::fill(wanted.marked.begin(), wanted.marked.end(), 0);
  for (const Index edge : marked)
  {
    room -= (1 + shareOfClosing) * edges.valence(edge);
    if (room < 0)
    {
      break;
    }
    wanted.marked[edge] = 1;
  }
  closeMarks(edges, wanted);
}

/** Whether an edge is between pieces of one facet. */
bool isWithinFacet(const RefinedSurface& surface, const EdgeTable& edges, Index edge)
{
  const Index begin = edges.edgeFacetsBegin[edge];
  return edges.valence(edge) == 2 &&
    surface.origins[edges.edgeFacets[begin]].facet ==
    surface.origins[edges.edgeFacets[begin + 1]].facet;
}

/** Pieces of needles are open; edges between them wait while a side of the needle is marked. */
void splitSidesFirst(const RefinedSurface& surface, const EdgeTable& edges,
  const std::vector<char>& needles, EdgesToSplit& wanted)
{
  wanted.open.resize(surface.origins.size());
  for (std::size_t f = 0; f < surface.origins.size(); ++f)
  {
    wanted.open[f] = needles[surface.origins[f].facet];
  }
  std::vector<char> waits(needles.size(), 0);
  const auto forEachMark = [&](const auto& visit)
  {
    for (std::size_t f = 0; f < surface.origins.size(); ++f)
    {
      const Index given = surface.origins[f].facet;
      for (int k = 0; k < 3 && needles[given]; ++k)
      {
        const Index edge = edges.facetEdges[f][k];
        if (wanted.marked[edge])
        {
          visit(given, edge);
        }
      }
    }
  };
  forEachMark([&](Index given, Index edge)
    { waits[given] |= static_cast<char>(!isWithinFacet(surface, edges, edge)); });
  forEachMark([&](Index given, Index edge)
    { wanted.marked[edge] = !waits[given] || !isWithinFacet(surface, edges, edge); });
}

/** Which facets are needles by the shapes; of no use when cancelled. */
std::vector<char> findNeedles(
  const RefinedSurface& surface, const PieceShapes& shapes, const RunControl& control)
{
  std::vector<char> needles(surface.origins.size());
  const auto find = [&](Offset f)
  { needles[f] = shapes.energy(surface.origins[f]) > shapes.needle; };
  static_cast<void>(forEachItem(static_cast<Offset>(needles.size()), control, find));
  return needles;
}
}

RefinedSurface wholeSurface(const SurfaceMesh& mesh, const Features* features)
{
  RefinedSurface surface;
  surface.mesh.points = mesh.points;
  surface.mesh.facetPoints = mesh.facetPoints;
  surface.mesh.facetCorners = mesh.facetCorners;
  surface.mesh.cornerPoints = mesh.cornerPoints;
  surface.mesh.facetInputCells = mesh.facetInputCells;
  if (features)
  {
    surface.features = *features;
  }
  surface.origins.resize(mesh.facetPoints.size());
  for (Index f = 0; f < mesh.numberOfFacets(); ++f)
  {
    surface.origins[f] = FacetOrigin::whole(f);
  }
  return surface;
}

namespace
{
/** Edges that were split are several edges of their curves. */
void traceAnew(const RunControl& control, RefinedSurface& surface)
{
  if (surface.features && !control.cancelled())
  {
    surface.features->corners.clear();
    surface.features->curves.clear();
    traceCurves(surface.mesh, *surface.features);
  }
}
}

bool refine(const SplitCriterion& criterion, const RefinementLimits& limits,
  const RunControl& control, RefinedSurface& surface)
{
  const std::vector<char> needles =
    limits.shapes ? findNeedles(surface, *limits.shapes, control) : std::vector<char>();
  bool any = false;
  bool fits = true;
  for (int round = 0; round < limits.maxRounds && fits && !control.cancelled(); ++round)
  {
    const EdgeTable own =
      surface.features ? EdgeTable{} : buildEdgeTable(surface.mesh.facetPoints, control);
    const EdgeTable& edges = surface.features ? surface.features->edges : own;
    if (control.cancelled())
    {
      break; // the table is not whole
    }
    EdgesToSplit wanted;
    criterion(surface, edges, wanted);
    if (std::find(wanted.marked.begin(), wanted.marked.end(), 1) == wanted.marked.end())
    {
      break;
    }
    if (limits.shapes)
    {
      splitSidesFirst(surface, edges, needles, wanted);
    }
    closeMarks(edges, wanted);
    const Offset room = limits.maxFacets - surface.mesh.numberOfFacets();
    fits = addedBy(edges, wanted) <= room;
    if (!fits)
    {
      keepLongest(edges, room, wanted);
    }
    if (!fits && addedBy(edges, wanted) > room)
    {
      break;
    }
    splitEdges(edges, wanted, limits.shapes, control, surface);
    any = true;
  }
  if (any)
  {
    traceAnew(control, surface);
  }
  return any;
}
}
