/**
 * @file MemoryCheck.h
 * @brief Whether a run can be held, asked before it begins: afterwards, the system may end it.
 */
#ifndef remesh_MemoryCheck_h
#define remesh_MemoryCheck_h

#include "Support/Status.h"
#include "Support/Types.h"

namespace remesh
{
/**
 * @param historyLength pairs of vectors that the optimiser keeps.
 * @return OutOfMemory, with what is needed and what there is, where the arrays per site alone are
 *         more than the machine's memory.
 */
Status checkMemory(Offset numberOfSites, int dimension, int historyLength);
}

#endif
