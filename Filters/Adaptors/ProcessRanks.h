/**
 * @file ProcessRanks.h
 * @brief VTK's processes as the core's ranks.
 */
#ifndef remesh_ProcessRanks_h
#define remesh_ProcessRanks_h

#include "Support/Ranks.h"

class vtkMultiProcessController;

namespace remesh
{
/**
 * Sleeps until a process has something to tell; else receiving would keep a core busy. Returns at
 * once where the processes are not those of MPI, or the library is built without it.
 */
void awaitMessage(vtkMultiProcessController* controller, int from, int tag);

class ProcessRanks : public Ranks
{
public:
  /** @param controller that outlives it. */
  explicit ProcessRanks(vtkMultiProcessController* controller)
    : Controller(controller)
  {
  }

  int count() const override;
  int own() const override;
  void send(int rank, const Packet& packet) override;
  Packet receive(int rank) override;

private:
  vtkMultiProcessController* Controller;
};
}

#endif
