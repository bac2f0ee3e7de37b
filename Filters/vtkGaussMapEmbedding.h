/**
 * @class   vtkGaussMapEmbedding
 * @brief   Adds the remesher's embedding of a surface as the point array `Embedding`.
 *
 * Shows the space in which vtkAnisotropicRemesher measures: each point's position, its normal times
 * the anisotropy, and what else is part of the embedding (see vtkEmbeddedSurfaceAlgorithm).
 *
 * @par Outputs and arrays:
 * Output: the input, geometry and arrays untouched, with one more point array `Embedding`
 * (double, d components, one tuple per input point): what vtkAnisotropicRemesher with the same
 * parameters works on (with the `NormalSmoothingRadius` that its field data tells) where no
 * features cut the surface, and no needles are left out of its normals. With `PreserveFeatures`,
 * its default, it cuts the surface open along creases and borders of labels, and each fan of
 * triangles between them has a corner and a normal of its own; here a point has one tuple for all
 * sides.
 *
 * Coincident points have the same tuple; points that no polygon uses (or only one that intake
 * drops) have zeros after their position. Give the output to vtkAnisotropicRemesher with
 * `SetEmbeddingArray("Embedding")`, or change the array first to make an embedding of your own.
 *
 * @par When to use it:
 * - To see what vtkAnisotropicRemesher works on: the first three components are the position, the
 *   next three the scaled normal. Where the normal changes fast, triangles become small or long.
 * - To remesh in a space of your own: change `Embedding`, as with a calculator, and choose it there
 *   as `EmbeddingArray`.
 *
 * @par What is guaranteed:
 * Points, cells and arrays of the input are passed on as they are; one array is added.
 *
 * @par Limits:
 * Unusable input is an error, as for vtkAnisotropicRemesher, and the output is empty.
 */
#ifndef vtkGaussMapEmbedding_h
#define vtkGaussMapEmbedding_h

#include "vtkEmbeddedSurfaceAlgorithm.h"

class VTKFILTERSANISOTROPICREMESHING_EXPORT vtkGaussMapEmbedding
  : public vtkEmbeddedSurfaceAlgorithm
{
public:
  static vtkGaussMapEmbedding* New();
  vtkTypeMacro(vtkGaussMapEmbedding, vtkEmbeddedSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Number of points of the mesh that the embedding is for, at least 1, default 10000: estimated
   * normals are smoothed over 1.5 times their mean spacing, if at all (see
   * `NormalSmoothingPasses`).
   */
  vtkSetMacro(NumberOfPoints, vtkIdType);
  vtkGetMacro(NumberOfPoints, vtkIdType);
  ///@}

protected:
  vtkGaussMapEmbedding();
  ~vtkGaussMapEmbedding() override;

  remesh::Status CheckParameters() override;
  bool PassesInput(int outputPort) const override;
  int RequestWhole(vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkGaussMapEmbedding(const vtkGaussMapEmbedding&) = delete;
  void operator=(const vtkGaussMapEmbedding&) = delete;

  vtkIdType NumberOfPoints = 10000;
};

#endif
