/**
 * Arrays that are computed from the surface before it is remeshed: a metric for solutions, and
 * eigenfunctions. And the metric of the mesh that comes out.
 */
#ifndef ComputedFields_h
#define ComputedFields_h

#include <vtkSmartPointer.h>

#include <string>

class vtkPolyData;
class vtkSurfaceFieldAlgorithm;
struct Options;

/** A filter that adds the point array Metric for the options' solutions; null: there are none. */
vtkSmartPointer<vtkSurfaceFieldAlgorithm> MetricForSolutions(const Options& options);

/** A filter that adds the point array Embedding of eigenfunctions; null: they are not wanted. */
vtkSmartPointer<vtkSurfaceFieldAlgorithm> EigenfunctionsFor(const Options& options);

/**
 * Throws Failure with EXIT_USAGE where more than one embedding is asked for, or a metric that the
 * mesh has no room for beside its own arrays, though it is to be written.
 */
void CheckEmbeddings(const Options& options);

/** The options that take the computed arrays for metric and embedding. */
Options WithComputedFields(const Options& options);

/** The file for the metric beside the mesh; "": none is asked for, or the format has none. */
std::string MetricNameFor(const Options& options);

/** The metric that the mesh was made in, at its points, for that file. Throws Failure. */
std::string MetricBytes(vtkPolyData* mesh, const Options& options);

#endif
