#include "Mesh/IntakeDraft.h"

#include "Support/Grouping.h"

namespace remesh
{
namespace
{
Status checkTriangles(const TriangleSoup& soup, const RunControl& control)
{
  const auto count = static_cast<std::int64_t>(soup.triangles.size());
  if (count > maximumInputTriangles)
  {
    return Status::invalid(sentence("The surface has ", count, " triangles; the most that can be ",
      "taken in is ", maximumInputTriangles, "."));
  }
  if (soup.inputCells.size() != soup.triangles.size())
  {
    return Status::invalid(
      sentence("There are ", soup.inputCells.size(), " cell ids for ", count, " triangles."));
  }
  const auto numberOfPoints = static_cast<Offset>(soup.points.size());
  const auto isBad = [numberOfPoints](Offset point)
  { return point < 0 || point >= numberOfPoints; };
  LowestItems bad(1);
  if (!forEachItem(count, control.silent(),
        [&](Offset t)
        {
          const auto& triangle = soup.triangles[t];
          if (std::any_of(triangle.begin(), triangle.end(), isBad))
          {
            bad.add(0, t);
          }
        }))
  {
    return Status::cancelled();
  }
  if (!bad.has(0))
  {
    return Status::success();
  }
  const auto& triangle = soup.triangles[bad[0]];
  return Status::invalid(sentence("Cell ", soup.inputCells[bad[0]], " refers to point ",
    *std::find_if(triangle.begin(), triangle.end(), isBad), ", but the surface has ",
    numberOfPoints, " points."));
}

/** Copies the used points; `local` gets their numbers. */
Status copyUsedPoints(
  const TriangleSoup& soup, const RunControl& control, Draft& draft, std::vector<Index>& local)
{
  const RunControl silent = control.silent();
  const auto count = static_cast<Offset>(soup.triangles.size());
  std::vector<std::atomic<bool>> used(soup.points.size());
  local.assign(soup.points.size(), noIndex);
  bool fits = true;
  const bool done = forEachItem(count, silent,
                      [&](Offset t)
                      {
                        for (const Offset point : soup.triangles[t])
                        {
                          used[point].store(true, std::memory_order_relaxed);
                        }
                      }) &&
    packItems(
      static_cast<Offset>(used.size()), silent,
      [&](Offset point) { return fits && used[point].load(std::memory_order_relaxed); },
      [&](Offset points)
      {
        fits = points <= maximumIndex;
        draft.inputPoints.resize(fits ? static_cast<std::size_t>(points) : 0);
        draft.points.resize(draft.inputPoints.size());
      },
      [&](Offset point, Offset number)
      {
        local[point] = static_cast<Index>(number);
        draft.inputPoints[number] = point;
        draft.points[number] = soup.points[point];
      });
  if (!done)
  {
    return Status::cancelled();
  }
  return fits ? Status::success()
              : Status::invalid(sentence("The surface has more than ", maximumIndex, " points."));
}

/** Numbers the used points and writes the facets with these numbers. */
Status collectUsedPoints(const TriangleSoup& soup, const RunControl& control, Draft& draft)
{
  std::vector<Index> local;
  if (Status status = copyUsedPoints(soup, control, draft, local); !status.ok())
  {
    return status;
  }
  draft.facets.resize(soup.triangles.size());
  draft.facetTriangles.resize(soup.triangles.size());
  return forEachItem(static_cast<Offset>(soup.triangles.size()), control.silent(),
           [&](Offset t)
           {
             const auto& triangle = soup.triangles[t];
             draft.facets[t] = { local[triangle[0]], local[triangle[1]], local[triangle[2]] };
             draft.facetTriangles[t] = static_cast<Index>(t);
           })
    ? Status::success()
    : Status::cancelled();
}

Status checkCoordinates(const Draft& draft)
{
  Point3 lower = Point3::Zero();
  Point3 upper = Point3::Zero();
  for (std::size_t i = 0; i < draft.points.size(); ++i)
  {
    const Point3& point = draft.points[i];
    if (!point.allFinite())
    {
      return Status::invalid(sentence("Point ", draft.inputPoints[i], " is not finite: (", point[0],
        ", ", point[1], ", ", point[2], ")."));
    }
    if (!(point.cwiseAbs().maxCoeff() <= largestCoordinate))
    {
      return Status::invalid(sentence("Point ", draft.inputPoints[i], " is too far away: (",
        point[0], ", ", point[1], ", ", point[2], ") exceeds ", largestCoordinate, "."));
    }
    lower = i == 0 ? point : Point3(lower.cwiseMin(point));
    upper = i == 0 ? point : Point3(upper.cwiseMax(point));
  }
  const double extent = (upper - lower).maxCoeff();
  if (extent > 0.0 && extent < smallestExtent)
  {
    return Status::invalid(sentence("The surface is too small: its longest extent, ", extent,
      ", is below ", smallestExtent, "; scale it up."));
  }
  return Status::success();
}
}

Status draftSoup(const TriangleSoup& soup, const RunControl& control, Draft& draft)
{
  Status status = checkTriangles(soup, control);
  if (status.ok())
  {
    status = collectUsedPoints(soup, control, draft);
  }
  return status.ok() ? checkCoordinates(draft) : status;
}
}
