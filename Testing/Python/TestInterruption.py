#!/usr/bin/env python3
"""Ctrl-C, typed in a terminal of its own, ends a run and raises KeyboardInterrupt."""
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
    say("running")
    try:
        call(*arguments, **more)
    except kind as error:
        say("caught", type(error).__name__, error)
    else:
        say("not raised")
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
    def interrupt(self, program, expected, delay=0.6, status=0):
        """Runs it, types Ctrl-C some time after "running", and waits for what it says."""
        terminal = Terminal(program)
        try:
            self.assertIsNotNone(terminal.read_until("running"), terminal.text)
            time.sleep(delay)
            terminal.interrupt()
            seconds = terminal.read_until(expected, 20.0)
            self.assertIsNotNone(seconds, terminal.text)
            code = terminal.end()
        except BaseException:
            os.kill(terminal.pid, signal.SIGKILL)
            terminal.end()
            raise
        self.assertEqual(code, status, terminal.text)
        self.assertLess(seconds, SECONDS, terminal.text)
        return terminal.text

    def test_function(self):
        text = self.interrupt("""
raises(KeyboardInterrupt, long_run)
say("handler", signal.getsignal(signal.SIGINT) is signal.default_int_handler)
say("again", ar.remesh(surface, 200).points.shape)
""", "caught KeyboardInterrupt")
        self.assertIn("handler True", text)
        self.assertIn("again (200, 3)", text)

    def test_every_moment(self):
        for delay in (0.0, 0.05, 0.2):
            self.interrupt("raises(KeyboardInterrupt, long_run)", "caught KeyboardInterrupt", delay)

    def test_script_that_does_not_catch(self):
        text = self.interrupt("say('running'); long_run()", "KeyboardInterrupt",
                              status=-signal.SIGINT)
        self.assertIn("Traceback", text)

    def test_progress(self):
        self.interrupt("raises(KeyboardInterrupt, long_run, progress=True)",
                       "caught KeyboardInterrupt")
        self.interrupt("raises(KeyboardInterrupt, long_run, progress=lambda *_: time.sleep(0.02))",
                       "caught KeyboardInterrupt")

    def test_filter(self):
        text = self.interrupt("""
remesher = filter_of()
raises(KeyboardInterrupt, remesher.Update)
remesher.SetNumberOfPoints(200)
remesher.SetNumberOfLloydIterations(0)
remesher.Update()
say("again", remesher.GetOutput().GetNumberOfPoints())
""", "caught KeyboardInterrupt")
        self.assertIn("again 200", text)

    def test_filter_with_observers(self):
        text = self.interrupt("""
remesher = filter_of()
remesher.AddObserver("ProgressEvent", lambda *_: time.sleep(0.01))
remesher.AddObserver("EndEvent", lambda *_: say("observed the end", sum(range(100000))))
raises(KeyboardInterrupt, remesher.Update)
""", "caught KeyboardInterrupt")
        self.assertIn("observed the end", text)

    def test_pipeline(self):
        text = self.interrupt("""
remesher = filter_of()
triangles = vtkTriangleFilter()
triangles.SetInputConnection(remesher.GetOutputPort())
triangles.AddObserver("StartEvent", lambda *_: say("observed the start", sum(range(100000))))
raises(KeyboardInterrupt, triangles.Update)
remesher.SetNumberOfPoints(200)
remesher.SetNumberOfLloydIterations(0)
triangles.Update()
say("again", triangles.GetOutput().GetNumberOfPoints())
""", "caught KeyboardInterrupt")
        self.assertIn("again 200", text)

    def test_own_handler_that_raises(self):
        text = self.interrupt("""
def handler(number, frame):
    raise LookupError(number)
signal.signal(signal.SIGINT, handler)
raises(LookupError, long_run)
say("handler", signal.getsignal(signal.SIGINT) is handler)
""", "caught LookupError 2")
        self.assertIn("handler True", text)

    def test_own_handler_that_does_not_raise(self):
        text = self.interrupt("""
signal.signal(signal.SIGINT, lambda *_: say("handled"))
say("running")
result = ar.remesh(surface, 20000, lloyd_iterations=60, coarse_start=False)
say("points", result.points.shape[0])
""", "handled", 0.3)
        self.assertIn("points 20000", text)

    def test_ignored(self):
        terminal = Terminal("""
signal.signal(signal.SIGINT, signal.SIG_IGN)
say("running")
say("points", ar.remesh(surface, 2000).points.shape[0])
""")
        self.assertIsNotNone(terminal.read_until("running"), terminal.text)
        terminal.interrupt()
        self.assertEqual(terminal.end(), 0)
        self.assertIn("points 2000", terminal.text)

    def test_other_thread_works_on(self):
        text = self.interrupt("""
found = []
thread = threading.Thread(target=lambda: found.append(
    ar.remesh(surface, 20000, lloyd_iterations=60, coarse_start=False)))
thread.start()
raises(KeyboardInterrupt, time.sleep, 60)
thread.join()
say("points", found[0].points.shape[0])
""", "caught KeyboardInterrupt", 0.3)
        self.assertIn("points 20000", text)


if __name__ == "__main__":
    unittest.main(verbosity=2)
