"""Runs the examples and looks at what they write.

    TestExamples.py --pipeline build/bin/MinimalPipeline --script Examples/Python/remesh.py
                    --work FOLDER [unittest options]
"""
import argparse
import os
import re
import subprocess
import sys
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkCylinderSource

from CommandLineTesting import CommandLineTest, read, write


class TestExamples(CommandLineTest):
    pipeline = None
    script = None

    def run_example(self, *command):
        """What it prints; its file out.vtp must hold as many points and triangles as it says."""
        result = subprocess.run(command, cwd=self.folder, capture_output=True, encoding="utf-8",
                                timeout=300, check=False)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(os.listdir(self.folder), ["out.vtp"])
        surface = read(self.path("out.vtp"))
        self.assertIn(f"{surface.GetNumberOfPoints()} points, "
                      f"{surface.GetNumberOfPolys()} triangles", result.stdout)
        return surface, result.stdout

    def test_minimal_pipeline(self):
        surface, _ = self.run_example(self.pipeline, "out.vtp")
        self.assertGreaterEqual(surface.GetNumberOfPoints(), 2000)

    def test_minimal_pipeline_cannot_write(self):
        result = subprocess.run([self.pipeline, "none/out.vtp"], cwd=self.folder,
                                capture_output=True, timeout=300, check=False)
        self.assertEqual(result.returncode, 1)

    def test_script(self):
        surface, text = self.run_example(sys.executable, self.script, self.input(), "out.vtp",
                                         "60")
        # A sphere: as many triangles as Euler's formula asks for.
        self.assertEqual((surface.GetNumberOfPoints(), surface.GetNumberOfPolys()), (60, 116))
        self.assertIn("Euler characteristic 2\n", text)

    def test_flat_parts(self):
        # A cylinder: nearly half of it is flat, and takes a third of the points that are even.
        cylinder = vtkCylinderSource()
        cylinder.SetResolution(256)
        cylinder.Update()
        cylinder.GetOutput().GetPointData().SetTCoords(None)  # whose seams have two points each
        write(cylinder.GetOutput(), self.path("in.vtp"))
        script = os.path.join(os.path.dirname(self.script), "flat_parts.py")
        distances, flat = [], []
        for density in ("1", "0.1"):
            result = subprocess.run(
                [sys.executable, script, "in.vtp", "out.vtp", "1500", "0.2", density],
                cwd=self.folder, capture_output=True, encoding="utf-8", timeout=300, check=False)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            found = re.match(r"1500 points, RMS distance ([^,]+), largest ", result.stdout)
            distances.append(float(found.group(1)))
            points = vtk_to_numpy(read(self.path("out.vtp")).GetPoints().GetData())
            inside = numpy.hypot(points[:, 0], points[:, 2]) < 0.4
            flat.append(numpy.count_nonzero(inside & (abs(points[:, 1]) > 0.499)))
        self.assertLess(distances[1], 0.9 * distances[0])
        self.assertLess(flat[1], 0.6 * flat[0])
        self.assertGreater(flat[1], 0.2 * flat[0])

    def test_render_from_above(self):
        render = os.path.join(os.path.dirname(self.script), os.pardir, "Gallery", "render.py")
        files = [word for name in ("surface", "cells", "edges") for word in (f"--{name}", "x.vtp")]
        for view in ("0,1,0", "0,-2,0", "nan,0,1"):
            result = subprocess.run([sys.executable, render, *files, "--output", "x.png",
                                     f"--view={view}"], cwd=self.folder, capture_output=True,
                                    encoding="utf-8", timeout=300, check=False)
            self.assertEqual(result.returncode, 2)
            self.assertIn("--view and --up must be directions", result.stderr)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    for option in ("--pipeline", "--script", "--work"):
        parser.add_argument(option, required=True)
    known, rest = parser.parse_known_args()
    TestExamples.pipeline = os.path.abspath(known.pipeline)
    TestExamples.script = os.path.abspath(known.script)
    CommandLineTest.work = os.path.abspath(known.work)
    os.makedirs(CommandLineTest.work, exist_ok=True)
    unittest.main(argv=sys.argv[:1] + rest, verbosity=2)
