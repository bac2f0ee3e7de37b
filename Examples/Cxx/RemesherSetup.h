/**
 * From the options of the command line to the properties of the filters.
 */
#ifndef RemesherSetup_h
#define RemesherSetup_h

#include <string>

class vtkAnisotropicRemesher;
class vtkEmbeddedSurfaceAlgorithm;
class vtkPolyData;
struct Options;

/**
 * Throws Failure unless `surface` has all arrays that the options name. Leaves it without active
 * normals if they are not to be used.
 */
void CheckArrays(vtkPolyData* surface, const Options& options);

/** The filters' number of a back-end. */
int BackendNumber(const std::string& name);

/** The parameters that the remesher and the embedding have in common. */
void SetEmbedding(vtkEmbeddedSurfaceAlgorithm* filter, const Options& options);

/** Those of the remesher alone. */
void SetRemeshing(vtkAnisotropicRemesher* remesher, const Options& options);

#endif
