/**
 * @class   vtkSpectralEmbedding
 * @brief   Adds the first eigenfunctions of a surface's Laplacian as the point array `Embedding`.
 *
 * Places in R^d whose distances are those of a kernel on the surface: of a random walk, of heat, or
 * biharmonic. Given to vtkAnisotropicRemesher as `EmbeddingArray`, triangles become even in those
 * distances ([Levy12], section 2).
 *
 * The Laplacian is that of linear finite elements (cotangents). Constant functions are left out, on
 * each component of the surface. Eigenvalues are found band by band, and a factor's signs prove
 * that none is missed.
 *
 * @par Outputs and arrays:
 * Output: the input with the point array `Embedding` (double, `Dimension` components):
 * eigenfunctions in the order of their eigenvalues, of the mean square 1 over the area, times the
 * `Scaling`. Field data: `Eigenvalues` (double, one tuple for each, 1 / length^2).
 *
 * @par When to use it:
 * - To remesh evenly in a surface's own distances, whatever its bends in space.
 * - For the spectrum itself: filters, signatures, segmentation.
 *
 * @par What is guaranteed:
 * Points, cells and arrays of the input are passed on as they are; one array is added. The output
 * does not depend on the threads or the back-end. The largest entry of each function is positive.
 *
 * @par Limits:
 * Functions of equal eigenvalues, as on symmetric surfaces, are one basis of many. More functions
 * than the surface has points less its components are an error. Where borders are fixed the
 * functions are 0 on them. Points that no polygon uses have zeros.
 *
 * Takes memory of points x `Dimension` x 16 bytes, and some 4 kB for each point beside, and time
 * for some 2.8 `Dimension` solutions with a sparse factor: seconds for 6 functions of 100 000
 * triangles, and about 50 s of one processor for a thousand.
 *
 * @par Reference:
 * B. Vallet, B. Levy: Spectral geometry processing with manifold harmonics. Computer Graphics Forum
 * 27, 2008.
 */
#ifndef vtkSpectralEmbedding_h
#define vtkSpectralEmbedding_h

#include "vtkFiltersAnisotropicRemeshingModule.h" // For export macro
#include "vtkSurfaceFieldAlgorithm.h"

class VTKFILTERSANISOTROPICREMESHING_EXPORT vtkSpectralEmbedding : public vtkSurfaceFieldAlgorithm
{
public:
  static vtkSpectralEmbedding* New();
  vtkTypeMacro(vtkSpectralEmbedding, vtkSurfaceFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Scalings
  {
    NONE = 0,
    COMMUTE_TIME = 1,
    DIFFUSION = 2,
    BIHARMONIC = 3
  };

  enum MassMatrices
  {
    LUMPED = 0,
    CONSISTENT = 1
  };

  enum BorderConditions
  {
    NATURAL = 0,
    FIXED = 1
  };

  ///@{
  /** Number of eigenfunctions d, 2 to 100000, default 6. */
  vtkSetMacro(Dimension, int);
  vtkGetMacro(Dimension, int);
  ///@}

  ///@{
  /**
   * What the eigenfunction of an eigenvalue lambda is multiplied by: NONE 1, COMMUTE_TIME (default)
   * lambda^(-1/2), DIFFUSION exp(-`DiffusionTime` lambda), BIHARMONIC 1 / lambda.
   */
  vtkSetMacro(Scaling, int);
  vtkGetMacro(Scaling, int);
  ///@}

  ///@{
  /** The time of DIFFUSION, in squares of the points' unit, from 0, default 0. Heat has then come
   * about twice the time's root far. */
  vtkSetMacro(DiffusionTime, double);
  vtkGetMacro(DiffusionTime, double);
  ///@}

  ///@{
  /** The mass matrix: LUMPED (default), or CONSISTENT. Eigenvalues are too low, or too high. */
  vtkSetMacro(MassMatrix, int);
  vtkGetMacro(MassMatrix, int);
  ///@}

  ///@{
  /** At borders functions have no slope across (NATURAL, default), or are 0 (FIXED). */
  vtkSetMacro(BorderCondition, int);
  vtkGetMacro(BorderCondition, int);
  ///@}

protected:
  vtkSpectralEmbedding();
  ~vtkSpectralEmbedding() override;

  remesh::Status CheckParameters() override;
  remesh::Status AddField(remesh::FieldSurface& surface) override;

private:
  vtkSpectralEmbedding(const vtkSpectralEmbedding&) = delete;
  void operator=(const vtkSpectralEmbedding&) = delete;

  int Dimension = 6;
  int Scaling = COMMUTE_TIME;
  double DiffusionTime = 0.0;
  int MassMatrix = LUMPED;
  int BorderCondition = NATURAL;
};

#endif
