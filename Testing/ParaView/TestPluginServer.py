"""TestPluginServer.py PLUGIN OUTPUT_FOLDER PVSERVER... (pvpython): a server gives the same output.

Runs the remesher in the built-in server, then in a server of its own, which a command starts, on one
process or several. Compares each array of each output but the times; progress and errors reach the
client. Of several processes, one whose input fails is told, and no other waits for it.
"""
import os
import queue
import subprocess
import sys
import threading

from paraview import servermanager
from paraview.simple import *
from vtkmodules.vtkCommonCore import vtkFileOutputWindow, vtkLogger, vtkOutputWindow

PLUGIN, OUTPUT_FOLDER, *PVSERVER = sys.argv[1:]
ATTEMPTS = 5
FIRST_PORT = 21111


def start_server():
    """A pvserver that waits for a client, and its port: the first of a few that is free."""
    # This process has initialised MPI: mpiexec would take itself for one of its children.
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith(("OMPI_", "PMIX_"))}
    environment.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    for port in range(FIRST_PORT, FIRST_PORT + ATTEMPTS):
        server = subprocess.Popen([*PVSERVER, f"--server-port={port}", "--timeout=5"],
                                  env=environment, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True)
        lines = queue.Queue()

        def read(pipe=server.stdout, lines=lines):
            for line in pipe:
                lines.put(line)
            lines.put("")
        threading.Thread(target=read, daemon=True).start()
        try:
            line = lines.get(timeout=60)
            while line and "Accepting connection" not in line:
                line = lines.get(timeout=60)
            if line:
                return server, port
        except queue.Empty:
            pass
        server.kill()
        server.wait()
    sys.exit("no pvserver could be started")


def run():
    """Bytes of all arrays of all outputs."""
    surface = Superquadric(ThetaResolution=32, PhiResolution=32)
    surface.UpdatePipeline()
    remesher = AnisotropicRemesher(Input=surface, NumberOfPoints=400, LloydIterations=5)
    remesher.UpdatePipeline()
    result = {}
    for port in range(5):
        data = servermanager.Fetch(remesher, idx=port)
        fields = [data.GetAttributes(i) for i in range(7) if data.GetAttributes(i)]
        for attributes in fields:
            for i in range(attributes.GetNumberOfArrays()):
                array = attributes.GetArray(i)
                if array and array.GetName() != "Seconds":
                    result[port, attributes.GetClassName(), array.GetName()] = bytes(memoryview(array))
        if data.IsA("vtkPointSet"):
            result[port, "points"] = bytes(memoryview(data.GetPoints().GetData()))
    return result


def texts_of_progress():
    """What the client sees of a run of some seconds; it is told at most once a second."""
    handler = servermanager.ActiveConnection.Session.GetProgressHandler()
    seen = []
    tag = handler.AddObserver("ProgressEvent",
                              lambda *_: seen.append(handler.GetLastProgressText()))
    AnisotropicRemesher(Input=Sphere(ThetaResolution=100, PhiResolution=100),
                        NumberOfPoints=15000).UpdatePipeline()
    handler.RemoveObserver(tag)
    return seen


def errors_of_client(pipeline):
    """What the client's output window says of an update that fails."""
    path = os.path.join(OUTPUT_FOLDER, "server-errors.txt")
    window = vtkFileOutputWindow()
    window.SetFileName(path)
    window.FlushOn()
    before = vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(window)
    verbosity = vtkLogger.GetCurrentVerbosityCutoff()
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)  # this error is wanted
    pipeline.UpdatePipeline()
    vtkLogger.SetStderrVerbosity(verbosity)
    vtkOutputWindow.SetInstance(before)
    with open(path) as file:
        return file.read()


def write_ply(path):
    """A tetrahedron."""
    with open(path, "w") as file:
        file.write("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                   "property float z\nelement face 4\nproperty list uchar int vertex_indices\n"
                   "end_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                   "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n")


def check_failing_input():
    """A file that the first process cannot read: all end with one message, and read a good one."""
    path = os.path.join(OUTPUT_FOLDER, "server-input.ply")
    filters = (lambda source: AnisotropicRemesher(Input=source, NumberOfPoints=200),
               lambda source: SurfaceMeshComparison(Input=source, Reference=Sphere()))
    for make in filters:
        with open(path, "w") as file:
            file.write("no mesh\n")
        source = PLYReader(FileNames=[path])
        filtered = make(source)
        text = errors_of_client(filtered)
        assert text.count("could not be made on 1 of the processes") == 1, text
        assert filtered.GetDataInformation().GetNumberOfPoints() == 0
        write_ply(path)
        ReloadFiles(source)
        filtered.UpdatePipeline()
        assert filtered.GetDataInformation().GetNumberOfPoints() > 0


LoadPlugin(PLUGIN, remote=False, ns=globals())
here = run()
assert len(here) > 20, sorted(here)

# The server ends with its client, when this script does, or at its own time-out.
server, port = start_server()
Connect("127.0.0.1", port)
LoadPlugin(PLUGIN, remote=True, ns=globals())
LoadPlugin(PLUGIN, remote=False, ns=globals())
there = run()
assert sorted(here, key=str) == sorted(there, key=str)
# Several processes number the cells of the input one piece after the other.
skipped = {"InputCellId"} if len(PVSERVER) > 1 else set()
different = [key for key in here if here[key] != there[key] and key[-1] not in skipped]
assert not different, different
print(len(here), "arrays are equal")

progress = texts_of_progress()
stages = {"Sampling", "Lloyd iterations", "Quasi-Newton iterations", "Vertex placement"}
if servermanager.vtkSMProxyManager.GetVersionMajor() < 6:
    assert stages & set(progress), progress
else:  # 6.1 loses the ends of longer texts
    assert any(stage.startswith(text) for stage in stages for text in progress if len(text) > 7), (
        progress)
text = errors_of_client(AnisotropicRemesher(Input=Sphere(), NumberOfPoints=0))
assert "at least" in text, text
if len(PVSERVER) > 1:
    check_failing_input()
