#!/usr/bin/env python3
"""Ctrl-C, typed in a terminal of its own, ends a run and raises KeyboardInterrupt."""
import contextlib
import os
import pty
import select
import signal
import sys
import time
import unittest

SECONDS = 0.3  # from Ctrl-C to the exception

# A surface, and a run of minutes.
PRELUDE = """
import signal, sys, threading, time
import anisotropic_remeshing as ar
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
sphere = vtkSphereSource()
sphere.SetThetaResolution(200)
sphere.SetPhiResolution(150)
sphere.Update()
surface = sphere.GetOutput()

def long_run(**more):
    return ar.remesh(surface, 20000, lloyd_iterations=100000, coarse_start=False, **more)

def filter_of(points=20000):
    remesher = ar.vtkAnisotropicRemesher()
    remesher.SetInputData(surface)
    remesher.SetNumberOfPoints(points)
    remesher.SetCoarseStart(False)
    remesher.SetNumberOfLloydIterations(100000)
    return remesher

def say(*words):
    print(*words, flush=True)

def raises(kind, call, *arguments, **more):
    # Says how a call ends, with a number that counts such calls.
    raises.count += 1
    say("running", raises.count)
    try:
        call(*arguments, **more)
    except kind as error:
        say("caught", raises.count, type(error).__name__, error)
    else:
        say("not raised", raises.count)

raises.count = 0
"""

# One process for all that ends a call: to start costs more than they do.
CALLS = """
raises(KeyboardInterrupt, long_run)
say("handler", signal.getsignal(signal.SIGINT) is signal.default_int_handler)
raises(KeyboardInterrupt, long_run)
raises(KeyboardInterrupt, long_run)
raises(KeyboardInterrupt, long_run, progress=True)
raises(KeyboardInterrupt, long_run, progress=lambda *_: time.sleep(0.02))
say("function again", ar.remesh(surface, 200).points.shape)

remesher = filter_of()
raises(KeyboardInterrupt, remesher.Update)
remesher.AddObserver("ProgressEvent", lambda *_: time.sleep(0.01))
remesher.AddObserver("EndEvent", lambda *_: say("observed the end", sum(range(100000))))
raises(KeyboardInterrupt, remesher.Update)
triangles = vtkTriangleFilter()
triangles.SetInputConnection(remesher.GetOutputPort())
triangles.AddObserver("StartEvent", lambda *_: say("observed the start", sum(range(100000))))
raises(KeyboardInterrupt, triangles.Update)
remesher.SetNumberOfPoints(200)
remesher.SetNumberOfLloydIterations(0)
triangles.Update()
say("pipeline again", triangles.GetOutput().GetNumberOfPoints())

def handler(number, frame):
    raise LookupError(number)

signal.signal(signal.SIGINT, handler)
raises(LookupError, long_run)
say("own handler", signal.getsignal(signal.SIGINT) is handler)
"""


class Terminal:
    """A Python program in a pseudo-terminal."""

    def __init__(self, program):
        self.text = ""
        self.pid, self.descriptor = pty.fork()
        if self.pid == 0:
            os.execv(sys.executable, [sys.executable, "-c", PRELUDE + program])

    def read_until(self, word, seconds=60.0):
        """Reads on until a word comes; the seconds that it took, or None."""
        start = time.monotonic()
        while word not in self.text:
            left = start + seconds - time.monotonic()
            if left <= 0 or not select.select([self.descriptor], [], [], left)[0]:
                return None
            try:
                read = os.read(self.descriptor, 65536)
            except OSError:  # the program has ended
                return None
            self.text += read.decode(errors="replace")
        return time.monotonic() - start

    def interrupt(self):
        os.write(self.descriptor, b"\x03")

    def end(self):
        """The exit status, negative for a signal."""
        self.read_until("no such word", 60.0)
        os.close(self.descriptor)
        status = os.waitpid(self.pid, 0)[1]
        return os.waitstatus_to_exitcode(status)


class TestInterruption(unittest.TestCase):
    def interrupt(self, terminal, start, expected, delay=0.4):
        """Types Ctrl-C some time after it says `start`; it must say `expected` soon."""
        self.assertIsNotNone(terminal.read_until(start), terminal.text)
        time.sleep(delay)
        terminal.interrupt()
        seconds = terminal.read_until(expected, 20.0)
        self.assertIsNotNone(seconds, terminal.text)
        print(f"{expected}: {seconds:.3f} s")
        self.assertLess(seconds, SECONDS, terminal.text)

    @contextlib.contextmanager
    def terminal(self, program, status=0):
        terminal = Terminal(program)
        try:
            yield terminal
        except BaseException:
            os.kill(terminal.pid, signal.SIGKILL)
            terminal.end()
            raise
        self.assertEqual(terminal.end(), status, terminal.text)

    def test_calls(self):
        delays = [0.6, 0.0, 0.1] + [0.4] * 5
        with self.terminal(CALLS) as terminal:
            for number, delay in enumerate(delays, 1):
                self.interrupt(terminal, f"running {number}", f"caught {number} KeyboardInterrupt",
                               delay)
            self.interrupt(terminal, "running 9", "caught 9 LookupError 2")
        for word in ("function again (200, 3)", "pipeline again 200", "observed the end",
                     "observed the start", "handler True", "own handler True"):
            self.assertIn(word, terminal.text)

    def test_script_that_does_not_catch(self):
        with self.terminal("say('running'); long_run()", -signal.SIGINT) as terminal:
            self.interrupt(terminal, "running", "KeyboardInterrupt")
        self.assertIn("Traceback", terminal.text)

    def test_own_handler_that_does_not_raise(self):
        with self.terminal("""
signal.signal(signal.SIGINT, lambda *_: say("handled"))
say("running")
result = ar.remesh(surface, 20000, lloyd_iterations=60, coarse_start=False)
say("points", result.points.shape[0])
""") as terminal:
            self.interrupt(terminal, "running", "handled", 0.3)
        self.assertIn("points 20000", terminal.text)

    def test_ignored(self):
        with self.terminal("""
signal.signal(signal.SIGINT, signal.SIG_IGN)
say("running")
say("points", ar.remesh(surface, 2000).points.shape[0])
""") as terminal:
            self.assertIsNotNone(terminal.read_until("running"), terminal.text)
            terminal.interrupt()
        self.assertIn("points 2000", terminal.text)

    def test_other_thread_works_on(self):
        with self.terminal("""
found = []
thread = threading.Thread(target=lambda: found.append(
    ar.remesh(surface, 20000, lloyd_iterations=60, coarse_start=False)))
thread.start()
raises(KeyboardInterrupt, time.sleep, 60)
thread.join()
say("points", found[0].points.shape[0])
""") as terminal:
            self.interrupt(terminal, "running 1", "caught 1 KeyboardInterrupt", 0.3)
        self.assertIn("points 20000", terminal.text)


if __name__ == "__main__":
    unittest.main(verbosity=2)
