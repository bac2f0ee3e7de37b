"""TestFailingInput.py PLUGIN OUTPUT_FOLDER MPIEXEC PVBATCH (python3): an input that fails somewhere.

Runs itself by pvbatch on two processes. Where the input fails on either, the filter ends on both with
one message, and makes no surface of the other piece, until the input is another.
"""
import os
import subprocess
import sys


def run_inside():
    """One process of pvbatch, which has a controller for both."""
    import anisotropic_remeshing as ar
    from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
    from vtkmodules.vtkCommonCore import vtkLogger
    from vtkmodules.vtkCommonDataModel import vtkPolyData
    from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
    from vtkmodules.vtkFiltersSources import vtkSphereSource
    from vtkmodules.vtkParallelCore import vtkMultiProcessController

    controller = vtkMultiProcessController.GetGlobalController()
    rank, processes = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
    assert processes == 2, processes

    class Source(VTKPythonAlgorithmBase):
        """A sphere on each process, or a failure."""

        failing = None

        def __init__(self):
            super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")

        def RequestInformation(self, request, inputs, outputs):
            outputs.GetInformationObject(0).Set(vtkAlgorithm.CAN_HANDLE_PIECE_REQUEST(), 1)
            return 1

        def RequestData(self, request, inputs, outputs):
            if rank == self.failing:
                return 0
            sphere = vtkSphereSource()
            sphere.SetCenter(3.0 * rank, 0.0, 0.0)
            sphere.Update()
            vtkPolyData.GetData(outputs).ShallowCopy(sphere.GetOutput())
            return 1

    def update(expected):
        errors = []
        tag = remesher.AddObserver("ErrorEvent", lambda *_: errors.append(1))
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)  # the errors are wanted
        done = remesher.UpdatePiece(rank, processes, 0)
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_INFO)
        remesher.RemoveObserver(tag)
        assert bool(done) == (expected == "surface"), (done, expected)
        assert len(errors) == (1 if expected == "error" and rank == 0 else 0), (errors, expected)
        points = remesher.GetOutput().GetNumberOfPoints()
        assert points == (200 if expected == "surface" and rank == 0 else 0), (points, expected)

    for failing in range(processes):
        source = Source()
        remesher = ar.vtkAnisotropicRemesher()
        remesher.SetInputConnection(source.GetOutputPort())
        remesher.SetNumberOfPoints(200)
        source.failing = failing
        update("error")
        update("nothing")  # VTK takes the source for up to date, and told is told
        source.failing = None
        source.Modified()
        update("surface")
    print("process", rank, "is done", flush=True)


def run_outside(mpiexec, pvbatch):
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    told = subprocess.run([mpiexec, "--oversubscribe", "-n", "2", pvbatch, "--symmetric", __file__],
                          env=environment, check=True, timeout=120, stdout=subprocess.PIPE,
                          text=True).stdout
    print(told)
    assert told.count("is done") == 2, told


if len(sys.argv) == 5:
    run_outside(*sys.argv[3:])
else:
    run_inside()
