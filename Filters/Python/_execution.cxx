/**
 * The module _execution: lets Python's signals through while a filter of the library works.
 *
 * Python runs a signal's handler only between two steps of Python code, so that Ctrl-C waits until
 * a filter is done; and where the filter calls a Python observer, VTK ends the program if the
 * handler raises there. Instead, while a filter works in the main thread:
 *
 * 1. SIGINT only sets a flag, if Python handles that signal (else it is left alone);
 * 2. the filter asks some thirty times a second (AbortCheckEvent): if the flag is set, Python's
 *    handler, whichever it is, is called then and there, outside of any observer;
 * 3. where the handler raises, the run is stopped, and what it raised is kept;
 * 4. afterwards the signal has its old handler, and what was kept is raised: by `update`, or where
 *    Python goes on after the call that made the filter execute.
 *
 * Other threads' executions are left alone: Python's handlers run in the main thread.
 */
#include "vtkPython.h" // first, as it asks

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkPythonUtil.h"
#include "vtkSmartPointer.h"
#include "vtkWholeSurfaceAlgorithm.h"

#include <csignal>
#include <new>
#include <utility>

namespace
{
volatile std::sig_atomic_t interrupted = 0;

void noteSignal(int)
{
  interrupted = 1;
}

/** An exception that Python has raised, kept for later. For the one who has the GIL. */
class KeptException
{
public:
  bool empty() const { return m_type == nullptr; }

  /** Keeps what is raised now; of several the first. */
  void take()
  {
    PyObject* type = nullptr;
    PyObject* value = nullptr;
    PyObject* traceback = nullptr;
    PyErr_Fetch(&type, &value, &traceback);
    if (this->empty())
    {
      std::swap(type, m_type);
      std::swap(value, m_value);
      std::swap(traceback, m_traceback);
    }
    Py_XDECREF(type);
    Py_XDECREF(value);
    Py_XDECREF(traceback);
  }

  void raise()
  {
    PyErr_Restore(std::exchange(m_type, nullptr), std::exchange(m_value, nullptr),
      std::exchange(m_traceback, nullptr));
  }

private:
  PyObject* m_type = nullptr;
  PyObject* m_value = nullptr;
  PyObject* m_traceback = nullptr;
};

/** What is true of the main thread's executions; no other thread looks at it. */
struct MainThread
{
  unsigned long id = 0;
  int depth = 0;            ///< executions within each other
  bool inUpdate = false;    ///< `update` raises what was kept
  bool takesSignal = false; ///< SIGINT is ours
  struct sigaction before = {};
  KeptException kept;
  PyFrameObject* frame = nullptr; ///< the Python code that made the filter execute

  bool isHere() const { return PyThread_get_thread_ident() == this->id; }
};

MainThread mainThread;

/** Whether SIGINT calls a Python function: not the system's default, nor a handler of C. */
bool pythonHandlesSignal()
{
  const vtkPythonScopeGilEnsurer gil(true);
  KeptException outside;
  outside.take();
  PyObject* const module = PyImport_ImportModule("signal");
  PyObject* const handler =
    module ? PyObject_CallMethod(module, "getsignal", "i", SIGINT) : nullptr;
  const bool handles = handler && PyCallable_Check(handler);
  Py_XDECREF(handler);
  Py_XDECREF(module);
  outside.raise();
  return handles;
}

/** Takes SIGINT where there is a handler to be called later. */
void takeSignal()
{
  struct sigaction ours = {};
  ours.sa_handler = noteSignal;
  sigemptyset(&ours.sa_mask);
  interrupted = 0;
  mainThread.takesSignal = pythonHandlesSignal() &&
    sigaction(SIGINT, nullptr, &mainThread.before) == 0 &&
    mainThread.before.sa_handler != SIG_DFL && mainThread.before.sa_handler != SIG_IGN &&
    sigaction(SIGINT, &ours, nullptr) == 0;
}

/** Gives SIGINT back, unless somebody else has taken it meanwhile. */
void giveSignalBack()
{
  struct sigaction current = {};
  if (mainThread.takesSignal && sigaction(SIGINT, nullptr, &current) == 0 &&
    current.sa_handler == noteSignal)
  {
    sigaction(SIGINT, &mainThread.before, nullptr);
  }
  mainThread.takesSignal = false;
}

/** Calls Python's handler if there was a signal; stops the execution where it raises. */
void callHandler(vtkAlgorithm* algorithm)
{
  if (!interrupted)
  {
    return;
  }
  interrupted = 0;
  const vtkPythonScopeGilEnsurer gil(true);
  KeptException outside;
  outside.take();
  PyErr_SetInterrupt();
  if (PyErr_CheckSignals() != 0)
  {
    mainThread.kept.take();
    algorithm->SetAbortExecute(1);
  }
  outside.raise();
}

/** Whether Python is in code, as an observer's, that `frame` waits for. */
bool isBelow(PyFrameObject* frame)
{
  PyFrameObject* current = PyEval_GetFrame();
  Py_XINCREF(current);
  bool below = false;
  while (current && current != frame && !below)
  {
    PyFrameObject* back = PyFrame_GetBack(current);
    Py_DECREF(current);
    current = back;
    below = current != nullptr && current == frame;
  }
  Py_XDECREF(current);
  return below;
}

/** A pending call of Python: raises what was kept, but not in observers, which VTK would not bear.
 */
int raiseLater(void*)
{
  if (mainThread.kept.empty())
  {
    return 0;
  }
  if (mainThread.depth > 0 || (mainThread.frame && isBelow(mainThread.frame)))
  {
    Py_AddPendingCall(raiseLater, nullptr);
    return 0;
  }
  Py_CLEAR(mainThread.frame);
  mainThread.kept.raise();
  return -1;
}

class SignalObserver : public vtkCommand
{
public:
  static SignalObserver* New() { return new SignalObserver; }

