/**
 * @file ExecutionScope.h
 * @brief The threads, back-end and memory of one filter's execution.
 */
#ifndef remesh_ExecutionScope_h
#define remesh_ExecutionScope_h

#include "Support/Status.h"

#include <functional>
#include <string>
#include <vector>

class vtkObject;

namespace remesh
{
struct Execution
{
  std::string backend; ///< name for vtkSMPTools
  int threads = 0;     ///< 0 asks for all; after runInScope, those that were there
};

/**
 * The execution for a choice of back-end ("" for automatic: VTK's current one, or STDThread where
 * that is Sequential, as in ParaView).
 *
 * @param available false when this VTK lacks the back-end and the automatic choice was taken.
 */
Execution chooseExecution(const std::string& backend, int threads, bool& available);

/** Runs `work` with that back-end and number of threads, and restores what was there. */
void runInScope(Execution& execution, const std::function<void()>& work);

/**
 * Runs a filter's work with its properties `SMPBackend` (0: automatic, Sequential, STDThread, TBB)
 * and `NumberOfThreads`; warns in its name where this VTK lacks the back-end.
 *
 * @param execution what was used.
 * @return what `work` does, or OutOfMemory where memory did not suffice for it.
 */
Status runFilter(vtkObject* filter, int backend, int threads, const std::function<Status()>& work,
  Execution& execution);

/** Shows warnings in a filter's name; empty ones are none. */
void showWarnings(vtkObject* filter, const std::vector<std::string>& warnings);

/**
 * Reports an error in a filter's name; not where there was nothing to do, nor of an aborted run.
 *
 * @return what RequestData is to return: 0 after an error, else 1.
 */
int reportEnd(vtkObject* filter, const Status& status);

/** Bytes; 0: not known. */
double machineMemory();
}

#endif
