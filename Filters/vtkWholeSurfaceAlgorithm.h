/**
 * @class   vtkWholeSurfaceAlgorithm
 * @brief   What all filters of this library share: inputs are whole surfaces.
 *
 * Whatever is at an input port becomes one vtkPolyData before a subclass sees it, and what the
 * subclass makes goes to the outputs after that.
 */
#ifndef vtkWholeSurfaceAlgorithm_h
#define vtkWholeSurfaceAlgorithm_h

#include "vtkFiltersAnisotropicRemeshingModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFILTERSANISOTROPICREMESHING_EXPORT vtkWholeSurfaceAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkWholeSurfaceAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkWholeSurfaceAlgorithm();
  ~vtkWholeSurfaceAlgorithm() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) final;

  /**
   * What RequestData is to other filters: there is at most one connection to each input port, with
   * plain data (vtkPolyData where a surface is asked for), and the outputs are vtkPolyData and
   * vtkTable.
   */
  virtual int RequestWhole(
    vtkInformationVector** inputVector, vtkInformationVector* outputVector) = 0;

private:
  vtkWholeSurfaceAlgorithm(const vtkWholeSurfaceAlgorithm&) = delete;
  void operator=(const vtkWholeSurfaceAlgorithm&) = delete;
};

#endif
