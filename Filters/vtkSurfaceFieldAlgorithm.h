/**
 * @class   vtkSurfaceFieldAlgorithm
 * @brief   What filters share that compute a point array on a surface for the remesher.
 *
 * The input is a surface of polygons or triangle strips, also of several blocks or as a grid (see
 * vtkWholeSurfaceAlgorithm). As for vtkAnisotropicRemesher polygons are cut into triangles,
 * points with equal coordinates count as one, and degenerate and duplicate triangles do not count.
 * The output is the input with one more point array, or for vtkMetricEmbedding its triangles with
 * more arrays. Coincident points have the same tuple.
 *
 * Setters keep what they are given. A value out of the range that a property's text names, or NaN,
 * is an error when the filter runs.
 */
#ifndef vtkSurfaceFieldAlgorithm_h
#define vtkSurfaceFieldAlgorithm_h

#include "vtkFiltersAnisotropicRemeshingModule.h" // For export macro
#include "vtkWholeSurfaceAlgorithm.h"

namespace remesh
{
struct FieldSurface;
struct Status;
}

class VTKFILTERSANISOTROPICREMESHING_EXPORT vtkSurfaceFieldAlgorithm
  : public vtkWholeSurfaceAlgorithm
{
public:
  vtkTypeMacro(vtkSurfaceFieldAlgorithm, vtkWholeSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SMPBackends
  {
    SMP_AUTOMATIC = 0,
    SMP_SEQUENTIAL = 1,
    SMP_STDTHREAD = 2,
    SMP_TBB = 3
  };

  ///@{
  /** Threads to use, as vtkEmbeddedSurfaceAlgorithm. */
  vtkSetMacro(NumberOfThreads, int);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /** The vtkSMPTools back-end of this filter alone, as vtkEmbeddedSurfaceAlgorithm. */
  vtkSetMacro(SMPBackend, int);
  vtkGetMacro(SMPBackend, int);
  ///@}

protected:
  vtkSurfaceFieldAlgorithm();
  ~vtkSurfaceFieldAlgorithm() override;

  bool PassesInput(int outputPort) const override;
  int RequestWhole(vtkInformationVector**, vtkInformationVector*) override;

  /** The first parameter that is out of its range, as an error. */
  virtual remesh::Status CheckParameters() = 0;

  /** Adds the array to the surface's output, which is a shallow copy of its input. */
  virtual remesh::Status AddField(remesh::FieldSurface& surface) = 0;

private:
  vtkSurfaceFieldAlgorithm(const vtkSurfaceFieldAlgorithm&) = delete;
  void operator=(const vtkSurfaceFieldAlgorithm&) = delete;

  int NumberOfThreads = 0;
  int SMPBackend = SMP_AUTOMATIC;
};

#endif
