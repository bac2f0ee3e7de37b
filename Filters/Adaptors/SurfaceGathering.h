/**
 * @file SurfaceGathering.h
 * @brief The pieces of a surface that is distributed over processes, brought to the first of them.
 *
 * Processes take part if a filter is asked for one piece on each of them, as by ParaView's servers.
 * Then each of these is called by all of them, in this order, or some wait for ever.
 *
 * 1. `agree`: whether the input could be made on all of them. Where it failed, VTK would not call
 *    that process again, and the others would wait for it.
 * 2. `gather`: the first process gets the pieces of all, leaf by leaf of composite data, in the
 *    order of the processes and without ghost cells. Points that several pieces have stay several:
 *    intake makes them one.
 * 3. `work`: the first process does it, and the others what it asks them for (RankWork.h).
 * 4. `finish`: the others learn how it went, and get their parts of the outputs if these are
 *    spread.
 *
 * Between its orders the others sleep where the processes are those of MPI.
 *
 * Memory: the first process holds the whole surface and the whole result, and for a while one more
 * copy of the largest piece.
 */
#ifndef remesh_SurfaceGathering_h
#define remesh_SurfaceGathering_h

#include "Support/Status.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <memory>
#include <vector>

class vtkDataObject;
class vtkInformationVector;
class vtkMultiProcessController;

namespace remesh
{
class ProcessRanks;
class Ranks;

class SurfaceGathering
{
public:
  /** @param inputs one for each port, with one connection or none. */
  SurfaceGathering(vtkInformationVector** inputs, int numberOfInputs);
  ~SurfaceGathering();

  /** Whether several processes share the work. */
  bool isShared() const { return this->Controller != nullptr; }

  /** @return the number of processes that are not ready, the same on all. */
  int agree(bool ready) const;

  /** Whether this process does the work: the first, or the only one. */
  bool worksHere() const;

  /** What is at the ports: of all processes on the first, once gathered; else this process's. */
  vtkInformationVector** inputs() { return this->Inputs; }

  /**
   * Brings the pieces to the first process. Cost: nothing where there is only one.
   *
   * @param takesPoints of each port, whether only its points count.
   */
  void gather(const std::vector<bool>& takesPoints);

  /** The processes that share the work; nullptr where this one is alone. */
  Ranks* ranks() const;

  /**
   * On the first process, does the work, which must not throw; on the others, what it asks for.
   *
   * @return InvalidInput on the first, where another cannot be told that the work is done.
   */
  Status work(const std::function<void()>& own) const;

  /**
   * Tells the others how the work went, and spreads the outputs: data with cells are cut into
   * ranges of cells, one for each process in their order. Points at the cuts are in both. Tables
   * and grids stay on the first.
   *
   * @param done, spreads of the first process count. @return the same on all.
   */
  int finish(int done, vtkInformationVector* outputs, bool spreads);

private:
  void SendInputs(const std::vector<bool>& takesPoints);
  void ReceiveInputs(const std::vector<bool>& takesPoints);
  void SendParts(vtkInformationVector* outputs);
  void ReceiveParts(vtkInformationVector* outputs);

  vtkMultiProcessController* Controller = nullptr; ///< nullptr: this process is alone
  std::unique_ptr<ProcessRanks> Processes;         ///< the same
  vtkInformationVector** Inputs;
  std::size_t NumberOfInputs;
  std::vector<vtkSmartPointer<vtkInformationVector>> Gathered;
  std::vector<vtkInformationVector*> GatheredPointers;
};
}

#endif
