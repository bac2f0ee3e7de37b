#include "Adaptors/ProcessRanks.h"

#include "vtkMultiProcessController.h"

#ifdef REMESH_HAS_MPI
#include "vtkMPIController.h"
#endif

#include <algorithm>
#include <chrono>
#include <new>
#include <string>
#include <thread>

namespace remesh
{
namespace
{
constexpr int packetTag = 20121;       ///< of all packets
constexpr vtkIdType longest = 1 << 20; ///< of the pieces of a packet, in bytes

bool tryToResize(std::vector<char>& bytes, vtkIdType size)
{
  try
  {
    bytes.resize(static_cast<std::size_t>(size));
    return true;
  }
  catch (const std::bad_alloc&)
  {
    return false;
  }
}
}

void awaitMessage(vtkMultiProcessController* controller, int from, int tag)
{
#ifdef REMESH_HAS_MPI
  if (auto* mpi = vtkMPIController::SafeDownCast(controller))
  {
    using namespace std::chrono;
    const auto begin = steady_clock::now();
    for (int arrived = 0; mpi->Iprobe(from, tag, &arrived, nullptr) && !arrived;)
    {
      // Late by a 32nd of the wait, and by 20 ms, at most; at each hop from process to process
      // (RankTree.h) anew. Between two orders there may be a millisecond, or an hour.
      const auto waited = duration_cast<microseconds>(steady_clock::now() - begin);
      std::this_thread::sleep_for(
        std::clamp<microseconds>(waited / 32, microseconds(20), milliseconds(20)));
    }
  }
#else
  static_cast<void>(controller);
  static_cast<void>(from);
  static_cast<void>(tag);
#endif
}

int ProcessRanks::count() const
{
  return this->Controller->GetNumberOfProcesses();
}

int ProcessRanks::own() const
{
  return this->Controller->GetLocalProcessId();
}

void ProcessRanks::send(int rank, const Packet& packet)
{
  const auto size = static_cast<vtkIdType>(packet.bytes().size());
  bool arrives = this->Controller->Send(&size, 1, rank, packetTag) != 0;
  for (vtkIdType begin = 0; begin < size && arrives; begin += longest)
  {
    const vtkIdType length = std::min(longest, size - begin);
    arrives = this->Controller->Send(packet.bytes().data() + begin, length, rank, packetTag) != 0;
  }
  if (!arrives)
  {
    throw std::runtime_error("Process " + std::to_string(rank) + " cannot be reached.");
  }
}

Packet ProcessRanks::receive(int rank)
{
  vtkIdType size = 0;
  if (this->own() != first)
  {
    awaitMessage(this->Controller, rank, packetTag);
  }
  bool arrived = this->Controller->Receive(&size, 1, rank, packetTag) != 0;
  std::vector<char> bytes;
  const bool fits = tryToResize(bytes, arrived ? size : 0);
  // What there is no room for has to be taken off the way, too.
  std::vector<char> spare(fits ? 0 : static_cast<std::size_t>(longest));
  for (vtkIdType begin = 0; begin < size && arrived; begin += longest)
  {
    const vtkIdType length = std::min(longest, size - begin);
    char* piece = fits ? bytes.data() + begin : spare.data();
    arrived = this->Controller->Receive(piece, length, rank, packetTag) != 0;
  }
  if (!fits)
  {
    throw std::bad_alloc();
  }
  if (!arrived)
  {
    throw std::runtime_error("Process " + std::to_string(rank) + " does not answer.");
  }
  return Packet(std::move(bytes));
}
}
