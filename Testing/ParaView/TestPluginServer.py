"""TestPluginServer.py PLUGIN OUTPUT_FOLDER PVSERVER (pvpython): a server gives the same output.

Runs the remesher in the built-in server, then in a pvserver of its own, and compares each array of
each output but the times.
"""
import queue
import subprocess
import sys
import threading

from paraview import servermanager
from paraview.simple import *

PLUGIN, _, PVSERVER = sys.argv[1:4]
ATTEMPTS = 5
FIRST_PORT = 21111


def start_server():
    """A pvserver that waits for a client, and its port: the first of a few that is free."""
    for port in range(FIRST_PORT, FIRST_PORT + ATTEMPTS):
        server = subprocess.Popen([PVSERVER, f"--server-port={port}", "--timeout=5"],
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
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
different = [key for key in here if here[key] != there[key]]
assert not different, different
print(len(here), "arrays are equal")
