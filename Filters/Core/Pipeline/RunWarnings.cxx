#include "Pipeline/RunWarnings.h"

#include "Mesh/FacetGeometry.h"
#include "Mesh/NormalFlow.h"
#include "Placement/StrayTriangles.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace remesh
{
namespace
{
// Of the length of all creases, dropped ones:
constexpr double minDropped = 0.005;
constexpr double maxDropped = 0.25;

/**
 * The RMS distance of a mesh that follows its surface, as shares of the mean spacing of its points
 * and of its triangles' length: beyond both, triangles are as large as what they should follow.
 * Where points are far apart, so may mesh and surface be, whatever the mean spacing is. (measured,
 * of the length: 0.08 for a sphere with spikes by 30 points, 0.10 for armadillo by 100; 0.04 by
 * 300, and at most 0.06 for meshes of graded and stretched embeddings that have the surface's
 * topology.)
 */
constexpr double maxOfSpacing = 0.1;
constexpr double maxOfLength = 0.07;

/** The distance between neighbours, if points were spread evenly and hexagonally. */
double hexagonalSpacing(const RunOutcome& outcome)
{
  return std::sqrt(2.0 / std::sqrt(3.0)) *
    meanSpacing(outcome.prepared.mesh, outcome.result.components.count());
}

/** The longest edges of the triangles, root mean square by area. */
double lengthOfTriangles(const RemeshResult& result)
{
  double area = 0.0;
  double sum = 0.0;
  const std::vector<Point3>& at = result.placement.positions;
  for (const auto& [i, j, k] : result.dual.triangles)
  {
    const double share = facetArea(at[i], at[j], at[k]);
    const double longest = std::max({ (at[i] - at[j]).squaredNorm(), (at[j] - at[k]).squaredNorm(),
      (at[k] - at[i]).squaredNorm() });
    area += share;
    sum += share * longest;
  }
  return area > 0.0 ? std::sqrt(sum / area) : 0.0;
}

/** Why a mesh is far from its surface, and what helps. */
std::string causeOfDistance(const RunOutcome& outcome)
{
  const Offset points = outcome.result.components.count();
  const Offset onFeatures = outcome.result.featureSites.numberOfPoints();
  std::ostringstream text;
  if (2 * onFeatures > points)
  {
    text << "Corners and curves take " << onFeatures << " of its " << points
         << " points. More points or a larger feature angle help.";
  }
  else if (outcome.prepared.isEmbeddingGiven)
  {
    text << "Its " << points
         << " points are too few where the given embedding is smallest. More points help.";
  }
  else
  {
    text << "Its " << points
         << " points are too few for the surface's bends. More points or another anisotropy help.";
  }
  return text.str();
}

/** A mesh that misses parts of the surface, whatever else holds of it. */
void tellDistance(const RunOutcome& outcome, std::vector<std::string>& warnings)
{
  if (!outcome.result.distance)
  {
    return;
  }
  const double rms = outcome.result.distance->rms();
  const double length = lengthOfTriangles(outcome.result);
  if (rms > std::max(maxOfSpacing * hexagonalSpacing(outcome), maxOfLength * length))
  {
    std::ostringstream warning;
    warning.precision(2);
    warning << "The mesh is far from the surface: the RMS distance is " << rms << ", "
            << rms / length << " times the length of the triangles. " << causeOfDistance(outcome);
    warnings.push_back(warning.str());
  }
}

/**
 * Creases of a part that are missed. Where many are left out, they are the noise of a scan, or a
 * thin rim that is rounded: that is nothing to tell. Fewer can hardly be seen.
 */
void tellDroppedCreases(const PreparedSurface& prepared, std::vector<std::string>& warnings)
{
  const DroppedCreases& dropped = prepared.dropped;
  const double all = dropped.length + dropped.keptLength;
  const double share = all > 0.0 ? dropped.length / all : 0.0;
  if (!(share > minDropped && share < maxDropped))
  {
    return;
  }
  std::ostringstream warning;
  warning.precision(2);
  warning << "Not all creases are kept: " << dropped.edges << " edges, " << 100.0 * share
          << " percent of their length, are left out. ";
  if (dropped.sidesOfNeedles > 0)
  {
    warning << dropped.sidesOfNeedles << " of them run along triangles that are narrower than a "
            << "fifth of the spacing of the points. ";
  }
  if (dropped.edges > dropped.sidesOfNeedles)
  {
    warning << dropped.edges - dropped.sidesOfNeedles << " are of creases that are short against "
            << "it, or branch and zigzag like noise. ";
  }
  warning.precision(4);
  warning << "The longest is at (" << dropped.place.x() << ", " << dropped.place.y() << ", "
          << dropped.place.z() << "). More points help.";
  warnings.push_back(warning.str());
}

void tellWrongTriangles(const RemeshResult& result, std::vector<std::string>& warnings)
{
  if (const Offset flipped = result.placement.edits.inverted; flipped > 0)
  {
    warnings.push_back(std::to_string(flipped) +
      (flipped == 1 ? " triangle faces" : " triangles face") +
      " the surface the wrong way. More points or less anisotropy help.");
  }
  if (const Offset strays = result.placement.strays; strays > 0)
  {
    warnings.push_back(std::to_string(strays) + (strays == 1 ? " triangle is" : " triangles are") +
      " closer to another part of the surface than to " + (strays == 1 ? "its" : "their") +
      " own, facing it the wrong way. More points help where its sheets are close to each other.");
  }
  const Offset pairs = result.placement.crossings;
  if (pairs > 0 && result.placement.strays == 0) // strays go through what they are close to
  {
    const auto triangles = static_cast<Offset>(result.dual.triangles.size());
    warnings.push_back((pairs > maxStrays(triangles) ? "At least " : "") + std::to_string(pairs) +
      (pairs == 1 ? " pair" : " pairs") +
      " of triangles go through each other where the surface does not. More points help.");
  }
}
}

namespace
{
/** What keeps the mesh from the number of points that was asked for. */
void tellNumber(
  const RemeshResult& result, const RemeshOptions& options, std::vector<std::string>& warnings)
{
  if (result.emptyCells > 0)
  {
    warnings.push_back(std::to_string(result.emptyCells) +
      " sites have empty cells: the surface cannot hold so many points.");
  }
  const Offset extra = result.extraVertices();
  if (result.hasTooManyVertices(options))
  {
    warnings.push_back("The mesh has " + std::to_string(extra) +
      " points more than asked for, as features take so many, each component and patch a few, or "
      "so many cells reach several parts of the surface. More points or less anisotropy help.");
  }
  if (extra < 0 && result.emptyCells == 0)
  {
    warnings.push_back("The mesh has fewer points than asked for, by " + std::to_string(-extra) +
      ", as so many cells reach several parts of the surface. More points help.");
  }
  if (2 * result.neededFeaturePoints > options.numberOfSites)
  {
    warnings.push_back("Corners and curves of the surface need " +
      std::to_string(result.neededFeaturePoints) + " of the " +
      std::to_string(options.numberOfSites) + " points asked for; the mesh has " +
      std::to_string(result.components.count()) + ", " +
      std::to_string(result.featureSites.numberOfPoints()) +
      " of them there. More points or a larger feature angle help.");
  }
}
}

std::vector<std::string> warningsOf(const RunRequest& request, const RunOutcome& outcome)
{
  const RemeshResult& result = outcome.result;
  const bool hasNumber = request.hasNumber();
  std::vector<std::string> warnings = outcome.prepared.warnings;
  if (!request.options.optimize)
  {
    return warnings;
  }
  if (hasNumber)
  {
    tellDroppedCreases(outcome.prepared, warnings);
    tellNumber(result, request.options, warnings);
  }
  if (result.topology.lost())
  {
    warnings.push_back(
      result.topology.describe() + " More points, extra points or less anisotropy help.");
  }
  tellWrongTriangles(result, warnings);
  if (hasNumber && outcome.given.places.empty()) // else it is the caller's choice
  {
    tellDistance(outcome, warnings);
  }
  return warnings;
}
}
