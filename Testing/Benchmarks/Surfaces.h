/**
 * @file Surfaces.h
 * @brief What is measured: a scan where there is one, else a generated surface of its size.
 */
#ifndef remesh_benchmark_Surfaces_h
#define remesh_benchmark_Surfaces_h

#include "Embedding/EmbeddedSurface.h"
#include "Results.h"

#include <vtkDoubleArray.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

namespace remesh::benchmark
{
constexpr double anisotropy = 0.02; ///< of every Gauss map, a fraction of the diagonal
constexpr double scanTriangles = 86482.0;

struct Surface
{
  std::string name;
  vtkSmartPointer<vtkPolyData> data;
  std::string file; ///< "" if it was generated
};

/** armadillo.ply (86 482 triangles) of a folder, or, where it is not, a bumpy torus of its size. */
Surface scan(const std::string& folder);

/** A torus with waves of several lengths on it, of about this many triangles. */
Surface bumpyTorus(double triangles);

/** Two of them, the inner one turned over, closer to each other than the points of a mesh. */
Surface thinShell(double triangles);

/**
 * A plain torus of about this many points. Its point array Metric (6 components, VTK's order) wants
 * edges three times as long along one direction as across it, which turns three times on the way
 * around, and sizes that differ by 5.7.
 */
Surface torusWithMetric(double points);

/**
 * The unit square as a grid of about this many points. Its point array Metric wants edges of 1e-4
 * across a sine, that grow to 0.1 away from it, and of 0.1 along it: a layer that bends more than
 * straight edges can follow, and is thinner than the grid.
 */
Surface gridWithLayer(double points);

/** The one of both that is meant. */
Surface surfaceFor(const MetricRun& run);

/** Each triangle cut into 16: Loop's scheme, twice. */
Surface subdivided(const Surface& surface);

/** Binary PLY, as scans come; VTP where there is a Metric. Throws std::runtime_error. */
void writeSurface(vtkPolyData* surface, const std::string& path);

/** The ending of that file's name. */
const char* extensionFor(vtkPolyData* surface);

/** Embedded by the Gauss map, d = 6, as in a default run. Throws std::runtime_error. */
EmbeddedSurface gaussMapped(vtkPolyData* surface);

/** A point array of `count` smooth functions of the positions, of a common size that is fixed. */
vtkSmartPointer<vtkDoubleArray> smoothFunctions(vtkPolyData* surface, int count);

/** Embedded by the positions and d - 3 smooth functions of them. */
EmbeddedSurface embeddedIn(vtkPolyData* surface, int dimension);
}

#endif