  void Execute(vtkObject* caller, unsigned long event, void*) override
  {
    auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
    if (!algorithm || !mainThread.isHere())
    {
      return;
    }
    switch (event)
    {
      case vtkCommand::StartEvent:
        this->Start();
        break;
      case vtkCommand::AbortCheckEvent:
        callHandler(algorithm);
        break;
      default:
        this->End(algorithm);
    }
  }

private:
  void Start()
  {
    if (mainThread.depth++ > 0)
    {
      return;
    }
    takeSignal();
    if (!mainThread.inUpdate)
    {
      const vtkPythonScopeGilEnsurer gil(true); // some releases of VTK update without it
      Py_XDECREF(mainThread.frame);
      mainThread.frame = PyEval_GetFrame();
      Py_XINCREF(mainThread.frame);
    }
  }

  void End(vtkAlgorithm* algorithm)
  {
    if (--mainThread.depth > 0)
    {
      return;
    }
    giveSignalBack();
    callHandler(algorithm);
    if (!mainThread.kept.empty())
    {
      if (!mainThread.inUpdate)
      {
        Py_AddPendingCall(raiseLater, nullptr);
      }
    }
    else if (mainThread.frame)
    {
      const vtkPythonScopeGilEnsurer gil(true);
      Py_CLEAR(mainThread.frame);
    }
  }
};

/** A VTK built without regard to Python's threads, as ParaView's, calls observers without the GIL.
 */
#ifdef VTK_NO_PYTHON_THREADS
constexpr bool releasesGil = false;
#else
constexpr bool releasesGil = true;
#endif

/** Updates, with the GIL released where VTK bears it; false where memory did not suffice. */
bool updateAlone(vtkAlgorithm* algorithm)
{
  bool done = true;
  PyThreadState* const state = releasesGil ? PyEval_SaveThread() : nullptr;
  try
  {
    algorithm->Update();
  }
  catch (const std::bad_alloc&)
  {
    done = false;
  }
  if (state)
  {
    PyEval_RestoreThread(state);
  }
  return done;
}

PyObject* update(PyObject*, PyObject* object)
{
  vtkObjectBase* const pointer = vtkPythonUtil::GetPointerFromObject(object, "vtkAlgorithm");
  if (!pointer)
  {
    return nullptr;
  }
  const vtkSmartPointer<vtkAlgorithm> algorithm = static_cast<vtkAlgorithm*>(pointer);
  const bool isMain = mainThread.isHere();
  const bool outer = isMain && std::exchange(mainThread.inUpdate, true);
  const bool done = updateAlone(algorithm);
  if (isMain)
  {
    mainThread.inUpdate = outer;
    if (!outer && !mainThread.kept.empty())
    {
      mainThread.kept.raise();
      return nullptr;
    }
  }
  if (!done)
  {
    return PyErr_NoMemory();
  }
  Py_RETURN_NONE;
}

PyObject* watch(PyObject*, PyObject* object)
{
  const unsigned long id = PyLong_AsUnsignedLong(object);
  if (PyErr_Occurred())
  {
    return nullptr;
  }
  mainThread.id = id;
  vtkNew<SignalObserver> observer;
  vtkWholeSurfaceAlgorithm::SetExecutionObserver(observer);
  Py_RETURN_NONE;
}

PyMethodDef methods[] = {
  { "update", update, METH_O,
    "update(algorithm) -> None\n\nCalls its Update(), and raises what a signal's handler raises, "
    "as "
    "KeyboardInterrupt.\nOther threads work meanwhile if releases_gil is True." },
  { "watch", watch, METH_O,
    "watch(main_thread_ident) -> None\n\nFrom now on signals are heard while a filter of the "
    "library works." },
  { nullptr, nullptr, 0, nullptr },
};

PyModuleDef definition = { PyModuleDef_HEAD_INIT, "_execution", nullptr, -1, methods, nullptr,
  nullptr, nullptr, nullptr };
} // namespace

PyMODINIT_FUNC PyInit__execution()
{
  PyObject* const module = PyModule_Create(&definition);
  if (module)
  {
    PyModule_AddObject(module, "releases_gil", PyBool_FromLong(releasesGil));
  }
  return module;
}
