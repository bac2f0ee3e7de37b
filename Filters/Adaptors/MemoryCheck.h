/**
 * @file MemoryCheck.h
 * @brief Whether a run can be held: asked before it begins, or tried beside a mesh there is.
 */
#ifndef remesh_MemoryCheck_h
#define remesh_MemoryCheck_h

#include "Support/Status.h"
#include "Support/Types.h"

#include <new>

namespace remesh
{
/**
 * To be asked before a run: once it has begun, the system may end it.
 *
 * @param historyLength pairs of vectors that the optimiser keeps.
 * @return OutOfMemory, with what is needed and what there is, where the arrays per site alone are
 *         more than the machine's memory.
 */
Status checkMemory(Offset numberOfSites, int dimension, int historyLength);

/** What `work` returns, or OutOfMemory, without a message, where memory does not suffice for it. */
template <class Work>
Status withinMemory(const Work& work)
{
  try
  {
    return work();
  }
  catch (const std::bad_alloc&)
  {
    return { StatusCode::OutOfMemory, "" };
  }
}
}

#endif
