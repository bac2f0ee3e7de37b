/**
 * @file TestRequests.h
 * @brief Triangles and numbers as the pipeline asks for them.
 */
#ifndef remesh_TestRequests_h
#define remesh_TestRequests_h

#include "Pipeline/Pipeline.h"
#include "TestSupport.h"

#include <string>
#include <vector>

namespace remesh::test
{
/** The triangles, which must outlive it; counts how often they are read: once for each run. */
inline SurfaceSource sourceOf(const TriangleSoup& soup, int* reads = nullptr)
{
  SurfaceSource source;
  source.numberOfPoints = static_cast<Offset>(soup.points.size());
  source.read = [&soup, reads](TriangleSoup& taken, std::string&)
  {
    taken = soup;
    if (reads)
    {
      ++*reads;
    }
    return Status::success();
  };
  return source;
}

/** A run with so many points, without features. */
inline RunRequest requestOf(const TriangleSoup& soup, Offset points, int* reads = nullptr)
{
  RunRequest request;
  request.preparation.source = sourceOf(soup, reads);
  request.options.numberOfSites = points;
  request.options.quasiNewton.iterations = 10;
  return request;
}

inline RunOutcome outcomeOf(const RunRequest& request)
{
  RunOutcome outcome;
  CHECK(makeMesh(request, RunControl(), outcome).ok());
  return outcome;
}

/** Rows of so many values, which must outlive it. */
inline PointArray arrayOf(const std::vector<double>& values, int dimension)
{
  PointArray array;
  array.name = "Values";
  array.dimension = dimension;
  array.count = static_cast<Offset>(values.size()) / dimension;
  array.doubles = values.data();
  return array;
}

/** The coordinates of the points, row by row. */
inline std::vector<double> positionsOf(const TriangleSoup& soup)
{
  std::vector<double> values;
  for (const Point3& point : soup.points)
  {
    values.insert(values.end(), point.data(), point.data() + 3);
  }
  return values;
}
}

#endif
