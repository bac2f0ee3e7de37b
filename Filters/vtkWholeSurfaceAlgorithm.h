/**
 * @class   vtkWholeSurfaceAlgorithm
 * @brief   What all filters of this library share: what they take for a surface, and blocks.
 *
 * A surface is
 * - vtkPolyData with polygons or triangle strips;
 * - vtkUnstructuredGrid with triangles, quadrilaterals, pixels, polygons and strips alone;
 * - vtkMultiBlockDataSet, vtkPartitionedDataSetCollection or vtkPartitionedDataSet of those, within
 *   each other to any depth.
 * Vertices and lines are ignored. Anything else, also as a block (volumes, images, tables), is an
 * error that tells how to get a surface.
 *
 * Composite data are one surface: numbers of points are of all blocks together, and blocks that
 * touch (in points with equal coordinates) stay joined. A block's border is a feature, as if the
 * block's number were a label of the cells (see vtkAnisotropicRemesher::SetFeatureLabelArray).
 * Partitions of one vtkPartitionedDataSet are pieces of one block: between them is no feature.
 *
 * For composite input the outputs are of the same class and structure, with its names and other
 * metadata; null blocks stay null, empty ones empty. Then GetOutput() and its like return nothing:
 * use GetOutputDataObject(). Tables stay tables. In the outputs
 * - each triangle is in the block that most of it lies on, which with features is the only one; a
 *   point that several blocks share is in each, with the same coordinates and `SiteId`;
 * - the input's arrays in a block are those that the input's block has, also where others lack
 *   them, and their values at shared points are those of that block's side;
 * - an array that is to be used (as embedding, labels, density, coordinates) must be in all blocks
 *   that have polygons; active normals count only where all have them;
 * - sites are each in one block, the one with the largest part of its cell; lines along a border of
 *   blocks are in both; `SiteId` and `PatchId` number those of the whole, and `InputCellId` is the
 *   cell's id in the input's block;
 * - what a cell has (`CellArea` and so on) is that of the whole cell, divided evenly among the
 * points of its vertex in all blocks; facts in the field data are those of the whole, too; they are
 * in the field data of each block and of the composite data set.
 *
 * Sites, too, may be composite, of any vtkPointSet: they are numbered block by block.
 *
 * Several processes, as of ParaView's servers and batch programs, share a surface if each is asked
 * for one piece of it: through vtkMultiProcessController::GetGlobalController() the pieces come to
 * the first process, which does the work on all threads that it has. So the first process takes the
 * memory of the whole surface and the whole work, and one copy of the largest piece. The others
 * wait, but for the iterations of an optimisation. These are divided among all processes: each
 * holds its part of the embedded surface, and all sites, as long as they last. And where the
 * distance of mesh and surface is measured after a number of points was asked for, the others
 * measure one way of the two. The surface is that of one process:
 * - ghost cells count once, and points that pieces share are one;
 * - a surface that could come in pieces (any source of the pipeline can give some), or has several
 *   blocks, is put in an order of its own, on one process as on many: the same bytes for any number
 *   of them. Only a filter that spreads what one process has read changes the order, and so the
 *   mesh, as another seed does;
 * - what a filter passes on (vtkGaussMapEmbedding, vtkSurfaceMeshComparison) comes in the order of
 *   the processes;
 * - `InputCellId` numbers the cells of the pieces one after the other, without ghost cells;
 * - an error or warning is told on the first process alone, and the execution fails on all;
 * - where the input fails on any process, the filter executes on none, until the input or the time
 *   that is asked for is another.
 *
 * @par Aborting:
 * `AbortExecute`, set by an observer or by another thread, ends an execution within a fraction of a
 * second; where other processes measure a distance, when the slowest of them has done its part. All
 * outputs are empty then, which is no error, and the next Update() executes again. Some thirty
 * times a second the thread that executes invokes AbortCheckEvent, whose observers may set it, too.
 */
#ifndef vtkWholeSurfaceAlgorithm_h
#define vtkWholeSurfaceAlgorithm_h

#include "vtkFiltersAnisotropicRemeshingModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory>

class vtkCommand;

namespace remesh
{
class Ranks;
class SharedInputs;
}

class VTKFILTERSANISOTROPICREMESHING_EXPORT vtkWholeSurfaceAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkWholeSurfaceAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Where several processes share the work (see above): whether the outputs are spread over them,
   * or stay on the first, and are empty on the others. Spread, each process has a range of the
   * cells; appended in the order of the processes they are those of one process, in the same order.
   * Points at the cuts are in both parts. Tables stay on the first. Default: off.
   */
  vtkSetMacro(DistributeOutputs, bool);
  vtkGetMacro(DistributeOutputs, bool);
  vtkBooleanMacro(DistributeOutputs, bool);
  ///@}

#ifndef __VTK_WRAP__
  /**
   * A command for all filters of this library in this process, or nullptr (default): it gets
   * StartEvent before one does its work, AbortCheckEvent meanwhile and EndEvent after it, from the
   * thread that executes. For bindings of languages, where signals wait while a filter works. Not
   * to be changed while one does.
   */
  static void SetExecutionObserver(vtkCommand* observer);
#endif

  vtkTypeBool ProcessRequest(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int ModifyRequest(vtkInformation* request, int when) override;

protected:
  vtkWholeSurfaceAlgorithm();
  ~vtkWholeSurfaceAlgorithm() override;

  /** Any data object: what cannot be used gets an error of the filter's own, in every language. */
  int FillInputPortInformation(int port, vtkInformation* info) override;
  /** Any data object: what it is depends on the input. */
  int FillOutputPortInformation(int port, vtkInformation* info) override;

  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*);
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) final;

  /**
   * What RequestData is to other filters: there is at most one connection to each input port, with
   * plain data (vtkPolyData where a surface is asked for), and the outputs are vtkPolyData and
   * vtkTable.
   */
  virtual int RequestWhole(
    vtkInformationVector** inputVector, vtkInformationVector* outputVector) = 0;

  /** Called before anything else: facts of an earlier execution are not true any more. */
  virtual void ForgetLastRun() {}

  /** Whether an input port takes points (any vtkPointSet) and no surface. */
  virtual bool TakesPoints(int inputPort) const;

  /** The input port whose structure an output port has. */
  virtual int GetStructurePort(int outputPort) const;

  /**
   * Whether the outputs depend on the order of the input's points and cells, and show nothing of
   * it: then a surface that could come in pieces is put in an order of its own.
   */
  virtual bool MayReorder(int inputPort) const;

  /** Whether an output is that input itself with other point arrays. */
  virtual bool PassesInput(int outputPort) const;

  /** While RequestWhole runs: the processes that wait for orders; nullptr where there are none. */
  remesh::Ranks* GetRanks() const
  {
    return this->WaitingRanks;
  }

private:
  vtkWholeSurfaceAlgorithm(const vtkWholeSurfaceAlgorithm&) = delete;
  void operator=(const vtkWholeSurfaceAlgorithm&) = delete;

  struct vtkWhole;
  int WorkOnWhole(vtkWhole& whole);
  void ForgetAbort();

  bool DistributeOutputs = false;
  const std::unique_ptr<remesh::SharedInputs> Inputs;
  remesh::Ranks* WaitingRanks = nullptr;
};

#endif
